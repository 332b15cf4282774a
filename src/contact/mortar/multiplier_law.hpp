#pragma once
// Contact conditions of one multiplier that is an unknown: normal contact and Coulomb friction as equations
// [theory 8.2].

#include "contact/mortar/mortar_law.hpp"

namespace signorini::contact {

/// Unknowns of one multiplier, as lengths so that their rows are forces: λ_A = s χ_A with the scale s, a pressure per
/// length. Without friction only the first.
template <int D> struct MultiplierUnknowns {
  double normal = 0;                  ///< pressure/s
  Vec<D> tangential = Vec<D>::Zero(); ///< friction/s; the traction on the slave is Σ M_A s (χ_N n̄ − χ_T)
};

/// Residual r_A of the conditions, normal first, and its derivatives.
template <int D> struct ConditionRows {
  using Values = Eigen::Matrix<double, 1 + D, 1>;
  using Directions = Eigen::Matrix<double, 1 + D, D>;
  Values residual = Values::Zero();
  Eigen::Matrix<double, 1 + D, 1 + D> of_unknowns = Eigen::Matrix<double, 1 + D, 1 + D>::Zero(); ///< with proximal term
  Values of_gap = Values::Zero();  ///< with respect to Σ w g
  Values of_area = Values::Zero(); ///< to Σ w, at constant sums of gaps and slips
  Directions of_normal = Directions::Zero(), of_slip = Directions::Zero(); ///< to Σ w n̄ and Σ w v
};

/// With q = s χ_N − ε_N ḡ_A, the normal n = Σ w n̄/‖·‖ and T = I − n nᵀ:
///   closed (q > 0):  r_N = −s a_A ḡ_A,    r_T = a_A (P(y) − s χ_T),   y = T (s χ_T + ε_T (V_A − V*_A)),
///   open:            r_N = −s a_A χ_N,    r_T = −s a_A χ_T (also closed, with μ = 0),
/// where P returns y to |y| ≤ μ q (P. Alart, A. Curnier, CMAME 92, 1991; S. Hüeber, B. Wohlmuth, CMAME 194, 2005). The
/// results do not depend on the penalty parameters. `touch` is V*_A, see mortar_law.hpp. `whole` is the area of the
/// multiplier without open ends. In the derivatives only, a proximal term −proximal s a δχ makes the system of
/// displacements and multipliers regular where the conditions of several multipliers depend on each other or on
/// supports; it vanishes with the correction δχ.
template <int D>
ConditionRows<D> multiplier_law(const PenaltyLaw& law, double scale, const MultiplierSums<D>& sums, double whole,
                                const MultiplierUnknowns<D>& unknowns, const Vec<D>& touch,
                                const FrictionControl& control, MultiplierResult<D>& result);

/// The conditions of an open multiplier.
template <int D> ConditionRows<D> open_multiplier(double scale, double whole, const MultiplierUnknowns<D>& unknowns);

} // namespace signorini::contact
