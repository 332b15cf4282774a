#include "solve/definite.hpp"

#include "base/error.hpp"
#include "solve/cholmod.hpp"

namespace signorini::solve {

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
  const auto* starts = static_cast<const int*>(factor.p);
  const auto* pivots = static_cast<const double*>(factor.x); // D is in the place of L's unit diagonal
  for (std::size_t j = 0; j < factor.n; ++j)
    if (!(pivots[starts[j]] > 0)) return false;
  return true;
}

} // namespace signorini::solve
