#pragma once
// Stress and moduli of a law at many points at once, as plain data for the files compiled for wider vectors.

namespace signorini::solid {

/// The entries of F, P and ∂P/∂F that a body uses: all nine in space, row by row; F₁₁, F₁₂, F₂₁, F₂₂, F₃₃ in the plane.
constexpr int entries_in(int dimensions) {
  return dimensions == 2 ? 5 : 9;
}
constexpr int plane_entries[] = {0, 1, 3, 4, 8}; ///< 3i + k for F_ik
/// 3i + k of entry e.
template <int D> constexpr int component(int e) {
  return D == 3 ? e : plane_entries[e];
}
/// The entry of F that a displacement component i makes with row r of functions, ∂R_A/∂X_r or, in a body of revolution,
/// R_A/R; −1: none.
template <int D> constexpr int entry_of(int i, int r) {
  return r < D ? D * i + r : i == 0 ? entries_in(D) - 1 : -1;
}

/// The place of ∂P_e/∂F_f, e ≤ f, in the packed upper triangle of the moduli.
constexpr int packed(int entries, int e, int f) {
  return e * entries - e * (e - 1) / 2 + f - e;
}
constexpr int packed_size(int entries) {
  return entries * (entries + 1) / 2;
}

/// Internal variables of the points of a block: `variables` values per point, point by point.
struct PointMemory {
  const double* committed = nullptr; ///< at the start of the step; null: there are none
  double* trial = nullptr;           ///< output; null: not wanted
  int variables = 0;                 ///< per point
  double duration = 0;               ///< of the step; infinite: until nothing changes any more
};

/// Points in rows of `stride` values, one row per entry. Rows are readable and writable up to whole vectors, and hold
/// valid F there.
struct PointBlock {
  int points, stride;
  double* f; ///< input; under plane stress the last row is output
  double* stress;
  double* moduli; ///< null: not wanted
  PointMemory memory = {};
};

/// Computes stress, moduli and trial values for F with positive determinant. Under plane stress F₃₃ is not positive
/// where there is no stretch with P₃₃ = 0.
using Respond = void (*)(const void* law, const PointBlock& block);

} // namespace signorini::solid
