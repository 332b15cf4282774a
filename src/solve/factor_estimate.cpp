#include "solve/factor_estimate.hpp"

#include "base/error.hpp"
#include "solve/cholmod.hpp"

namespace signorini::solve {

FactorEstimate estimate_factor(LinearKind kind, const Pattern& pattern) {
  CholmodCommon common;
  CholmodFactor lower(common);
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_METIS;
  common.supernodal = CHOLMOD_SUPERNODAL;
  cholmod_sparse matrix = upper_triangle(pattern, nullptr);
  matrix.xtype = CHOLMOD_PATTERN;
  lower.factor = cholmod_analyze(&matrix, &common);
  require(lower.factor != nullptr, "solve.cholmod.tangent", {{"status", common.status}});
  const double entries = common.lnz; // of L
  if (kind == LinearKind::automatic)
    kind = worth_reusing(2 * common.fl, 2 * entries) ? LinearKind::reuse : LinearKind::klu;
  switch (kind) {
  case LinearKind::klu:
    return {kind, 2 * (sizeof(double) + sizeof(int)) * entries};
  case LinearKind::umfpack:
    return {kind, 2 * sizeof(double) * entries};
  default: // supernodes of L
    return {kind, sizeof(double) * static_cast<double>(lower.factor->xsize)};
  }
}

} // namespace signorini::solve
