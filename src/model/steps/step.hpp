#pragma once
// State of the current step between its iterations.

#include "base/eigen.hpp"
#include "solve/newton.hpp"
#include "solve/pseudo_time.hpp"

#include <optional>

namespace signorini::model {

/// Contacts of unconstrained bodies that are open at the start of a step, see contact::Controls::all_stick.
struct ClosingContacts {
  std::vector<char> contacts; ///< by contact, true if it is one of them
  double largest_energy = 0;  ///< |f·Δu|, since any contact has closed
};

/// State of pseudo-transient continuation.
struct PseudoTransient {
  VectorX viscosity; ///< D, by unknown
  VectorX origin;    ///< displacement at its start
  solve::PseudoTime time = {};
};

struct Step {
  VectorX increment = {}; ///< of prescribed displacements, to be applied with the first solution
  bool pending = false;   ///< `increment` was not zero when the step began
  solve::NewtonReport report = {};
  bool moved_by_user = false;   ///< the last change of the state was by move_by()
  bool evaluated = false;       ///< the last evaluation was that of a line search, at the present state
  bool guess_evaluated = false; ///< a state away from the accepted one was the guess: contact::Controls::foresees
  bool definite = false;        ///< see Model
  VectorX before = {};          ///< displacement before the last correction; empty: there was none
  std::optional<ClosingContacts> closing = {}; ///< until unconstrained bodies are in contact
  std::optional<PseudoTransient> pseudo_transient = {};

  double pseudo_damping() const { return pseudo_transient ? pseudo_transient->time.damping() : 0; }
};

} // namespace signorini::model
