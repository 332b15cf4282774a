#include "solid/load.hpp"

#include "base/error.hpp"

#include <numbers>

namespace signorini::solid {

namespace {

/// ∫ R_A t dξ over a side; `force` returns the load t for the area vector of the reference configuration at Gauss
/// point number k of the side.
template <int D, class Force> VectorX integrate(const Body<D>& body, nurbs::Side side, const Force& force) {
  const MatrixX points = body.space().points();
  VectorX load = VectorX::Zero(D * body.functions());
  int k = 0;
  for (const FacePoints<D>& part : face_points(body, side)) {
    const MatrixX x = points(Eigen::all, part.functions);
    for (int q = 0; q < part.weights.size(); ++q, ++k) {
      const Vec<D> density = part.weight(x, q) * force(part.area_vector(x, q), k);
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
  return integrate(body, side,
                   [&](const Vec<D>& normal, int) -> Vec<D> { return normal.norm() * Vec<D>::Unit(component); });
}

template <int D> VectorX pressure_load(const Body<D>& body, nurbs::Side side) {
  return integrate(body, side, [](const Vec<D>& normal, int) -> Vec<D> { return -normal; });
}

template <int D> VectorX body_load(const Body<D>& body, int component) {
  check_component<D>(component);
  VectorX load = VectorX::Zero(D * body.functions());
  load(Eigen::seqN(component, body.functions(), D)) = body.tables().volumes();
  return load;
}

template <int D> Eigen::Index face_point_count(const Body<D>& body, nurbs::Side side) {
  Eigen::Index count = 0;
  for (const FacePoints<D>& part : face_points(body, side)) count += part.weights.size();
  return count;
}

template <int D> LoadPoints load_points(const Body<D>& body, nurbs::Side side, int times) {
  const MatrixX points = body.space().points();
  const std::vector<FacePoints<D>> parts = face_points(body, side, times);
  Eigen::Index count = 0, k = 0;
  for (const FacePoints<D>& part : parts) count += part.weights.size();
  LoadPoints result{MatrixX(D, count), VectorX(count)};
  for (const FacePoints<D>& part : parts) {
    const MatrixX x = points(Eigen::all, part.functions);
    result.positions.middleCols(k, part.weights.size()) = x * part.values;
    for (int q = 0; q < part.weights.size(); ++q)
      result.measures(k++) = part.weight(x, q) * part.area_vector(x, q).norm();
  }
  return result;
}

template <int D> LoadPoints load_points(const Body<D>& body, int times) {
  const nurbs::Discretization& space = body.space();
  const MatrixX points = space.points();
  std::vector<ElementQuadrature> rules;
  Eigen::Index count = 0, k = 0;
  for (int e = 0; e < space.elements(); ++e)
    count += rules.emplace_back(element_quadrature(space, e, times)).weights.size();
  LoadPoints result{MatrixX(D, count), VectorX(count)};
  for (int e = 0; e < space.elements(); ++e)
    for (Eigen::Index q = 0; q < rules[e].weights.size(); ++q, ++k) {
      const nurbs::ElementBasis basis = space.basis(e, rules[e].points.col(q));
      const Mat<D> jacobian = points(Eigen::all, basis.functions) * basis.gradients.transpose();
      const Vec<D> place = basis.combine(points);
      result.positions.col(k) = place;
      result.measures(k) = rules[e].weights(q) * jacobian.determinant() *
                           (body.kind() == Kind::axisymmetric ? 2 * std::numbers::pi * place(0) : 1);
    }
  return result;
}

template <int D> VectorX distributed_load(const Body<D>& body, nurbs::Side side, const MatrixX& values) {
  return integrate(body, side, [&](const Vec<D>& normal, int k) -> Vec<D> {
    if (values.rows() == 1) return -values(0, k) * normal;
    return normal.norm() * values.col(k);
  });
}

template <int D> VectorX distributed_load(const Body<D>& body, const MatrixX& values) {
  VectorX load = VectorX::Zero(D * body.functions());
  Eigen::Index k = 0;
  for (int e = 0; e < body.elements(); ++e) {
    const ElementQuadrature rule = element_quadrature(body.space(), e);
    const double* weights = body.tables().weights_of(e);
    for (int q = 0; q < body.tables().element(e).points; ++q, ++k) {
      const nurbs::ElementBasis basis = body.space().basis(e, rule.points.col(q));
      for (std::size_t a = 0; a < basis.functions.size(); ++a)
        load.template segment<D>(D * basis.functions[a]) +=
            weights[q] * basis.values(static_cast<int>(a)) * values.col(k);
    }
  }
  return load;
}

VectorX edge_lengths(const Body<3>& body, nurbs::Side first, nurbs::Side second) {
  const nurbs::Discretization& space = body.space();
  const MatrixX points = space.points();
  const int along = 3 - first.direction - second.direction;
  VectorX lengths = VectorX::Zero(body.functions());
  for (int e = 0; e < body.elements(); ++e) {
    if (!space.touches(e, first) || !space.touches(e, second)) continue;
    std::vector<QuadratureRule> rules(3);
    for (const nurbs::Side side : {first, second})
      rules[side.direction] = {{space.interval(e, side.direction)[side.at_end ? 1 : 0]}, {1}};
    const auto [a, b] = space.interval(e, along);
    rules[along] = gauss_legendre(2 * (space.degree(e, along) + 1), a, b);
    const ElementQuadrature rule = tensor_product(rules);
    for (int q = 0; q < rule.weights.size(); ++q) {
      const nurbs::ElementBasis basis = space.basis(e, rule.points.col(q));
      const VectorX tangent = points(Eigen::all, basis.functions) * basis.gradients.row(along).transpose();
      lengths(basis.functions) += rule.weights(q) * tangent.norm() * basis.values;
    }
  }
  return lengths;
}

template <int D> MatrixX follower_load(const FacePoints<D>& part, const MatrixX& x) {
  MatrixX load = MatrixX::Zero(D, x.cols());
  for (int q = 0; q < part.weights.size(); ++q)
    load -= part.weight(x, q) * part.area_vector(x, q) * part.values.col(q).transpose();
  return load;
}

template <int D> MatrixX follower_tangent(const FacePoints<D>& part, const MatrixX& x) {
  const int n = std::ssize(part.functions);
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
  template Eigen::Index face_point_count<D>(const Body<D>&, nurbs::Side);                                              \
  template LoadPoints load_points<D>(const Body<D>&, nurbs::Side, int);                                                \
  template LoadPoints load_points<D>(const Body<D>&, int);                                                             \
  template VectorX distributed_load<D>(const Body<D>&, nurbs::Side, const MatrixX&);                                   \
  template VectorX distributed_load<D>(const Body<D>&, const MatrixX&);                                                \
  template MatrixX follower_load<D>(const FacePoints<D>&, const MatrixX&);                                             \
  template MatrixX follower_tangent<D>(const FacePoints<D>&, const MatrixX&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::solid
