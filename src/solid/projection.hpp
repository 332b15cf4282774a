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

#include "base/eigen.hpp"
#include "nurbs/discretization.hpp"

#include <cmath>
#include <vector>

namespace signorini::solid {

/// F̄ for c = (Pθ − θ)/3, at small strains ε̄ + I.
inline Mat<3> dilated(bool linear, const Mat<3>& f, double c) {
  if (linear) return f + c * Mat<3>::Identity();
  return std::exp(c) * f;
}

/// Whether the volume change is that of each point, or projected.
enum class Volumetric { pointwise, projected };

/// Neighboring elements with one projection.
struct MacroElement {
  std::vector<int> elements;
  std::vector<int> functions;           ///< ascending
  std::vector<std::vector<int>> places; ///< per element: where its functions are in `functions`
  MatrixX box;                          ///< ends of the parameter intervals, one column per direction
  std::vector<int> degrees;             ///< of the polynomials, per direction
  MatrixX modes;   ///< φ_m at the Gauss points of all elements (rows), orthonormal: Σ_q w φ_m φ_n = δ_mn
  VectorX weights; ///< of these points, see Body::weights_of
  MatrixX combine; ///< Legendre polynomials times this are the modes
};

/// The macro-elements of a space, ξ¹ fastest, and their numbers per direction; functions and modes are missing.
/// In a direction with n elements of degree p there are c = ⌊n/p⌋ of p elements or a few more; c − 1 if c is even and n
/// odd, which no symmetric division into c parts has. For c = 2 that would be one macro-element, with dense tangents
/// and too few constraints: these are three, in which those of s < p elements have polynomials of degree s − 1, also
/// one constraint per element.
struct MacroElements {
  std::vector<MacroElement> list;
  std::vector<int> counts;
};
MacroElements macro_elements(const nurbs::Discretization& space);
/// The macro-element of element e.
int macro_containing(const MacroElements& macros, const nurbs::Discretization& space, int e);
/// Bytes of the tables.
std::size_t memory(const MacroElements& macros);

/// Products of Legendre polynomials up to its degrees at a parametric point, on the macro-element's box.
VectorX legendre_products(const MacroElement& macro, const VectorX& xi);

/// Makes the polynomials at the points (rows) orthonormal.
void orthonormalize(MacroElement& macro, const MatrixX& polynomials);

} // namespace signorini::solid
