#pragma once
// Quantities that a path controls: displacements and angles of supports, magnitudes of loads; and the displacements and
// forces that they prescribe.

#include "model/system/unknowns.hpp"

namespace signorini::model {

/// A support with driven components or rotation, or a load: its name and components, such as {"x", "y"}, {"angle"},
/// {"pressure"}, {"bx", "by"} of a force per volume, {"px", "py"} on corners and edges, {"factor"} of a function.
struct Drive {
  std::string name;
  int support; ///< index into Scene::supports; −1 for a load
  int load;    ///< index into Scene::loads; −1 for a support
  int first;   ///< index of its first component in the targets
  std::vector<std::string> components;
};

/// The scene's targets are one vector, drive after drive, component after component: lengths, degrees, forces per area.
template <int D> class Drives {
public:
  /// Throws Error for a load on a face that is not a tensor-product face.
  Drives(const Scene<D>& scene, const Unknowns<D>& unknowns);

  /// Supports before loads.
  const std::vector<Drive>& all() const { return all_; }
  /// Index of a drive's component in the targets. Throws Error if there is no such drive or component.
  int target(int drive, int component) const;
  /// Initial targets: zero displacements and the loads' start values.
  const VectorX& start() const { return start_; }

  /// Prescribed displacement at given targets, by degree of freedom; 0 where none is prescribed.
  VectorX displacement(const VectorX& targets) const;
  /// Its derivative along a direction of the targets.
  VectorX rate(const VectorX& targets, const VectorX& direction) const;
  /// Force of the dead loads on all degrees of freedom; linear in the targets.
  VectorX force(const VectorX& targets) const;

  /// Moment Σ (R(θ) r_A) × f_A of a rotating support about its center (3D: its axis), conjugate to its angle in
  /// radians.
  double moment(int support, const VectorX& targets, const VectorX& force) const;
  /// The targets of one load, all others zero.
  VectorX only(int load, const VectorX& targets) const;

private:
  /// A degree of freedom that follows a target: u = shape · target + ((R(θ) − I) r)_component.
  struct Follower {
    int dof, component;
    int target; ///< of the translation; −1: none
    int angle;  ///< target of the angle in degrees; −1: no rotation
    Vec<D> arm; ///< r = X − X_c
    Vec<D> axis;
    double shape; ///< 1 unless the support has a shape
  };
  void follow(int support, const Drive& drive);
  double shape_of(const Support<D>& support, int body, int function, int component) const;
  void add_unit_load(const Load& load, int component, Eigen::Ref<VectorX> force) const;

  const Scene<D>& scene_;
  const Unknowns<D>& unknowns_;
  std::vector<Drive> all_;
  std::vector<Follower> followers_;
  VectorX start_;
  MatrixX loads_; ///< degrees of freedom × targets: force of dead loads per unit of each; zero columns for others
};

/// Centroid of a face in the reference configuration.
template <int D> Vec<D> face_centroid(const solid::Body<D>& body, nurbs::Side side);

} // namespace signorini::model
