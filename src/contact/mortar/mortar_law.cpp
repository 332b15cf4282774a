#include "contact/mortar/mortar_law.hpp"

namespace signorini::contact {

namespace {

template <int D>
void friction(const InterfaceLaw& law, const MultiplierSums<D>& sums, const MultiplierHistory<D>& history,
              const FrictionControl& control, GapResponse& response, MultiplierResult<D>& result,
              MultiplierTangent<D>& tangent) {
  // Trial ε_T (η_A + e·V), V = V_A − V*_A
  const Vec<D> v = sums.slip / sums.area - history.touch;
  const Frame<D> frame = frame_of<D>(sums.normal, sums.along);
  const PlaneSlide<D> found = slide_in<D>(frame, law, history.elastic, v, response, result.gap, control);
  const Slide<D - 1>& step = found.rubbing.slide;
  response = found.rubbing.response;
  result.worn = found.rubbing.worn;
  result.state = step.state;
  result.mu = step.mu;
  result.flaw = step.flaw;
  result.components = step.friction;
  result.elastic = step.friction / law.tangential;
  result.slipped = (found.slip + history.elastic - result.elastic).norm();
  result.friction = found.friction;
  if (result.worn != 0 && !law.pressure) result.potential = energy(law, result.gap + result.worn, {}) * sums.area;
  result.potential += 0.5 * law.tangential * result.elastic.squaredNorm() * sums.area;
  if (step.state == ContactState::slip)
    tangent.of_gap = (step.of_pressure * response.rate) * (frame.axes * step.direction);
  tangent.of_slip = found.of_slip;
  tangent.of_normal = found.of_normal;
  tangent.of_along = found.of_along;
  tangent.worn = found.worn;
  if (!tangent.worn) return;
  tangent.of_slip += found.of_pressure * tangent.worn->of_slip.transpose();
  tangent.of_normal += found.of_pressure * tangent.worn->of_normal.transpose();
  tangent.of_along += found.of_pressure * tangent.worn->of_along.transpose();
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
