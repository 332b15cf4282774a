#pragma once
// Work arrays for a macro-element, reused between macro-elements.

#include "solid/body.hpp"
#include "solid/response.hpp"

namespace signorini::solid {

/// Values at the Gauss points of a macro-element: one row per point, entries of F as in response.hpp in columns.
/// Columns of F, P and moduli are rows of a PointBlock, up to whole vectors.
template <int D> struct MacroArrays {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, entries_in(D)>;

  Rows f, directions;                ///< F, later F̄, and T = ∂θ/∂F
  Rows stress, coupling;             ///< P̄, later P*, and v
  MatrixX moduli;                    ///< A, later M
  VectorX dilation, change, scale;   ///< θ, c, eᶜ
  VectorX mean, excess, square;      ///< τ, π − τ, b
  VectorX predicted;                 ///< PΔ; empty: 0
  VectorX weighted, coefficients;    ///< of the last projection
  MatrixX direction_modes, modes;    ///< Σ w φ T:∂F/∂u and Σ w φ (v + …):∂F/∂u
  MatrixX inner;                     ///< Σ w b φ φ
  std::vector<double> local;         ///< displacements of an element, D rows of n values
  MatrixX gradients, strains, sums;  ///< of an element
  std::vector<double> force, blocks; ///< of an element
  std::vector<double> internal;      ///< internal variables of its points

  std::size_t memory() const {
    Eigen::Index numbers = 0;
    for (const Rows* rows : {&f, &directions, &stress, &coupling}) numbers += rows->size();
    for (const VectorX* list :
         {&dilation, &change, &scale, &mean, &excess, &square, &predicted, &weighted, &coefficients})
      numbers += list->size();
    for (const MatrixX* one : {&moduli, &direction_modes, &modes, &inner, &gradients, &strains, &sums})
      numbers += one->size();
    return sizeof(double) *
           (static_cast<std::size_t>(numbers) + local.size() + force.size() + blocks.size() + internal.size());
  }
};

} // namespace signorini::solid
