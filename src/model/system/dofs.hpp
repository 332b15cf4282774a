#pragma once
// Numbering of degrees of freedom.

#include "base/eigen.hpp"
#include "model/scene/scene.hpp"

namespace signorini::model {

/// The angle of an obstacle that is an unknown, see free_angles.hpp.
template <int D> struct FreeAngle {
  int obstacle;
  int dof;     ///< of s = L θ
  int markers; ///< first degree of freedom of the markers, D each
  Vec<D> axis; ///< unit vector (3D); unused in 2D
  double arm;  ///< L
};

/// Degrees of freedom are numbered by body, control point and component, then by obstacle, D translations each, those
/// of D markers if it turns, and D for its angle if that is free, of which the first is used; then by contact, the
/// additional unknowns of its formulation, and by tie, its multipliers.
template <int D> class Dofs {
public:
  Dofs(const Scene<D>& scene, const contact::Formulations<D>& contacts, const contact::Ties<D>& ties);

  int dofs() const { return dofs_; }
  /// Number of degrees of freedom that are displacements; those of contacts and ties follow.
  int displacements() const { return displacements_; }
  /// First degree of freedom of a body, and of an obstacle.
  int offset(int body) const { return offsets_[body]; }
  int obstacle_offset(int obstacle) const { return obstacle_offsets_[obstacle]; }
  /// First degree of freedom of all obstacles.
  int obstacles() const { return obstacles_; }
  /// Angles that are unknowns, by obstacle.
  const std::vector<FreeAngle<D>>& free_angles() const { return free_angles_; }
  /// First degrees of freedom of a contact's faces and additional unknowns.
  const contact::Offsets& of_contact(std::size_t contact) const { return of_contacts_[contact]; }
  /// First degree of freedom of a tie's multipliers.
  int of_tie(std::size_t tie) const { return of_ties_[tie]; }
  /// Sum by component over control points and translations of obstacles.
  Vec<D> resultant(const VectorX& values) const;

private:
  int obstacles_ = 0, displacements_ = 0, dofs_ = 0;
  std::vector<int> offsets_, obstacle_offsets_, of_ties_;
  std::vector<FreeAngle<D>> free_angles_;
  std::vector<contact::Offsets> of_contacts_;
};

} // namespace signorini::model
