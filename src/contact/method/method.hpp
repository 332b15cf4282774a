#pragma once
// Contact method as the user specifies it, and the formulation made from it.

#include "contact/gauss/cohesive_contact.hpp"
#include "contact/mortar/mortar_contact.hpp"
#include "contact/mortar/multiplier_contact.hpp"

#include <functional>
#include <optional>

namespace signorini::contact {

/// Contact between a slave face and its master: a law, a bond in addition to it, and where the conditions hold: at
/// contact points, or weighted by multiplier functions on the slave face (mortar contact).
struct Method {
  Method(InterfaceLaw of = {0}, std::optional<MultiplierSpace> by = {}, Pass acts = Pass::full,
         std::optional<Cohesion> bonded = {})
      : law(of), multipliers(by), pass(acts), bond(bonded) {}

  InterfaceLaw law;
  std::optional<MultiplierSpace> multipliers; ///< none: at contact points
  /// One of two half passes between two faces: its forces act on the slave alone, those on the other face come from the
  /// other pass. Tractions act per current area, since reference areas of the two faces are stretched differently.
  Pass pass;
  std::optional<Cohesion> bond; ///< with a law at contact points, per reference area
  UnknownMultipliers unknown = {};
};

/// Makes a user-defined formulation. Scenes with one can be solved, but not saved.
template <int D> using FormulationFactory = std::function<std::unique_ptr<Formulation<D>>(ContactSetting<D>)>;

/// Throws Error if a constant is invalid, or the formulation has no such enforcement.
template <int D> std::unique_ptr<Formulation<D>> make_formulation(const Method& method, ContactSetting<D> setting);

} // namespace signorini::contact
