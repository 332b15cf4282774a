#include "contact/gauss/cohesive_contact.hpp"

#include "base/error.hpp"
#include "contact/constants.hpp"
#include "contact/point/interface_force.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::contact {

namespace {

/// Friction on the fraction d of the area: F ← (1 − d) F₀ + d F with the force F₀ without friction.
template <int D> void rub_in_part(const LocalForce<D>& without, double damage, LocalForce<D>& force) {
  const auto mix = [&](auto& with, const auto& other) { with = (1 - damage) * other + damage * with; };
  mix(force.force, without.force);
  mix(force.tangent, without.tangent);
  mix(force.potential, without.potential);
  force.friction *= damage;
}

} // namespace

template <int D>
CohesiveContact<D>::CohesiveContact(const ContactSetting<D>& setting, const InterfaceLaw& law, const Cohesion& cohesion)
    : GaussPointContact<D>(setting, law), bonds_{cohesion, std::vector<Projection<D>>(points_.size())} {
  check(cohesion);
  require(law.per == TractionArea::reference && law.enforcement == Enforcement::penalty, "contact.cohesion.penalty");
  require(!law.along, "contact.cohesion.axis");
  const double most = bond_distance * strongest_opening(cohesion);
  double nearest = std::numeric_limits<double>::infinity();
  bool any = false;
  FacePoint<D> foot;
  FaceCoordinates<D> rate;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vec<D>& place = points_.reference[i];
    if (setting.bonded && !setting.bonded(place)) continue;
    const Projection<D> closest = faces_.master.project(place, {}, foot);
    if (closest.foot == Foot::none || faces_.master.fade(closest.xi, rate) < 1) continue;
    nearest = std::min(nearest, std::abs(closest.gap));
    bonds_.closest[i] = closest;
    if (std::abs(closest.gap) > most)
      bonds_.closest[i].foot = Foot::none;
    else
      any = true;
  }
  require(any || nearest < std::numeric_limits<double>::infinity(), "contact.cohesion.nowhere");
  require(any, "contact.cohesion.apart", {{"distance", nearest}, {"most", most}});
}

template <int D>
void CohesiveContact<D>::evaluate_point(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet) {
  if (!bonds_.bonded(i)) return GaussPointContact<D>::evaluate_point(i, trial, part, feet);
  const std::optional<FixedContactState> fixed = this->close(i, trial, part, feet);
  FacePoint<D> bonded;
  faces_.master.locate(bonds_.closest[i], bonded);
  faces_.master.functions(bonded, 1);
  Bond<D> bond{Vec<D>(trial.present.results[i].position - bonded.position)};
  const PointBond<D>& accepted = trial.accepted.bonds[i];
  const double weight = shear_weight(bonds_.law);
  bond.weight = weight * weight;
  const InterfaceLaw& law = *part.law;
  if (!fixed) {
    if (tells_shear(bonds_.law)) {
      bond.split = &bonded;
      bond.normal = faces_.master.normal(bonded);
    }
    const Separation separation = separate(bonds_.law, bond.opening(), accepted.largest, bond.mix(), accepted.left);
    return record_bond(i, trial, bond, separation, bonded, part);
  }
  const LocalGeometry<D> geometry = this->closed_geometry(i, trial, law, *fixed, feet);
  bond.closed = true;
  bond.gap = geometry.gap;
  bond.normal = geometry.normal;
  const Separation separation = separate(bonds_.law, bond.opening(), accepted.largest, bond.mix(), accepted.left);

  LocalForce<D> force, relief;
  interface_force(law, geometry, force);
  relief_force(bond, separation, geometry, relief);
  if (law.friction > 0) {
    LocalForce<D> without;
    InterfaceLaw smooth = law;
    smooth.friction = 0;
    interface_force(smooth, geometry, without);
    // δ[d (F − F₀)] contains (F − F₀) δd.
    relief.tangent.noalias() += (separation.damage_rate * (force.force - without.force)) * opening_row(bond, false);
    rub_in_part(without, separation.damage, force);
  }
  this->record(i, trial, geometry, force, part, feet);
  if (separation.stiffness > 0 || separation.damage_rate > 0)
    part.sums.add(points_, i, feet.foot, &bonded, relief, part.tangent);
  record_bond(i, trial, bond, separation, bonded, part, &feet.foot);
}

/// Stores the bond, adds its traction to the result of a point and its spring to the blocks.
template <int D>
void CohesiveContact<D>::record_bond(std::size_t i, const Trial<D>& trial, const Bond<D>& bond,
                                     const Separation& separation, const FacePoint<D>& bonded, SumPart<D>& part,
                                     const FacePoint<D>* foot) const {
  PointBond<D>& own = trial.present.bonds[i];
  const PointBond<D>& accepted = trial.accepted.bonds[i];
  own = accepted;
  own.opening = bond.opening();
  own.largest = std::max(own.opening, accepted.largest);
  own.pressure = 0;
  own.shear.setZero();
  own.left = separation.left;
  if (own.left < accepted.left) own.mix = bond.mix();
  if (separation.stiffness == 0) return;

  PointResult<D>& result = trial.present.results[i];
  const ContactPoint& point = points_.list[i];
  LocalForce<D> spring;
  spring_force(bond, separation, point.reference_area, spring);
  part.sums.add(points_, i, bonded, foot, spring, part.tangent);

  const double stretch = slave_measure(points_, faces_.slave, i, result.position) / point.reference_area;
  const Vec<D> normal = foot ? bond.normal : faces_.master.normal(bonded);
  // The traction of the spring and, at a closed point, of its relief: −k (v − b² g n̄)
  const Vec<D> traction = -separation.stiffness * (bond.pull() - bond.weight * bond.gap * bond.normal) / stretch;
  own.pressure = normal.dot(traction);
  own.shear = own.pressure * normal - traction;
  result.pressure += own.pressure;
  result.friction += own.shear;
  result.law_area = point.weight * point.reference_area;
  result.area = result.law_area * stretch;
  result.force += result.area * traction;
  result.potential += result.law_area * 0.5 * separation.stiffness * own.opening * own.opening;
  const auto slave_tangents = tangents(points_, faces_.slave, i);
  for (int k = 0; k < D - 1; ++k) result.tangents.col(k) = slave_tangents[k];
  if (foot) return;
  result.gap = normal.dot(bond.apart);
  const bool broken = bonds_.law.formula ? own.remaining <= 1 - broken_energy
                                         : separation.dissipated >= broken_energy * bonds_.law.energy;
  if (!broken) result.state = ContactState::bonded;
}

/// Books the energy that the bond of a point has lost in an accepted step, at the mean of its two mode mixes, weighted
/// by the openings.
template <int D>
void CohesiveContact<D>::dissipate(PointResult<D>& result, PointBond<D>& bond, const PointBond<D>& before) const {
  if (bond.left >= before.left) return;
  const double weight = before.left < 1 ? before.largest / (before.largest + bond.opening) : 0;
  const double mix = weight * before.mix + (1 - weight) * bond.mix;
  const CohesionFormula::Loss loss =
      bonds_.law.formula->loss(before.left, bond.left, mix, before.largest, bond.opening);
  bond.dissipated += loss.dissipated;
  bond.sheared += mix * loss.dissipated;
  bond.remaining *= loss.remaining;
  if (bond.remaining <= 1 - broken_energy && result.state == ContactState::bonded) result.state = ContactState::open;
}

template <int D>
void CohesiveContact<D>::commit(History<D>& present, const History<D>& accepted, double penalty_factor) {
  present.debonding = 0;
  for (std::size_t i = 0; i < points_.size() && bonds_.law.formula; ++i)
    dissipate(present.results[i], present.bonds[i], accepted.bonds[i]);
  for (std::size_t i = 0; i < points_.size(); ++i)
    present.debonding += reference_area(points_.list[i]) * bonds_.separation(present, i).dissipated;
  GaussPointContact<D>::commit(present, accepted, penalty_factor);
}

template <int D> Vec<D> CohesiveContact<D>::friction_of(const History<D>& history, std::size_t i) const {
  return history.results[i].friction - history.bonds[i].shear;
}

template <int D> double CohesiveContact<D>::pressure_of(const History<D>& history, std::size_t i) const {
  return history.results[i].pressure - history.bonds[i].pressure;
}

template <int D> double CohesiveContact<D>::stiffness(const History<D>& history, double penalty_factor) const {
  const double contact = GaussPointContact<D>::stiffness(history, penalty_factor);
  double sum = contact * contact;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double spring = history.results[i].law_area * bonds_.separation(history, i).stiffness;
    if (bonds_.bonded(i)) sum += spring * spring;
  }
  return std::sqrt(sum);
}

template class CohesiveContact<2>;
template class CohesiveContact<3>;

} // namespace signorini::contact
