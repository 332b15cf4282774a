#include "solid/body.hpp"

namespace signorini::solid {

template <int D>
Body<D>::Body(std::shared_ptr<const nurbs::Discretization> space, Material material, Kind kind, Volumetric volumetric,
              double density)
    : space_(std::move(space)), material_(std::move(material)), kind_(kind), volumetric_(volumetric), density_(density),
      tables_(*space_, material_, kind, volumetric),
      macros_(volumetric == Volumetric::projected ? solid::macro_elements(*space_, tables_) : MacroElements()) {}

template <int D>
Body<D>::Body(nurbs::Discretization space, Material material)
    : Body(std::make_shared<const nurbs::Discretization>(std::move(space)), std::move(material)) {}

template <int D> int Body<D>::macro_index(int m, int d) const {
  if (macros_.list.empty()) return space_->element_index(m, d);
  for (int lower = 0; lower < d; ++lower) m /= macros_.counts[lower];
  return m % macros_.counts[d];
}

template <int D> VectorX reference_point(const Body<D>& body, int e, int q) {
  const nurbs::Discretization& space = body.space();
  return space.basis(e, element_quadrature(space, e).points.col(q)).combine(space.points());
}

std::shared_ptr<const Body<2>> revolved(const Body<2>& body) {
  return std::make_shared<const Body<2>>(body.shared_space(), body.material(), Kind::axisymmetric, body.volumetric(),
                                         body.density());
}

std::shared_ptr<const Body<2>> in_plane_stress(const Body<2>& body) {
  return std::make_shared<const Body<2>>(body.shared_space(), body.material(), Kind::plane_stress, body.volumetric(),
                                         body.density());
}

template class Body<2>;
template class Body<3>;
template VectorX reference_point(const Body<2>&, int, int);
template VectorX reference_point(const Body<3>&, int, int);

} // namespace signorini::solid
