#pragma once
// The routines of LAPACK and BLAS that the solvers call, by their Fortran symbols, from the library of the machine.

// NOLINTBEGIN(readability-identifier-naming)
extern "C" {
/// LU of a dense matrix with row pivoting, and the solution with it; in single precision below.
void dgetrf_(const int* rows, const int* columns, double* a, const int* leading, int* pivots, int* info);
void dgetrs_(const char* transposed, const int* size, const int* right_sides, const double* a, const int* leading,
             const int* pivots, double* b, const int* leading_b, int* info);
void sgetrf_(const int* rows, const int* columns, float* a, const int* leading, int* pivots, int* info);
void sgetrs_(const char* transposed, const int* size, const int* right_sides, const float* a, const int* leading,
             const int* pivots, float* b, const int* leading_b, int* info);
/// B ← α op(A)⁻¹ B for a triangular A on the left, and C ← α op(A) op(B) + β C.
void dtrsm_(const char* side, const char* triangle, const char* transposed, const char* diagonal, const int* rows,
            const int* columns, const double* alpha, const double* a, const int* leading, double* b,
            const int* leading_b);
void strsm_(const char* side, const char* triangle, const char* transposed, const char* diagonal, const int* rows,
            const int* columns, const float* alpha, const float* a, const int* leading, float* b, const int* leading_b);
void dgemm_(const char* transposed_a, const char* transposed_b, const int* rows, const int* columns, const int* inner,
            const double* alpha, const double* a, const int* leading, const double* b, const int* leading_b,
            const double* beta, double* c, const int* leading_c);
void sgemm_(const char* transposed_a, const char* transposed_b, const int* rows, const int* columns, const int* inner,
            const float* alpha, const float* a, const int* leading, const float* b, const int* leading_b,
            const float* beta, float* c, const int* leading_c);
/// C ← α A Aᵀ + β C on a triangle of C.
void dsyrk_(const char* triangle, const char* transposed, const int* size, const int* columns, const double* alpha,
            const double* a, const int* leading, const double* beta, double* c, const int* leading_c);
/// Cholesky factors of a triangle of a symmetric matrix; info > 0 unless it is positive definite.
void dpotrf_(const char* triangle, const int* size, double* a, const int* leading, int* info);
/// Eigenvalues, increasing, and in place of the matrix the eigenvectors of a dense symmetric one.
void dsyev_(const char* vectors, const char* triangle, const int* size, double* a, const int* leading, double* values,
            double* work, const int* work_size, int* info);
/// Eigenvalues, real and imaginary parts, and left and right eigenvectors of a dense matrix, which it overwrites.
void dgeev_(const char* left_vectors, const char* right_vectors, const int* size, double* a, const int* leading,
            double* real, double* imaginary, double* left, const int* leading_left, double* right,
            const int* leading_right, double* work, const int* work_size, int* info);
}
// NOLINTEND(readability-identifier-naming)
