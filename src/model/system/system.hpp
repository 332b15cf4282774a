#pragma once
// System: turns a scene and a state into residual and tangent.

#include "model/system/assembly.hpp"
#include "model/system/damping.hpp"
#include "model/system/follower_loads.hpp"
#include "model/system/springs.hpp"

namespace signorini::model {

template <int D> struct System {
  /// Throws Error as complete() and make_ties(), and for faces other than tensor-product faces.
  explicit System(Scene<D> given);
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  contact::Formulations<D> contacts; ///< in the scene's order, with the current positions of their faces
  const contact::Ties<D> ties;       ///< in the scene's order
  const Scene<D> scene;
  const Unknowns<D> unknowns;
  const Drives<D> drives;
  const FollowerLoads<D> followers;
  const Springs<D> springs;
  Assembly<D> assembly;          ///< with the tangent of the last evaluation with tangent
  std::vector<double> stiffness; ///< of the contacts: contact_stiffness()
  double size = 0;               ///< largest coordinate of control points, of bodies and obstacles
  double extent = 0;             ///< largest diameter of a body about its middle, the scale of penetrations

  /// The initial state, not evaluated yet.
  State<D> start() const;
  /// Updates the contacts at the end of an accepted step, for example by advancing slip points; the caller then makes
  /// `present` the accepted state.
  void commit(State<D>& present, const State<D>& accepted);
  /// Moves the contacts' faces back to the accepted state.
  void return_to_accepted(const State<D>& accepted);
  /// Drops everything from past evaluations that affects rounding later.
  void settle(State<D>& accepted);

  /// Rigid-body modes that no support prevents; computed on first use.
  const std::vector<UnconstrainedMotion>& unconstrained();
  /// Unknown motions of obstacles that no spring prevents; computed on first use.
  const std::vector<UnconstrainedObstacle>& unconstrained_obstacles();
  /// True if there are any of both.
  bool has_unconstrained() { return !unconstrained().empty() || !unconstrained_obstacles().empty(); }
  /// See path_norm.hpp; computed on first use.
  const VectorX& path_weights();

private:
  std::optional<std::vector<UnconstrainedMotion>> unconstrained_;
  std::optional<std::vector<UnconstrainedObstacle>> unconstrained_obstacles_;
  std::optional<VectorX> path_weights_;
};

} // namespace signorini::model
