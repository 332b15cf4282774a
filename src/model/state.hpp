#pragma once
// Where a model stands: a plain value. To accept a state, and to return to it, are assignments.

#include "base/eigen.hpp"
#include "contact/history.hpp"

namespace signorini::model {

template <int D> struct State {
  VectorX displacement; ///< of all degrees of freedom (Unknowns), with the values of the contacts' own unknowns behind
  VectorX targets;      ///< that the prescribed displacements have (Drives)
  VectorX force;        ///< f_int + f_c of all degrees of freedom in the last evaluation
  double penalty_factor = 1; ///< of all contacts' penalty parameters
  std::vector<contact::History<D>> contacts;
  std::vector<std::vector<double>> internal; ///< the materials' internal variables, by body; empty for most
};

/// What the steps up to the accepted state leave to the next one.
struct Way {
  VectorX increment;        ///< displacement of the last accepted step
  VectorX previous_targets; ///< before it
  double bend = 1;          ///< relative difference of the last two steps' rates; 1 where there are none to compare
  double force_scale = 0;   ///< largest norm of the forces of supports and loads in the accepted states
  double work = 0;          ///< of supports and loads in all accepted steps, by the trapezoidal rule
};

} // namespace signorini::model
