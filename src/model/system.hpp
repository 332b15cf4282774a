#pragma once
// What turns a scene and a state into residual and tangent.

#include "model/assembly.hpp"
#include "model/damping.hpp"
#include "model/drives.hpp"

namespace signorini::model {

template <int D> struct System {
  /// Throws Error for a scene without bodies, a contact of a face with itself, faces that carry no tensor product, or
  /// supports that contradict each other.
  explicit System(Scene<D> given);
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  contact::Formulations<D> contacts; ///< in the scene's order; they hold where the faces stand now
  const Scene<D> scene;
  const Unknowns<D> unknowns;
  const Drives<D> drives;
  Assembly<D> assembly; ///< holds the tangent of the last evaluation that wanted one
  double size = 0;      ///< largest coordinate of a control point or an obstacle
  double extent = 0;    ///< largest diameter of a body about its middle: what penetrations are measured against

  /// The scene as it was given, not evaluated yet.
  State<D> start() const;
  /// What accepting leaves behind in contacts, such as slip points that advance; the caller then makes `present` the
  /// accepted state.
  void commit(State<D>& present, const State<D>& accepted);
  /// Moves the contacts' faces back to the accepted state.
  void stand(const State<D>& accepted);
  /// Drops all that evaluations of other states have left behind and that rounding may depend on later.
  void settle(State<D>& accepted);

  /// Rigid motions that no support stops; found when first asked for.
  const std::vector<LooseMotion>& loose();
  /// See path_norm.hpp; found when first asked for.
  const VectorX& path_weights();

private:
  std::optional<std::vector<LooseMotion>> loose_;
  std::optional<VectorX> path_weights_;
};

} // namespace signorini::model
