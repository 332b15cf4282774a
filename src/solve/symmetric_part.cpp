#include "solve/symmetric_part.hpp"

#include "base/error.hpp"
#include "solve/cholmod.hpp"
#include "solve/values.hpp"

#include <algorithm>

namespace signorini::solve {

struct SymmetricPart::Factors {
  CholmodCommon common;
  CholmodFactor lower{common};
  CholmodSolve triangular{common};
};

SymmetricPart::SymmetricPart() : factors_(std::make_unique<Factors>()) {}
SymmetricPart::~SymmetricPart() = default;

void SymmetricPart::analyse(const Pattern& pattern) {
  CholmodCommon& common = factors_->common;
  cholmod_factor*& lower = factors_->lower.factor;
  cholmod_sparse matrix = lower_triangle(pattern, nullptr);
  matrix.xtype = CHOLMOD_PATTERN;
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.nmethods = 1;
  const auto analyse_with = [&](int ordering, int* order) {
    cholmod_free_factor(&lower, &common);
    common.method[0].ordering = ordering;
    lower = cholmod_analyze_p(&matrix, order, nullptr, 0, &common);
    require(lower != nullptr, "the sparse solver could not analyse the tangent (CHOLMOD status ", common.status, ")");
  };
  // Contacts that slide on add few entries; a new dissection takes as long as a few factorisations.
  constexpr double worse = 1.2;
  if (!order_.empty()) analyse_with(CHOLMOD_GIVEN, order_.data());
  if (order_.empty() || common.fl > worse * best_) {
    analyse_with(CHOLMOD_METIS, nullptr);
    const int* order = static_cast<int*>(lower->Perm);
    order_.assign(order, order + lower->n);
    best_ = common.fl;
  }
  analysed_ = true;
}

bool SymmetricPart::factor(const Pattern& pattern, const double* values, const std::vector<double>& transposed) {
  values_.resize(transposed.size());
  for (std::size_t k = 0; k < values_.size(); ++k) values_[k] = 0.5 * (values[k] + transposed[k]);
  if (!analysed_) analyse(pattern);
  auto& [common, lower, triangular] = *factors_;
  cholmod_sparse matrix = lower_triangle(pattern, values_.data());
  factorize(matrix, lower.factor, common);
  count(*lower.factor, common, statistics_);
  return common.status == CHOLMOD_OK && cholmod_rcond(lower.factor, &common) > least_pivot;
}

bool SymmetricPart::solve(double* b) {
  ++statistics_.solutions;
  auto& [common, lower, triangular] = *factors_;
  const double* x = triangular(CHOLMOD_A, lower.factor, b);
  if (!x) return false;
  std::copy_n(x, lower.factor->n, b);
  return true;
}

} // namespace signorini::solve
