#pragma once
// A scene in motion: the displacement state, one Newton step at a time, accepted or rolled back by the caller.

#include "model/assembly.hpp"
#include "solve/linear.hpp"
#include "solve/newton.hpp"

#include <memory>

namespace signorini::model {

struct StepOptions {
  solve::NewtonOptions newton;
  solve::LinearKind linear = solve::LinearKind::automatic;
};

/// The model keeps two states: the accepted one, and the present one, which equals it before a step and after a
/// roll-back.
template <int D> class Model {
public:
  /// Throws Error for a scene without bodies, a contact of a face with itself, faces that carry no tensor product, or
  /// supports that contradict each other.
  explicit Model(Scene<D> scene);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const Scene<D>& scene() const { return scene_; }
  const Unknowns<D>& unknowns() const { return unknowns_; }
  const std::vector<contact::Pair<D>>& pairs() const { return pairs_; }

  /// Prescribed displacement that a driven component shall have at the end of the next step.
  void set_target(int support, int component, double displacement);
  /// The same as accepted last.
  double accepted_target(int support, int component) const;

  /// Solves for the present targets by Newton's method from the accepted state. Does not accept.
  solve::NewtonReport solve_step(const StepOptions& options);
  /// Makes the present state the accepted one. Call after solve_step() has converged.
  void accept();
  /// Returns to the accepted state, targets included.
  void rollback();

  /// Present displacement of all degrees of freedom (see Unknowns).
  const VectorX& displacement() const { return displacement_; }
  /// Present displacement of a body's control points, D × functions.
  Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic>> body_displacement(int body) const;
  /// Force that a support exerts on its bodies.
  Vec<D> reaction(int support) const;
  contact::Resultant<D> contact_resultant(int contact) const;
  double stored_energy() const;

  const Timings& timings() const { return timings_; }
  /// Patterns analysed, full assemblies.
  int patterns() const { return assembly_.pattern_version(); }
  solve::LinearKind linear_kind() const;

private:
  solve::Outcome assemble(const VectorX* increment, bool tangent, std::string& why);
  bool advance(const StepOptions& options, VectorX& increment, double& energy);
  double reaction_norm() const;
  double rounding_floor() const;

  Scene<D> scene_;
  Unknowns<D> unknowns_;
  Assembly<D> assembly_;
  std::vector<contact::Pair<D>> pairs_;
  VectorX displacement_, accepted_;
  std::vector<double> targets_, accepted_targets_; ///< [support · D + component]
  std::unique_ptr<solve::LinearSolver> solver_;
  solve::LinearKind solver_asked_ = solve::LinearKind::automatic;
  int solver_version_ = 0;
  double force_scale_ = 0; ///< largest reaction norm of the accepted states
  double size_ = 0;        ///< largest coordinate of a control point
  Timings timings_;
};

} // namespace signorini::model
