#pragma once
// The element kernels for laws that give stress and moduli at many points at once, with the vector width for which the
// including file is compiled; see kernel_space.hpp.

#include "solid/kernel_plane.hpp"
#include "solid/kernel_space.hpp"

namespace signorini::solid {

namespace {

/// The arrays of an element with R rows of functions per Gauss point.
template <int D, int R> struct ModuliArrays {
  explicit ModuliArrays(const KernelArguments& in)
      : padded((in.functions + lanes - 1) / lanes * lanes), stride((in.points + 7) / 8 * 8), step(in.functions),
        f(in.work), stress(f + entries_in(D) * stride), moduli(stress + entries_in(D) * stride),
        local(moduli + packed_size(entries_in(D)) * stride), force(local + D * padded), panel(force + D * padded),
        rows(in.gradients) {
    if constexpr (R == D) return;
    // A body of revolution has its rows in two tables.
    double* own = panel + R * tile_rows * in.points;
    step = padded;
    rows = own;
    for (int q = 0; q < in.points; ++q)
      for (int r = 0; r < R; ++r, own += padded) {
        const double* row = r < D ? in.gradients + (q * D + r) * in.functions : in.hoop + q * in.functions;
        for (int a = 0; a < padded; ++a) own[a] = a < in.functions ? row[a] : 0;
      }
  }
  double* modulus(int e, int o) const {
    return moduli + (e <= o ? packed(entries_in(D), e, o) : packed(entries_in(D), o, e)) * stride;
  }

  int padded, stride, step; ///< values in a row of functions, in a row of points; from row to row of functions
  double *f, *stress, *moduli, *local, *force, *panel;
  const double* rows;
};

/// det F of a solid; in the plane that of the plane part or, if this is positive, F₃₃.
template <int D> inline double least_jacobian(const double* f) {
  if constexpr (D == 3)
    return f[0] * (f[4] * f[8] - f[5] * f[7]) + f[1] * (f[5] * f[6] - f[3] * f[8]) + f[2] * (f[3] * f[7] - f[4] * f[6]);
  const double plane = f[0] * f[3] - f[1] * f[2];
  return plane > 0 ? f[4] : plane;
}

/// Writes F = I + Σ_A u_iA row_rA at all points, and up to whole vectors that of the last point. Returns the first
/// point with J ≤ 0.
template <int D, int R>
inline KernelResult write_deformations(const KernelArguments& in, const ModuliArrays<D, R>& to) {
  constexpr int entries = entries_in(D);
  const int n = in.functions;
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < to.padded; ++a) to.local[i * to.padded + a] = a < n ? in.local[i * n + a] : 0;
  const double* rows = to.rows;
  for (int q = 0; q < in.points; ++q, rows += R * to.step) {
    Lanes sums[D][R] = {};
    for (int a = 0; a < to.padded; a += lanes) {
      Lanes row[R];
#pragma GCC unroll 3
      for (int r = 0; r < R; ++r) row[r] = lanes_at(rows + r * to.step + a);
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i)
#pragma GCC unroll 3
        for (int r = 0; r < R; ++r) sums[i][r] += lanes_at(to.local + i * to.padded + a) * row[r];
    }
    double f[entries];
    f[entries - 1] = 1;
#pragma GCC unroll 3
    for (int i = 0; i < D; ++i)
#pragma GCC unroll 3
      for (int r = 0; r < R; ++r)
        if (const int e = entry_of<D>(i, r); e >= 0) f[e] = (r == i || r == D ? 1 : 0) + sum_of(sums[i][r]);
    for (int e = 0; e < entries; ++e) to.f[e * to.stride + q] = f[e];
    if (const double j = least_jacobian<D>(f); !(j > 0 || in.small_strains)) return {q, j};
  }
  for (int q = in.points; q < to.stride; ++q)
    for (int e = 0; e < entries; ++e) to.f[e * to.stride + q] = to.f[e * to.stride + in.points - 1];
  return {-1, 1};
}

/// f_iA = ∫ P_ik ∂R_A/∂X_k + δ_ir P_θθ R_A/R dV
template <int D, int R> inline void write_force(const KernelArguments& in, const ModuliArrays<D, R>& at) {
  const int n = in.functions;
  for (int a = 0; a < D * at.padded; ++a) at.force[a] = 0;
  const double* rows = at.rows;
  for (int q = 0; q < in.points; ++q, rows += R * at.step) {
    double p[entries_in(D)];
    for (int e = 0; e < entries_in(D); ++e) p[e] = in.weights[q] * at.stress[e * at.stride + q];
    for (int a = 0; a < at.padded; a += lanes)
#pragma GCC unroll 3
      for (int i = 0; i < D; ++i) {
        Lanes sum = lanes_at(at.force + i * at.padded + a);
#pragma GCC unroll 3
        for (int r = 0; r < R; ++r)
          if (const int e = entry_of<D>(i, r); e >= 0) sum += p[e] * lanes_at(rows + r * at.step + a);
        set_lanes(at.force + i * at.padded + a, sum);
      }
  }
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < n; ++a) in.force[i * n + a] = at.force[i * at.padded + a];
}

/// panel_qsA = Σ_r row_rA a(entry_ir, entry_js) for the rows A of a tile of K^{ij}.
template <int D, int R>
inline void write_panel(const KernelArguments& in, const ModuliArrays<D, R>& at, int i, int j, int a) {
  const double* moduli[R][R]; // null: none
  for (int r = 0; r < R; ++r)
    for (int s = 0; s < R; ++s) {
      const int e = entry_of<D>(i, r), o = entry_of<D>(j, s);
      moduli[r][s] = e < 0 || o < 0 ? nullptr : at.modulus(e, o);
    }
  const double* rows = at.rows + a;
  double* panel = at.panel;
  const int points = in.points, step = at.step;
  for (int q = 0; q < points; ++q, rows += R * step, panel += R * tile_rows) {
    Row row[R], sums[R] = {};
#pragma GCC unroll 3
    for (int r = 0; r < R; ++r) get_row(rows + r * step, row[r]);
#pragma GCC unroll 3
    for (int s = 0; s < R; ++s)
#pragma GCC unroll 3
      for (int r = 0; r < R; ++r)
        if (R == D || moduli[r][s]) sums[s] += moduli[r][s][q] * row[r];
#pragma GCC unroll 3
    for (int s = 0; s < R; ++s) set_row(panel + s * tile_rows, sums[s]);
  }
}

/// A tile of K^{ij} from vector `first` on: Σ_q Σ_s panel_qsA row_sB.
template <int Columns, int D, int R>
inline void add_columns(const KernelArguments& in, const ModuliArrays<D, R>& at, int first, double* tile) {
  Lanes sum[tile_rows][Columns] = {};
  add_products<Columns>(at.panel, at.rows + first * lanes, R * in.points, at.step, sum);
#pragma GCC unroll 4
  for (int r = 0; r < tile_rows; ++r)
#pragma GCC unroll 4
    for (int c = 0; c < Columns; ++c) set_lanes(tile + r * in.functions + (first + c) * lanes, sum[r][c]);
}

// Three columns of four sums leave no register of AVX2 and SSE2 for the factors, which takes three times as long as
// two.
#if defined(__AVX512F__)
constexpr int columns_at_once = 4;
#else
constexpr int columns_at_once = 2;
#endif

/// All blocks i ≤ j; of those with i = j a triangle, then the other. The last columns of a tile are computed first:
/// what their vectors write beyond a row is the start of the next.
template <int D, int R> inline void write_tangent(const KernelArguments& in, const ModuliArrays<D, R>& at) {
  const int n = in.functions, vectors = at.padded / lanes;
  double* block = in.blocks;
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j, block += n * n)
      for (int row = 0; row < n; row += tile_rows) {
        const int a = row + tile_rows < n ? row : n - tile_rows, begin = i == j ? a / lanes : 0;
        write_panel<D, R>(in, at, i, j, a);
        for (int end = vectors; end > begin;) {
          const int columns = end - begin < columns_at_once ? end - begin : columns_at_once, first = end - columns;
          end = first;
          double* tile = block + a * n;
          if (columns == 1) add_columns<1>(in, at, first, tile);
          if (columns == 2) add_columns<2>(in, at, first, tile);
          if constexpr (columns_at_once == 4) {
            if (columns == 3) add_columns<3>(in, at, first, tile);
            if (columns == 4) add_columns<4>(in, at, first, tile);
          }
        }
      }
  block = in.blocks;
  for (int i = 0; i < D; block += (D - i) * n * n, ++i)
    for (int a = 1; a < n; ++a)
      for (int b = 0; b < a; ++b) block[a * n + b] = block[b * n + a];
}

/// A_ik,jl −= b Δ T_il T_jk with T = F⁻ᵀ, the moduli b = F:(A:F + P)/9 of a change of volume and Δ, what was predicted
/// for ln J less ln J [theory 2.10].
template <int D, int R> inline void predict_volume(const KernelArguments& in, const ModuliArrays<D, R>& at) {
  constexpr int entries = entries_in(D);
  for (int q = 0; q < in.points; ++q) {
    double f[9] = {}, inverse[9], rate = 0;
    for (int e = 0; e < entries; ++e) f[component<D>(e)] = at.f[e * at.stride + q];
    for (int e = 0; e < entries; ++e) {
      double change = at.stress[e * at.stride + q];
      for (int o = 0; o < entries; ++o) change += at.modulus(e, o)[q] * f[component<D>(o)];
      rate += f[component<D>(e)] * change / 9;
    }
    invert_space(f, inverse);
    const double factor = rate * in.predicted[q];
    for (int e = 0; e < entries; ++e)
      for (int o = e; o < entries; ++o) {
        const int i = component<D>(e) / 3, k = component<D>(e) % 3, j = component<D>(o) / 3, l = component<D>(o) % 3;
        at.modulus(e, o)[q] -= factor * inverse[3 * l + i] * inverse[3 * k + j];
      }
  }
}

template <int D, int R> inline KernelResult run_rows(const KernelArguments& in) {
  const ModuliArrays<D, R> at(in);
  if (const KernelResult result = write_deformations<D, R>(in, at); result.point >= 0) return result;
  in.respond(in.law, {in.points, at.stride, at.f, at.stress, in.blocks ? at.moduli : nullptr, in.memory});
  if constexpr (D == 2)
    for (int q = 0; q < in.points; ++q)
      if (const double across = at.f[4 * at.stride + q]; !(across > 0)) return {q, across};
  write_force<D, R>(in, at);
  if (!in.blocks) return {-1, 1};
  if (in.predicted) predict_volume<D, R>(in, at);
  constexpr int used = D == 2 && R == 2 ? 4 : entries_in(D);
  for (int e = 0; e < used; ++e)
    for (int o = e; o < used; ++o) {
      double* __restrict row = at.modulus(e, o);
      for (int q = 0; q < in.points; ++q) row[q] *= in.weights[q];
    }
  write_tangent<D, R>(in, at);
  return {-1, 1};
}

/// Elements have at least `tile_rows` functions.
template <int D> KernelResult run_moduli(const KernelArguments& in) {
  if constexpr (D == 2)
    if (in.hoop) return run_rows<2, 3>(in);
  return run_rows<D, D>(in);
}

} // namespace

} // namespace signorini::solid
