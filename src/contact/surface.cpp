#include "contact/surface.hpp"

#include "nurbs/basis.hpp"

namespace signorini::contact {

namespace {

constexpr int row = nurbs::max_degree + 1;

/// Sign that makes the natural normal (2D: tangent turned by −90°; 3D: τ₁×τ₂, both in parametric order) point outward
/// from a right-handed body.
double orientation_of(nurbs::Side side) {
  // 2D: south (ξ² = 0, tangent +ξ¹) has its outside at −90°, west (ξ¹ = 0, tangent +ξ²) at +90°.
  // 3D: ξ²×ξ³ is +ξ¹, ξ¹×ξ³ is −ξ², ξ¹×ξ² is +ξ³.
  return side.at_end == (side.direction == 1) ? -1 : 1;
}

} // namespace

template <int D> Surface<D>::Surface(const nurbs::Discretisation& body, nurbs::Side side) {
  const nurbs::Patch patch = body.face_patch(side);
  directions_ = patch.directions();
  functions_ = body.face_functions(side);
  weights_ = patch.weights();
  polynomial_ = (weights_.array() == weights_(0)).all();
  orientation_ = orientation_of(side);
  reference_ = patch.points();
  points_ = reference_;

  per_element_ = 1;
  int elements = 1;
  for (const auto& knots : directions_) {
    per_element_ *= knots.degree() + 1;
    elements *= knots.elements();
  }
  for (int e = 0; e < elements; ++e) {
    const nurbs::KnotVector& u = directions_.front();
    const int first_u = u.first_function(e % u.elements());
    if constexpr (D == 2) {
      for (int m = 0; m <= u.degree(); ++m) nodes_.push_back(first_u + m);
    } else {
      const nurbs::KnotVector& v = directions_.back();
      const int first_v = v.first_function(e / u.elements());
      for (int n = 0; n <= v.degree(); ++n)
        for (int m = 0; m <= u.degree(); ++m) nodes_.push_back(first_u + m + u.functions() * (first_v + n));
    }
  }
}

template <int D> std::array<double, 2> Surface<D>::interval(int element, int alpha) const {
  const int count = directions_.front().elements();
  const std::size_t i = static_cast<std::size_t>(alpha == 0 ? element % count : element / count);
  const auto& breaks = direction(alpha).breaks();
  return {breaks[i], breaks[i + 1]};
}

template <int D> int Surface<D>::neighbour(int element, int alpha, bool at_end) const {
  const int count = directions_.front().elements();
  const int index = alpha == 0 ? element % count : element / count;
  const int next = index + (at_end ? 1 : -1);
  if (next < 0 || next >= direction(alpha).elements()) return -1;
  return element + (next - index) * (alpha == 0 ? 1 : count);
}

template <int D> void Surface<D>::move(const double* displacement) {
  for (int i = 0; i < functions(); ++i)
    for (int k = 0; k < D; ++k) points_(k, i) = reference_(k, i) + displacement[D * body_function(i) + k];
}

template <int D>
void Surface<D>::evaluate(int element, const FaceCoordinates<D>& xi, int order, FacePoint<D>& point) const {
  point.element = element;
  point.xi = xi;
  const int* local = nodes(element);
  const int n = per_element_;
  if constexpr (D == 2) {
    double b[3 * row];
    nurbs::basis_derivatives(directions_.front(), element, xi(0), order, b);
    double *r = point.value.data(), *dr = point.derivative[0].data(), *ddr = b + 2 * n;
    if (polynomial_) {
      for (int a = 0; a < n; ++a) r[a] = b[a];
      if (order > 0)
        for (int a = 0; a < n; ++a) dr[a] = b[n + a];
    } else {
      double w[3] = {0, 0, 0};
      for (int k = 0; k <= order; ++k)
        for (int a = 0; a < n; ++a) {
          b[k * n + a] *= weights_(local[a]);
          w[k] += b[k * n + a];
        }
      // R = wN/W, R' = (wN' − R W')/W, R'' = (wN'' − 2 R' W' − R W'')/W
      const double scale = 1 / w[0];
      for (int a = 0; a < n; ++a) r[a] = b[a] * scale;
      if (order > 0)
        for (int a = 0; a < n; ++a) dr[a] = (b[n + a] - r[a] * w[1]) * scale;
      if (order > 1)
        for (int a = 0; a < n; ++a) ddr[a] = (ddr[a] - 2 * dr[a] * w[1] - r[a] * w[2]) * scale;
    }
    point.position.setZero();
    point.tangent[0].setZero();
    point.second[0].setZero();
    for (int a = 0; a < n; ++a) {
      const auto x = points_.col(local[a]);
      point.position += r[a] * x;
      if (order > 0) point.tangent[0] += dr[a] * x;
      if (order > 1) point.second[0] += ddr[a] * x;
    }
  } else {
    double u[3 * row], v[3 * row];
    const nurbs::KnotVector &ku = directions_.front(), &kv = directions_.back();
    nurbs::basis_derivatives(ku, element % ku.elements(), xi(0), order, u);
    nurbs::basis_derivatives(kv, element / ku.elements(), xi(1), order, v);
    const int nu = ku.degree() + 1, nv = kv.degree() + 1;
    // Orders of differentiation (i, j) in the order of the results: value; ,1 ,2; ,11 ,12 ,22
    constexpr int orders[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
    const int count = (order + 1) * (order + 2) / 2;
    double w[6] = {};
    Vec<D> x[6];
    for (auto& sum : x) sum.setZero();
    for (int j = 0, a = 0; j < nv; ++j)
      for (int i = 0; i < nu; ++i, ++a) {
        const double weight = weights_(local[a]);
        const auto position = points_.col(local[a]);
        for (int c = 0; c < count; ++c) {
          const double b = weight * u[orders[c][0] * nu + i] * v[orders[c][1] * nv + j];
          w[c] += b;
          x[c] += b * position;
          if (c == 0) point.value[static_cast<std::size_t>(a)] = b;
          if (c == 1 || c == 2) point.derivative[static_cast<std::size_t>(c - 1)][static_cast<std::size_t>(a)] = b;
        }
      }
    const double scale = 1 / w[0];
    for (int a = 0; a < n; ++a) {
      const std::size_t i = static_cast<std::size_t>(a);
      point.value[i] *= scale;
      if (order > 0)
        for (std::size_t k = 0; k < 2; ++k)
          point.derivative[k][i] = (point.derivative[k][i] - point.value[i] * w[k + 1]) * scale;
    }
    // Quotient rule: W x = X; W x_,α = X_,α − W_,α x; W x_,αβ = X_,αβ − W_,α x_,β − W_,β x_,α − W_,αβ x
    point.position = x[0] * scale;
    if (order > 0)
      for (int k = 1; k < 3; ++k)
        point.tangent[static_cast<std::size_t>(k - 1)] = (x[k] - w[k] * point.position) * scale;
    if (order > 1)
      for (int k = 0; k < 3; ++k) {
        const std::size_t alpha = k == 2 ? 1 : 0, beta = k == 0 ? 0 : 1;
        point.second[static_cast<std::size_t>(k)] = (x[3 + k] - w[1 + alpha] * point.tangent[beta] -
                                                     w[1 + beta] * point.tangent[alpha] - w[3 + k] * point.position) *
                                                    scale;
      }
  }
}

template <int D> Vec<D> Surface<D>::outward(const std::array<Vec<D>, D - 1>& tangent) const {
  if constexpr (D == 2)
    return orientation_ * Vec<2>(tangent[0](1), -tangent[0](0));
  else
    return orientation_ * tangent[0].cross(tangent[1]);
}

template class Surface<2>;
template class Surface<3>;

} // namespace signorini::contact
