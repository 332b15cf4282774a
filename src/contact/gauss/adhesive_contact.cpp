#include "contact/gauss/adhesive_contact.hpp"

#include <cmath>
#include <utility>

namespace signorini::contact {

template <int D>
AdhesiveContact<D>::AdhesiveContact(ContactSetting<D> setting, const Adhesion& law)
    : GaussPointContact<D>(std::move(setting)), law_(law) {
  check(law);
}

template <int D>
void AdhesiveContact<D>::evaluate_point(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet) {
  if (!this->parameters_.active(trial.present.changes) || !this->find_foot(i, trial, part, feet)) return;
  const LocalGeometry<D> geometry = this->geometry(i, trial, feet);
  LocalForce<D> force;
  adhesion_force(law_, geometry, force);
  this->record(i, trial, geometry, force, part, feet);
}

template <int D> double AdhesiveContact<D>::stiffness(const History<D>& history, double /*penalty_factor*/) const {
  double sum = 0;
  for (const PointResult<D>& point : history.results) {
    const double slope = contact::stiffness(law_, point.gap);
    sum += point.area * slope * point.area * slope;
  }
  return std::sqrt(sum);
}

template class AdhesiveContact<2>;
template class AdhesiveContact<3>;

} // namespace signorini::contact
