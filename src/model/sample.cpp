#include "model/sample.hpp"

#include "base/index.hpp"

#include <cmath>

namespace signorini::model {

template <int D> BodyPoint<D> body_point(const Model<D>& model, int body, int e, const VectorX& xi) {
  const nurbs::Discretisation& space = model.scene().bodies[at(body)].body->space();
  const nurbs::ElementBasis basis = space.basis(e, xi);
  const auto displacement = model.body_displacement(body);
  BodyPoint<D> point{Vec<D>::Zero(), Mat<D>::Zero(), {Vec<D>::Zero(), Mat<D>::Zero()}};
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
  if (model.scene().bodies[at(body)].body->kind() == solid::Kind::axisymmetric) {
    // F_θθ = 1 + u_r/R → 1 + ∂u_r/∂R on the axis; nearer than this the quotient is rounding
    const double radius = point.reference(0), size = jacobian.cwiseAbs().maxCoeff();
    point.state.hoop = radius > 1e-8 * size ? 1 + point.state.displacement(0) / radius : point.state.deformation(0, 0);
  }
  return point;
}

template <int D> BodyPoint<D> regular_point(const Model<D>& model, int body, int e, const VectorX& xi) {
  BodyPoint<D> point = body_point(model, body, e, xi);
  const double size = point.jacobian.colwise().norm().maxCoeff();
  if (std::abs(point.jacobian.determinant()) > 1e-10 * std::pow(size, D)) return point;
  const nurbs::Discretisation& space = model.scene().bodies[at(body)].body->space();
  VectorX inwards(D);
  for (int d = 0; d < D; ++d) {
    const auto [from, to] = space.interval(e, d);
    inwards(d) = 0.5 * (from + to) - xi(d);
  }
  const BodyPoint<D> beside = body_point(model, body, e, xi + 1e-4 * inwards);
  point.jacobian = beside.jacobian;
  const Vec<D> displacement = point.state.displacement;
  point.state = beside.state;
  point.state.displacement = displacement;
  return point;
}

template <int D> double sample(const Model<D>& model, int body, const Field<D>& field, const VectorX& xi) {
  const solid::Body<D>& solid = *model.scene().bodies[at(body)].body;
  return field.value(solid.material(), regular_point(model, body, solid.space().find_element(xi), xi).state);
}

template BodyPoint<2> body_point<2>(const Model<2>&, int, int, const VectorX&);
template BodyPoint<3> body_point<3>(const Model<3>&, int, int, const VectorX&);
template BodyPoint<2> regular_point<2>(const Model<2>&, int, int, const VectorX&);
template double sample<2>(const Model<2>&, int, const Field<2>&, const VectorX&);
template BodyPoint<3> regular_point<3>(const Model<3>&, int, int, const VectorX&);
template double sample<3>(const Model<3>&, int, const Field<3>&, const VectorX&);

} // namespace signorini::model
