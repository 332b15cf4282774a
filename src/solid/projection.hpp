#pragma once
// Projection of the volume change against locking of nearly incompressible bodies (F̄ method).
//
// In each macro-element of about p × p (× p) neighboring elements of degree p, θ = ln J is replaced by its L₂
// projection Pθ on polynomials of degree p − 1 per direction of the macro-element, as in the F̄ method for splines of T.
// Elguedj, Y. Bazilevs, V. M. Calo, T. J. R. Hughes, Comput. Methods Appl. Mech. Engrg. 197 (2008), but local, so that
// the tangent remains sparse: projection on continuous splines of degree p − 1 makes it dense. Both have one constraint
// per element, as many as D unknowns per element bear; projection in each element has p^D and locks. For p = 1 it is
// the mean dilatation of each element. Where p does not divide the number of elements the macro-elements are larger,
// and symmetric about the middle, as the mesh is: see macro_elements().
//
// F̄ = exp((Pθ − θ)/3) F, at small strains ε̄ = ε + (P tr ε − tr ε)/3 I. The energy is ∫ W(F̄) dV; forces and tangent
// are its derivatives. Projecting ln J instead of J keeps the volume positive.

#include "solid/gauss_tables.hpp"

#include <cmath>

namespace signorini::solid {

/// F̄ for c = (Pθ − θ)/3, at small strains ε̄ + I.
inline Mat<3> dilated(bool linear, const Mat<3>& f, double c) {
  if (linear) return f + c * Mat<3>::Identity();
  return std::exp(c) * f;
}

/// Neighboring elements with one projection.
struct MacroElement {
  std::vector<int> elements;
  std::vector<int> functions;           ///< ascending
  std::vector<std::vector<int>> places; ///< per element: where its functions are in `functions`
  MatrixX box;                          ///< ends of the parameter intervals, one column per direction
  std::vector<int> degrees;             ///< of the polynomials, per direction
  MatrixX modes;   ///< φ_m at the Gauss points of all elements (rows), orthonormal: Σ_q w φ_m φ_n = δ_mn
  VectorX weights; ///< of these points, see GaussTables::weights_of
  MatrixX combine; ///< Legendre polynomials times this are the modes

  /// The modes at a parametric point.
  VectorX modes_at(const VectorX& xi) const;
};

/// In a direction with n elements of degree p there are c = ⌊n/p⌋ macro-elements of p elements or a few more; c − 1 if
/// c is even and n odd, which no symmetric division into c parts has. For c = 2 that would be one macro-element, with
/// dense tangents and too few constraints: these are three, in which those of s < p elements have polynomials of degree
/// s − 1, also one constraint per element.
struct MacroElements {
  std::vector<MacroElement> list; ///< ξ¹ fastest
  std::vector<int> counts;        ///< per direction

  /// The one that contains element e.
  int containing(const nurbs::Discretization& space, int e) const;
  /// Largest number of functions on one of them.
  int most_functions() const;
  /// Bytes of the tables.
  std::size_t memory() const;
};
template <int D> MacroElements macro_elements(const nurbs::Discretization& space, const GaussTables<D>& tables);

} // namespace signorini::solid
