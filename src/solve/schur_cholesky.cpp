#include "solve/schur.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "solve/cholmod.hpp"
#include "solve/constants.hpp"
#include "solve/lapack.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <limits>

namespace signorini::solve {

namespace {

/// A function of the OpenMP library that CHOLMOD has loaded, or nullptr if it was built without.
template <class F> F* openmp(const char* name) {
  return reinterpret_cast<F*>(dlsym(RTLD_DEFAULT, name));
}

/// Factors without CHOLMOD's own threads: it requests four from OpenMP, whatever the user or the machine has, for loops
/// far shorter than the start of a thread. BLAS keeps its threads.
void factorize(cholmod_sparse& matrix, cholmod_factor* factor, cholmod_common& common) {
  static auto* const depth = openmp<int()>("omp_get_max_active_levels");
  static auto* const set_depth = openmp<void(int)>("omp_set_max_active_levels");
  const int before = depth ? depth() : 0;
  if (depth && set_depth) set_depth(0);
  cholmod_factorize(&matrix, factor, &common);
  if (depth && set_depth) set_depth(before);
}

/// With a shift D of the border's diagonal, so that A_cc need not be positive definite,
///     P (A + D) Pᵀ = L Lᵀ, S = L_cc L_ccᵀ − D,
/// so that A x = b is solved by L z = P b, S x_c = L_cc z_c, Lᵀ x = (z_i, L_ccᵀ x_c).
class SchurCholesky final : public SchurSolver {
public:
  explicit SchurCholesky(double dissect_above) : dissect_above_(dissect_above) {
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_GIVEN;
    common_.final_ll = true;
  }

  void analyze(const Pattern& pattern, const std::vector<int>& border) override;
  bool factor(const double* values) override;
  const std::vector<int>& border() const override { return border_; }
  const MatrixX& complement() const override { return complement_; }
  bool solve(double* b, const std::function<bool(double*)>& middle) override;
  PivotRange pivots() const override { return pivots_; }
  SolverStatistics statistics() const override { return statistics_; }

private:
  int size() const { return pattern_.size; }
  int interior() const { return size() - static_cast<int>(border_.size()); }
  void analyze_in_order(cholmod_sparse& matrix, const std::vector<int>& order, bool postorder);
  bool order_by_degree(cholmod_sparse& matrix);
  void dissect(cholmod_sparse& matrix);
  bool factor_shifted(const double* values);
  void read_factor();

  double dissect_above_;
  CholmodCommon common_;
  CholmodFactor lower_{common_};
  CholmodSolve triangular_{common_};
  Pattern pattern_;
  std::vector<char> last_;      ///< marks the border
  std::vector<int> dissection_; ///< METIS' ordering of all unknowns
  double best_ = 0;             ///< operations with it, for the pattern it was made for
  double raise_ = 1;            ///< factor on the shifts of rows without a positive diagonal
  bool raises_ = false;         ///< whether the last matrix has such rows
  std::vector<int> order_;      ///< unknown at each row of L
  std::vector<int> border_;     ///< its last part
  MatrixX corner_, complement_; ///< L_cc, S
  PivotRange pivots_;
  VectorX right_, part_;
  SolverStatistics statistics_;
};

/// Analyzes with an ordering in which the border is moved to the end.
void SchurCholesky::analyze_in_order(cholmod_sparse& matrix, const std::vector<int>& order, bool postorder) {
  order_ = order;
  std::stable_partition(order_.begin(), order_.end(), [&](int unknown) { return !last_[at(unknown)]; });
  common_.postorder = postorder;
  cholmod_free_factor(&lower_.factor, &common_);
  lower_.factor = cholmod_analyze_p(&matrix, order_.data(), nullptr, 0, &common_);
  require(lower_.factor != nullptr, "solve.cholmod.matrix", {{"status", common_.status}});
  const int* found = static_cast<int*>(lower_.factor->Perm);
  order_.assign(found, found + size());
}

bool SchurCholesky::order_by_degree(cholmod_sparse& matrix) {
  std::vector<int> order(at(size())), sets(at(size()), 0);
  // CAMD expects set numbers below the number of unknowns.
  if (interior() > 0) sets.assign(last_.begin(), last_.end());
  if (!cholmod_camd(&matrix, nullptr, 0, sets.data(), order.data(), &common_)) return false;
  analyze_in_order(matrix, order, false); // a postorder would move the border forward
  return true;
}

void SchurCholesky::dissect(cholmod_sparse& matrix) {
  // Postordering forms supernodes but moves the border forward, so the order is corrected and analyzed again.
  const auto analyze_dissection = [&] {
    analyze_in_order(matrix, dissection_, true);
    analyze_in_order(matrix, order_, false);
  };
  if (!dissection_.empty()) analyze_dissection();
  if (!dissection_.empty() && common_.fl <= stale_dissection * best_) return;
  dissection_.resize(at(size()));
  require(cholmod_metis(&matrix, nullptr, 0, true, dissection_.data(), &common_), "solve.cholmod.order",
          {{"status", common_.status}});
  analyze_dissection();
  best_ = common_.fl;
}

void SchurCholesky::analyze(const Pattern& pattern, const std::vector<int>& border) {
  pattern_ = pattern;
  border_ = border;
  last_.assign(at(size()), 0);
  for (int unknown : border) last_[at(unknown)] = 1;
  cholmod_sparse matrix = lower_triangle(pattern_, nullptr);
  matrix.xtype = CHOLMOD_PATTERN;
  const bool by_degree = dissect_above_ > 0 && order_by_degree(matrix);
  if (!by_degree || common_.fl > dissect_above_ * common_.lnz) {
    const double fewest = by_degree ? common_.fl : std::numeric_limits<double>::infinity();
    CholmodFactor other(common_);
    std::vector<int> other_order = order_;
    std::swap(lower_.factor, other.factor);
    dissect(matrix);
    if (common_.fl >= fewest) {
      std::swap(lower_.factor, other.factor);
      order_ = other_order;
    }
  }
  border_.assign(order_.begin() + interior(), order_.end());
  statistics_.operations = common_.fl;
  right_.resize(size());
  part_.resize(border_.size());
}

bool SchurCholesky::factor(const double* values) {
  bool factored = factor_shifted(values);
  // If the factorization ends in the border, the shift of a row without a positive diagonal was too small.
  while (!factored && raises_ && common_.status == CHOLMOD_NOT_POSDEF && raise_ < most_raise &&
         static_cast<int>(lower_.factor->minor) >= interior()) {
    raise_ *= raise_step;
    factored = factor_shifted(values);
  }
  if (!factored) raise_ = 1;
  return factored && pivots_.regular();
}

/// Factors the matrix with shifts on the border's diagonal, which makes it positive definite, and removes them from the
/// complement. The rows of multipliers have no positive entry to derive a shift from.
bool SchurCholesky::factor_shifted(const double* values) {
  std::vector<double> shifted(values, values + pattern_.entries());
  VectorX shift = VectorX::Zero(border_.size());
  double largest = 0;
  raises_ = false;
  for (double value : shifted) largest = std::max(largest, std::abs(value));
  for (int k = 0; k < shift.size(); ++k) {
    double& value = shifted[at(pattern_.find(border_[at(k)], border_[at(k)]))];
    raises_ = raises_ || value <= 0;
    shift(k) = value > 0 ? value : raise_ * largest;
    value += shift(k);
  }
  cholmod_sparse matrix = lower_triangle(pattern_, shifted.data());
  factorize(matrix, lower_.factor, common_);
  ++statistics_.factorizations;
  statistics_.operations = common_.fl;
  statistics_.entries = 2 * common_.lnz; // forward and back substitution
  statistics_.memory = lower_.factor->is_super
                           ? sizeof(double) * static_cast<double>(lower_.factor->xsize)
                           : (sizeof(double) + sizeof(int)) * static_cast<double>(lower_.factor->nzmax);
  if (common_.status != CHOLMOD_OK || lower_.factor->minor < lower_.factor->n) return false;
  read_factor();
  const int rows = static_cast<int>(border_.size());
  const double one = 1, zero = 0;
  complement_.setZero(rows, rows);
  if (rows > 0) dsyrk_("L", "N", &rows, &rows, &one, corner_.data(), &rows, &zero, complement_.data(), &rows);
  complement_.diagonal() -= shift;
  complement_.triangularView<Eigen::StrictlyUpper>() = complement_.transpose();
  return true;
}

/// Reads L_cc and the pivots of A_ii from L.
void SchurCholesky::read_factor() {
  const cholmod_factor& lower = *lower_.factor;
  const double* values = static_cast<double*>(lower.x);
  const int *rows = static_cast<int*>(lower.is_super ? lower.s : lower.i), first_row = interior();
  corner_.setZero(size() - first_row, size() - first_row);
  pivots_ = {};
  // A column of L from its diagonal on: the values and their rows.
  const auto read = [&](int column, int entries, const double* value, const int* row) {
    if (column < first_row) return pivots_.add(*value * *value);
    for (int k = 0; k < entries; ++k) corner_(row[k] - first_row, column - first_row) = value[k];
  };
  if (!lower.is_super) {
    const int *starts = static_cast<int*>(lower.p), *entries = static_cast<int*>(lower.nz);
    for (int j = 0; j < size(); ++j) read(j, entries[j], values + starts[j], rows + starts[j]);
    return;
  }
  const int *first = static_cast<int*>(lower.super), *rows_from = static_cast<int*>(lower.pi),
            *values_from = static_cast<int*>(lower.px);
  for (int s = 0; s < static_cast<int>(lower.nsuper); ++s) {
    const int height = rows_from[s + 1] - rows_from[s];
    for (int j = first[s]; j < first[s + 1]; ++j) {
      const int above = j - first[s];
      read(j, height - above, values + values_from[s] + above + static_cast<std::ptrdiff_t>(above) * height,
           rows + rows_from[s] + above);
    }
  }
}

bool SchurCholesky::solve(double* b, const std::function<bool(double*)>& middle) {
  for (int k = 0; k < size(); ++k) right_(k) = b[order_[at(k)]];
  double* z = triangular_(CHOLMOD_L, lower_.factor, right_.data());
  if (!z) return false;
  Eigen::Map<VectorX> tail(z + interior(), size() - interior());
  if (tail.size() > 0) {
    part_.noalias() = corner_.triangularView<Eigen::Lower>() * tail;
    if (!middle(part_.data())) return false;
    tail.noalias() = corner_.transpose().triangularView<Eigen::Upper>() * part_;
  }
  right_ = Eigen::Map<const VectorX>(z, size());
  const double* x = triangular_(CHOLMOD_Lt, lower_.factor, right_.data());
  if (!x) return false;
  for (int k = 0; k < size(); ++k) b[order_[at(k)]] = x[k];
  return true;
}

} // namespace

std::unique_ptr<SchurSolver> make_schur_cholesky(double dissect_above) {
  return std::make_unique<SchurCholesky>(dissect_above);
}

} // namespace signorini::solve
