#include "solve/definite.hpp"

#include "base/error.hpp"
#include "solve/cholmod.hpp"
#include "solve/values.hpp"

#include <cmath>

namespace signorini::solve {

namespace {

/// Calls visit(pivot) for D of L D Lᵀ.
template <class Visit> void each_pivot(const cholmod_factor& factor, const Visit& visit) {
  const auto* starts = static_cast<const int*>(factor.p);
  const auto* pivots = static_cast<const double*>(factor.x); // D is in the place of L's unit diagonal
  for (std::size_t j = 0; j < factor.n; ++j) visit(pivots[starts[j]]);
}

/// The relative residual of the solution for a right-hand side without pattern.
double error_of(const Pattern& pattern, const std::vector<double>& values, cholmod_factor* factor,
                cholmod_common& common) {
  std::vector<double> b(pattern.size), difference;
  for (int i = 0; i < pattern.size; ++i) b[i] = std::sin(1.0 + 0.7 * i + 0.01 * i * i);
  cholmod_dense side{};
  side.nrow = side.d = side.nzmax = static_cast<std::size_t>(pattern.size);
  side.ncol = 1;
  side.x = b.data();
  side.xtype = CHOLMOD_REAL;
  side.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor, &side, &common);
  require(x != nullptr, "solve.cholmod.matrix", {{"status", common.status}});
  const double error =
      relative_residual(pattern, values.data(), static_cast<const double*>(x->x), b.data(), difference);
  cholmod_free_dense(&x, &common);
  return error;
}

} // namespace

bool is_positive_definite(const Pattern& pattern, const std::vector<double>& values) {
  CholmodCommon common;
  common.quick_return_if_not_posdef = true;
  cholmod_sparse matrix = upper_triangle(pattern, values.data());
  CholmodFactor factors(common);
  factors.factor = cholmod_analyze(&matrix, &common);
  require(factors.factor != nullptr, "solve.cholmod.matrix", {{"status", common.status}});
  factorize(matrix, factors.factor, common);
  const cholmod_factor& factor = *factors.factor;
  if (common.status != CHOLMOD_OK || factor.minor < factor.n) return false;
  if (factor.is_ll) return true;
  bool positive = true;
  each_pivot(factor, [&](double pivot) { positive = positive && pivot > 0; });
  return positive;
}

std::optional<int> negative_eigenvalues(const Pattern& pattern, const std::vector<double>& values) {
  CholmodCommon common;
  common.supernodal = CHOLMOD_SIMPLICIAL; // its supernodal factors are L Lᵀ
  common.final_ll = false;
  cholmod_sparse matrix = upper_triangle(pattern, values.data());
  CholmodFactor factors(common);
  factors.factor = cholmod_analyze(&matrix, &common);
  require(factors.factor != nullptr, "solve.cholmod.matrix", {{"status", common.status}});
  factorize(matrix, factors.factor, common);
  if (common.status != CHOLMOD_OK || factors.factor->minor < factors.factor->n) return std::nullopt;
  if (!(error_of(pattern, values, factors.factor, common) <= reliable_factors)) return std::nullopt;
  int negative = 0;
  each_pivot(*factors.factor, [&](double pivot) { negative += pivot < 0; });
  return negative;
}

} // namespace signorini::solve
