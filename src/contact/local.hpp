#pragma once
// One contact point in a few local variables: what a law needs to know of the geometry, what it gives back, and the
// first derivatives of gap, normal and area that all laws share.

#include "contact/projection.hpp"

namespace signorini::contact {

/// Open: no traction (penalty), or past the strongest attraction (adhesion). Stick and slip: touching under the penalty
/// law, without friction always stick. Adhesion: closer than where the attraction is strongest.
enum class ContactState { open, stick, slip, adhesion };

/// What a point is told to be, whatever its gap and friction say: touching leaves the choice of stick or slip.
enum class FixedContactState : unsigned char { free, open, touching, stick };

/// "open", "stick", "slip", "adhesion".
const char* name_of(ContactState state);

/// What a law needs at one point, all in the current configuration unless said otherwise.
template <int D> struct LocalGeometry {
  Vec<D> slave;                            ///< xˢ
  std::array<Vec<D>, D - 1> slave_tangent; ///< xˢ_,α
  const FacePoint<D>* master;              ///< at the closest point, order 2
  Foot foot;
  int along = 0; ///< Foot::edge: the direction along the kink
  double gap;
  Vec<D> normal;            ///< n̄, unit, outward from the master
  const Vec<D>* slip_point; ///< xᵐ(ξ_sl) on the current master; null: no friction yet at this point
  bool revolved = false;    ///< axisymmetric: the first coordinate is the radius, areas are those of the full circle
  double reference_measure; ///< reference area per parametric area
  double multiplier = 0;    ///< λ_N of the augmented Lagrangian method, a pressure
  FixedContactState fixed_state = FixedContactState::free;
  /// A slip within this distance of Coulomb's cone sticks; negative: slips. See Controls::guessed.
  double tie = 0;
  double fade = 1; ///< part of the area that counts: less than 1 beyond an open end of the master
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
  double potential;                          ///< energy of the law per area: springs of the penalty law, adhesion
  double pressure;                           ///< normal traction t_N on the slave along n̄; attraction is negative
  Vec<D> friction;                           ///< t_T; the traction on the slave is t_N n̄ − t_T
  double measure;                            ///< area per parametric area that the traction acts on
  Vec<D> force;                              ///< (t_N n̄ − t_T) · measure
  Eigen::Matrix<double, D, columns> tangent; ///< ∂force/∂q
  Eigen::Matrix<double, tangents, columns> shift; ///< ∂ξ̄/∂q; zero at a corner, at an edge but for its direction
};

/// Derivatives by the local variables q: of a number, of a vector in space, of face coordinates.
template <int D> using LocalRow = Eigen::Matrix<double, 1, LocalForce<D>::columns>;
template <int D> using LocalBlock = Eigen::Matrix<double, D, LocalForce<D>::columns>;
template <int D> using LocalShift = Eigen::Matrix<double, D - 1, LocalForce<D>::columns>;

/// δg and δn̄ by the local variables, and ∂ξ̄/∂q (thesis A.17, A.18).
template <int D> struct GapRows {
  LocalRow<D> gap;
  LocalBlock<D> normal;
};
template <int D> GapRows<D> gap_rows(const LocalGeometry<D>& geometry, LocalShift<D>& shift);

/// Multiplies an area by the part of it that counts: m ← w m, δm ← w δm + m w_,α δξ̄^α.
template <int D>
void fade_area(const LocalGeometry<D>& geometry, const LocalShift<D>& shift, double& measure, LocalRow<D>& derivative);

/// Current area per parametric area, |xˢ_,1| or |xˢ_,1 × xˢ_,2|, axisymmetric 2πr |xˢ_,1|, and its derivative.
template <int D> double slave_measure(const LocalGeometry<D>& geometry, LocalRow<D>& derivative);

} // namespace signorini::contact
