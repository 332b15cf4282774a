#pragma once
// Elastic laws from a formula of the energy.

#include "solid/energy_program.hpp"
#include "solid/material.hpp"
#include "symbolic/graph.hpp"

namespace signorini::solid {

/// What the variables of an energy are.
enum class Measure {
  invariants, ///< I₁ = tr C, I₂ = (tr² C − tr C²)/2, J = det F, then a·C a for each fiber direction a
  stretches,  ///< the principal stretches, in which the energy must be symmetric
};

/// An energy per reference volume as it is written to files.
struct EnergyFormula {
  std::string label; ///< "Mooney-Rivlin"
  Measure measure;
  std::vector<Vec<3>> fibers; ///< directions in the reference configuration, scaled to length 1
  symbolic::Graph graph;
  int energy; ///< node
};

/// The variables of an energy in their order.
std::vector<std::string> variable_names(Measure measure, std::size_t fibers);

/// Compiled energies and their derivatives.
struct Energy;

struct Hyperelastic : ElasticConstants {
  static constexpr auto name = "hyperelastic";
  static constexpr bool linear = false;
  double energy(const Mat<3>& f) const;
  Mat<3> stress(const Mat<3>& f) const;
  Moduli moduli(const Mat<3>& f) const;
  template <int D> static void respond(const void* law, const PointBlock& block);
  const EnergyFormula& formula() const;

  std::shared_ptr<const Energy> compiled;
};

/// Throws Error unless energy and derivatives are finite at F = I, stress is zero there and the moduli are positive
/// definite; if the energy is not symmetric in the stretches; or if there are more than most_fibers directions or one
/// is zero. The elastic constants are those of the moduli at F = I; with fibers, of their average over all directions
/// (Voigt).
Hyperelastic hyperelastic(EnergyFormula formula);

/// The law of a material made from a formula, or null.
const Hyperelastic* hyperelastic_law(const Material& material);

extern template Material::Material(Hyperelastic);

} // namespace signorini::solid
