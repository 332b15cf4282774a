#include "solid/face_points.hpp"

#include <algorithm>
#include <numbers>

namespace signorini::solid {

namespace {

ElementQuadrature face_quadrature(const nurbs::Discretization& space, int e, nurbs::Side side, int times) {
  std::vector<QuadratureRule> rules;
  for (int d = 0; d < space.parametric_dimension(); ++d) {
    const auto [a, b] = space.interval(e, d);
    rules.push_back(d == side.direction ? QuadratureRule{{side.at_end ? b : a}, {1}}
                                        : gauss_legendre(times * (space.degree(e, d) + 1), a, b));
  }
  return tensor_product(rules);
}

template <int D>
FacePoints<D> points_of(const Body<D>& body, nurbs::Side side, int e, int times,
                        const std::vector<int>& face_functions) {
  const nurbs::Discretization& space = body.space();
  const ElementQuadrature rule = face_quadrature(space, e, side, times);
  FacePoints<D> part{{}, rule.weights, {}, {}, nurbs::outward_sign(side), body.kind() == Kind::axisymmetric};
  std::vector<int> own; // of the element's functions
  for (int q = 0; q < rule.weights.size(); ++q) {
    const nurbs::ElementBasis basis = space.basis(e, rule.points.col(q));
    if (q == 0) {
      for (std::size_t a = 0; a < basis.functions.size(); ++a)
        if (std::binary_search(face_functions.begin(), face_functions.end(), basis.functions[a])) {
          own.push_back(static_cast<int>(a));
          part.functions.push_back(basis.functions[a]);
        }
      const auto n = static_cast<Eigen::Index>(own.size());
      part.values.resize(n, rule.weights.size());
      for (MatrixX& gradient : part.gradients) gradient.resize(n, rule.weights.size());
    }
    part.values.col(q) = basis.values(own);
    for (int d = 0, k = 0; d < D; ++d)
      if (d != side.direction) part.gradients[k++].col(q) = basis.gradients.row(d)(own);
  }
  return part;
}

} // namespace

template <int D> Vec<D> FacePoints<D>::area_vector(const MatrixX& x, int q) const {
  const Vec<D> first = x.lazyProduct(gradients[0].col(q));
  if constexpr (D == 2)
    return outward * Vec<2>(first(1), -first(0));
  else
    return outward * first.cross(Vec<3>(x.lazyProduct(gradients[1].col(q))));
}

template <int D> double FacePoints<D>::weight(const MatrixX& x, int q) const {
  return revolved ? weights(q) * 2 * std::numbers::pi * x.row(0).dot(values.col(q)) : weights(q);
}

template <int D> std::vector<FacePoints<D>> face_points(const Body<D>& body, nurbs::Side side, int times) {
  const nurbs::Discretization& space = body.space();
  std::vector<int> functions = space.face_functions(side);
  std::sort(functions.begin(), functions.end());
  std::vector<FacePoints<D>> parts;
  for (int f = 0; f < space.elements_on(side); ++f)
    parts.push_back(points_of(body, side, space.element_behind(side, f), times, functions));
  return parts;
}

template struct FacePoints<2>;
template struct FacePoints<3>;
template std::vector<FacePoints<2>> face_points<2>(const Body<2>&, nurbs::Side, int);
template std::vector<FacePoints<3>> face_points<3>(const Body<3>&, nurbs::Side, int);

} // namespace signorini::solid
