#include "solve/direct.hpp"

#include "base/index.hpp"
#include "solve/band_order.hpp"
#include "solve/lapack.hpp"

#include <optional>

namespace signorini::solve {

namespace {

class Banded final : public DirectSolver {
public:
  void analyze(const Pattern& pattern) override {
    pattern_ = pattern;
    symmetry_.emplace(pattern);
    order_ = band_order(pattern);
    place_.resize(order_.size());
    for (std::size_t k = 0; k < order_.size(); ++k) place_[at(order_[k])] = static_cast<int>(k);
    band_ = band_width(pattern, order_);
    exchanges_.resize(order_.size());
    right_.resize(order_.size());
  }

  bool factor(const double* values) override {
    ++statistics_.factorisations;
    definite_ = symmetry_->holds(values) && factor_definite(values);
    return definite_ || factor_with_pivots(values);
  }

  bool solve(double* b) override {
    ++statistics_.solutions;
    for (std::size_t k = 0; k < order_.size(); ++k) right_[k] = b[order_[k]];
    const int one = 1, size = pattern_.size, leading = definite_ ? band_ + 1 : 3 * band_ + 1;
    int info = 0;
    if (definite_)
      dpbtrs_("L", &size, &band_, &one, factors_.data(), &leading, right_.data(), &size, &info);
    else
      dgbtrs_("N", &size, &band_, &band_, &one, factors_.data(), &leading, exchanges_.data(), right_.data(), &size,
              &info);
    for (std::size_t k = 0; k < order_.size(); ++k) b[order_[k]] = right_[k];
    return info == 0;
  }
  PivotRange pivots() const override { return pivots_; }
  SolverStatistics statistics() const override { return statistics_; }

private:
  /// LAPACK keeps a_ij at row i − j + `diagonal` of column j, columns `leading` apart.
  template <bool Lower> void spread(const double* values, int leading, int diagonal) {
    factors_.assign(at(leading) * order_.size(), 0.0);
    statistics_.entries = static_cast<double>(factors_.size());
    statistics_.memory = sizeof(double) * statistics_.entries;
    for (int j = 0; j < pattern_.size; ++j) {
      const int column = place_[at(j)];
      double* to = factors_.data() + at(leading) * at(column) + diagonal - column;
      for (int k = pattern_.starts[at(j)]; k < pattern_.starts[at(j) + 1]; ++k) {
        const int row = place_[at(pattern_.rows[at(k)])];
        if (!Lower || row >= column) to[row] = values[k];
      }
    }
  }

  bool factor_definite(const double* values) {
    const int size = pattern_.size, leading = band_ + 1;
    spread<true>(values, leading, 0);
    int info = 0;
    dpbtrf_("L", &size, &band_, factors_.data(), &leading, &info);
    return info == 0 && regular(leading, 0, [](double pivot) { return pivot * pivot; });
  }

  bool factor_with_pivots(const double* values) {
    const int size = pattern_.size, leading = 3 * band_ + 1;
    spread<false>(values, leading, 2 * band_);
    int info = 0;
    dgbtrf_(&size, &size, &band_, &band_, factors_.data(), &leading, exchanges_.data(), &info);
    return info == 0 && regular(leading, 2 * band_, [](double pivot) { return pivot; });
  }

  /// `power` makes pivots of the matrix of the diagonal of its factors.
  template <class Power> bool regular(int leading, int diagonal, Power power) {
    pivots_ = {};
    for (std::size_t k = 0; k < order_.size(); ++k) pivots_.add(power(factors_[at(leading) * k + at(diagonal)]));
    return pivots_.regular();
  }

  Pattern pattern_;
  std::optional<Symmetry> symmetry_;
  std::vector<int> order_, place_;
  int band_ = 0;
  bool definite_ = false;
  PivotRange pivots_;
  std::vector<int> exchanges_; ///< of rows, by LAPACK's numbers
  std::vector<double> factors_, right_;
  SolverStatistics statistics_;
};

} // namespace

std::unique_ptr<DirectSolver> make_banded() {
  return std::make_unique<Banded>();
}

} // namespace signorini::solve
