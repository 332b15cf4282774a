#include "contact/mortar/mortar_law.hpp"

#include "contact/law/wear.hpp"

#include <cmath>

namespace signorini::contact {

namespace {

/// Plane normal to n_A with its directions, and their derivatives:
///   δn = turn δN,   δe₁ = −(e₁·δn) n + φ e₂,   δe₂ = −(e₂·δn) n − φ e₁,
///   φ = spin_normal δn + spin_along δ(Σ w xˢ_,1).
template <int D> struct Frame {
  Vec<D> normal;
  Eigen::Matrix<double, D, D - 1> axes;
  Mat<D> turn;
  Eigen::Matrix<double, 1, D> spin_normal = Eigen::Matrix<double, 1, D>::Zero(), spin_along = spin_normal; ///< 3D only
};

template <int D> Frame<D> frame_of(const MultiplierSums<D>& sums) {
  Frame<D> frame;
  const double length = sums.normal.norm();
  const Vec<D> n = sums.normal / length;
  frame.normal = n;
  frame.turn = (Mat<D>::Identity() - n * n.transpose()) / length;
  const double across = n.dot(sums.along);
  const Vec<D> first = sums.along - across * n;
  frame.axes.col(0) = first.normalized();
  if constexpr (D == 3) {
    const Vec<D> second = n.cross(Vec<D>(frame.axes.col(0)));
    frame.axes.col(1) = second;
    // φ = e₂·δe₁ = e₂·(δa − (n·a) δn)/|first|,  a = Σ w xˢ_,1
    frame.spin_along = second.transpose() / first.norm();
    frame.spin_normal = -across * frame.spin_along;
  }
  return frame;
}

/// The vector e₂ of a frame for components (c₁, c₂): c₁ e₂ − c₂ e₁, by which Σ c_i e_i changes per spin.
template <int D> Vec<D> turned(const Frame<D>& frame, const FaceCoordinates<D>& c) {
  if constexpr (D == 2)
    return Vec<D>::Zero();
  else
    return c(0) * frame.axes.col(1) - c(1) * frame.axes.col(0);
}

template <int D>
void friction(const InterfaceLaw& law, const MultiplierSums<D>& sums, const MultiplierHistory<D>& history,
              const FrictionControl& control, GapResponse& response, MultiplierResult<D>& result,
              MultiplierTangent<D>& tangent) {
  using Components = FaceCoordinates<D>;
  using Square = Eigen::Matrix<double, D - 1, D - 1>;
  const Frame<D> frame = frame_of(sums);
  const auto& e = frame.axes;
  const Vec<D> v = sums.slip / sums.area - history.touch;
  // Trial ε_T (η_A + e·V), V = V_A − V*_A
  const Components slip = e.transpose() * v, trial = law.tangential * (history.elastic + slip);
  const Rubbing<D - 1> rubbing =
      rub<D - 1>(law, response, result.gap, trial, control.fixed, control.tie, control.interface);
  const Slide<D - 1>& step = rubbing.slide;
  response = rubbing.response;
  result.worn = rubbing.worn;
  result.state = step.state;
  result.mu = step.mu;
  result.flaw = step.flaw;
  const Components& traction = step.friction;
  Square scale = Square::Identity(); // ∂traction/∂trial
  if (step.state == ContactState::slip) {
    scale = step.of_trial;
    tangent.of_gap = (step.of_pressure * response.rate) * (e * step.direction);
  }
  result.components = traction;
  result.elastic = traction / law.tangential;
  result.slipped = (slip + history.elastic - result.elastic).norm();
  result.friction = e * traction;
  if (rubbing.worn != 0 && !law.pressure) result.potential = energy(law, result.gap + rubbing.worn, {}) * sums.area;
  result.potential += 0.5 * law.tangential * result.elastic.squaredNorm() * sums.area;

  // t = Σ_i t_i e_i,  δtrial_i = ε_T (e_i·δV + δe_i·V),  with δe_i of the frame
  const Eigen::Matrix<double, D, D - 1> stiff = law.tangential * e * scale;
  const Vec<D>& n = frame.normal;
  tangent.of_slip = stiff * e.transpose();
  Components spun = Components::Zero(); // ∂(e_i·V)/∂φ
  if constexpr (D == 3) spun = Components(slip(1), -slip(0));
  const Vec<D> by_spin = stiff * spun + turned(frame, traction);
  Mat<D> by_normal = -n.dot(v) * (stiff * e.transpose()) - n * result.friction.transpose();
  by_normal += by_spin * frame.spin_normal;
  tangent.of_normal = by_normal * frame.turn;
  tangent.of_along = by_spin * frame.spin_along;
  if (rubbing.worn == 0) return;
  // δz = … + of_trial·δtrial
  const Vec<D> by_slip = law.tangential * (e * rubbing.of_trial), along = step.of_pressure * (e * step.direction);
  const double by_turn = law.tangential * rubbing.of_trial.dot(spun);
  const Vec<D> by_normals = frame.turn.transpose() * (by_turn * frame.spin_normal.transpose() - n.dot(v) * by_slip);
  tangent.worn = {by_normals, by_slip, by_turn * frame.spin_along.transpose()};
  tangent.of_normal += along * tangent.worn->of_normal.transpose();
  tangent.of_slip += along * tangent.worn->of_slip.transpose();
  tangent.of_along += along * tangent.worn->of_along.transpose();
}

} // namespace

template <int D>
MultiplierTangent<D> mortar_law(const InterfaceLaw& law, const MultiplierSums<D>& sums,
                                const MultiplierHistory<D>& history, const FrictionControl& control,
                                MultiplierResult<D>& result) {
  MultiplierTangent<D> tangent;
  GapResponse response = respond(law, result.gap, control.interface);
  result.pressure = response.pressure;
  result.state = state_of(law, result.gap, result.pressure);
  result.potential = law.pressure ? 0 : energy(law, result.gap, {}) * sums.area;
  result.mu = law.coefficient ? 0 : law.friction;
  if (slides(law) && (result.pressure > 0 || control.fixed == FixedContactState::stick))
    friction(law, sums, history, control, response, result, tangent);
  result.pressure = response.pressure;
  tangent.pressure = response.rate;
  return tangent;
}

template MultiplierTangent<2> mortar_law(const InterfaceLaw&, const MultiplierSums<2>&, const MultiplierHistory<2>&,
                                         const FrictionControl&, MultiplierResult<2>&);
template MultiplierTangent<3> mortar_law(const InterfaceLaw&, const MultiplierSums<3>&, const MultiplierHistory<3>&,
                                         const FrictionControl&, MultiplierResult<3>&);

} // namespace signorini::contact
