#include "solve/condensed.hpp"

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "base/index.hpp"
#include "solve/changing_block.hpp"
#include "solve/cholmod.hpp"
#include "solve/lapack.hpp"
#include "solve/values.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace signorini::solve {

namespace {

/// With the contact unknowns c behind the interior i, and a shift D of their diagonal that makes K₀ regular where only
/// contact holds a body,
///     P (K₀ + D) Pᵀ = L Lᵀ,   S = K_cc − K_ci K_ii⁻¹ K_ic = L_cc L_ccᵀ − D,
/// so that K x = b is L z = P b, (S + C) x_c = L_cc z_c, Lᵀ x = (z_i, L_ccᵀ x_c).
class Condensed final : public LinearSolver {
public:
  Condensed(const Pattern& pattern, const Condensation& condensation);

  bool factor(const double* values) override;
  bool solve(double* b) override;
  LinearKind kind() const override { return LinearKind::condensed; }
  SolverStatistics statistics() const override { return statistics_; }

private:
  struct Entry {
    int position;    ///< in the pattern
    int row, column; ///< places among the contact unknowns
    double constant; ///< its part of K₀
  };

  void factor_bulk(const Pattern& pattern, const Condensation& condensation, const std::vector<char>& touched);
  void order(cholmod_sparse& matrix, const std::vector<char>& touched);

  int size_, contacts_;
  CholmodCommon common_;
  CholmodFactor bulk_{common_};
  CholmodSolve triangular_{common_};
  std::vector<int> unknowns_; ///< unknown at each place of L
  std::vector<Entry> entries_;
  bool regular_ = false;
  PivotRange interior_;
  MatrixX corner_;      ///< L_cc
  ChangingBlock block_; ///< S + C
  std::vector<ChangingBlock::Change> changes_;
  std::vector<char> touched_, beside_; ///< contact unknowns that C touches; and those coupled with them
  VectorX right_, contact_;
  SolverStatistics statistics_;
};

void check(const Pattern& pattern, const Condensation& condensation) {
  const auto& [constant, contact] = condensation;
  require(constant.size() == pattern.rows.size(), "condensed solver: the constant matrix has ", constant.size(),
          " values, expected ", pattern.rows.size(), ", one for each entry of the pattern");
  const bool increases = std::adjacent_find(contact.begin(), contact.end(), std::greater_equal<>()) == contact.end();
  require(increases && (contact.empty() || (contact.front() >= 0 && contact.back() < pattern.size)),
          "condensed solver: the contact unknowns must increase and lie in 0 … ", pattern.size - 1);
  require(Symmetry(pattern).holds(constant.data()), "condensed solver: the constant matrix is not symmetric");
}

Condensed::Condensed(const Pattern& pattern, const Condensation& condensation)
    : size_(pattern.size), contacts_(static_cast<int>(condensation.contact.size())), touched_(at(contacts_)),
      beside_(at(contacts_)), right_(size_), contact_(contacts_) {
  check(pattern, condensation);
  std::vector<char> touched(at(size_), 0);
  for (int unknown : condensation.contact) touched[at(unknown)] = 1;
  factor_bulk(pattern, condensation, touched);
  if (!regular_) return;

  std::vector<int> place(at(size_), -1);
  for (int k = size_ - contacts_; k < size_; ++k) place[at(unknowns_[at(k)])] = k - (size_ - contacts_);
  for (int column : condensation.contact)
    for (int k = pattern.starts[at(column)]; k < pattern.starts[at(column) + 1]; ++k)
      if (const int row = place[at(pattern.rows[at(k)])]; row >= 0)
        entries_.push_back({k, row, place[at(column)], condensation.constant[at(k)]});
  changes_.reserve(entries_.size());
}

/// An ordering with the contact unknowns last: constrained minimum degree, or nested dissection where that is poor, by
/// CHOLMOD's own measure, and dissection better. In two dimensions it is not, and takes longer than the factorisation.
void Condensed::order(cholmod_sparse& matrix, const std::vector<char>& touched) {
  // CSYMAMD numbers its sets from 0 without gaps.
  std::vector<int> constraints(at(size_), 0), trial(at(size_));
  if (contacts_ < size_) constraints.assign(touched.begin(), touched.end());
  common_.nmethods = 1;
  common_.method[0].ordering = CHOLMOD_GIVEN;
  common_.postorder = false;   // it would move contact unknowns forward
  constexpr double poor = 500; // operations per entry of L
  double least = std::numeric_limits<double>::infinity();
  for (bool dissect : {false, true}) {
    if (dissect && common_.fl < poor * common_.lnz) break;
    const bool ordered = dissect ? cholmod_metis(&matrix, nullptr, 0, true, trial.data(), &common_)
                                 : cholmod_csymamd(&matrix, constraints.data(), trial.data(), &common_);
    if (!ordered) continue;
    std::stable_partition(trial.begin(), trial.end(), [&](int unknown) { return !touched[at(unknown)]; });
    CholmodFactor symbolic(common_);
    symbolic.factor = cholmod_analyze_p(&matrix, trial.data(), nullptr, 0, &common_);
    if (!symbolic.factor || common_.fl >= least) continue;
    least = common_.fl;
    unknowns_ = trial;
    std::swap(bulk_.factor, symbolic.factor);
  }
  require(bulk_.factor != nullptr, "the sparse solver could not analyse the constant matrix (CHOLMOD status ",
          common_.status, ")");
}

void Condensed::factor_bulk(const Pattern& pattern, const Condensation& condensation,
                            const std::vector<char>& touched) {
  // Entries that are zero for good, such as the couplings of two faces, cost no fill.
  Pattern kept;
  kept.size = size_;
  kept.starts.push_back(0);
  std::vector<double> values;
  VectorX shift = VectorX::Zero(size_);
  double largest = 0;
  for (double value : condensation.constant) largest = std::max(largest, std::abs(value));
  for (int j = 0; j < size_; ++j) {
    for (int k = pattern.starts[at(j)]; k < pattern.starts[at(j) + 1]; ++k) {
      const int i = pattern.rows[at(k)];
      const double value = condensation.constant[at(k)];
      if (i != j && value == 0) continue;
      if (i == j && touched[at(i)]) shift(i) = value > 0 ? value : largest;
      kept.rows.push_back(i);
      values.push_back(value + (i == j ? shift(i) : 0));
    }
    kept.starts.push_back(kept.entries());
  }
  cholmod_sparse matrix = lower_triangle(kept, values.data());
  order(matrix, touched);
  common_.final_ll = true;
  factorize(matrix, bulk_.factor, common_);
  count(*bulk_.factor, common_, statistics_);
  statistics_.memory += 4.0 * sizeof(double) * contacts_ * contacts_; // L_cc and the changing block
  if (common_.status != CHOLMOD_OK || bulk_.factor->minor < bulk_.factor->n) return;

  CholmodFactor copy(common_);
  copy.factor = cholmod_copy_factor(bulk_.factor, &common_);
  cholmod_sparse* lower = cholmod_factor_to_sparse(copy.factor, &common_);
  require(lower != nullptr, "the sparse solver ran out of memory");
  const int* starts = static_cast<int*>(lower->p);
  const int* rows = static_cast<int*>(lower->i);
  const double* entries = static_cast<double*>(lower->x);
  const int interior = size_ - contacts_;
  corner_.setZero(contacts_, contacts_);
  for (int j = 0; j < size_; ++j)
    for (int k = starts[j]; k < starts[j + 1]; ++k) {
      if (j >= interior) corner_(rows[k] - interior, j - interior) = entries[k];
      if (j >= interior || rows[k] != j) continue;
      interior_.add(entries[k] * entries[k]);
    }
  cholmod_free_sparse(&lower, &common_);

  MatrixX schur = MatrixX::Zero(contacts_, contacts_); // its lower triangle is enough
  const double one = 1, zero = 0;
  if (contacts_ > 0)
    dsyrk_("L", "N", &contacts_, &contacts_, &one, corner_.data(), &contacts_, &zero, schur.data(), &contacts_);
  for (int k = 0; k < contacts_; ++k) schur(k, k) -= shift(unknowns_[at(interior + k)]);
  block_ = ChangingBlock(std::move(schur));
  regular_ = interior_.regular();
}

bool Condensed::factor(const double* values) {
  if (!regular_) return false;
  ++statistics_.factorisations;
  changes_.clear();
  std::fill(touched_.begin(), touched_.end(), 0);
  for (const Entry& entry : entries_) {
    const double change = values[entry.position] - entry.constant;
    if (change == 0) continue;
    changes_.push_back({entry.row, entry.column, change});
    touched_[at(entry.row)] = touched_[at(entry.column)] = 1;
  }
  if (!block_.covers(touched_)) {
    // Contact spreads to what is beside it next.
    beside_ = touched_;
    for (const Entry& entry : entries_)
      if (touched_[at(entry.column)]) beside_[at(entry.row)] = 1;
    block_.condense(beside_);
  }
  PivotRange pivots = interior_;
  block_.factor(changes_, pivots);
  return pivots.regular();
}

bool Condensed::solve(double* b) {
  ++statistics_.solutions;
  const int interior = size_ - contacts_;
  for (int k = 0; k < size_; ++k) right_(k) = b[unknowns_[at(k)]];
  double* z = triangular_(CHOLMOD_L, bulk_.factor, right_.data());
  if (!z) return false;
  if (contacts_ > 0) {
    Eigen::Map<VectorX> tail(z + interior, contacts_);
    contact_.noalias() = corner_.triangularView<Eigen::Lower>() * tail;
    block_.solve(contact_.data());
    tail.noalias() = corner_.transpose().triangularView<Eigen::Upper>() * contact_;
  }
  right_ = Eigen::Map<const VectorX>(z, size_);
  const double* x = triangular_(CHOLMOD_Lt, bulk_.factor, right_.data());
  if (!x) return false;
  for (int k = 0; k < size_; ++k) b[unknowns_[at(k)]] = x[k];
  return true;
}

} // namespace

std::unique_ptr<LinearSolver> make_condensed(const Pattern& pattern, const Condensation& condensation) {
  return std::make_unique<Condensed>(pattern, condensation);
}

} // namespace signorini::solve
