#pragma once
// Neighbors of a run: two models of the same scene at q + ε and q − ε that follow it. Their difference over 2ε is the
// derivative of its state, and of all that follows from it [theory 12].

#include "model/gradients/kinks.hpp"
#include "model/steps/model.hpp"
#include "model/steps/step_options.hpp"

namespace signorini::model {

template <int D> struct Neighbors {
  Model<D>& plus;
  Model<D>& minus;
  double step; ///< ε
  double size; ///< of the parameter, of which ε is a small part
  /// A neighbor in another parameter that has made its factors in this step, as `renewed` of its report says, or
  /// nullptr.
  Model<D>* factored = nullptr;
  /// Likewise one whose factors are those of the first solution of this step, as `begun` says, or nullptr.
  Model<D>* begun = nullptr;
};

template <int D> struct FollowReport {
  int passes = 0;
  bool renewed = false; ///< the factors of the run gained too little, so that `plus` has those of its own state
  bool begun = false; ///< `minus` has the factors of its first solution, which the step takes if it is not extrapolated
  double defect = 0;  ///< residual of the equation of the derivative, times the size of the parameter
  double forces = 0;  ///< what to compare it with: its first value, or the forces of supports and loads if larger
  Kinks<D> kinks;
  Message failure = {}; ///< why the neighbors could not follow; its code is empty if they did
};

/// Moves both neighbors from their accepted states to those that belong to the converged present state of the run,
/// which is not accepted yet, and accepts them. Their targets, penalty factor, time and constants of contacts have been
/// set; `options`: of the run's step. Does not change the run.
template <int D> FollowReport<D> follow_run(Model<D>& run, const Neighbors<D>& neighbors, const StepOptions& options);

/// What a neighbor must have in common with the run and has not: unknowns, prescribed quantities or contact points; its
/// code is empty if it has all.
template <int D> Message difference(const Model<D>& run, const Model<D>& neighbor);

} // namespace signorini::model
