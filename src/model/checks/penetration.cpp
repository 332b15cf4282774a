#include "model/checks/penetration.hpp"

#include "base/index.hpp"
#include "model/checks/resolution.hpp"
#include "model/constants.hpp"
#include "model/default_penalty.hpp"
#include "model/element_size.hpp"
#include "model/region.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace signorini::model {

namespace {

/// The bodies of a contact, and those that ties and joins connect with them.
template <int D> std::vector<char> bodies_behind(const Scene<D>& scene, const Contact<D>& contact) {
  std::vector<char> behind(scene.bodies.size(), 0);
  for (int b = 0; b < std::ssize(scene.bodies); ++b) behind[at(b)] = acts_on(contact, b);
  const auto connect = [&](int a, int b) {
    const bool new_one = behind[at(a)] != behind[at(b)];
    if (new_one) behind[at(a)] = behind[at(b)] = 1;
    return new_one;
  };
  for (bool more = true; more;) {
    more = false;
    for (const Join& join : scene.joins) more |= connect(join.first.body, join.second.body);
    for (const Tie& tie : scene.ties)
      for (const FaceReference& slave : tie.slave)
        for (const FaceReference& master : tie.master) more |= connect(slave.body, master.body);
  }
  return behind;
}

/// Sums over the contact points or, with multipliers, over these.
struct SpringSums {
  double force = 0, area = 0; ///< ∫ p da, and the area with pressure
  double normal = 0;          ///< ½ ∫ p |g| da
  double slip = 0;            ///< ∫ p |elastic slip| da where they stick
  double uneven = 0;          ///< with multipliers: ∫ p |g| da over the points, beyond that of the mean gaps
};

/// Adds a point or a multiplier with its elastic slip.
template <class Result> void add_spring(SpringSums& sum, const Result& one, double slip) {
  if (!contact::touches(one.state) || one.pressure <= 0) return;
  const double force = one.pressure * one.area;
  sum.force += force;
  sum.area += one.area;
  sum.normal += 0.5 * force * std::max(-one.gap, 0.0);
  if (one.state == contact::ContactState::stick) sum.slip += force * slip;
}

template <int D> SpringSums springs_of(const contact::History<D>& history, const contact::PenaltyLaw& law) {
  SpringSums sum;
  for (const auto& multiplier : history.multiplier_results) add_spring(sum, multiplier, multiplier.elastic.norm());
  if (!history.multipliers.empty()) {
    for (const auto& point : history.results)
      if (contact::touches(point.state) && point.pressure > 0)
        sum.uneven += point.pressure * point.area * std::abs(point.gap);
    sum.uneven = std::max(sum.uneven - 2 * sum.normal, 0.0);
    return sum;
  }
  const double compliance = law.friction > 0 ? 1 / law.tangential : 0;
  for (const auto& point : history.results) add_spring(sum, point, stretch(point) * point.friction.norm() * compliance);
  return sum;
}

/// `energy(body)`: the strain energy of a body.
template <int D, class Energy>
void warn_of_springs(const Model<D>& model, int index, const Energy& energy, std::vector<Message>& warnings) {
  const Scene<D>& scene = model.system.scene;
  const contact::History<D>& history = model.present.contacts[at(index)];
  const Contact<D> contact =
      with_regions(scene.contacts[at(index)], *model.system.contacts[at(index)], model.system.size);
  const contact::PenaltyLaw law = contact::scaled(
      contact::changed(*contact::penalty_law(contact.method), history.changes), model.present.penalty_factor);
  const SpringSums sum = springs_of(history, law);
  if (sum.force <= 0) return;
  const double modulus = youngs_modulus(scene, contact.slave);
  const bool lost =
      sum.force < lost_strain * modulus * sum.area && law.normal < far_too_soft * contact_stiffness(scene, contact);
  double strain = model.system.springs.energy(model.present.displacement);
  const std::vector<char> behind = bodies_behind(scene, contact);
  for (int b = 0; b < std::ssize(scene.bodies); ++b)
    if (behind[at(b)] && !lost) strain += std::max(energy(b), 0.0); // rounding errors can be negative
  const double part = sum.normal / (strain + sum.normal), approach = 2 * (strain + sum.normal) / sum.force;
  const bool stuck = law.friction > 0 && law.enforcement != contact::Enforcement::multipliers;
  // A contact that touches at rounding error has a penetration p/ε far below an element's size.
  const double size = modulus / contact_stiffness(scene, contact), rounding = contact_rounding * size * sum.force;
  const auto noticeable = [&](double sum_of, double of) { return sum_of > std::max(noticeable_part * of, rounding); };
  const bool penetrates = noticeable(sum.normal, strain + sum.normal);
  const bool slips = stuck && noticeable(sum.slip, approach * sum.force);
  const bool uneven = noticeable(sum.uneven, approach * sum.force);
  if (!penetrates && !slips && !uneven) return;
  const double usual = default_penalty(scene, contact);
  // Springs in series: part/(1 − part) is inversely proportional to the penalty.
  const double series = strain > 0 ? law.normal * (sum.normal / strain) * (1 - small_part) / small_part : 0;
  const double enough = std::max(usual, series);
  const Message cure = law.enforcement == contact::Enforcement::augmented
                           ? Message("model.soft.augmented")
                           : Message("model.soft.penalty", {{"penalty", enough}});
  const bool narrow = is_narrow(model, index);
  const bool soft = penetrates && !(law.normal >= usual && narrow);
  if (soft)
    warnings.push_back(Message("model.warning.penetration", {{"contact", contact.name},
                                                             {"percent", 100 * part},
                                                             {"penetration", 2 * sum.normal / sum.force},
                                                             {"cure", cure}}));
  if (slips)
    warnings.push_back(
        Message("model.warning.elastic_slip",
                {{"contact", contact.name},
                 {"slip", sum.slip / sum.force},
                 {"percent", 100 * sum.slip / sum.force / approach},
                 {"penalty", std::max(usual, law.friction * sum.force / sum.area / (small_part * approach))}}));
  if (uneven && !narrow)
    warnings.push_back(
        Message("model.warning.uneven",
                {{"contact", contact.name}, {"distance", sum.uneven / sum.force}, {"approach", approach}}));
}

} // namespace

template <int D> void warn_of_soft_penalties(const Model<D>& model, std::vector<Message>& warnings) {
  std::vector<std::optional<double>> energies(model.system.scene.bodies.size());
  const auto energy = [&](int body) {
    std::optional<double>& known = energies[at(body)];
    if (!known) known = model.system.assembly.stored_energy(body, model.present.displacement, model.accepted.internal);
    return *known;
  };
  for (int k = 0; k < std::ssize(model.system.scene.contacts); ++k) {
    const Contact<D>& contact = model.system.scene.contacts[at(k)];
    const bool second_pass = contact.other_pass >= 0 && contact.other_pass < k;
    if (contact::penalty_law(contact.method) && !std::holds_alternative<contact::CohesiveLaw>(contact.method) &&
        !second_pass)
      warn_of_springs(model, k, energy, warnings);
  }
}

template void warn_of_soft_penalties(const Model<2>&, std::vector<Message>&);
template void warn_of_soft_penalties(const Model<3>&, std::vector<Message>&);

} // namespace signorini::model
