#pragma once
// The constant terms of ties in residual and tangent.

#include "model/scene/scene.hpp"
#include "model/system/unknowns.hpp"

namespace signorini::model {

/// The terms of all ties, by degree of freedom. The unknowns are lengths χ = λ/s, and rows of the residual forces
/// [theory 9.1]:
///     f_s −= s Cᵀ χ,   f_m += s C̄ᵀ χ,   f_χ = s (C̄ u_m − C u_s),
/// with C, C̄ = ∫ M_A R dA and the stiffness s = 10 E/h of the softer body, on which results do not depend.
struct TieTerms {
  struct Coupling {
    int multiplier, displacement;
    double value; ///< ∂f_χ/∂u = ∂f_u/∂χ
  };
  struct Proximal {
    int multiplier;
    double value;
  };
  std::vector<Coupling> couplings;
  /// −η s ∫ M_A dA on the diagonal of the tangent, not in the residual. With this proximal term a multiplier that acts
  /// on no unknown, such as at the end of a seam on a clamped face, keeps its value, and the tangent is quasi-definite
  /// (R. J. Vanderbei, SIAM J. Optim. 5, 1995). Newton's method leaves a fraction of order η in each iteration; what it
  /// converges to is independent of η.
  std::vector<Proximal> proximal;

  /// product += ∂f/∂(u, χ) vector, without the proximal term.
  void multiply(const VectorX& vector, VectorX& product) const;
};
template <int D> TieTerms tie_terms(const Scene<D>& scene, const Unknowns<D>& unknowns, const contact::Ties<D>& ties);

/// The unknowns that a Cholesky factorization must leave to the end, because the others have a positive definite
/// tangent: the multipliers, and the displacements of tied faces of bodies that supports do not hold. Sorted.
template <int D>
std::vector<int> tie_border(const Scene<D>& scene, const Unknowns<D>& unknowns, const contact::Ties<D>& ties);

} // namespace signorini::model
