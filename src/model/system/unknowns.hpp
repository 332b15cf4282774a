#pragma once
// Numbering of degrees of freedom and unknowns: free, prescribed and shared displacement components.

#include "base/eigen.hpp"
#include "model/scene/scene.hpp"

#include <vector>

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
/// additional unknowns of its formulation, and by tie, its multipliers, which are all free. The free ones
/// are numbered consecutively as unknowns. The control points of a rotating support share one unknown for each free
/// component of its translation. Coincident control points of a body, such as the pole of a sphere, and those of joined
/// faces share their unknowns; a support of one of them acts on all.
template <int D> class Unknowns {
public:
  /// Throws Error if two supports constrain the same component in contradictory ways.
  explicit Unknowns(const Scene<D>& scene, const contact::Formulations<D>& contacts = {},
                    const contact::Ties<D>& ties = {});

  int dofs() const { return std::ssize(unknown_); }
  /// Number of degrees of freedom that are displacements; those of contacts and ties follow.
  int displacements() const { return displacements_; }
  int size() const { return size_; }
  /// Number of unknowns that are displacements; those of contacts and ties follow.
  int free_displacements() const { return free_displacements_; }
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
  /// Unknown of a degree of freedom; −1 if it is prescribed.
  int unknown(int dof) const { return unknown_[dof]; }
  /// The unknown that moves a degree of freedom: its own, or of a marker the angle that it follows; −1: none.
  int mover(int dof) const { return movers_.empty() ? unknown(dof) : movers_[dof]; }
  /// Whether any unknown belongs to several bodies.
  bool any_of_several_bodies() const { return any_of_several_bodies_; }
  /// Whether an unknown belongs to several bodies, which are joined or rotate together.
  bool of_several_bodies(int unknown) const { return of_several_bodies_[unknown] != 0; }
  /// Whether a support constrains this degree of freedom: it is prescribed, or rotates with others.
  bool constrained(int dof) const { return constrained_[dof] != 0; }
  /// Degrees of freedom of a support in one component, also if that is free.
  const std::vector<int>& of_support(int support, int component) const { return of_support_[support * D + component]; }

  /// Sums values of all degrees of freedom into their unknowns.
  VectorX gather(const VectorX& values) const;
  /// Transpose of gather(): the value of each degree of freedom's unknown, 0 if it is prescribed.
  VectorX spread(const VectorX& values) const;
  /// 2-norm over the degrees of freedom with constrained().
  double constrained_norm(const VectorX& values) const;
  /// Sum by component over control points and translations of obstacles.
  Vec<D> resultant(const VectorX& values) const;

private:
  int size_ = 0, obstacles_ = 0, displacements_ = 0, free_displacements_ = 0;
  std::vector<int> offsets_, obstacle_offsets_, unknown_, movers_, of_ties_;
  std::vector<FreeAngle<D>> free_angles_;
  std::vector<contact::Offsets> of_contacts_;
  std::vector<char> constrained_, of_several_bodies_;
  bool any_of_several_bodies_ = false;
  std::vector<std::vector<int>> of_support_;
};

} // namespace signorini::model
