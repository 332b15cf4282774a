#pragma once
// Numbering of degrees of freedom, and of unknowns: the free ones.

#include "base/eigen.hpp"
#include "contact/gauss/block_dofs.hpp"
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
  /// A body's part of values of all degrees of freedom, one column per control point.
  Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic>> of_body(int body, const VectorX& values) const {
    const int first = offset(body), end = body + 1 < std::ssize(offsets_) ? offset(body + 1) : obstacles_;
    return {values.data() + first, D, (end - first) / D};
  }
  /// Sum by component over control points and translations of obstacles.
  Vec<D> resultant(const VectorX& values) const;

private:
  int obstacles_ = 0, displacements_ = 0, dofs_ = 0;
  std::vector<int> offsets_, obstacle_offsets_, of_ties_;
  std::vector<FreeAngle<D>> free_angles_;
  std::vector<contact::Offsets> of_contacts_;
};

/// The free degrees of freedom are numbered consecutively as unknowns; those of contacts and ties all are. The control
/// points of a rotating support share one unknown for each free component of its translation. Coincident control points
/// of a body, such as the pole of a sphere, and those of joined faces share their unknowns; a support of one of them
/// acts on all.
template <int D> class Unknowns : public Dofs<D> {
public:
  /// Requires a scene that complete() accepts: of supports that contradict each other the last one counts.
  explicit Unknowns(const Scene<D>& scene, const contact::Formulations<D>& contacts = {},
                    const contact::Ties<D>& ties = {});

  int size() const { return size_; }
  /// Number of unknowns that are displacements; those of contacts and ties follow.
  int free_displacements() const { return free_displacements_; }
  /// Unknown of a degree of freedom; −1 if it is prescribed.
  int unknown(int dof) const { return unknown_[dof]; }
  /// The unknown on which a degree of freedom depends: its own, or of a marker that of its angle; −1: none.
  int independent(int dof) const { return independent_.empty() ? unknown(dof) : independent_[dof]; }
  /// True if a support constrains this degree of freedom: it is prescribed, or rotates with others.
  bool constrained(int dof) const { return constrained_[dof] != 0; }
  /// Degrees of freedom of a support in one component, also if that is free.
  const std::vector<int>& of_support(int support, int component) const { return of_support_[support * D + component]; }

  /// Sums values of all degrees of freedom into their unknowns.
  VectorX gather(const VectorX& values) const;
  /// Transpose of gather(): the value of each degree of freedom's unknown, 0 if it is prescribed.
  VectorX spread(const VectorX& values) const;
  /// 2-norm over the degrees of freedom with constrained().
  double constrained_norm(const VectorX& values) const;

private:
  int size_ = 0, free_displacements_ = 0;
  std::vector<int> unknown_, independent_;
  std::vector<char> constrained_;
  std::vector<std::vector<int>> of_support_;
};

} // namespace signorini::model
