#pragma once
// Contact method as the user specifies it, and the formulation made from it.

#include "contact/gauss/cohesive_contact.hpp"
#include "contact/mortar/mortar_contact.hpp"
#include "contact/point/adhesion.hpp"

#include <optional>
#include <variant>

namespace signorini::contact {

/// One of two half passes between two faces: its forces act on the slave alone, those on the other face come from the
/// other pass. Tractions act per current area, since reference areas of the two faces are stretched differently.
struct HalfPass {
  PenaltyLaw penalty;
  std::optional<MultiplierSpace> multipliers = {}; ///< of mortar contact; none: at contact points
};

/// Makes a user-defined formulation. Scenes with one can be solved, but not saved.
template <int D> using FormulationFactory = std::function<std::unique_ptr<Formulation<D>>(ContactSetting<D>)>;

/// Contact law between a slave face and its master: one alternative per formulation, with its constants.
template <int D>
using Method = std::variant<PenaltyLaw, Adhesion, MortarLaw, HalfPass, CohesiveLaw, FormulationFactory<D>>;

/// The penalty law of a method, with the constness of its argument; nullptr for adhesion and user-defined formulations.
template <class AnyMethod> auto penalty_law(AnyMethod& method) {
  auto* law = std::get_if<PenaltyLaw>(&method);
  if (auto* mortar = std::get_if<MortarLaw>(&method)) law = &mortar->penalty;
  if (auto* half = std::get_if<HalfPass>(&method)) law = &half->penalty;
  if (auto* cohesive = std::get_if<CohesiveLaw>(&method)) law = &cohesive->penalty;
  return law;
}

/// Throws Error if a constant is invalid, or the formulation has no such enforcement.
template <int D> std::unique_ptr<Formulation<D>> make_formulation(const Method<D>& method, ContactSetting<D> setting);

} // namespace signorini::contact
