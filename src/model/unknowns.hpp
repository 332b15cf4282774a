#pragma once
// Numbering: which displacement components of which control points are free, and which a support prescribes.

#include "base/eigen.hpp"
#include "model/scene.hpp"

#include <vector>

namespace signorini::model {

/// Degrees of freedom are numbered body after body, control point after control point, component after component. The
/// free ones are numbered again without gaps: those are the unknowns.
template <int D> class Unknowns {
public:
  /// Throws Error when a component is fixed by one support and driven by another, or driven by two.
  explicit Unknowns(const Scene<D>& scene);

  int dofs() const { return static_cast<int>(unknown_.size()); }
  int size() const { return static_cast<int>(free_.size()); }
  /// First degree of freedom of a body.
  int offset(int body) const { return offsets_[static_cast<std::size_t>(body)]; }
  /// Unknown behind a degree of freedom; −1 when it is prescribed.
  int unknown(int dof) const { return unknown_[static_cast<std::size_t>(dof)]; }
  /// Degree of freedom of each unknown.
  const std::vector<int>& free() const { return free_; }
  const std::vector<int>& prescribed() const { return prescribed_; }
  /// Degrees of freedom that a support drives in one component.
  const std::vector<int>& driven(int support, int component) const {
    return driven_[static_cast<std::size_t>(support * D + component)];
  }
  /// Degrees of freedom of a support in one component, held or not.
  const std::vector<int>& of_support(int support, int component) const {
    return of_support_[static_cast<std::size_t>(support * D + component)];
  }

private:
  std::vector<int> offsets_, unknown_, free_, prescribed_;
  std::vector<std::vector<int>> driven_, of_support_;
};

} // namespace signorini::model
