#pragma once
// Stress and moduli from an energy of invariants, many points at a time, with the vector width for which the including
// file is compiled. Everything is local to these files and no inline functions of other files are called, so that the
// linker cannot select a copy that an older machine is unable to run. Formulas: [theory 2.4].

#include "solid/energy_program.hpp"
#include "solid/kernel_space.hpp"
#include "symbolic/run.hpp"

namespace signorini::solid {

namespace {

constexpr int chunk = 32; ///< points per run of the tape: its registers stay in the first-level cache

template <int E> constexpr int entry_at(int e) {
  return E == 9 ? e : plane_entries[e];
}

/// One vector of points: F, its cofactors ∂J/∂F, and C = Fᵀ F.
struct LanesOfPoints {
  Lanes f[9], cofactors[9], c[9];
};

template <int E> inline void read_deformation(const PointBlock& block, int q, LanesOfPoints& at) {
  Lanes(&f)[9] = at.f, (&cof)[9] = at.cofactors;
  for (int i = 0; i < 9; ++i) f[i] = cof[i] = Lanes{};
#pragma GCC unroll 9
  for (int e = 0; e < E; ++e) f[entry_at<E>(e)] = lanes_at(block.f + e * block.stride + q);
  cof[8] = f[0] * f[4] - f[1] * f[3];
  if constexpr (E == 9) {
    cof[0] = f[4] * f[8] - f[5] * f[7], cof[1] = f[5] * f[6] - f[3] * f[8], cof[2] = f[3] * f[7] - f[4] * f[6];
    cof[3] = f[2] * f[7] - f[1] * f[8], cof[4] = f[0] * f[8] - f[2] * f[6], cof[5] = f[1] * f[6] - f[0] * f[7];
    cof[6] = f[1] * f[5] - f[2] * f[4], cof[7] = f[2] * f[3] - f[0] * f[5];
  } else {
    cof[0] = f[4] * f[8], cof[1] = -f[3] * f[8], cof[3] = -f[1] * f[8], cof[4] = f[0] * f[8];
  }
}

inline void add_right_cauchy_green(LanesOfPoints& at) {
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
#pragma GCC unroll 3
    for (int l = 0; l < 3; ++l)
      at.c[3 * k + l] = at.f[k] * at.f[l] + at.f[3 + k] * at.f[3 + l] + at.f[6 + k] * at.f[6 + l];
}

/// I₁ = |F|², I₂ = |cof F|², J, |F a|².
template <int E> inline void write_invariants(const EnergyProgram& in, const LanesOfPoints& at, double* registers) {
  Lanes first{}, second{};
#pragma GCC unroll 9
  for (int e = 0; e < E; ++e) {
    const int i = entry_at<E>(e);
    first += at.f[i] * at.f[i];
    second += at.cofactors[i] * at.cofactors[i];
  }
  set_lanes(registers, first);
  set_lanes(registers + chunk, second);
  set_lanes(registers + 2 * chunk, at.f[0] * at.cofactors[0] + at.f[1] * at.cofactors[1] + at.f[2] * at.cofactors[2]);
  const double* a = in.fibers;
  for (int v = 3; v < in.invariants; ++v, a += 3) {
    Lanes sum{};
    for (int i = 0; i < 3; ++i) {
      const Lanes stretched = at.f[3 * i] * a[0] + at.f[3 * i + 1] * a[1] + at.f[3 * i + 2] * a[2];
      sum += stretched * stretched;
    }
    set_lanes(registers + v * chunk, sum);
  }
}

/// The kinds of invariants: all after J are |F a|².
enum class Invariant { i1, i2, j, fiber };

/// Calls visit with the kind of invariant v as a constant, and its direction a.
template <class Visit> inline void with_kind(const EnergyProgram& in, int v, const Visit& visit) {
  if (v == 0) return visit.template operator()<Invariant::i1>(nullptr);
  if (v == 1) return visit.template operator()<Invariant::i2>(nullptr);
  if (v == 2) return visit.template operator()<Invariant::j>(nullptr);
  visit.template operator()<Invariant::fiber>(in.fibers + 3 * (v - 3));
}

/// The entries of ∂I/∂F: 2F, 2(I₁ F − F C), cof F, 2 F a ⊗ a.
template <int E, Invariant kind> inline void write_gradient(const LanesOfPoints& at, const double* a, Lanes* g) {
  const Lanes trace = at.c[0] + at.c[4] + at.c[8];
#pragma GCC unroll 9
  for (int e = 0; e < E; ++e) {
    const int entry = entry_at<E>(e), i = 3 * (entry / 3), k = entry % 3;
    if constexpr (kind == Invariant::i1)
      g[e] = 2 * at.f[entry];
    else if constexpr (kind == Invariant::i2)
      g[e] = 2 * (trace * at.f[entry] - (at.f[i] * at.c[k] + at.f[i + 1] * at.c[3 + k] + at.f[i + 2] * at.c[6 + k]));
    else if constexpr (kind == Invariant::j)
      g[e] = at.cofactors[entry];
    else
      g[e] = 2 * a[k] * (at.f[i] * a[0] + at.f[i + 1] * a[1] + at.f[i + 2] * a[2]);
  }
}

/// The sign of F_mn in ∂(cof F)_ik/∂F_jl = ε_ijm ε_kln F_mn.
constexpr int cofactor_sign(int i, int k, int j, int l) {
  const auto epsilon = [](int a, int b) { return a == b ? 0 : (b - a + 3) % 3 == 1 ? 1 : -1; };
  return epsilon(i, j) * epsilon(k, l);
}

/// Adds slope ∂²I/∂F∂F.
template <int E, Invariant kind>
inline void add_second_gradient(const LanesOfPoints& at, const double* a, const Lanes& slope, Lanes* m) {
  const Lanes twice = 2 * slope, trace = at.c[0] + at.c[4] + at.c[8];
  const Lanes(&f)[9] = at.f;
#pragma GCC unroll 9
  for (int e = 0; e < E; ++e)
#pragma GCC unroll 9
    for (int o = e; o < E; ++o) {
      const int first = entry_at<E>(e), second = entry_at<E>(o);
      const int i = first / 3, k = first % 3, j = second / 3, l = second % 3;
      Lanes& sum = m[packed(E, e, o)];
      if constexpr (kind == Invariant::i1) { // 2 δ_ij δ_kl
        if (e == o) sum += twice;
      } else if constexpr (kind == Invariant::i2) {
        // 2 (I₁ δ_ij δ_kl + 2 F_ik F_jl − F_il F_jk − δ_ij C_kl − δ_kl (F Fᵀ)_ij)
        Lanes part = 2 * f[first] * f[second] - f[3 * i + l] * f[3 * j + k];
        if (i == j) part -= at.c[3 * k + l];
        if (k == l) part -= f[3 * i] * f[3 * j] + f[3 * i + 1] * f[3 * j + 1] + f[3 * i + 2] * f[3 * j + 2];
        if (e == o) part += trace;
        sum += twice * part;
      } else if constexpr (kind == Invariant::j) {
        const int sign = cofactor_sign(i, k, j, l), other = 3 * (3 - i - j) + 3 - k - l;
        if (sign > 0) sum += slope * f[other];
        if (sign < 0) sum -= slope * f[other];
      } else if (i == j) { // 2 δ_ij a_k a_l
        sum += a[k] * a[l] * twice;
      }
    }
}

/// P = Σ_v ∂W/∂I_v ∂I_v/∂F and ∂P/∂F = Σ_vw ∂²W/∂I_v∂I_w ∂I_v/∂F ⊗ ∂I_w/∂F + Σ_v ∂W/∂I_v ∂²I_v/∂F∂F.
template <int E>
inline void write_response(const EnergyProgram& in, const LanesOfPoints& at, const double* registers,
                           const PointBlock& block, int q) {
  Lanes gradients[most_invariants][E], stress[E] = {}, moduli[packed_size(E)] = {};
  const bool wanted = block.moduli != nullptr;
  for (int v = 0; v < in.invariants; ++v) {
    if (in.slopes[v] < 0) continue; // then its derivatives are zero, too
    const Lanes slope = lanes_at(registers + in.slopes[v] * chunk);
    with_kind(in, v, [&]<Invariant kind>(const double* a) {
      write_gradient<E, kind>(at, a, gradients[v]);
      if (wanted) add_second_gradient<E, kind>(at, a, slope, moduli);
    });
    for (int e = 0; e < E; ++e) stress[e] += slope * gradients[v][e];
  }
  for (int v = 0; wanted && v < in.invariants; ++v) {
    Lanes sums[E] = {};
    bool any = false;
    for (int w = 0; w < in.invariants; ++w) {
      if (in.curvatures[v][w] < 0) continue;
      any = true;
      const Lanes curvature = lanes_at(registers + in.curvatures[v][w] * chunk);
      for (int e = 0; e < E; ++e) sums[e] += curvature * gradients[w][e];
    }
    if (!any) continue;
#pragma GCC unroll 9
    for (int e = 0; e < E; ++e)
#pragma GCC unroll 9
      for (int o = e; o < E; ++o) moduli[packed(E, e, o)] += gradients[v][e] * sums[o];
  }
  for (int e = 0; e < E; ++e) set_lanes(block.stress + e * block.stride + q, stress[e]);
  if (wanted)
    for (int e = 0; e < packed_size(E); ++e) set_lanes(block.moduli + e * block.stride + q, moduli[e]);
}

template <int E> void respond_by_energy(const EnergyProgram& in, const PointBlock& block) {
  auto* registers =
      static_cast<double*>(__builtin_alloca(sizeof(double) * chunk * static_cast<unsigned>(in.registers)));
  const int count = block.moduli ? in.curvatures_end : in.slopes_end;
  LanesOfPoints at;
  for (int begin = 0; begin < block.points; begin += chunk) {
    const int points = block.points - begin < chunk ? block.points - begin : chunk;
    for (int q = 0; q < points; q += lanes) {
      read_deformation<E>(block, begin + q, at);
      write_invariants<E>(in, at, registers + q);
    }
    symbolic::run(in.code, count, registers, chunk, points);
    for (int q = 0; q < points; q += lanes) {
      read_deformation<E>(block, begin + q, at);
      add_right_cauchy_green(at);
      write_response<E>(in, at, registers + q, block, begin + q);
    }
  }
}

} // namespace

} // namespace signorini::solid
