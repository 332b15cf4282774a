#pragma once
// Internal force and its exact tangent, element by element.

#include "solid/body.hpp"

#include <optional>

namespace signorini::solid {

/// Force and tangent of one element, laid out for the scatter that follows. Reused between elements.
///   force:  D rows of n values, f_iA
///   blocks: for each pair of components i ≤ j in the order (0,0), (0,1), …, (1,1), … an n×n matrix K^{ij}_{AB}, A
///   slowest;
///           K^{ji}_{BA} = K^{ij}_{AB}.
template <int D> struct ElementArrays {
  /// Room for the largest element of a body.
  explicit ElementArrays(const Body<D>& body);
  /// Bytes that the arrays take.
  std::size_t memory() const;
  std::vector<double> force, blocks;
  std::vector<double> local;   ///< working space: displacements, D rows of n values
  std::vector<double> work;    ///< working space of the kernel
  std::vector<double> factors; ///< working space: two per Gauss point
};

/// Internal variables of an unstrained body, Gauss point after Gauss point in the order of its elements; empty for most
/// materials. Whoever holds a state keeps two such lists, committed and trial: an accepted step commits the trial
/// values, a roll-back forgets them.
template <int D> std::vector<double> initial_values(const Body<D>& body);

/// f_iA = ∫ P_ik ∂R_A/∂X_k dV and, when `tangent` is wanted, ∂f_iA/∂u_jB for element e; per unit depth in plane strain,
/// over the full circle for a body of revolution.
///
/// `displacement` holds u of the body's control points, D values each. Returns where J ≤ 0 when the element is inverted
/// (the arrays are then meaningless), nothing otherwise; small strains know no inversion.
///
/// Only for a body with internal variables: `committed` holds the whole body's values at the step's start, `trial`
/// receives those of this element at `displacement`; both are laid out as in initial_values(). The tangent is that at
/// fixed committed values. Throws Error when their sizes are wrong.
template <int D>
std::optional<Inversion> internal_force(const Body<D>& body, int e, const double* displacement,
                                        ElementArrays<D>& arrays, bool tangent = true,
                                        std::span<const double> committed = {}, std::span<double> trial = {});

/// Where det F of the whole body is least, among the Gauss points at which it is not positive; nothing where it is
/// positive everywhere. For small strains, which internal_force() lets pass.
template <int D> std::optional<Inversion> worst_inversion(const Body<D>& body, const double* displacement);

/// Stored energy of the whole body; infinity when an element is inverted, which small strains never are. `committed` as
/// for internal_force(); empty: the initial values.
template <int D>
double stored_energy(const Body<D>& body, const double* displacement, std::span<const double> committed = {});

} // namespace signorini::solid
