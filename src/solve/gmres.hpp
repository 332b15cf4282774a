#pragma once
// GMRES: solves a linear system by products with its matrix and a preconditioner.

#include "base/eigen.hpp"

#include <functional>

namespace signorini::solve {

struct KrylovReport {
  int iterations = 0;
  double reduction = 1; ///< ‖b − K x‖ / ‖b‖; infinite if a result is not finite
};

/// Minimizes ‖b − K x‖ over x = M⁻¹ span{b, K M⁻¹ b, …} (Saad & Schultz, SIAM J. Sci. Stat. Comput. 7, 1986), without
/// restarts. The vectors M⁻¹ v are stored, so that x needs no further application of M⁻¹ (Saad, SIAM J. Sci. Comput.
/// 14, 1993).
class Gmres {
public:
  /// y ← K x; the vectors have the size of the system.
  using Apply = std::function<void(const double* x, double* y)>;
  /// z ← M⁻¹ z; false if that failed.
  using Precondition = std::function<bool(double* z)>;

  /// At most `most` iterations, for which 2 · most + 1 vectors of `size` are stored.
  Gmres(int size, int most);

  /// Stops at ‖b − K x‖ ≤ tolerance ‖b‖ or after `most` iterations. b must not be zero.
  KrylovReport operator()(const Apply& apply, const Precondition& precondition, const VectorX& b, double tolerance,
                          int most, VectorX& x);

private:
  MatrixX basis_, directions_; ///< V, and Z = M⁻¹ V: K Z_k = V_{k+1} H
  MatrixX triangle_;           ///< R of H = Q R
  VectorX right_;              ///< Qᵀ ‖b‖ e₁
  VectorX cosine_, sine_;      ///< rotations of which Q is the product
  VectorX column_, correction_;
};

} // namespace signorini::solve
