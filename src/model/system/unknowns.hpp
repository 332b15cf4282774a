#pragma once
// Numbering of unknowns: the free degrees of freedom.

#include "model/system/dofs.hpp"

namespace signorini::model {

/// The free degrees of freedom are numbered consecutively as unknowns; those of contacts and ties all are. The control
/// points of a rotating support share one unknown for each free component of its translation. Coincident control points
/// of a body, such as the pole of a sphere, and those of joined faces share their unknowns; a support of one of them
/// acts on all.
template <int D> class Unknowns : public Dofs<D> {
public:
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
