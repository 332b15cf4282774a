#include "solve/schur.hpp"

#include "base/error.hpp"
#include "solve/cholmod.hpp"
#include "solve/constants.hpp"
#include "solve/lapack.hpp"
#include "solve/supernodes.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <type_traits>

namespace signorini::solve {

namespace {

cholmod_sparse lower_triangle(const Pattern& pattern, const double* values) {
  cholmod_sparse matrix = upper_triangle(pattern, values);
  matrix.stype = -1;
  if (!values) matrix.xtype = CHOLMOD_PATTERN;
  return matrix;
}

/// The Cholesky factor of P A Pᵀ with a permutation P that orders the border last.
class BorderedFactor {
public:
  explicit BorderedFactor(double dissect_above) : dissect_above_(dissect_above) {
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_NATURAL; // the matrices are ordered by permute()
    common_.final_ll = true;
    common_.supernodal = CHOLMOD_SUPERNODAL;
  }

  void analyze(const Pattern& pattern, const std::vector<int>& border);
  /// The lower triangle of P A Pᵀ for values in the order of the pattern.
  std::vector<double> ordered(const double* values) const;
  /// Position in it of the diagonal entry of row k.
  int diagonal(int k) const { return ordered_.starts[k]; }
  /// Factors the matrix with these values of its lower triangle. Returns false if it is not positive definite.
  bool factor(const std::vector<double>& ordered_values);
  /// True if the last factorization ended in the border.
  bool ended_in_border() const {
    return common_.status == CHOLMOD_NOT_POSDEF && static_cast<int>(lower_.factor->minor) >= interior();
  }
  int size() const { return pattern_.size; }
  int interior() const { return interior_; }
  /// Unknown at each row of L.
  const std::vector<int>& order() const { return order_; }
  cholmod_factor& lower() const { return *lower_.factor; }
  double operations() const { return common_.fl; }

private:
  void permute();
  void analyze_in_order(const std::vector<int>& order, bool postorder);
  bool order_by_degree(cholmod_sparse& matrix);
  void dissect(cholmod_sparse& matrix);

  double dissect_above_;
  CholmodCommon common_;
  CholmodFactor lower_{common_};
  Pattern pattern_;
  int interior_ = 0;
  std::vector<char> last_; ///< marks the border
  struct {
    std::vector<int> order;     ///< METIS' ordering of all unknowns
    std::vector<int> postorder; ///< made of it
    std::vector<char> last;     ///< the border then
    double operations = 0;      ///< with it, for the pattern it was made for
  } dissection_;
  std::vector<int> order_;
  Pattern ordered_;          ///< lower triangle of P A Pᵀ
  std::vector<int> sources_; ///< positions of its entries in pattern_
};

/// Orders the matrix once: CHOLMOD would do so three times in an analysis and again for every factorization.
void BorderedFactor::permute() {
  std::vector<int> place(size());
  for (int k = 0; k < size(); ++k) place[order_[k]] = k;
  // Calls visit(row, column, position of the transposed entry) with increasing rows.
  const auto visit_lower = [&](const auto& visit) {
    for (int row = 0; row < size(); ++row) {
      const std::size_t from = order_[row];
      for (int k = pattern_.starts[from]; k < pattern_.starts[from + 1]; ++k)
        if (const int column = place[pattern_.rows[k]]; column <= row) visit(row, column, k);
    }
  };
  ordered_.size = size();
  ordered_.starts.assign(size() + 1, 0);
  visit_lower([&](int, int column, int) { ++ordered_.starts[column + 1]; });
  std::partial_sum(ordered_.starts.begin(), ordered_.starts.end(), ordered_.starts.begin());
  ordered_.rows.resize(ordered_.starts.back());
  sources_.resize(ordered_.rows.size());
  std::vector<int> next(ordered_.starts.begin(), ordered_.starts.end() - 1);
  visit_lower([&](int row, int column, int position) {
    const std::size_t k = next[column]++;
    ordered_.rows[k] = row;
    sources_[k] = position;
  });
}

/// Analyzes with an ordering in which the border is moved to the end.
void BorderedFactor::analyze_in_order(const std::vector<int>& order, bool postorder) {
  order_ = order;
  std::stable_partition(order_.begin(), order_.end(), [&](int unknown) { return !last_[unknown]; });
  permute();
  cholmod_sparse matrix = lower_triangle(ordered_, nullptr);
  common_.postorder = postorder;
  cholmod_free_factor(&lower_.factor, &common_);
  lower_.factor = cholmod_analyze(&matrix, &common_);
  require(lower_.factor != nullptr, "solve.cholmod.matrix", {{"status", common_.status}});
  if (!postorder) return;
  const int* found = static_cast<int*>(lower_.factor->Perm);
  const std::vector<int> before = order_;
  for (int k = 0; k < size(); ++k) order_[k] = before[found[k]];
}

bool BorderedFactor::order_by_degree(cholmod_sparse& matrix) {
  std::vector<int> order(size()), sets(size(), 0);
  // CAMD expects set numbers below the number of unknowns.
  if (interior() > 0) sets.assign(last_.begin(), last_.end());
  if (!cholmod_camd(&matrix, nullptr, 0, sets.data(), order.data(), &common_)) return false;
  analyze_in_order(order, false); // a postorder would move the border forward
  return true;
}

void BorderedFactor::dissect(cholmod_sparse& matrix) {
  // Postordering forms supernodes but moves the border forward, so the order is corrected and analyzed again.
  const auto analyze_dissection = [&] {
    if (dissection_.last != last_) {
      analyze_in_order(dissection_.order, true);
      dissection_.postorder = order_;
      dissection_.last = last_;
    }
    analyze_in_order(dissection_.postorder, false);
  };
  if (!dissection_.order.empty()) analyze_dissection();
  if (!dissection_.order.empty() && common_.fl <= stale_dissection * dissection_.operations) return;
  dissection_.order.resize(size());
  dissection_.last.clear();
  require(cholmod_metis(&matrix, nullptr, 0, true, dissection_.order.data(), &common_), "solve.cholmod.order",
          {{"status", common_.status}});
  analyze_dissection();
  dissection_.operations = common_.fl;
}

void BorderedFactor::analyze(const Pattern& pattern, const std::vector<int>& border) {
  pattern_ = pattern;
  interior_ = size() - static_cast<int>(std::ssize(border));
  last_.assign(size(), 0);
  for (int unknown : border) last_[unknown] = 1;
  cholmod_sparse matrix = upper_triangle(pattern_, nullptr);
  matrix.xtype = CHOLMOD_PATTERN;
  const bool by_degree = dissect_above_ > 0 && order_by_degree(matrix);
  if (by_degree && common_.fl <= dissect_above_ * common_.lnz) return;
  const double fewest = by_degree ? common_.fl : std::numeric_limits<double>::infinity();
  CholmodFactor other(common_);
  const std::vector<int> other_order = order_;
  std::swap(lower_.factor, other.factor);
  dissect(matrix);
  if (common_.fl >= fewest) {
    std::swap(lower_.factor, other.factor);
    order_ = other_order;
    permute();
  }
}

std::vector<double> BorderedFactor::ordered(const double* values) const {
  std::vector<double> result(sources_.size());
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = values[sources_[k]];
  return result;
}

bool BorderedFactor::factor(const std::vector<double>& ordered_values) {
  cholmod_sparse matrix = lower_triangle(ordered_, ordered_values.data());
  factorize(matrix, lower_.factor, common_);
  return common_.status == CHOLMOD_OK && lower_.factor->minor >= lower_.factor->n;
}

/// With a shift D of the border's diagonal, so that A_cc need not be positive definite,
///     P (A + D) Pᵀ = L Lᵀ, S = L_cc L_ccᵀ − D,
/// so that A x = b is solved by L_ii z_i = b_i, S x_c = b_c − L_ci z_i, L_iiᵀ x_i = z_i − L_ciᵀ x_c, with the values of
/// L_ii and L_ci rounded to Real.
template <class Real> class SchurCholesky final : public SchurSolver {
public:
  explicit SchurCholesky(double dissect_above) : bordered_(dissect_above) {}

  void analyze(const Pattern& pattern, const std::vector<int>& border) override;
  bool factor(const double* values) override;
  const std::vector<int>& border() const override { return border_; }
  const MatrixX& complement() const override { return complement_; }
  bool solve(double* b, const std::function<bool(double*)>& middle) override;
  PivotRange pivots() const override { return pivots_; }
  SolverStatistics statistics() const override { return statistics_; }

private:
  bool factor_shifted(const double* values);
  void read_factor(MatrixX& corner);
  void round_values();

  BorderedFactor bordered_;
  Supernodes<Real> triangular_;
  std::vector<int> border_; ///< in its order
  double raise_ = 1;        ///< factor on the shifts
  bool raises_ = false;     ///< true if the last matrix has rows without a positive diagonal
  MatrixX complement_;      ///< S
  PivotRange pivots_;
  typename Supernodes<Real>::Vector right_;
  VectorX part_;
  SolverStatistics statistics_;
};

template <class Real> void SchurCholesky<Real>::analyze(const Pattern& pattern, const std::vector<int>& border) {
  bordered_.analyze(pattern, border);
  border_.assign(bordered_.order().begin() + bordered_.interior(), bordered_.order().end());
  statistics_.operations = bordered_.operations();
  triangular_.analyze(bordered_.lower(), bordered_.interior());
  right_.resize(bordered_.size());
  part_.resize(border_.size());
}

template <class Real> bool SchurCholesky<Real>::factor(const double* values) {
  bool factored = factor_shifted(values);
  // If the factorization ends in the border, the shifts were too small.
  while (!factored && bordered_.ended_in_border() && raise_ < (raises_ ? most_raise : raise_step)) {
    raise_ *= raise_step;
    factored = factor_shifted(values);
  }
  if (!factored) raise_ = 1;
  return factored && pivots_.regular();
}

/// Factors the matrix with shifts on the border's diagonal, which makes it positive definite, and removes them from the
/// complement. The rows of multipliers have no positive entry to derive a shift from; contact far from equilibrium can
/// make the block of others indefinite.
template <class Real> bool SchurCholesky<Real>::factor_shifted(const double* values) {
  std::vector<double> shifted = bordered_.ordered(values);
  VectorX shift = VectorX::Zero(border_.size());
  raises_ = false;
  double largest = 0;
  for (double value : shifted) largest = std::max(largest, std::abs(value));
  for (int k = 0; k < shift.size(); ++k) {
    double& value = shifted[bordered_.diagonal(bordered_.interior() + k)];
    raises_ = raises_ || value <= 0;
    shift(k) = value > 0 ? std::min(raise_, raise_step) * value : raise_ * largest;
    value += shift(k);
  }
  const bool factored = bordered_.factor(shifted);
  ++statistics_.factorizations;
  statistics_.operations = bordered_.operations();
  const double entries = static_cast<double>(bordered_.lower().xsize);
  statistics_.entries = 2 * entries * sizeof(Real) / sizeof(double); // forward and back substitution
  statistics_.memory = sizeof(double) * entries;
  if (!factored) return false;
  MatrixX corner;
  read_factor(corner);
  round_values();
  const int rows = std::ssize(border_);
  const double one = 1, zero = 0;
  complement_.setZero(rows, rows);
  if (rows > 0) dsyrk_("L", "N", &rows, &rows, &one, corner.data(), &rows, &zero, complement_.data(), &rows);
  complement_.diagonal() -= shift;
  complement_.triangularView<Eigen::StrictlyUpper>() = complement_.transpose();
  return true;
}

/// Reads L_cc and the pivots of A_ii from L.
template <class Real> void SchurCholesky<Real>::read_factor(MatrixX& corner) {
  const cholmod_factor& lower = bordered_.lower();
  const int interior = bordered_.interior();
  const double* values = static_cast<double*>(lower.x);
  const int *rows = static_cast<int*>(lower.s), *first = static_cast<int*>(lower.super),
            *rows_from = static_cast<int*>(lower.pi), *values_from = static_cast<int*>(lower.px);
  corner.setZero(std::ssize(border_), std::ssize(border_));
  pivots_ = {};
  for (int s = 0; s < static_cast<int>(lower.nsuper); ++s) {
    const int height = rows_from[s + 1] - rows_from[s];
    for (int j = first[s]; j < first[s + 1]; ++j) {
      const int above = j - first[s]; // the column's values and rows from its diagonal on
      const double* value = values + values_from[s] + above + static_cast<std::ptrdiff_t>(above) * height;
      const int* row = rows + rows_from[s] + above;
      if (j < interior)
        pivots_.add(*value * *value);
      else
        for (int k = 0; k < height - above; ++k) corner(row[k] - interior, j - interior) = value[k];
    }
  }
}

/// Rounds the values of L in place: a triangular solve takes as long as reading them from memory.
template <class Real> void SchurCholesky<Real>::round_values() {
  if constexpr (!std::is_same_v<Real, double>) {
    const cholmod_factor& lower = bordered_.lower();
    const double* values = static_cast<double*>(lower.x);
    char* rounded = static_cast<char*>(lower.x);
    for (std::size_t k = 0; k < lower.xsize; ++k) {
      const Real value = static_cast<Real>(values[k]);
      std::memcpy(rounded + k * sizeof(Real), &value, sizeof(Real));
    }
  }
}

template <class Real> bool SchurCholesky<Real>::solve(double* b, const std::function<bool(double*)>& middle) {
  const std::vector<int>& order = bordered_.order();
  for (int k = 0; k < std::ssize(order); ++k) right_(k) = static_cast<Real>(b[order[k]]);
  const Real* values = static_cast<Real*>(bordered_.lower().x);
  triangular_.solve_lower(values, right_);
  auto tail = right_.tail(part_.size());
  part_ = tail.template cast<double>();
  if (!middle(part_.data())) return false;
  tail = part_.template cast<Real>();
  triangular_.solve_upper(values, right_);
  for (int k = 0; k < std::ssize(order); ++k) b[order[k]] = static_cast<double>(right_(k));
  return true;
}

} // namespace

std::unique_ptr<SchurSolver> make_schur_cholesky(double dissect_above, Precision precision) {
  if (precision == Precision::single) return std::make_unique<SchurCholesky<float>>(dissect_above);
  return std::make_unique<SchurCholesky<double>>(dissect_above);
}

} // namespace signorini::solve
