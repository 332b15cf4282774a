#pragma once
// Stress and moduli with respect to F of an energy W(F̄) whose volume change differs from that of F: the projected one,
// or none.

#include "solid/law.hpp"
#include "solid/response.hpp"

namespace signorini::solid {

/// The entries of F, P and the like as in response.hpp.
template <int D> using Entries = Eigen::Matrix<double, entries_in(D), 1>;

/// F̄ = eᶜ F; with small strains F̄ = F + c I. c depends on F at this point by −θ/3, with θ = ln J or tr ε, and on an
/// average of θ.
template <int D> struct VolumeChange {
  bool small_strains;
  double scale;         ///< eᶜ; with small strains 1
  double mean;          ///< τ = P̄:F̄/3, with small strains tr P̄/3
  double excess;        ///< π − τ, with π the average of τ
  Entries<D> f, t;      ///< F̄ and T = ∂θ/∂F = F⁻ᵀ; both are I with small strains
  double predicted = 0; ///< average of what was predicted for θ less θ
};

/// What multiplies averages in the second variation: v and b.
template <int D> struct VolumeCoupling {
  Entries<D> vector;
  double square;
};

/// Turns P̄ and A, its packed moduli in steps of `stride` (null: not wanted), into P* and M.
// P* = eᶜ P̄ + (π − τ) T, and with u = A:F̄, h = eᶜ (u + P̄), b = F̄:u/9 + τ/3
//   M = e²ᶜ A − (h⊗T + T⊗h)/3 + b T⊗T − (π − τ) X, X_ik,jl = T_il T_jk, v = h/3 − b T [theory 2.10].
// At small strains F̄ = ε̄ + I with ε̄ = ε + c I is linear in u: eᶜ is 1, F̄ and T are I, P̄ is the stress σ(ε̄) and
// τ = tr σ/3, so that P* is the same, and the terms with P̄, τ and π vanish from M, b and v.
template <int D> VolumeCoupling<D> change_volume(const VolumeChange<D>& at, Entries<D>& p, double* moduli, int stride) {
  constexpr int entries = entries_in(D);
  const auto& [linear, scale, mean, excess, f, t, predicted] = at;
  const Entries<D> given = p;
  p = scale * given + excess * t;
  if (!moduli) return {};
  Entries<D> u = Entries<D>::Zero();
  for (int e = 0; e < entries; ++e)
    for (int o = e; o < entries; ++o) {
      const double modulus = moduli[packed(entries, e, o) * stride];
      u(e) += modulus * f(o);
      if (o > e) u(o) += modulus * f(e);
    }
  const Entries<D> h = linear ? u : Entries<D>(scale * (u + given));
  const double b = f.dot(u) / 9 + (linear ? 0 : mean / 3), turned = excess + b * predicted;
  Mat<3> turn = Mat<3>::Zero(); // T
  for (int e = 0; e < entries; ++e) turn(component<D>(e) / 3, component<D>(e) % 3) = t(e);
  for (int e = 0; e < entries; ++e)
    for (int o = e; o < entries; ++o) {
      double& value = moduli[packed(entries, e, o) * stride];
      value = scale * scale * value - (h(e) * t(o) + t(e) * h(o)) / 3 + b * t(e) * t(o);
      const int ik = component<D>(e), jl = component<D>(o);
      if (!linear) value -= turned * turn(ik / 3, jl % 3) * turn(jl / 3, ik % 3);
    }
  return {h / 3 - b * t, b};
}

} // namespace signorini::solid
