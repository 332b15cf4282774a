#pragma once
// The penalty law at one contact point: traction of normal contact and Coulomb friction with its exact linearisation in
// a few local variables.

#include "contact/projection.hpp"

namespace signorini::contact {

/// Penalty parameters are pressure per length.
struct PenaltyLaw {
  double normal;         ///< ε_N > 0
  double tangential = 0; ///< ε_T, used when friction > 0
  double friction = 0;   ///< Coulomb's μ ≥ 0
};

enum class ContactState { open, stick, slip };

/// What the law needs at one point, all in the current configuration.
template <int D> struct LocalGeometry {
  Vec<D> slave;                            ///< xˢ
  std::array<Vec<D>, D - 1> slave_tangent; ///< xˢ_,α
  const FacePoint<D>* master;              ///< at the closest point, order 2
  Foot foot;
  double gap;
  Vec<D> normal;            ///< n̄, unit, outward from the master
  const Vec<D>* slip_point; ///< xᵐ(ξ_sl) on the current master; null: no friction yet at this point
};

/// Traction and derivatives. Columns of the derivatives run over the local variables
///   q = [xˢ, xˢ_,1 …, x̄ᵐ, τ_1 …, xᵐ(ξ_sl)],   D columns each, where x̄ᵐ and τ_α are taken at fixed ξ̄.
template <int D> struct LocalForce {
  static constexpr int tangents = D - 1;
  static constexpr int columns = D * (3 + 2 * tangents);
  static constexpr int slave_tangent_column = D, master_column = D * (1 + tangents),
                       tangent_column = D * (2 + tangents), slip_column = D * (2 + 2 * tangents);
  ContactState state;
  double pressure;                                ///< t_N = −ε_N g ≥ 0
  Vec<D> friction;                                ///< t_T; the traction on the slave is t_N n̄ − t_T
  double measure;                                 ///< current area per parametric area, |xˢ_,1 (× xˢ_,2)|
  Vec<D> force;                                   ///< (t_N n̄ − t_T) · measure
  Eigen::Matrix<double, D, columns> tangent;      ///< ∂force/∂q
  Eigen::Matrix<double, tangents, columns> shift; ///< ∂ξ̄/∂q; zero at a corner
};

/// Evaluates the law at a penetrating point (gap < 0).
template <int D> void penalty_force(const PenaltyLaw& law, const LocalGeometry<D>& geometry, LocalForce<D>& result);

} // namespace signorini::contact
