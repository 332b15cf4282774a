#pragma once
// Energy stored in the bodies.

#include "model/system/unknowns.hpp"
#include "solve/symmetric_blocks.hpp"

namespace signorini::model {

template <int D> class StoredEnergy {
public:
  /// `stiffness`: of each body if all are linear elastic; otherwise empty.
  StoredEnergy(const Scene<D>& scene, const Unknowns<D>& unknowns,
               const std::vector<solve::SymmetricBlocks<D>>& stiffness)
      : scene_(scene), unknowns_(unknowns), stiffness_(stiffness), known_(scene.bodies.size()) {}

  /// Energy of one body at a displacement and internal variables of all, see solid::stored_energy().
  double of_body(int body, const VectorX& displacement, const std::vector<std::vector<double>>& internal) const;
  double of_all(const VectorX& displacement, const std::vector<std::vector<double>>& internal) const;

private:
  struct Known {
    VectorX displacement;
    std::vector<double> internal;
    double energy = 0;
  };
  const Scene<D>& scene_;
  const Unknowns<D>& unknowns_;
  const std::vector<solve::SymmetricBlocks<D>>& stiffness_;
  mutable std::vector<Known> known_; ///< of each nonlinear body the last energy: at the end of a stage it is used twice
};

} // namespace signorini::model
