#pragma once
// State of the current step.

#include "base/eigen.hpp"
#include "solve/newton.hpp"
#include "solve/pseudo_time.hpp"

namespace signorini::model {

struct Step {
  VectorX increment = {}; ///< of prescribed displacements, to be applied with the first solution
  bool pending = false;   ///< whether `increment` is nonzero
  solve::NewtonReport report = {};
  bool moved = true;     ///< the state has changed since the active set recorded it
  bool lead = false;     ///< the last change of the state was by move_by()
  bool foreseen = false; ///< a state away from the accepted one was the guess, see contact::Controls::foresees
  bool landing = false;  ///< unconstrained bodies are coming into contact, see contact::Controls
  double impact = 0;     ///< largest |f·Δu| since their first contact
  int augmentations = 0;
  VectorX before = {}, move = {}; ///< for line search: the state before the last move, and the move
  double slope = 0;               ///< f·Δu in that state
  bool definite = false;          ///< see Model
  solve::PseudoTime pseudo_time = {};
  VectorX viscosity = {}; ///< D of pseudo-transient continuation, by unknown
  VectorX origin = {};    ///< displacement at its start
  double fraction = 0;    ///< λ of an arc-length increment: 0 at the accepted state, 1 at the targets
};

} // namespace signorini::model
