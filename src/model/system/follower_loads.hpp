#pragma once
// Loads that follow the deformation: pressures along the current normal, per current area.

#include "model/system/drives.hpp"
#include "solid/face_points.hpp"

namespace signorini::model {

template <int D> class FollowerLoads {
public:
  FollowerLoads(const Scene<D>& scene, const Unknowns<D>& unknowns, const Drives<D>& drives);

  /// True if the scene has none.
  bool empty() const { return parts_.empty(); }
  /// Adds their force on all degrees of freedom, which is linear in the targets.
  void add_force(const VectorX& displacement, const VectorX& targets, VectorX& force) const;

  /// An element of a loaded face.
  struct Part {
    solid::FacePoints<D> points;
    MatrixX reference;     ///< control points, D × functions
    std::vector<int> dofs; ///< degrees of freedom, D per function
    int target;            ///< of the pressure
  };
  const std::vector<Part>& parts() const { return parts_; }
  /// ∂f/∂u of a part, in the order of its degrees of freedom [theory 3.5].
  MatrixX tangent(const Part& part, const VectorX& displacement, const VectorX& targets) const;

  /// True if each load derives from an energy, so that the tangent of the unknowns is symmetric: the borders of its
  /// faces close, lie on the axis, or are held so that the area swept by their motion lies across them.
  bool conservative() const;

private:
  MatrixX positions(const Part& part, const VectorX& displacement) const;

  const Unknowns<D>& unknowns_;
  std::vector<Part> parts_;
};

} // namespace signorini::model
