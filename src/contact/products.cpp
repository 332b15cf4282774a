#include "contact/products.hpp"

#include "contact/constants.hpp"

#include <cstddef>

extern "C" {
/// BLAS: C ← α A B + β C, A or B optionally transposed, column-major.
void dgemm_(const char* transpose_a, const char* transpose_b, const int* m, const int* n, const int* k,
            const double* alpha, const double* a, const int* lda, const double* b, const int* ldb, const double* beta,
            double* c, const int* ldc);
}

namespace signorini::contact {

namespace {

/// Grows the array by one row of `count` values and returns the start of that row; never shrinks it.
double* extend(std::vector<double>& values, int points, int count) {
  const std::size_t from = static_cast<std::size_t>(points) * static_cast<std::size_t>(count);
  if (values.size() < from + static_cast<std::size_t>(count))
    values.resize(2 * (from + static_cast<std::size_t>(count)));
  return values.data() + from;
}

/// C_rc += Σ_k A_kr B_kc, row-major, with row stride `step` of B and C.
void add_product(int rows, int columns, int depth, const double* a, const double* b, int step, double* c) {
  const double one = 1;
  dgemm_("N", "T", &columns, &rows, &depth, &one, b, &step, a, &rows, &one, c, &step);
}

} // namespace

void Products::start(int nodes, int master_nodes, int columns, double* block) {
  nodes_ = nodes;
  master_nodes_ = master_nodes;
  columns_ = columns;
  block_ = block;
  points_ = 0;
}

Products::Factors Products::add() {
  if (points_ > 0 && (points_ + 1) * nodes_ * columns_ > most_multiplications) finish();
  const Factors factors{extend(left_, points_, nodes_), extend(rates_, points_, 2 * master_nodes_),
                        extend(traction_, points_, 3 * columns_), extend(turn_, points_, 6 * columns_)};
  ++points_;
  return factors;
}

void Products::finish() {
  if (points_ == 0) return;
  const int step = 3 * columns_;
  double* of_master = block_ + (nodes_ - master_nodes_) * step;
  for (int i = 0; i < 3; ++i) {
    add_product(nodes_, columns_, points_, left_.data(), traction_.data() + i * columns_, step, block_ + i * columns_);
    if (master_nodes_ == 0) continue;
    add_product(master_nodes_, columns_, 2 * points_, rates_.data(), turn_.data() + i * columns_, step,
                of_master + i * columns_);
  }
  points_ = 0;
}

} // namespace signorini::contact
