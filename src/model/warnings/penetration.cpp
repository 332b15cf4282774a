#include "model/warnings/penetration.hpp"

#include "model/checks/constants.hpp"
#include "model/constants.hpp"
#include "model/scene/default_penalty.hpp"
#include "model/scene/element_size.hpp"
#include "model/scene/joins.hpp"
#include "model/scene/region.hpp"
#include "model/warnings/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace signorini::model {

namespace {

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

template <int D> SpringSums springs_of(const contact::History<D>& history, const contact::InterfaceLaw& law) {
  SpringSums sum;
  const bool solved = law.enforcement == contact::Enforcement::multipliers; // without springs
  for (const auto& multiplier : history.multiplier_results) add_spring(sum, multiplier, multiplier.elastic.norm());
  if (solved || !history.multipliers.empty()) {
    for (const auto& point : history.results) {
      if (!contact::touches(point.state) || point.pressure <= 0) continue;
      const double force = point.pressure * point.area;
      sum.uneven += force * std::abs(point.gap);
      if (solved) sum.force += force, sum.area += point.area;
    }
    sum.uneven = std::max(sum.uneven - 2 * sum.normal, 0.0);
    return sum;
  }
  const double compliance = law.friction > 0 ? 1 / law.tangential : 0;
  for (const auto& point : history.results) add_spring(sum, point, stretch(point) * point.friction.norm() * compliance);
  return sum;
}

template <int D> void warn_of_springs(const Model<D>& model, int index, std::vector<Message>& warnings) {
  const Scene<D>& scene = model.system.scene;
  const contact::History<D>& history = model.present.contacts[index];
  const Contact<D>& contact = scene.contacts[index];
  const contact::InterfaceLaw law =
      contact::scaled(contact::changed(*penalty_law(contact), history.changes), model.present.penalty_factor);
  const SpringSums sum = springs_of(history, law);
  if (sum.force <= 0) return;
  const double modulus = youngs_modulus(scene, contact.slave), stiffness = model.system.stiffness[index];
  const bool lost = sum.force < lost_strain * modulus * sum.area && law.normal < far_too_soft * stiffness;
  double strain = model.system.springs.energy(model.present.displacement);
  // The bodies of the contact, and those that joins and ties connect with them
  const Groups connected = connected_bodies(scene, true);
  const auto is_behind = [&](int body) {
    for (int b = 0; b < std::ssize(scene.bodies); ++b)
      if (acts_on(contact, b) && connected.leader(b) == connected.leader(body)) return true;
    return false;
  };
  for (int b = 0; b < std::ssize(scene.bodies) && !lost; ++b)
    if (is_behind(b))
      strain += std::max( // rounding errors can be negative
          model.system.assembly.bulk().account(b, model.present.displacement, model.present.internal).stored, 0.0);
  const double part = sum.normal / (strain + sum.normal), approach = 2 * (strain + sum.normal) / sum.force;
  const bool stuck = law.friction > 0 && law.enforcement != contact::Enforcement::multipliers;
  // A contact that touches at rounding error has a penetration p/ε far below an element's size.
  const double size = modulus / stiffness, rounding = contact_rounding * size * sum.force;
  const auto above = [&](double part_of, double sum_of, double all) {
    return sum_of > std::max(part_of * all, rounding);
  };
  const bool penetrates = above(noticeable_part, sum.normal, strain + sum.normal);
  const bool slips = stuck && above(noticeable_part, sum.slip, approach * sum.force);
  const bool uneven = above(uneven_part, sum.uneven, approach * sum.force);
  if (!penetrates && !slips && !uneven) return;
  const double usual = default_penalty(scene, with_regions(contact, *model.system.contacts[index], model.system.size));
  // Springs in series: part/(1 − part) is inversely proportional to the penalty.
  const double series = strain > 0 ? law.normal * (sum.normal / strain) * (1 - small_part) / small_part : 0;
  const double enough = std::max(usual, series);
  const bool narrow = is_narrow(model, index);
  const bool soft = penetrates && !(law.normal >= usual && narrow);
  if (soft)
    warnings.push_back(Message("model.warning.penetration", {{"contact", contact.name},
                                                             {"percent", 100 * part},
                                                             {"penetration", 2 * sum.normal / sum.force},
                                                             {"penalty", enough}}));
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

/// Below its equilibrium distance adhesion repels like a penalty, by which stiff bodies overlap.
void warn_of_adhesion(const std::string& contact, const contact::Adhesion& law, double overlap,
                      std::vector<Message>& warnings) {
  if (overlap <= noticeable_part * law.distance) return;
  const double nearest = contact::equilibrium_distance(law);
  warnings.push_back(Message("model.warning.adhesive_overlap", {{"contact", contact},
                                                                {"depth", overlap},
                                                                {"distance", nearest},
                                                                {"penalty", -contact::stiffness(law, nearest)}}));
}

} // namespace

template <int D> void warn_of_soft_penalties(const Model<D>& model, std::vector<Message>& warnings) {
  for (int k = 0; k < std::ssize(model.system.scene.contacts); ++k) {
    const Contact<D>& contact = model.system.scene.contacts[k];
    const bool second_pass = contact.other_pass >= 0 && contact.other_pass < k;
    if (penalty_law(contact) && !contact.method.bond && !second_pass) warn_of_springs(model, k, warnings);
    if (const auto& law = contact.method.law.adhesion)
      warn_of_adhesion(contact.name, *law, contact::resultant(model.present.contacts[k]).max_penetration, warnings);
  }
}

template void warn_of_soft_penalties(const Model<2>&, std::vector<Message>&);
template void warn_of_soft_penalties(const Model<3>&, std::vector<Message>&);

} // namespace signorini::model
