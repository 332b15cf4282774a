#include "solve/dense_factors.hpp"

#include "os/parallel.hpp"
#include "solve/constants.hpp"
#include "solve/lapack.hpp"

#include <algorithm>

namespace signorini::solve {

namespace {

// LAPACK and BLAS by precision

int getrf(int rows, int columns, double* a, int leading, int* pivots) {
  int info = 0;
  dgetrf_(&rows, &columns, a, &leading, pivots, &info);
  return info;
}
int getrf(int rows, int columns, float* a, int leading, int* pivots) {
  int info = 0;
  sgetrf_(&rows, &columns, a, &leading, pivots, &info);
  return info;
}
void getrs(int size, const double* a, const int* pivots, double* b) {
  int one = 1, info = 0;
  dgetrs_("N", &size, &one, a, &size, pivots, b, &size, &info);
}
void getrs(int size, const float* a, const int* pivots, float* b) {
  int one = 1, info = 0;
  sgetrs_("N", &size, &one, a, &size, pivots, b, &size, &info);
}
/// B ← L⁻¹ B, L lower triangular with a unit diagonal.
void solve_unit_lower(int rows, int columns, const double* l, double* b, int leading) {
  const double one = 1;
  dtrsm_("L", "L", "N", "U", &rows, &columns, &one, l, &leading, b, &leading);
}
void solve_unit_lower(int rows, int columns, const float* l, float* b, int leading) {
  const float one = 1;
  strsm_("L", "L", "N", "U", &rows, &columns, &one, l, &leading, b, &leading);
}
/// C ← C − A B; all three have columns at the same distance in memory.
void subtract_product(int rows, int columns, int inner, const double* a, const double* b, double* c, int leading) {
  const double minus = -1, one = 1;
  dgemm_("N", "N", &rows, &columns, &inner, &minus, a, &leading, b, &leading, &one, c, &leading);
}
void subtract_product(int rows, int columns, int inner, const float* a, const float* b, float* c, int leading) {
  const float minus = -1, one = 1;
  sgemm_("N", "N", &rows, &columns, &inner, &minus, a, &leading, b, &leading, &one, c, &leading);
}

} // namespace

// LU by blocks (G. H. Golub, C. F. Van Loan, Matrix Computations, 1996, section 3.2). For each panel of columns, P
// [A₁₁; A₂₁] = [L₁₁; L₂₁] U₁₁, then in every other piece of columns A ← P A, on the right also U₁₂ = L₁₁⁻¹ A₁₂ and A₂₂
// ← A₂₂ − L₂₁ U₁₂. Pieces do not depend on the number of threads.
template <class Real> bool factor_dense(DenseMatrix<Real>& a, std::vector<int>& exchanges) {
  const int size = static_cast<int>(a.rows());
  exchanges.resize(size);
  if (size < shared_dense_size) return getrf(size, size, a.data(), size, exchanges.data()) == 0;
  bool regular = true;
  for (int first = 0; first < size; first += panel_width) {
    const int width = std::min(panel_width, size - first), end = first + width;
    int* const own = exchanges.data() + first;
    regular = getrf(size - first, width, &a(first, first), size, own) == 0 && regular;
    const int right = (size - end + panel_width - 1) / panel_width;
    parallel(right + (first > 0 ? 1 : 0), [&](int piece) {
      const bool left = piece == right;
      const int begin = left ? 0 : end + piece * panel_width;
      const int columns = left ? first : std::min(panel_width, size - begin);
      for (int column = begin; column < begin + columns; ++column)
        for (int k = 0; k < width; ++k) std::swap(a(first + k, column), a(first + own[k] - 1, column));
      if (left) return;
      solve_unit_lower(width, columns, &a(first, first), &a(first, begin), size);
      if (end < size)
        subtract_product(size - end, columns, width, &a(end, first), &a(first, begin), &a(end, begin), size);
    });
    for (int k = 0; k < width; ++k) own[k] += first;
  }
  return regular;
}

template <class Real>
void solve_dense(const DenseMatrix<Real>& factors, const std::vector<int>& exchanges, Eigen::Ref<VectorX> b) {
  Eigen::Matrix<Real, Eigen::Dynamic, 1> right = b.template cast<Real>();
  getrs(static_cast<int>(b.size()), factors.data(), exchanges.data(), right.data());
  b = right.template cast<double>();
}

template bool factor_dense(DenseMatrix<double>&, std::vector<int>&);
template bool factor_dense(DenseMatrix<float>&, std::vector<int>&);
template void solve_dense(const DenseMatrix<double>&, const std::vector<int>&, Eigen::Ref<VectorX>);
template void solve_dense(const DenseMatrix<float>&, const std::vector<int>&, Eigen::Ref<VectorX>);

bool is_positive_definite(DenseMatrix<double> a) {
  a = (0.5 * (a + a.transpose())).eval();
  const int size = static_cast<int>(a.rows());
  int info = 0;
  if (size > 0) dpotrf_("L", &size, a.data(), &size, &info);
  return info == 0;
}

} // namespace signorini::solve
