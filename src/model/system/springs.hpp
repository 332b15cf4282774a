#pragma once
// Elastic supports: springs between faces and the ground, with a stiffness per reference area for each component, and
// between obstacles and the ground.

#include "model/system/unknowns.hpp"

namespace signorini::model {

template <int D> class Springs {
public:
  Springs(const Scene<D>& scene, const Unknowns<D>& unknowns);

  /// One component on an element of a face, or of an obstacle.
  struct Part {
    int support;           ///< index into Scene::supports
    std::vector<int> dofs; ///< degrees of freedom of this component
    MatrixX stiffness;     ///< k ∫ N_A N_B dA [theory 3.3]; of an obstacle k
  };
  const std::vector<Part>& parts() const { return parts_; }

  /// Adds K u of all supports, or of one.
  void multiply(const VectorX& displacement, VectorX& force, int support = -1) const;
  /// ½ u · K u.
  double energy(const VectorX& displacement) const;

private:
  std::vector<Part> parts_;
};

} // namespace signorini::model
