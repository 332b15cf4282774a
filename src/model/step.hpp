#pragma once
// A step under way.

#include "base/eigen.hpp"
#include "solve/newton.hpp"
#include "solve/pseudo_time.hpp"

namespace signorini::model {

struct Step {
  VectorX increment = {}; ///< prescribed displacements that wait for the first solve
  bool pending = false;   ///< whether there are any
  solve::NewtonReport report = {};
  bool moved = true;    ///< the state has moved since the active set took note of it
  bool lead = false;    ///< the last to move the state was move_by()
  bool landing = false; ///< bodies that only contact will hold have not settled on it yet, see contact::Controls
  double impact = 0;    ///< largest |f·Δu| since they touch
  int augmentations = 0;
  VectorX before = {}, move = {}; ///< for line search: the state before the last move, and the move
  double slope = 0;               ///< f·Δu in that state
  solve::PseudoTime pseudo_time = {};
  VectorX viscosity = {}; ///< D of pseudo-transient continuation, by unknown
  VectorX origin = {};    ///< where that began
  double fraction = 0;    ///< λ of an arc: 0 at the accepted state, 1 at the targets
};

} // namespace signorini::model
