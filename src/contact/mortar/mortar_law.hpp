#pragma once
// Law of one multiplier of mortar contact [theory 8.1].

#include "contact/point/frame.hpp"
#include "contact/point/history.hpp"

namespace signorini::contact {

/// Sums over the points k with a projection, with w_k their areas times M_A(k) of one multiplier. Areas
/// are those on which tractions act, see MortarContact.
template <int D> struct MultiplierSums {
  double area = 0;                ///< a_A = Σ w_k
  double gap = 0;                 ///< Σ w_k g_k
  double before = 0;              ///< at the guess of a step: the same with the gaps of the accepted state
  Vec<D> normal = Vec<D>::Zero(); ///< Σ w_k n̄_k; this and the following with friction only
  Vec<D> slip = Vec<D>::Zero();   ///< Σ w_k v_k
  Vec<D> along = Vec<D>::Zero();  ///< Σ w_k a^α xˢ_,α, see ContactPoints::axis()

  void add(double weight, const MultiplierSums& other) {
    area += weight * other.area;
    gap += weight * other.gap;
    before += weight * other.before;
    normal += weight * other.normal;
    slip += weight * other.slip;
    along += weight * other.along;
  }
};

/// Derivatives of z_A and t_A with respect to ḡ_A, Σ w n̄, V_A = Σ w v/a_A and Σ w a^α xˢ_,α; zero if open. Those of z_A
/// with respect to the last three are not zero where the multiplier wears.
template <int D> struct MultiplierTangent {
  double pressure = 0; ///< ∂z/∂ḡ
  Vec<D> of_gap = Vec<D>::Zero();
  Mat<D> of_normal = Mat<D>::Zero(), of_slip = Mat<D>::Zero(), of_along = Mat<D>::Zero();
  std::optional<PlaneGradient<D>> worn = {};
};

/// The law of a closed multiplier, whose result has its area and gap: z_A = −ε_N ḡ_A > 0, and with n_A = Σ w n̄/‖·‖
/// the friction t_A in the plane normal to n_A:
///   trial ε_T (η_A + V_A − V*_A), returned to |t_A| ≤ μ z_A,   η_A the elastic slip of the accepted state,
/// V*_A the slip V_A of the step where the multiplier touches.
/// η_A has components along e₁, the direction of Σ w a^α xˢ_,α in this plane, and e₂ = n_A × e₁ (3D), so that it
/// turns with the slave. A multiplier that slips wears (wear.hpp).
template <int D>
MultiplierTangent<D> mortar_law(const InterfaceLaw& law, const MultiplierSums<D>& sums,
                                const MultiplierHistory<D>& history, const FrictionControl& control,
                                MultiplierResult<D>& result);

} // namespace signorini::contact
