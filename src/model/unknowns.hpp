#pragma once
// Numbering: which displacement components are free, which a support prescribes, and which move as one.

#include "base/eigen.hpp"
#include "model/scene.hpp"

#include <vector>

namespace signorini::model {

/// Degrees of freedom are numbered body after body, control point after control point, component after component, then
/// obstacle after obstacle, D translations each, then contact after contact, the unknowns of its formulation's own, all
/// free. Those that are free are numbered again without gaps: the unknowns. The
/// control points of a support that rotates share one unknown for each free component of its translation; those that
/// are one point of a body, such as the pole of a sphere, share theirs, and a support that holds one of them holds all.
template <int D> class Unknowns {
public:
  /// Throws Error when two supports hold the same component in ways that contradict each other.
  explicit Unknowns(const Scene<D>& scene, const contact::Formulations<D>& contacts = {});

  int dofs() const { return static_cast<int>(unknown_.size()); }
  /// Degrees of freedom that are displacements: those of contacts come behind.
  int displacements() const { return displacements_; }
  int size() const { return size_; }
  /// First degree of freedom of a body, and of an obstacle.
  int offset(int body) const { return offsets_[at(body)]; }
  int obstacle_offset(int obstacle) const { return obstacles_ + D * obstacle; }
  /// First degrees of freedom that a contact acts on.
  const contact::Offsets& of_contact(std::size_t contact) const { return of_contacts_[contact]; }
  /// Unknown behind a degree of freedom; −1 when it is prescribed.
  int unknown(int dof) const { return unknown_[at(dof)]; }
  /// Whether a support has a say in this degree of freedom: it is prescribed, or rotates with others.
  bool held(int dof) const { return held_[at(dof)] != 0; }
  /// Degrees of freedom of a support in one component, held or not.
  const std::vector<int>& of_support(int support, int component) const {
    return of_support_[at(support * D + component)];
  }

  /// Sums values of all degrees of freedom into their unknowns.
  VectorX gather(const VectorX& values) const;
  /// The opposite: the value of each degree of freedom's unknown, 0 where it is prescribed.
  VectorX spread(const VectorX& values) const;
  /// 2-norm over the degrees of freedom that are held.
  double held_norm(const VectorX& values) const;

private:
  int size_ = 0, obstacles_ = 0, displacements_ = 0;
  std::vector<int> offsets_, unknown_;
  std::vector<contact::Offsets> of_contacts_;
  std::vector<char> held_;
  std::vector<std::vector<int>> of_support_;
};

} // namespace signorini::model
