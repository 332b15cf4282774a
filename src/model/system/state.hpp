#pragma once
// State of a model: a plain value. Accepting and restoring a state are assignments.

#include "base/eigen.hpp"
#include "base/shared_list.hpp"
#include "contact/point/history.hpp"

namespace signorini::model {

template <int D> struct State {
  VectorX displacement;      ///< of all degrees of freedom (Unknowns), followed by the contacts' additional unknowns
  VectorX targets;           ///< of the prescribed displacements (Drives)
  VectorX force;             ///< f_int + f_c of all degrees of freedom in the last evaluation
  double penalty_factor = 1; ///< on all penalty parameters
  double time = 0;           ///< of stages with a duration
  bool relaxed = false;      ///< the step to this state lasts until nothing changes any more; never of an accepted one
  /// Shared, since those of contacts with many points are large, and most states are only kept.
  SharedList<contact::History<D>> contacts;
  std::vector<std::vector<double>> internal; ///< internal variables of the materials, by body; empty without any
};

/// History of the path up to the accepted state, which the next step uses.
struct PathHistory {
  VectorX increment;        ///< displacement of the last accepted step
  VectorX previous_targets; ///< before that step
  VectorX before;           ///< displacement of the step before the last one
  VectorX targets_before;   ///< before that step
  /// Relative deviations of the last step from its extrapolations: the step before it in proportion, and the parabola
  /// through the three states before it; 1 without one.
  double linear_error = 1, quadratic_error = 1;
  double force_scale = 0; ///< largest norm of the forces of supports and loads in the accepted states
  double work = 0;        ///< of supports and loads in all accepted steps, by the trapezoidal rule
};

} // namespace signorini::model
