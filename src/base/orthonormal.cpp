#include "base/orthonormal.hpp"

namespace signorini {

namespace {

/// Subtracts from v its components along the first `count` columns of Q.
void subtract(const MatrixX& q, Eigen::Index count, VectorX& v) {
  for (Eigen::Index k = 0; k < count; ++k) v -= q.col(k).dot(v) * q.col(k);
}

} // namespace

MatrixX orthonormal(MatrixX x) {
  for (Eigen::Index j = 0; j < x.cols(); ++j) {
    VectorX v = x.col(j);
    // Rounding errors matter where a pass cancels most of v; "twice is enough" unless v depends on the other columns.
    for (int pass = 0; pass < 4; ++pass) {
      const double before = v.norm();
      if (before == 0) break;
      v /= before;
      subtract(x, j, v);
      if (v.norm() > 0.7) break;
    }
    const double size = v.norm();
    x.col(j) = size > 0 ? VectorX(v / size) : v;
  }
  return x;
}

MatrixX pseudo_inverse(const MatrixX& x) {
  // X = Q R, so R X⁺ = Qᵀ with the triangle R = Qᵀ X.
  const MatrixX q = orthonormal(x);
  MatrixX result = q.transpose();
  for (Eigen::Index k = x.cols() - 1; k >= 0; --k) {
    for (Eigen::Index m = k + 1; m < x.cols(); ++m) result.row(k) -= q.col(k).dot(x.col(m)) * result.row(m);
    result.row(k) /= q.col(k).dot(x.col(k));
  }
  return result;
}

MatrixX residual_of(const MatrixX& q, MatrixX b) {
  for (Eigen::Index j = 0; j < b.cols(); ++j) {
    VectorX v = b.col(j);
    subtract(q, q.cols(), v);
    b.col(j) = v;
  }
  return b;
}

} // namespace signorini
