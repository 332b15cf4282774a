#pragma once
// The routines of LAPACK that the solvers call: Fortran by its C address, from whichever LAPACK the machine has.

extern "C" {
/// Row-pivoted LU of a dense matrix, and the solution with it.
void dgetrf_(const int* rows, const int* columns, double* a, const int* leading, int* pivots, int* info);
void dgetrs_(const char* transposed, const int* size, const int* right_sides, const double* a, const int* leading,
             const int* pivots, double* b, const int* leading_b, int* info);
/// The same for a band.
void dgbtrf_(const int* rows, const int* columns, const int* lower, const int* upper, double* a, const int* leading,
             int* pivots, int* info);
void dgbtrs_(const char* transposed, const int* size, const int* lower, const int* upper, const int* right_sides,
             const double* a, const int* leading, const int* pivots, double* b, const int* leading_b, int* info);
/// Cholesky's factor of a symmetric band, and the solution with it.
void dpbtrf_(const char* triangle, const int* size, const int* band, double* a, const int* leading, int* info);
void dpbtrs_(const char* triangle, const int* size, const int* band, const int* right_sides, const double* a,
             const int* leading, double* b, const int* leading_b, int* info);
}
