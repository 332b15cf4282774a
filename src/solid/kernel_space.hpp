#pragma once
// The element kernel in space for any number of functions, with the vector width for which the including file is
// compiled. Everything is local to these files and no inline functions of other files are called, so that the linker
// cannot select a copy that an older machine is unable to run.
//
// Rows of n values are read and written in whole vectors, beyond their end: tables and arrays are padded
// (`vector_padding` of kernel.hpp); values read there are multiplied by zero or not used, values written there are
// overwritten later.

#include "solid/kernel.hpp"

#include <cmath>
#include <cstdint>

namespace signorini::solid {

namespace {

#if defined(__AVX512F__)
constexpr int lanes = 8, most_columns = 4; // 32 registers
#elif defined(__AVX2__)
constexpr int lanes = 4, most_columns = 3; // 16 registers
#else
constexpr int lanes = 2, most_columns = 3;
#endif
constexpr int tile_rows = 4;
static_assert(lanes <= vector_padding);

typedef double Lanes __attribute__((vector_size(8 * lanes), may_alias));
typedef double Row __attribute__((vector_size(8 * tile_rows), may_alias));

// Addresses are aligned to a double, not to a vector. Rows may be longer than a register, in which functions cannot
// return them.
inline Lanes lanes_at(const double* values) {
  Lanes v;
  __builtin_memcpy(&v, values, sizeof v);
  return v;
}
inline void set_lanes(double* values, const Lanes& v) {
  __builtin_memcpy(values, &v, sizeof v);
}
inline void get_row(const double* values, Row& row) {
  __builtin_memcpy(&row, values, sizeof row);
}
inline void set_row(double* values, const Row& row) {
  __builtin_memcpy(values, &row, sizeof row);
}

inline double sum_of(const Lanes& v) {
#if defined(__AVX512F__)
  const auto half = __builtin_shufflevector(v, v, 0, 1, 2, 3) + __builtin_shufflevector(v, v, 4, 5, 6, 7);
#else
  const auto half = v;
#endif
#if defined(__AVX2__)
  const auto pair = __builtin_shufflevector(half, half, 0, 1) + __builtin_shufflevector(half, half, 2, 3);
#else
  const auto pair = half;
#endif
  return pair[0] + pair[1];
}

/// Returns the determinant of F and computes its inverse, row by row.
inline double invert_space(const double* f, double* inverse) {
  const double c0 = f[4] * f[8] - f[5] * f[7], c1 = f[5] * f[6] - f[3] * f[8], c2 = f[3] * f[7] - f[4] * f[6];
  const double j = f[0] * c0 + f[1] * c1 + f[2] * c2, scale = 1 / j;
  inverse[0] = c0 * scale;
  inverse[1] = (f[2] * f[7] - f[1] * f[8]) * scale;
  inverse[2] = (f[1] * f[5] - f[2] * f[4]) * scale;
  inverse[3] = c1 * scale;
  inverse[4] = (f[0] * f[8] - f[2] * f[6]) * scale;
  inverse[5] = (f[2] * f[3] - f[0] * f[5]) * scale;
  inverse[6] = c2 * scale;
  inverse[7] = (f[1] * f[6] - f[0] * f[7]) * scale;
  inverse[8] = (f[0] * f[4] - f[1] * f[3]) * scale;
  return j;
}

/// F_ik = δ_ik + Σ_A u_iA ∂R_A/∂X_k; from displacements, so that rounding errors are relative to the strain, not the
/// position. `local`: rows of `padded` values, zero from the n-th on.
inline void deformation_in_space(const double* local, const double* gradients, int n, int padded, double* f) {
  Lanes sums[9] = {};
  for (int a = 0; a < padded; a += lanes) {
    const Lanes g0 = lanes_at(gradients + a), g1 = lanes_at(gradients + n + a), g2 = lanes_at(gradients + 2 * n + a);
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const Lanes u = lanes_at(local + i * padded + a);
      sums[3 * i] += u * g0;
      sums[3 * i + 1] += u * g1;
      sums[3 * i + 2] += u * g2;
    }
  }
  for (int i = 0; i < 9; ++i) f[i] = (i % 4 == 0 ? 1 : 0) + sum_of(sums[i]);
}

/// f_iA += P_ik ∂R_A/∂X_k (P times the point's weight), in rows of `padded` values.
inline void add_force(const double* stress, const double* gradients, int n, int padded, double* force) {
  for (int a = 0; a < padded; a += lanes) {
    const Lanes g0 = lanes_at(gradients + a), g1 = lanes_at(gradients + n + a), g2 = lanes_at(gradients + 2 * n + a);
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      double* row = force + i * padded + a;
      set_lanes(row, lanes_at(row) + stress[3 * i] * g0 + stress[3 * i + 1] * g1 + stress[3 * i + 2] * g2);
    }
  }
}

/// Current gradients g_iA = (F⁻¹)_ki ∂R_A/∂X_k, in rows of `padded` values.
inline void push_forward_in_space(const double* inverse, const double* gradients, int n, int padded, double* current) {
  for (int a = 0; a < padded; a += lanes) {
    const Lanes g0 = lanes_at(gradients + a), g1 = lanes_at(gradients + n + a), g2 = lanes_at(gradients + 2 * n + a);
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i)
      set_lanes(current + i * padded + a, inverse[i] * g0 + inverse[3 + i] * g1 + inverse[6 + i] * g2);
  }
}

/// Data common to all tiles of a tangent.
struct Tiles {
  const double *current, *factors;
  double* panel; ///< the factors of a tile's rows, by Gauss point
  int n, padded, points;
};

/// Σ_q panel_qA g_qB for `tile_rows` rows A and vectors of B; g_q are rows of the current gradients.
template <int Columns>
inline void add_products(const double* panel, const double* g, int points, int step, Lanes (&sum)[tile_rows][Columns]) {
  for (int q = 0; q < points; ++q, panel += tile_rows, g += step)
#pragma GCC unroll 4
    for (int c = 0; c < Columns; ++c) {
      const Lanes column = lanes_at(g + c * lanes);
#pragma GCC unroll 4
      for (int r = 0; r < tile_rows; ++r) sum[r][c] += panel[r] * column;
    }
}

/// A tile of K^{ij}, from row a and column `first` on: with the geometric factor c and the volumetric factor v,
///   K^{ij}_{AB} = Σ_q (c_q g_jA) g_iB + (v_q g_iA) g_jB, K^{ii}_{AB} = constant_AB + Σ_q ((c_q + v_q) g_iA) g_iB.
/// The sums stay in registers.
template <int Columns>
inline void add_tile(const Tiles& in, int i, int j, int a, int first, const double* constant, double* block) {
  const int step = 3 * in.padded, place = a * in.n + first;
  const double *gi = in.current + i * in.padded, *gj = in.current + j * in.padded;
  double* second = in.panel + in.points * tile_rows;
  for (int q = 0; q < in.points; ++q) {
    const double geometric = in.factors[2 * q], volumetric = in.factors[2 * q + 1];
    Row row;
    get_row(gj + q * step + a, row);
    set_row(in.panel + q * tile_rows, (i == j ? geometric + volumetric : geometric) * row);
    if (i == j) continue;
    get_row(gi + q * step + a, row);
    set_row(second + q * tile_rows, volumetric * row);
  }
  Lanes sum[tile_rows][Columns];
#pragma GCC unroll 4
  for (int r = 0; r < tile_rows; ++r)
#pragma GCC unroll 4
    for (int c = 0; c < Columns; ++c) sum[r][c] = i == j ? lanes_at(constant + place + r * in.n + c * lanes) : Lanes{};
  add_products<Columns>(in.panel, gi + first, in.points, step, sum);
  if (i != j) add_products<Columns>(second, gj + first, in.points, step, sum);
#pragma GCC unroll 4
  for (int r = 0; r < tile_rows; ++r)
#pragma GCC unroll 4
    for (int c = 0; c < Columns; ++c) set_lanes(block + place + r * in.n + c * lanes, sum[r][c]);
}

/// The last tile overlaps the previous one if n is not a multiple of their rows.
template <int Columns> void strip(const Tiles& in, int i, int j, int first, const double* constant, double* block) {
  for (int a = 0; a < in.n; a += tile_rows)
    add_tile<Columns>(in, i, j, a + tile_rows < in.n ? a : in.n - tile_rows, first, constant, block);
}

/// All blocks i ≤ j. The last columns are computed first: what their vectors write beyond a row is the start of the
/// next.
inline void tangent_in_space(const Tiles& in, const double* constant, double* blocks) {
  const int vectors = in.padded / lanes, strips = (vectors + most_columns - 1) / most_columns;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j, blocks += in.n * in.n)
      for (int s = strips - 1; s >= 0; --s) {
        const int first = vectors * s / strips, columns = vectors * (s + 1) / strips - first;
        if (columns == 1) strip<1>(in, i, j, first * lanes, constant, blocks);
        if (columns == 2) strip<2>(in, i, j, first * lanes, constant, blocks);
        if (columns == 3) strip<3>(in, i, j, first * lanes, constant, blocks);
        if (columns == 4) strip<most_columns>(in, i, j, first * lanes, constant, blocks);
      }
}

// K^{ij}_{AB} = ∫ μ ∇R_A·∇R_B δ_ij + (μ − λ ln J) g_jA g_iB + λ g_iA g_jB dV,
// from ∂P = μ ∂F + (μ − λ ln J) F⁻ᵀ ∂Fᵀ F⁻ᵀ + λ (F⁻ᵀ:∂F) F⁻ᵀ; the first term is constant.
inline KernelResult run_space(const KernelArguments& in) {
  const int n = in.functions, padded = (n + lanes - 1) / lanes * lanes;
  // Vectors at multiples of their size do not cross cache lines.
  double* local = in.work + (-reinterpret_cast<std::uintptr_t>(in.work) / sizeof(double)) % lanes;
  double *force = local + 3 * padded, *current = force + 3 * padded;
  for (int i = 0; i < 3; ++i)
    for (int a = 0; a < padded; ++a) {
      local[i * padded + a] = a < n ? in.local[i * n + a] : 0;
      force[i * padded + a] = 0;
    }
  const double* gradients = in.gradients;
  for (int q = 0; q < in.points; ++q, gradients += 3 * n) {
    double f[9], inverse[9], stress[9];
    deformation_in_space(local, gradients, n, padded, f);
    const double j = invert_space(f, inverse), weight = in.weights[q];
    if (!(j > 0)) return {q, j};
    const double bracket = in.mu - in.lambda * std::log(j);
    // P = μ F − (μ − λ ln J) F⁻ᵀ
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) stress[3 * i + k] = weight * (in.mu * f[3 * i + k] - bracket * inverse[3 * k + i]);
    add_force(stress, gradients, n, padded, force);
    in.factors[2 * q] = weight * (in.predicted ? bracket - in.lambda * in.predicted[q] : bracket);
    in.factors[2 * q + 1] = weight * in.lambda;
    if (in.blocks) push_forward_in_space(inverse, gradients, n, padded, current + 3 * q * padded);
  }
  for (int i = 0; i < 3; ++i)
    for (int a = 0; a < n; ++a) in.force[i * n + a] = force[i * padded + a];
  if (in.blocks) {
    double* panel = current + 3 * in.points * padded + vector_padding;
    tangent_in_space({current, in.factors, panel, n, padded, in.points}, in.constant, in.blocks);
  }
  return {-1, 1};
}

} // namespace

} // namespace signorini::solid
