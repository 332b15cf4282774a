#include "contact/gauss/cohesive_contact.hpp"

#include "base/error.hpp"
#include "contact/constants.hpp"

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
CohesiveContact<D>::CohesiveContact(const ContactSetting<D>& setting, const CohesiveLaw& law)
    : PenaltyContact<D>(setting, law.penalty), law_(checked(law.cohesion)), bonds_(this->points_.size()) {
  require(law.penalty.per == TractionArea::reference && law.penalty.enforcement == Enforcement::penalty,
          "contact.cohesion.penalty");
  const double most = bond_distance * strongest_opening(law_);
  double nearest = std::numeric_limits<double>::infinity();
  bool any = false;
  FacePoint<D> foot;
  FaceCoordinates<D> rate;
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const Vec<D>& place = this->points_.reference[i];
    if (setting.bonded && !setting.bonded(place)) continue;
    const Projection<D> closest = this->master().project(place, {}, foot);
    if (closest.foot == Foot::none || this->master().fade(closest.xi, rate) < 1) continue;
    nearest = std::min(nearest, std::abs(closest.gap));
    bonds_[i] = closest;
    if (std::abs(closest.gap) > most)
      bonds_[i].foot = Foot::none;
    else
      any = true;
  }
  require(any || nearest < std::numeric_limits<double>::infinity(), "contact.cohesion.nowhere");
  require(any, "contact.cohesion.apart", {{"distance", nearest}, {"most", most}});
}

template <int D> void CohesiveContact<D>::evaluate_point(std::size_t i, const Trial<D>& trial, Part& part, Feet& at) {
  if (!is_bonded(i)) return PenaltyContact<D>::evaluate_point(i, trial, part, at);
  const std::optional<FixedContactState> fixed = this->close(i, trial, part, at);
  FacePoint<D> bonded;
  this->master().locate(bonds_[i], bonded);
  this->master().functions(bonded, 1);
  Bond<D> bond{Vec<D>(trial.present.results[i].position - bonded.position)};
  bond.largest = trial.accepted.bonds[i].largest;
  const PenaltyLaw law = this->law(trial.present, trial.penalty_factor);
  if (!fixed) {
    const Separation separation = separate(law_, bond.opening(), bond.largest);
    return record_bond(i, trial, bond, separation, bonded, part);
  }
  const LocalGeometry<D> geometry = this->closed_geometry(i, trial, law, *fixed, at);
  bond.closed = true;
  bond.gap = geometry.gap;
  bond.normal = geometry.normal;
  const Separation separation = separate(law_, bond.opening(), bond.largest);

  LocalForce<D> force, relief;
  penalty_force(law, geometry, force);
  relief_force(bond, separation, geometry, relief);
  if (law.friction > 0) {
    LocalForce<D> without;
    PenaltyLaw smooth = law;
    smooth.friction = 0;
    penalty_force(smooth, geometry, without);
    // δ[d (F − F₀)] contains (F − F₀) δd.
    relief.tangent.noalias() += (separation.damage_rate * (force.force - without.force)) * opening_row(bond, false);
    rub_in_part(without, separation.damage, force);
  }
  this->record(i, trial, geometry, force, part, at);
  if (separation.stiffness > 0 || separation.damage_rate > 0)
    part.sums.add(this->points_, i, at.foot, &bonded, relief, part.tangent);
  record_bond(i, trial, bond, separation, bonded, part, &at.foot);
}

/// Stores the bond, adds its traction to the result of a point and its spring to the blocks.
template <int D>
void CohesiveContact<D>::record_bond(std::size_t i, const Trial<D>& trial, const Bond<D>& bond,
                                     const Separation& separation, const FacePoint<D>& bonded, Part& part,
                                     const FacePoint<D>* foot) const {
  PointBond<D>& own = trial.present.bonds[i];
  own = {bond.opening(), std::max(bond.opening(), bond.largest)};
  if (separation.stiffness == 0) return;

  PointResult<D>& result = trial.present.results[i];
  const ContactPoint& point = this->points_.list[i];
  LocalForce<D> spring;
  spring_force(bond, separation, point.reference_area, spring);
  part.sums.add(this->points_, i, bonded, foot, spring, part.tangent);

  LocalGeometry<D> geometry;
  geometry.slave = result.position;
  geometry.slave_tangent = tangents(this->points_, this->slave(), i);
  geometry.revolved = this->points_.revolved;
  LocalRow<D> row;
  const double stretch = slave_measure(geometry, row) / point.reference_area;
  const Vec<D> normal = foot ? bond.normal : this->master().normal(bonded);
  // Of the spring and, at a closed point, of its relief: −k (Δ − g n̄)
  const Vec<D> traction = -separation.stiffness * (bond.apart - bond.gap * bond.normal) / stretch;
  own.pressure = normal.dot(traction);
  own.shear = own.pressure * normal - traction;
  result.pressure += own.pressure;
  result.friction += own.shear;
  result.law_area = point.weight * point.reference_area;
  result.area = result.law_area * stretch;
  result.force += result.area * traction;
  result.potential += result.law_area * 0.5 * separation.stiffness * own.opening * own.opening;
  for (int k = 0; k < D - 1; ++k) result.tangents.col(k) = geometry.slave_tangent[k];
  if (foot) return;
  result.gap = normal.dot(bond.apart);
  if (separation.dissipated < broken_energy * law_.energy) result.state = ContactState::bonded;
}

template <int D>
void CohesiveContact<D>::commit_points(History<D>& present, const History<D>& accepted, double penalty_factor) {
  PenaltyContact<D>::commit_points(present, accepted, penalty_factor);
  present.debonding = 0;
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const ContactPoint& point = this->points_.list[i];
    present.debonding += point.weight * point.reference_area * separate(law_, 0, present.bonds[i].largest).dissipated;
  }
}

template <int D> std::vector<double> CohesiveContact<D>::damage(const History<D>& history) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < bonds_.size(); ++i) values.push_back(rubbing(history, i));
  return values;
}

template <int D> double CohesiveContact<D>::rubbing(const History<D>& history, std::size_t i) const {
  return is_bonded(i) ? separate(law_, 0, history.bonds[i].largest).damage : 1;
}

template <int D> Vec<D> CohesiveContact<D>::friction_of(const History<D>& history, std::size_t i) const {
  return history.results[i].friction - history.bonds[i].shear;
}

template <int D> double CohesiveContact<D>::pressure_of(const History<D>& history, std::size_t i) const {
  return history.results[i].pressure - history.bonds[i].pressure;
}

template <int D> double CohesiveContact<D>::stiffness(const History<D>& history, double penalty_factor) const {
  const double contact = PenaltyContact<D>::stiffness(history, penalty_factor);
  double sum = contact * contact;
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const double spring = history.results[i].law_area * separate(law_, 0, history.bonds[i].largest).stiffness;
    if (is_bonded(i)) sum += spring * spring;
  }
  return std::sqrt(sum);
}

template class CohesiveContact<2>;
template class CohesiveContact<3>;

} // namespace signorini::contact
