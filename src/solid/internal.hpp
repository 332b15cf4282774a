#pragma once
// Internal force and its consistent tangent, element by element, or by macro-elements if the volume change is
// projected.

#include "solid/body.hpp"
#include "solid/macro_arrays.hpp"

#include <functional>
#include <optional>

namespace signorini::solid {

/// Force and tangent of one element in the layout needed for assembly. Reused between elements.
///   force:  D rows of n values, f_iA
///   blocks: for each pair of components i ≤ j in the order (0,0), (0,1), …, (1,1), … an n×n matrix K^{ij}_{AB},
///           A slowest; K^{ji}_{BA} = K^{ij}_{AB}.
template <int D> struct ElementArrays {
  /// Arrays for the largest element of a body.
  explicit ElementArrays(const Body<D>& body);
  /// Bytes of the arrays.
  std::size_t memory() const;
  /// Kernel arguments of element e with these arrays; the results go to `to_force` and, unless null, `to_blocks`.
  KernelArguments arguments(const Body<D>& body, int e, double* to_force, double* to_blocks);
  std::vector<double> force, blocks;
  std::vector<double> local;     ///< work array: displacements, D rows of n values
  std::vector<double> moves;     ///< work array: see predicted_volume.hpp
  std::vector<double> predicted; ///< likewise, per Gauss point
  std::vector<double> work;      ///< work array of the kernel
  std::vector<double> factors;   ///< work array: two values per Gauss point
  MacroArrays<D> macro;          ///< only with projected volume change
};

/// Writes the displacements of an element's functions, D rows of n values.
template <int D> void gather(const Body<D>& body, int e, const double* displacement, double* local);

/// Internal variables of an unstrained body, by Gauss point in the order of its elements; empty for most materials. A
/// state consists of two such lists, committed and trial: an accepted step commits the trial values, a roll-back
/// discards them.
template <int D> std::vector<double> initial_values(const Body<D>& body);

/// f_iA = ∫ P_ik ∂R_A/∂X_k dV and, if `tangent`, ∂f_iA/∂u_jB for macro-element m, which is element m unless the volume
/// change is projected; per unit depth in plane strain, over the full circle for a body of revolution.
///
/// `displacement` holds u of the body's control points, D values each. Returns a point with J ≤ 0 if the element is
/// inverted (the arrays are then undefined), otherwise nothing; small-strain laws have no inversion.
///
/// Only for a body with internal variables: `memory.committed` holds the values of the whole body at the start of the
/// step, `memory.trial` receives those of this element at `displacement`; both have the layout of initial_values(). The
/// tangent is that at fixed committed values. Throws Error if their sizes are wrong.
///
/// `before`: the displacement from which Newton's last correction started. The tangent of a nearly incompressible body
/// is then that with the volume change which it predicted (predicted_volume.hpp). Null: the tangent is ∂f/∂u.
template <int D>
std::optional<Inversion> internal_force(const Body<D>& body, int m, const double* displacement,
                                        ElementArrays<D>& arrays, bool tangent = true, const Memory& memory = {},
                                        const double* before = nullptr);

/// Internal variables at a parametric point of element e: the polynomial through their values at its Gauss points, of
/// the degree of the element in each direction. Empty for most materials.
template <int D>
std::vector<double> values_at(const Body<D>& body, int e, const VectorX& xi, std::span<const double> values);

/// The part of a body's internal variables that belongs to element e.
template <int D> PointMemory element_memory(const Body<D>& body, int e, const Memory& memory);

/// Means over the reference volume of an element.
template <int D> struct MeanDeformation {
  Mat<D> gradient = Mat<D>::Zero(); ///< F
  double hoop = 0;                  ///< stretch about the axis of an axisymmetric body, otherwise 1
};
template <int D> std::vector<MeanDeformation<D>> mean_deformations(const Body<D>& body, const double* displacement);

/// Calls visit with the number of each Gauss point of a body, its weight and F, with projected volume change F̄. Returns
/// false where an element is inverted (never with small strains). `memory` as for internal_force().
using VisitPoint = std::function<void(std::size_t point, double weight, const Mat<3>& f)>;
template <int D>
bool visit_points(const Body<D>& body, const double* displacement, const Memory& memory, const VisitPoint& visit);

/// Energies of the whole body; infinity if an element is inverted. `values`: internal variables of this state; empty:
/// the initial ones.
template <int D> Account account(const Body<D>& body, const double* displacement, std::span<const double> values = {});

} // namespace signorini::solid
