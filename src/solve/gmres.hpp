#pragma once
// GMRES: a linear system by products with its matrix and a preconditioner.

#include "base/eigen.hpp"

#include <functional>

namespace signorini::solve {

struct KrylovReport {
  int iterations = 0;
  double reduction = 1; ///< ‖b − K x‖ / ‖b‖; infinite when something came out that is no number
};

/// Minimizes ‖b − K x‖ over x = M⁻¹ span{b, K M⁻¹ b, …} (Saad & Schultz, SIAM J. Sci. Stat. Comput. 7, 1986), without
/// restarts. What M⁻¹ gave is kept, so that x costs no further application (Saad, SIAM J. Sci. Comput. 14, 1993).
class Gmres {
public:
  /// y ← K x; the vectors are of the system's size.
  using Apply = std::function<void(const double* x, double* y)>;
  /// z ← M⁻¹ z; false when that failed.
  using Precondition = std::function<bool(double* z)>;

  /// At most `most` iterations, for which 2 · most + 1 vectors of `size` are kept.
  Gmres(int size, int most);

  /// Stops at ‖b − K x‖ ≤ tolerance ‖b‖ or after `most` iterations. b must not be zero.
  KrylovReport operator()(const Apply& apply, const Precondition& precondition, const VectorX& b, double tolerance,
                          int most, VectorX& x);

private:
  MatrixX basis_, directions_; ///< V, and Z = M⁻¹ V: K Z_k = V_{k+1} H
  MatrixX triangle_;           ///< R of H = Q R
  VectorX right_;              ///< Qᵀ ‖b‖ e₁
  VectorX cosine_, sine_;      ///< the rotations that Q is made of
  VectorX column_, correction_;
};

} // namespace signorini::solve
