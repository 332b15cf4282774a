#pragma once
// Gauss points of a face of a body, for loads.

#include "solid/body.hpp"

#include <array>

namespace signorini::solid {

/// The Gauss points of one element of a face.
template <int D> struct FacePoints {
  std::vector<int> functions;           ///< of the body, those that do not vanish on the face
  VectorX weights;                      ///< in the parameter domain
  MatrixX values;                       ///< R_A, functions × points
  std::array<MatrixX, D - 1> gradients; ///< ∂R_A/∂ξ in each direction along the face, functions × points
  double outward;                       ///< orientation: the sign of area_vector()
  bool revolved;                        ///< of a body of revolution, with integrals over the full circle

  /// Outward normal times dA/dξ at a point q, for positions x (D × functions); without the circumference.
  Vec<D> area_vector(const MatrixX& x, int q) const;
  /// Weight of a point q in an integral over the surface of positions x, with the circumference 2πr.
  double weight(const MatrixX& x, int q) const;
};

/// The elements of a face, which may cross a layer, where it is not a tensor product. There are twice as many Gauss
/// points per direction as in the elements: faces are curved and rational, so that no rule is exact. `times`: how many
/// times as many.
template <int D> std::vector<FacePoints<D>> face_points(const Body<D>& body, nurbs::Side side, int times = 2);

} // namespace signorini::solid
