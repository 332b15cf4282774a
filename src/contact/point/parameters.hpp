#pragma once
// Parameters of a contact along a load path: those of the scene, and what changes make of them.

#include "contact/law/interface_law.hpp"

#include <optional>
#include <vector>

namespace signorini::contact {

/// Where forces act: on both faces, or in a half pass on the slave alone.
enum class Pass : unsigned char { full, half };

struct Parameters {
  Start start;
  std::optional<InterfaceLaw> law = {}; ///< of the scene, if the formulation has one
  Pass pass = Pass::full;
  /// Overlap of the initial shapes at the points, if the contact is an interference fit; otherwise empty.
  std::vector<double> overlap = {};

  bool active(const Changes& changes) const { return changes.active.value_or(start.active); }
  /// The gap at which the faces touch [theory 5.7]; at point i, where an overlap is allowed.
  double offset(const Changes& changes) const { return changes.offset.value_or(start.offset); }
  double offset(std::size_t i, const Changes& changes) const {
    return offset(changes) - (overlap.empty() ? 0 : changes.overlap * overlap[i]);
  }
  /// The same in a state: what the point has lost by wear is missing.
  template <class History> double offset(std::size_t i, const History& history) const {
    return offset(i, history.changes) - history.points[i].worn;
  }
  /// The law in a state, with its penalty parameters times a factor, which does not act on those that weigh
  /// multipliers. Requires a law.
  InterfaceLaw law_in(const Changes& changes, double factor) const {
    return scaled(changed(*law, changes), law->enforcement == Enforcement::multipliers ? 1 : factor);
  }
  /// Coulomb's μ and the penalty parameter ε_N (0: none), which warnings and the diagnosis compare with usual values.
  double friction(const Changes& changes) const { return law ? changed(*law, changes).friction : 0; }
  bool slides(const Changes& changes) const { return law && contact::slides(changed(*law, changes)); }
  /// True if the coefficient of friction or the rate of wear differs between points or directions.
  bool by_formula() const { return law && (law->coefficient || law->wear || law->ellipse); }
  bool wears() const { return law && law->wear; }
  bool rubs() const { return law && may_rub(*law); }
  double penalty(const Changes& changes) const { return law ? changed(*law, changes).normal : 0; }
  /// Both half passes compute the whole energy of the springs and the whole work of friction between the faces: each
  /// counts half.
  double energy_share() const { return pass == Pass::half ? 0.5 : 1; }
};

} // namespace signorini::contact
