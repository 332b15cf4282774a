#include "solid/load.hpp"

#include "base/error.hpp"

#include <numbers>

namespace signorini::solid {

namespace {

/// ∫ R_A t dξ over a side; `force` returns the load t for the area vector of the reference configuration.
template <int D, class Force> VectorX integrate(const Body<D>& body, nurbs::Side side, const Force& force) {
  const MatrixX points = body.space().points();
  VectorX load = VectorX::Zero(D * body.functions());
  for (const FacePoints<D>& part : face_points(body, side)) {
    const MatrixX x = points(Eigen::all, part.functions);
    for (int q = 0; q < part.weights.size(); ++q) {
      const Vec<D> density = part.weight(x, q) * force(part.area_vector(x, q));
      for (std::size_t a = 0; a < part.functions.size(); ++a)
        load.template segment<D>(D * part.functions[a]) += part.values(static_cast<int>(a), q) * density;
    }
  }
  return load;
}

template <int D> void check_component(int component) {
  require(component >= 0 && component < D, "solid.load.component", {{"component", component}, {"most", D - 1}});
}

/// Derivatives of area_vector() with respect to the position of control point b: m = J ∂x/∂ξ in the plane, with the
/// rotation J by a quarter, and ∂x/∂ξ × ∂x/∂η in space.
template <int D> Mat<D> area_vector_derivative(const FacePoints<D>& part, const MatrixX& x, int q, int b) {
  Mat<D> derivative;
  if constexpr (D == 2) {
    const double slope = part.gradients[0](b, q);
    derivative << 0, slope, -slope, 0;
  } else {
    const Vec<3> first = x.lazyProduct(part.gradients[0].col(q)), second = x.lazyProduct(part.gradients[1].col(q));
    const Vec<3> w = part.gradients[1](b, q) * first - part.gradients[0](b, q) * second; // the map v → w × v
    derivative << 0, -w(2), w(1), w(2), 0, -w(0), -w(1), w(0), 0;
  }
  return part.outward * derivative;
}

} // namespace

template <int D> VectorX traction_load(const Body<D>& body, nurbs::Side side, int component) {
  check_component<D>(component);
  return integrate(body, side, [&](const Vec<D>& normal) -> Vec<D> { return normal.norm() * Vec<D>::Unit(component); });
}

template <int D> VectorX pressure_load(const Body<D>& body, nurbs::Side side) {
  return integrate(body, side, [](const Vec<D>& normal) -> Vec<D> { return -normal; });
}

template <int D> VectorX body_load(const Body<D>& body, int component) {
  check_component<D>(component);
  VectorX load = VectorX::Zero(D * body.functions());
  load(Eigen::seqN(component, body.functions(), D)) = body.volumes();
  return load;
}

template <int D> MatrixX follower_load(const FacePoints<D>& part, const MatrixX& x) {
  MatrixX load = MatrixX::Zero(D, x.cols());
  for (int q = 0; q < part.weights.size(); ++q)
    load -= part.weight(x, q) * part.area_vector(x, q) * part.values.col(q).transpose();
  return load;
}

template <int D> MatrixX follower_tangent(const FacePoints<D>& part, const MatrixX& x) {
  const int n = static_cast<int>(part.functions.size());
  MatrixX tangent = MatrixX::Zero(D * n, D * n);
  for (int q = 0; q < part.weights.size(); ++q) {
    const double weight = part.weight(x, q);
    const Vec<D> area = part.area_vector(x, q);
    for (int b = 0; b < n; ++b) {
      Mat<D> change = weight * area_vector_derivative(part, x, q, b);
      if (part.revolved) change.col(0) += part.weights(q) * 2 * std::numbers::pi * part.values(b, q) * area;
      for (int a = 0; a < n; ++a) tangent.template block<D, D>(D * a, D * b) -= part.values(a, q) * change;
    }
  }
  return tangent;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template VectorX traction_load<D>(const Body<D>&, nurbs::Side, int);                                                 \
  template VectorX pressure_load<D>(const Body<D>&, nurbs::Side);                                                      \
  template VectorX body_load<D>(const Body<D>&, int);                                                                  \
  template MatrixX follower_load<D>(const FacePoints<D>&, const MatrixX&);                                             \
  template MatrixX follower_tangent<D>(const FacePoints<D>&, const MatrixX&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::solid
