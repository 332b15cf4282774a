// The map of a patch: points, derivatives, and rational functions at a parameter.
#include "nurbs/patch.hpp"

#include "base/error.hpp"
#include "nurbs/basis.hpp"
#include "nurbs/tensor.hpp"

#include <map>

namespace signorini::nurbs {

namespace {

/// The functions that do not vanish on the element of xi, per direction; missing directions are constant 1.
struct LocalBasis {
  std::vector<int> numbers[3];
  ElementFunctions functions;
  std::vector<double> values[3] = {{1.0}, {1.0}, {1.0}}; ///< row k: k-th derivatives

  template <class Direction> LocalBasis(const TensorProduct<Direction>& patch, const VectorX& xi, int order) {
    require(xi.size() == patch.parametric_dimension(), "nurbs.patch.parameters",
            {{"expected", patch.parametric_dimension()}, {"count", xi.size()}});
    for (int d = 0; d < patch.parametric_dimension(); ++d) {
      const Direction& space = patch.direction(d);
      const int element = space.find_element(xi(d));
      const auto& on_element = space.functions_on(element);
      numbers[d].assign(on_element.begin(), on_element.end());
      functions.along[d] = numbers[d];
      functions.stride[d] = patch.stride(d);
      values[d].resize((order + 1) * functions.count(d));
      basis_derivatives(space, element, xi(d), order, values[d].data());
    }
  }

  /// Calls visit(function, value) for the tensor product of the directions' derivatives of the given orders.
  template <class Visit> void each(const int (&orders)[3], Visit visit) const {
    const double* n[3];
    for (int d = 0; d < 3; ++d) n[d] = values[d].data() + orders[d] * functions.count(d);
    functions.each(
        [&](int function, const std::array<int, 3>& i) { visit(function, n[0][i[0]] * n[1][i[1]] * n[2][i[2]]); });
  }

  VectorX sum(const MatrixX& homogeneous, const int (&orders)[3]) const {
    VectorX result = VectorX::Zero(homogeneous.rows());
    each(orders, [&](int function, double value) { result += value * homogeneous.col(function); });
    return result;
  }
};

double binomial(int n, int k) {
  double result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

} // namespace

template <class Direction> VectorX evaluate(const TensorProduct<Direction>& patch, const VectorX& xi) {
  const VectorX x = LocalBasis(patch, xi, 0).sum(patch.homogeneous(), {0, 0, 0});
  return x.head(patch.dimension()) / x(patch.dimension());
}

template VectorX evaluate(const Patch&, const VectorX&);
template VectorX evaluate(const Row&, const VectorX&);

std::vector<Derivative> derivatives(const Patch& patch, const VectorX& xi, int n) {
  require(n >= 0 && n <= max_degree + 2, "nurbs.patch.derivative", {{"order", n}, {"most", max_degree + 2}});
  const LocalBasis basis(patch, xi, n);
  const int dimension = patch.dimension();
  const int last[3] = {n, patch.parametric_dimension() > 1 ? n : 0, patch.parametric_dimension() > 2 ? n : 0};

  std::map<std::array<int, 3>, double> weight; // w^(β)
  std::map<std::array<int, 3>, VectorX> map;   // S^(α) computed so far
  std::vector<Derivative> result;
  for (int total = 0; total <= n; ++total)
    for (int a = total; a >= 0; --a)
      for (int b = total - a; b >= 0; --b) {
        const int c = total - a - b;
        if (b > last[1] || c > last[2]) continue;
        // S^(α) = (A^(α) − Σ_{0≠β≤α} (α over β) w^(β) S^(α−β)) / w   (NURBS Book, eq. 4.20, in any dimension)
        const VectorX homogeneous = basis.sum(patch.homogeneous(), {a, b, c});
        VectorX value = homogeneous.head(dimension);
        weight[{a, b, c}] = homogeneous(dimension);
        for (int i = 0; i <= a; ++i)
          for (int j = 0; j <= b; ++j)
            for (int k = 0; k <= c; ++k)
              if (i + j + k > 0)
                value -=
                    binomial(a, i) * binomial(b, j) * binomial(c, k) * weight[{i, j, k}] * map[{a - i, b - j, c - k}];
        value /= weight[{0, 0, 0}];
        map[{a, b, c}] = value;
        std::vector<int> orders{a, b, c};
        orders.resize(patch.parametric_dimension());
        result.push_back({std::move(orders), std::move(value)});
      }
  return result;
}

std::vector<BasisValue> rational_basis(const Patch& patch, const VectorX& xi) {
  // R_A = w_A N_A / Σ_B w_B N_B [theory 4.1]
  std::vector<BasisValue> result;
  double sum = 0;
  LocalBasis(patch, xi, 0).each({0, 0, 0}, [&](int function, double value) {
    result.push_back({function, value * patch.homogeneous()(patch.dimension(), function)});
    sum += result.back().value;
  });
  for (BasisValue& basis : result) basis.value /= sum;
  return result;
}

} // namespace signorini::nurbs
