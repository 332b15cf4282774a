#pragma once
// Stability of elastic laws from a formula at the strains of a body.

#include "solid/body.hpp"
#include "solid/hyperelastic.hpp"

#include <optional>

namespace signorini::solid {

/// The least eigenvalue of the moduli of the Kirchhoff stress's Jaumann rate by the rate of deformation at F, a
/// modulus; the law is stable in Hill's and Drucker's sense, dτ:dε > 0 for logarithmic strains of an isotropic law, if
/// it is positive (R. Hill, J. Mech. Phys. Solids 16, 1968).
double least_modulus(const Hyperelastic& law, const Mat<3>& f);

/// A point at which the law of a body is unstable.
struct Instability {
  Vec<3> stretches; ///< principal, ascending
  VectorX point;    ///< in the reference configuration
};

/// The point with the least of the negative moduli of a body, if any, among one Gauss point (number n/2 of n) in each
/// of at most 256 elements; only laws from a formula are checked. `displacement` as for internal_force().
template <int D> std::optional<Instability> unstable_point(const Body<D>& body, const double* displacement);

} // namespace signorini::solid
