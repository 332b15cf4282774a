#include "base/dense.hpp"

namespace signorini::dense {

MatrixX solve(const MatrixX& a, const MatrixX& b) {
  return a.partialPivLu().solve(b);
}

MatrixX least_squares(const MatrixX& a, const MatrixX& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

MatrixX cholesky(const MatrixX& a) {
  return a.llt().matrixL();
}

MatrixX orthogonal(const MatrixX& a) {
  return a.householderQr().householderQ();
}

VectorX symmetric_eigenvalues(const MatrixX& a) {
  return Eigen::SelfAdjointEigenSolver<MatrixX>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

SingularValues singular_values(const MatrixX& a) {
  const Eigen::JacobiSVD<MatrixX> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

} // namespace signorini::dense
