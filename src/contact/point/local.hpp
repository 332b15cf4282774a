#pragma once
// One contact point in local variables: input and output of a contact law, and the first derivatives of gap, normal and
// area that all laws share.

#include "contact/closest/projection.hpp"
#include "contact/law/slip_formula.hpp"
#include "contact/law/state.hpp"

namespace signorini::contact {

/// Input of a contact law at one point, in the current configuration unless noted otherwise.
template <int D> struct LocalGeometry {
  Vec<D> slave;                            ///< xˢ
  std::array<Vec<D>, D - 1> slave_tangent; ///< xˢ_,α
  const FacePoint<D>* master;              ///< at the closest point, order 2
  Foot foot;
  int along = 0; ///< Foot::edge: parametric direction along the kink
  double gap;
  double offset = 0;        ///< gap at which the surfaces touch
  Vec<D> normal;            ///< n̄, unit, outward from the master
  const Vec<D>* slip_point; ///< xᵐ(ξ_sl) on the current master; null: no friction at this point yet
  /// At a corner of a curve, 1 or −1: the way from the slip point to it runs along n̄ turned by 90° or against it
  double way = 0;
  FaceCoordinates<D> axis = FaceCoordinates<D>::Unit(0); ///< see ContactPoints::axis()
  bool revolved = false;    ///< axisymmetric: the first coordinate is the radius, areas are those of the full circle
  double reference_measure; ///< reference area per parametric area
  FixedContactState fixed_state = FixedContactState::free;
  /// A trial slip within this distance of Coulomb's cone sticks, if negative slips. See Controls::tie().
  double tie = 0;
  Interface interface = {}; ///< what a formula of friction depends on
  double fade = 1;          ///< effective fraction of the area, below 1 beyond an open end of the master
  FaceCoordinates<D> fade_rate = FaceCoordinates<D>::Zero(); ///< ∂fade/∂ξ̄
};

/// Traction and derivatives. Columns of the derivatives run over the local variables
///   q = [xˢ, xˢ_,1 …, x̄ᵐ, τ_1 …, xᵐ(ξ_sl)],   D columns each, where x̄ᵐ and τ_α are taken at fixed ξ̄.
template <int D> struct LocalForce {
  static constexpr int tangents = D - 1;
  static constexpr int columns = D * (3 + 2 * tangents);
  static constexpr int slave_tangent_column = D, master_column = D * (1 + tangents),
                       tangent_column = D * (2 + tangents), slip_column = D * (2 + 2 * tangents);
  ContactState state;
  double potential;                          ///< energy of the law per area: penalty springs or adhesion
  double pressure;                           ///< normal traction t_N on the slave along n̄; negative in attraction
  Vec<D> friction;                           ///< t_T; the traction on the slave is t_N n̄ − t_T
  double mu = 0;                             ///< see Slide
  FrictionFlaw flaw = FrictionFlaw::none;    ///< see Slide
  double worn = 0;                           ///< depth by which the point wears in the step
  double measure;                            ///< area, per parametric area, on which the traction acts
  double stretch;                            ///< current area per area on which the traction acts
  Vec<D> force;                              ///< (t_N n̄ − t_T) · measure
  Eigen::Matrix<double, D, columns> tangent; ///< ∂force/∂q
  Eigen::Matrix<double, tangents, columns> shift; ///< ∂ξ̄/∂q; zero at a corner; at an edge nonzero only along it
};

/// a^α xˢ_,α.
template <int D> Vec<D> direction_of(const FaceCoordinates<D>& axis, const std::array<Vec<D>, D - 1>& tangents) {
  Vec<D> sum = axis(0) * tangents[0];
  if constexpr (D == 3) sum += axis(1) * tangents[1];
  return sum;
}

/// Derivatives with respect to q: of a scalar, of a vector, of face coordinates.
template <int D> using LocalRow = Eigen::Matrix<double, 1, LocalForce<D>::columns>;
template <int D> using LocalBlock = Eigen::Matrix<double, D, LocalForce<D>::columns>;
template <int D> using LocalShift = Eigen::Matrix<double, D - 1, LocalForce<D>::columns>;

/// Derivatives of g and n̄ with respect to q, and ∂ξ̄/∂q in `shift` [theory 5.1] (thesis A.17, A.18).
template <int D> struct GapRows {
  LocalRow<D> gap;
  LocalBlock<D> normal;
};
template <int D> GapRows<D> gap_rows(const LocalGeometry<D>& geometry, LocalShift<D>& shift);
/// The slip v = x̄ᵐ − xᵐ(ξ_sl); at a corner of a curve, around which friction is carried,
///   v = s |x̄ᵐ − xᵐ(ξ_sl)| J n̄,   J: rotation by 90°, s = `way`  [theory 7.8].
template <int D> Vec<D> slip_of(const LocalGeometry<D>& geometry);
/// Its derivative  δv = δx̄ᵐ + τ_α δξ̄^α − δxᵐ(ξ_sl).
template <int D>
LocalBlock<D> slip_rows(const LocalGeometry<D>& geometry, const GapRows<D>& rows, const LocalShift<D>& shift);
/// Turns derivatives of k (x̄ᵐ − xᵐ(ξ_sl)) at a corner into those of k v.
template <int D>
void turn_slip(const LocalGeometry<D>& geometry, const GapRows<D>& rows, double factor, LocalBlock<D>& slip);

/// Multiplies an area by its effective fraction w [theory 5.10]: m ← w m, δm ← w δm + m w_,α δξ̄^α.
template <int D>
void fade_area(const LocalGeometry<D>& geometry, const LocalShift<D>& shift, double& measure, LocalRow<D>& derivative);

/// Current area per parametric area, |xˢ_,1| or |xˢ_,1 × xˢ_,2|, axisymmetric 2πr |xˢ_,1|, and its derivative.
template <int D> double slave_measure(const LocalGeometry<D>& geometry, LocalRow<D>& derivative);

} // namespace signorini::contact
