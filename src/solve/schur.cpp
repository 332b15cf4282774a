#include "solve/schur.hpp"

#include <utility>

namespace signorini::solve {

namespace {

/// Using any direct solver of A_ii: one solution per unknown of the border, and two per system.
class BySolutions final : public SchurSolver {
public:
  explicit BySolutions(std::unique_ptr<DirectSolver> interior) : solver_(std::move(interior)) {}

  void analyze(const Pattern& pattern, const std::vector<int>& border) override {
    border_ = border;
    interior_.clear();
    entries_.clear();
    inner_.clear();
    // Index in the interior, or −1 − index in the border
    std::vector<int> place(pattern.size, 0);
    for (std::size_t k = 0; k < border.size(); ++k) place[border[k]] = -1 - static_cast<int>(k);
    for (int i = 0; i < pattern.size; ++i)
      if (place[i] == 0) {
        place[i] = std::ssize(interior_);
        interior_.push_back(i);
      }
    Pattern inner{static_cast<int>(interior_.size()), {0}, {}};
    for (int j = 0; j < pattern.size; ++j) {
      for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k) {
        const int row = place[pattern.rows[k]], column = place[j];
        if (row >= 0 && column >= 0) {
          inner.rows.push_back(row);
          inner_.push_back(k);
        } else if (column < 0) {
          entries_.push_back({k, row, -1 - column});
        }
      }
      if (place[j] >= 0) inner.starts.push_back(inner.entries());
    }
    if (!interior_.empty()) solver_->analyze(inner);
  }

  /// A is symmetric: the border's columns also contain A_ci.
  bool factor(const double* values) override {
    const int inside = std::ssize(interior_), size = std::ssize(border_);
    std::vector<double> inner(inner_.size());
    for (std::size_t k = 0; k < inner.size(); ++k) inner[k] = values[inner_[k]];
    if (inside > 0 && !solver_->factor(inner.data())) return false;
    coupling_.setZero(inside, size);
    complement_.setZero(size, size);
    for (const Entry& entry : entries_)
      (entry.row >= 0 ? coupling_(entry.row, entry.column) : complement_(-1 - entry.row, entry.column)) =
          values[entry.position];
    for (int c = 0; c < size; ++c) {
      inside_ = coupling_.col(c);
      if (!solve_interior()) return false;
      complement_.col(c).noalias() -= coupling_.transpose() * inside_;
    }
    return true;
  }

  const std::vector<int>& border() const override { return border_; }
  const MatrixX& complement() const override { return complement_; }

  bool solve(double* b, const std::function<bool(double*)>& middle) override {
    const Eigen::Map<VectorX> all(b, static_cast<int>(interior_.size() + border_.size()));
    const VectorX given = all(interior_);
    inside_ = given;
    if (!solve_interior()) return false;
    VectorX rest = all(border_) - coupling_.transpose() * inside_;
    if (!middle(rest.data())) return false;
    inside_ = given - coupling_ * rest;
    if (!solve_interior()) return false;
    for (std::size_t k = 0; k < interior_.size(); ++k) b[interior_[k]] = inside_(static_cast<int>(k));
    for (std::size_t k = 0; k < border_.size(); ++k) b[border_[k]] = rest(static_cast<int>(k));
    return true;
  }

  PivotRange pivots() const override { return interior_.empty() ? PivotRange() : solver_->pivots(); }
  SolverStatistics statistics() const override { return solver_->statistics(); }

private:
  struct Entry {
    int position; ///< in the pattern
    int row;      ///< index in the interior, or −1 − index in the border
    int column;   ///< index in the border
  };
  bool solve_interior() { return interior_.empty() || solver_->solve(inside_.data()); }

  std::unique_ptr<DirectSolver> solver_;
  std::vector<int> border_, interior_;
  std::vector<int> inner_;        ///< positions of A_ii in the pattern
  std::vector<Entry> entries_;    ///< the border's columns
  MatrixX coupling_, complement_; ///< A_ic, S
  VectorX inside_;
};

} // namespace

std::unique_ptr<SchurSolver> make_schur(std::unique_ptr<DirectSolver> interior) {
  return std::make_unique<BySolutions>(std::move(interior));
}

} // namespace signorini::solve
