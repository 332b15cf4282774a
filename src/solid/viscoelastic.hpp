#pragma once
// Viscoelasticity: any elastic law whose stress relaxes by a Prony series.

#include "solid/material.hpp"

namespace signorini::solid {

/// A term of a Prony series: the fraction g of the stress relaxes with time τ.
struct Relaxation {
  double fraction, time;
};

/// What relaxes: the stress of the change of shape alone, or all of it.
enum class Relaxes { shape, all };

/// Stress of the elastic law W and overstresses H_i that follow it: convolution in the second Piola–Kirchhoff stress
/// (J. C. Simo, Comput. Methods Appl. Mech. Eng. 60, 1987; G. A. Holzapfel, Int. J. Numer. Methods Eng. 39, 1996)
/// [theory 2.12]. The elastic constants are those at once.
struct Viscoelastic : ElasticConstants {
  static constexpr auto name = "viscoelastic";
  static constexpr bool linear = false;
  bool small_strains() const { return elastic.small_strains(); }
  std::vector<double> initial_values(int dimensions) const;
  double energy(const Mat<3>& f, const Memory& memory) const;
  Mat<3> stress(const Mat<3>& f, const Memory& memory) const;
  Moduli moduli(const Mat<3>& f, const Memory& memory) const;
  Account account(const Mat<3>& f, std::span<const double> values) const;
  template <int D> static void respond(const void* law, const PointBlock& block);

  Material elastic;
  Relaxes relaxes;
  std::vector<Relaxation> series;
};

/// Throws Error unless all fractions and times are positive and the fractions sum up to less than 1; for a law that has
/// internal variables itself; and without series.
Viscoelastic viscoelastic(Material elastic, std::vector<Relaxation> series, Relaxes relaxes);

/// The law of a viscoelastic material, or null.
const Viscoelastic* viscoelastic_law(const Material& material);

/// ΔS of the error that a step makes in the overstresses of one point relative to the stress, estimated as the
/// difference from the backward Euler rule. `memory`: at the start and at the end of the step.
double step_error(const Viscoelastic& law, const Memory& memory);

extern template Material::Material(Viscoelastic);

} // namespace signorini::solid
