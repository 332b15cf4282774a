#include "model/system/free_angles.hpp"

#include "model/scene/rotation.hpp"

namespace signorini::model {

namespace {

/// A derivative of R(θ) e_i, of an angle's marker.
template <int D> Vec<D> marker_rate(const FreeAngle<D>& angle, const VectorX& displacement, int i, int order) {
  return rotation_rate<D>(displacement(angle.dof) / angle.arm, angle.axis, Vec<D>::Unit(i), order);
}

} // namespace

template <int D> void follow_angles(const Unknowns<D>& unknowns, VectorX& displacement) {
  for (const FreeAngle<D>& angle : unknowns.free_angles())
    for (int i = 0; i < D; ++i)
      displacement.template segment<D>(angle.markers + D * i) =
          angle.arm * turned<D>(displacement(angle.dof) / angle.arm, angle.axis, Vec<D>::Unit(i));
}

template <int D> VectorX angle_rates(const Unknowns<D>& unknowns, const VectorX& displacement) {
  VectorX rates = VectorX::Ones(unknowns.dofs());
  for (const FreeAngle<D>& angle : unknowns.free_angles())
    for (int i = 0; i < D; ++i)
      rates.template segment<D>(angle.markers + D * i) = marker_rate(angle, displacement, i, 1);
  return rates;
}

template <int D> void add_moments(const Unknowns<D>& unknowns, const VectorX& displacement, VectorX& force) {
  for (const FreeAngle<D>& angle : unknowns.free_angles())
    for (int i = 0; i < D; ++i)
      force(angle.dof) += force.template segment<D>(angle.markers + D * i).dot(marker_rate(angle, displacement, i, 1));
}

template <int D> double angle_curvature(const FreeAngle<D>& angle, const VectorX& displacement, const VectorX& force) {
  double sum = 0;
  for (int i = 0; i < D; ++i)
    sum += force.template segment<D>(angle.markers + D * i).dot(marker_rate(angle, displacement, i, 2)) / angle.arm;
  return sum;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template void follow_angles(const Unknowns<D>&, VectorX&);                                                           \
  template VectorX angle_rates(const Unknowns<D>&, const VectorX&);                                                    \
  template void add_moments(const Unknowns<D>&, const VectorX&, VectorX&);                                             \
  template double angle_curvature(const FreeAngle<D>&, const VectorX&, const VectorX&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
