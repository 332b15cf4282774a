#include "model/results/sample.hpp"

#include "model/results/results.hpp"
#include "solid/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace signorini::model {

template <int D> BodyPoint<D> body_point(const Model<D>& model, int body, int e, const VectorX& xi) {
  const nurbs::Discretization& space = model.system.scene.bodies[body].body->space();
  const nurbs::ElementBasis basis = space.basis(e, xi);
  const auto displacement = body_displacement(model, body);
  BodyPoint<D> point{Vec<D>::Zero(), Mat<D>::Zero(), {Vec<D>::Zero(), Mat<D>::Zero()}, e, xi};
  Mat<D>& jacobian = point.jacobian;
  Mat<D> rate = Mat<D>::Zero(); // ∂u/∂ξ
  for (std::size_t a = 0; a < basis.functions.size(); ++a) {
    const int function = basis.functions[a], i = static_cast<int>(a);
    const Vec<D> reference = space.homogeneous().col(function).template head<D>() / space.homogeneous()(D, function);
    point.reference += basis.values(i) * reference;
    point.state.displacement += basis.values(i) * displacement.col(function);
    jacobian += reference * basis.gradients.col(i).transpose();
    rate += displacement.col(function) * basis.gradients.col(i).transpose();
  }
  point.state.deformation = Mat<D>::Identity() + rate * jacobian.inverse();
  const solid::Body<D>& solid = *model.system.scene.bodies[body].body;
  point.state.internal = solid::values_at(solid, e, xi, model.present.internal[body]);
  if constexpr (D == 2)
    if (solid.kind() == solid::Kind::plane_stress)
      point.state.hoop = solid.material().thickness_stretch(point.state.deformation, {point.state.internal, {}, 0});
  if (solid.kind() == solid::Kind::axisymmetric) {
    // F_θθ = 1 + u_r/R → 1 + ∂u_r/∂R on the axis; at smaller radii the quotient is rounding error
    const double radius = point.reference(0), size = jacobian.cwiseAbs().maxCoeff();
    point.state.hoop = radius > 1e-8 * size ? 1 + point.state.displacement(0) / radius : point.state.deformation(0, 0);
  }
  return point;
}

template <int D> void add_volume_change(const Model<D>& model, int body, BodyPoint<D>& point) {
  const solid::Body<D>& solid = *model.system.scene.bodies[body].body;
  if (solid.volumetric() == solid::Volumetric::pointwise) return;
  const Mat<3> f = solid::in_space<D>(point.state.deformation, point.state.hoop);
  point.state.dilation =
      model.projected_volumes[body].change(solid, point.element, point.xi, f, body_displacement(model, body).data());
}

template <int D> double value_at(const Model<D>& model, int body, const Field<D>& field, BodyPoint<D> point) {
  if (field.of_stress) add_volume_change(model, body, point);
  return field.value(model.system.scene.bodies[body].body->material(), point.state);
}

namespace {

/// A point with the gradients of a nearby point.
template <int D> BodyPoint<D> with_gradients(const BodyPoint<D>& point, BodyPoint<D> nearby) {
  nearby.reference = point.reference;
  nearby.state.displacement = point.state.displacement;
  return nearby;
}

/// xi clamped to the box of an element's Gauss points, the nearest one of these, and, if xi lies outside of the box in
/// two or more directions, the corresponding point of the element's border.
template <int D> struct GaussBox {
  VectorX inside, nearest;
  std::optional<VectorX> border;
};
template <int D> GaussBox<D> gauss_box(const nurbs::Discretization& space, int e, const VectorX& xi) {
  VectorX inside = xi, nearest = xi, border = xi;
  int outside = 0;
  for (int d = 0; d < D; ++d) {
    const auto [from, to] = space.interval(e, d);
    const std::vector<double> points = solid::gauss_legendre(space.degree(e, d) + 1, from, to).points;
    inside(d) = std::clamp(xi(d), points.front(), points.back());
    nearest(d) = *std::ranges::min_element(points, {}, [&](double point) { return std::abs(point - xi(d)); });
    if (inside(d) == xi(d)) continue;
    border(d) = xi(d) < inside(d) ? from : to;
    ++outside;
  }
  return {inside, nearest, outside > 1 ? std::optional(border) : std::nullopt};
}

/// True if the columns of ∂X/∂ξ are nonzero (unlike at a pole) but parallel, as at the corners of a disc of four arcs.
template <int D> bool is_flat_corner(const Mat<D>& jacobian) {
  const auto lengths = jacobian.colwise().norm();
  return lengths.minCoeff() > 1e-6 * lengths.maxCoeff() && std::abs(jacobian.determinant()) < 1e-8 * lengths.prod();
}

/// True if an edge or a face of the patch is collapsed to a point or a line there.
template <int D> bool is_pole(const Mat<D>& jacobian) {
  const double size = jacobian.colwise().norm().maxCoeff();
  return !(std::abs(jacobian.determinant()) > 1e-10 * std::pow(size, D));
}

} // namespace

template <int D> BodyPoint<D> regular_point(const Model<D>& model, int body, int e, const VectorX& xi) {
  BodyPoint<D> point = body_point(model, body, e, xi);
  const solid::Body<D>& solid = *model.system.scene.bodies[body].body;
  const nurbs::Discretization& space = solid.space();
  // F is unbounded towards a flat corner, and det F may be negative next to and between the Gauss points.
  const auto is_inverted = [&](const BodyPoint<D>& at) {
    return !solid.small_strains() &&
           (at.state.deformation.determinant() <= 0 || at.state.hoop <= 0); // not where it is nan
  };
  const GaussBox<D> box = gauss_box<D>(space, e, xi);
  const bool flat = box.border && is_flat_corner<D>(body_point(model, body, e, *box.border).jacobian);
  if (!flat && !is_inverted(point)) {
    if (!is_pole(point.jacobian)) return point;
    VectorX inwards(D);
    for (int d = 0; d < D; ++d) {
      const auto [from, to] = space.interval(e, d);
      inwards(d) = 0.5 * (from + to) - xi(d);
    }
    const BodyPoint<D> nearby = body_point(model, body, e, xi + 1e-4 * inwards);
    if (!is_inverted(nearby)) return with_gradients(point, nearby);
  }
  const BodyPoint<D> inside = body_point(model, body, e, box.inside);
  return with_gradients(point, is_inverted(inside) ? body_point(model, body, e, box.nearest) : inside);
}

template <int D> double sample(const Model<D>& model, int body, const Field<D>& field, const VectorX& xi) {
  const solid::Body<D>& solid = *model.system.scene.bodies[body].body;
  return value_at(model, body, field, regular_point(model, body, solid.space().find_element(xi), xi));
}

template BodyPoint<2> body_point<2>(const Model<2>&, int, int, const VectorX&);
template BodyPoint<3> body_point<3>(const Model<3>&, int, int, const VectorX&);
template void add_volume_change<2>(const Model<2>&, int, BodyPoint<2>&);
template void add_volume_change<3>(const Model<3>&, int, BodyPoint<3>&);
template double value_at<2>(const Model<2>&, int, const Field<2>&, BodyPoint<2>);
template double value_at<3>(const Model<3>&, int, const Field<3>&, BodyPoint<3>);
template BodyPoint<2> regular_point<2>(const Model<2>&, int, int, const VectorX&);
template double sample<2>(const Model<2>&, int, const Field<2>&, const VectorX&);
template BodyPoint<3> regular_point<3>(const Model<3>&, int, int, const VectorX&);
template double sample<3>(const Model<3>&, int, const Field<3>&, const VectorX&);

} // namespace signorini::model
