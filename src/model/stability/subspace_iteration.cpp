#include "model/stability/subspace_iteration.hpp"

#include "solve/eigenpairs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini::model {

namespace {

/// Deterministic start vectors without preferred direction.
MatrixX start_vectors(int size, int count) {
  MatrixX x(size, count);
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < size; ++i) x(i, j) = std::sin(1.0 + 0.7 * (i + 1) * (j + 1) + 0.01 * i * i);
  return x;
}

/// By distance of κ from the shift; complex pairs, which are equally far, stay together.
solve::Eigenpairs sorted(const solve::Eigenpairs& all) {
  std::vector<int> order(static_cast<std::size_t>(all.values.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater(), [&](int k) { return std::abs(all.values(k)); });
  return {all.values(order), all.vectors(Eigen::all, order)};
}

} // namespace

MatrixX times(const solve::Pattern& pattern, const std::vector<double>& values, const MatrixX& x) {
  MatrixX product = MatrixX::Zero(x.rows(), x.cols());
  for (int c = 0; c < x.cols(); ++c)
    for (int j = 0; j < pattern.size; ++j)
      for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k)
        product(pattern.rows[k], c) += values[k] * x(j, c);
  return product;
}

std::vector<double> Eigenproblem::shifted(double shift) const {
  std::vector<double> values(stiffness.begin(), stiffness.begin() + pattern.entries());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] -= shift * mass[k];
  return values;
}

SubspaceIteration::SubspaceIteration(solve::LinearKind solver, Eigenproblem problem, int count)
    : problem_(std::move(problem)), solver_(solve::make_solver(solver, problem_.pattern)),
      x_(start_vectors(problem_.pattern.size, count)), mass_times_x_(times(problem_.pattern, problem_.mass, x_)) {
  orthonormalize();
}

bool SubspaceIteration::shift(double shift) {
  shift_ = shift;
  return solver_->factor(problem_.shifted(shift).data());
}

bool SubspaceIteration::advance() {
  MatrixX y = mass_times_x_;
  for (int j = 0; j < y.cols(); ++j)
    if (!solver_->solve(y.col(j).data(), true)) return false;
  const MatrixX mass_times_y = times(problem_.pattern, problem_.mass, y);
  find_pairs(y, mass_times_y);
  return true;
}

/// The small problem H q = θ q, H = Xᵀ M (K − σM)⁻¹ M X, with κ = σ + 1/θ; then X ← Y Q.
void SubspaceIteration::find_pairs(const MatrixX& y, const MatrixX& mass_times_y) {
  const MatrixX small = x_.transpose().lazyProduct(mass_times_y);
  const auto [values, q] = sorted(problem_.symmetric ? solve::symmetric_eigenpairs(0.5 * (small + small.transpose()))
                                                     : solve::eigenpairs(small));
  const MatrixX image = y.lazyProduct(q), mass_times_image = mass_times_y.lazyProduct(q);
  pairs_.vectors = x_.lazyProduct(q);
  const MatrixX mass_times_vectors = mass_times_x_.lazyProduct(q);
  pairs_.values = shift_ + values.cwiseInverse().array();
  pairs_.errors.resize(values.size());
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    // (K − σM)⁻¹ M φ − θ φ of φ = a + b i, in columns k and k + 1
    const bool is_pair = values(k).imag() != 0;
    const double real = values(k).real(), imaginary = values(k).imag();
    const auto difference = [&](const MatrixX& of_image, const MatrixX& of_vectors, int part) -> VectorX {
      VectorX d = of_image.col(k + part) - real * of_vectors.col(k + part);
      if (is_pair) d += (part == 0 ? imaginary : -imaginary) * of_vectors.col(k + 1 - part);
      return d;
    };
    double square = 0;
    for (int part = 0; part < (is_pair ? 2 : 1); ++part)
      square += difference(image, pairs_.vectors, part).dot(difference(mass_times_image, mass_times_vectors, part));
    pairs_.errors(k) = std::sqrt(std::max(square, 0.0)) / std::abs(values(k));
    if (is_pair) {
      pairs_.errors(k + 1) = pairs_.errors(k);
      ++k;
    }
  }
  x_ = image;
  mass_times_x_ = mass_times_image;
  orthonormalize();
}

/// Gram–Schmidt with reorthogonalization in the inner product of M, by X and M X; see base/orthonormal.cpp.
void SubspaceIteration::orthonormalize() {
  for (Eigen::Index j = 0; j < x_.cols(); ++j)
    for (int pass = 0; pass < 4; ++pass) {
      const auto scale = [&] {
        const double size = std::sqrt(std::max(0.0, x_.col(j).dot(mass_times_x_.col(j))));
        if (size > 0) x_.col(j) /= size;
        if (size > 0) mass_times_x_.col(j) /= size;
        return size;
      };
      if (scale() == 0) break;
      for (Eigen::Index k = 0; k < j; ++k) {
        const double part = x_.col(k).dot(mass_times_x_.col(j));
        x_.col(j) -= part * x_.col(k);
        mass_times_x_.col(j) -= part * mass_times_x_.col(k);
      }
      if (scale() > 0.7) break;
    }
}

} // namespace signorini::model
