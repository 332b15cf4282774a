#include "contact/face/products.hpp"

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

/// Grows the array by one row of `count` values and returns the start of that row; never shrinks it, and keeps room for
/// one more value.
double* extend(std::vector<double>& values, int points, int count) {
  const std::size_t from = static_cast<std::size_t>(points) * static_cast<std::size_t>(count);
  const std::size_t to = from + static_cast<std::size_t>(count) + 1;
  if (values.size() < to) values.resize(2 * to);
  return values.data() + from;
}

/// Row-major, with its row stride.
struct Factor {
  const double* values;
  int stride;
};

/// C_rc += Σ_k A_kr B_kc, row-major.
void add_product(int rows, int columns, int depth, Factor a, Factor b, double* c, int stride) {
  const double one = 1;
  dgemm_("N", "T", &columns, &rows, &depth, &one, b.values, &b.stride, a.values, &a.stride, &one, c, &stride);
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
  const Factors factors{extend(left_, points_, nodes_), extend(traction_, points_, 3 * columns_),
                        extend(rates_, points_, 6 * master_nodes_), extend(shift_, points_, 2 * columns_)};
  ++points_;
  return factors;
}

void Products::finish() {
  if (points_ == 0) return;
  const int step = 3 * columns_, rows = 3 * master_nodes_;
  // Large products in three parts, below the number of multiplications from which OpenBLAS starts threads
  const auto parts = [&](int factor) { return factor * columns_ * points_ > most_multiplications ? 3 : 1; };
  const int of_columns = parts(3 * nodes_), of_rows = parts(2 * rows);
  for (int i = 0, width = step / of_columns; i < of_columns; ++i)
    add_product(nodes_, width, points_, {left_.data(), nodes_}, {traction_.data() + i * width, step},
                block_ + i * width, step);
  double* of_master = block_ + (nodes_ - master_nodes_) * step;
  for (int i = 0, height = rows / of_rows; i < of_rows && rows > 0; ++i)
    add_product(height, columns_, 2 * points_, {rates_.data() + i * height, rows}, {shift_.data(), columns_},
                of_master + i * height * columns_, columns_);
  points_ = 0;
}

} // namespace signorini::contact
