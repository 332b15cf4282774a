#include "solve/eigenpairs.hpp"

#include "solve/lapack.hpp"

namespace signorini::solve {

Eigenpair least_eigenpair(MatrixX symmetric) {
  const Eigen::Index size = symmetric.rows();
  const Eigenpairs all = symmetric_eigenpairs(std::move(symmetric));
  if (all.values.size() == 0) return {0, VectorX::Zero(size)};
  return {all.values(0).real(), all.vectors.col(0)};
}

Eigenpairs symmetric_eigenpairs(MatrixX symmetric) {
  const int size = static_cast<int>(symmetric.rows()), workspace = 3 * size;
  VectorX values(size), work(workspace);
  int info = 0;
  dsyev_("V", "L", &size, symmetric.data(), &size, values.data(), work.data(), &workspace, &info);
  if (info != 0) return {};
  return {values.cast<std::complex<double>>(), std::move(symmetric)};
}

Eigenpairs eigenpairs(MatrixX matrix) {
  const int size = static_cast<int>(matrix.rows()), workspace = 4 * size, one = 1;
  VectorX real(size), imaginary(size), work(workspace);
  MatrixX vectors(size, size);
  int info = 0;
  dgeev_("N", "V", &size, matrix.data(), &size, real.data(), imaginary.data(), nullptr, &one, vectors.data(), &size,
         work.data(), &workspace, &info);
  if (info != 0) return {};
  Eigen::VectorXcd values(size);
  values.real() = real;
  values.imag() = imaginary;
  return {std::move(values), std::move(vectors)};
}

} // namespace signorini::solve
