#include "contact/mortar/mortar_law.hpp"

namespace signorini::contact {

namespace {

template <int D>
void friction(const InterfaceLaw& law, const MultiplierSums<D>& sums, const MultiplierHistory<D>& history,
              const FrictionControl& control, MultiplierResult<D>& result, MultiplierTangent<D>& tangent) {
  // Trial ε_T (η_A + e·V), V = V_A − V*_A
  const Vec<D> v = sums.slip / sums.area - history.touch;
  const Frame<D> frame = frame_of<D>(sums.normal, sums.along);
  const PlaneSlide<D> found = slide_in<D>(frame, law, history.elastic, v, result.pressure, control);
  const Slide<D - 1>& step = found.step;
  result.state = step.state;
  result.mu = step.mu;
  result.flaw = step.flaw;
  result.components = step.friction;
  result.elastic = step.friction / law.tangential;
  result.slipped = (found.slip + history.elastic - result.elastic).norm();
  result.friction = found.friction;
  result.potential += 0.5 * law.tangential * result.elastic.squaredNorm() * sums.area;
  if (step.state == ContactState::slip)
    tangent.of_gap = (step.of_pressure * tangent.pressure) * (frame.axes * step.direction);
  tangent.of_slip = found.of_slip;
  tangent.of_normal = found.of_normal;
  tangent.of_along = found.of_along;
}

} // namespace

template <int D>
MultiplierTangent<D> mortar_law(const InterfaceLaw& law, const MultiplierSums<D>& sums,
                                const MultiplierHistory<D>& history, const FrictionControl& control,
                                MultiplierResult<D>& result) {
  MultiplierTangent<D> tangent;
  const GapResponse response = respond(law, result.gap, control.interface);
  result.pressure = response.pressure;
  tangent.pressure = response.rate;
  result.state = state_of(law, result.gap, result.pressure);
  result.potential = response.potential * sums.area;
  result.mu = law.coefficient ? 0 : law.friction;
  if (law.friction > 0 && (result.pressure > 0 || control.fixed == FixedContactState::stick))
    friction(law, sums, history, control, result, tangent);
  return tangent;
}

template MultiplierTangent<2> mortar_law(const InterfaceLaw&, const MultiplierSums<2>&, const MultiplierHistory<2>&,
                                         const FrictionControl&, MultiplierResult<2>&);
template MultiplierTangent<3> mortar_law(const InterfaceLaw&, const MultiplierSums<3>&, const MultiplierHistory<3>&,
                                         const FrictionControl&, MultiplierResult<3>&);

} // namespace signorini::contact
