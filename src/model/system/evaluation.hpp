#pragma once
// What one evaluation of residual and tangent reads and writes.

#include "contact/gauss/formulation.hpp"
#include "model/system/sparse_tangent.hpp"
#include "model/system/state.hpp"

namespace signorini::model {

/// A trial state and the accepted state.
template <int D> struct States {
  State<D>& present;
  const State<D>& accepted;
  const std::vector<contact::Controls>& controls; ///< by contact
  const VectorX& loads;                           ///< targets at which the loads act
};

template <int D> struct Evaluation {
  const States<D>& states;
  const VectorX* direction; ///< null: `product` is not computed
  bool tangent;             ///< the tangent is computed
  SparseTangent& matrix;
  VectorX& product; ///< full tangent times `direction`, by degree of freedom
};

} // namespace signorini::model
