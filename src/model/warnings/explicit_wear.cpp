#include "model/warnings/explicit_wear.hpp"

#include "model/scene/element_size.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::model {

namespace {

/// (1 − ν²)/E of the softest body of some faces.
template <int D> double compliance(const Scene<D>& scene, const Faces& faces) {
  double most = 0;
  for (const FaceReference& face : faces) {
    const solid::ElasticConstants& law = scene.bodies[face.body].body->material().constants();
    most = std::max(most, (1 - law.poissons_ratio * law.poissons_ratio) / law.youngs_modulus);
  }
  return most;
}

/// 1/K of the bodies for averages of gaps that alternate between multipliers: 2 h/(α π E*), α = 2 (π/2)^(p + q) with
/// the degrees p of the face and q of the multipliers. Such splines have small waves.
template <int D> double alternating_compliance(const Model<D>& model, int contact) {
  const Scene<D>& scene = model.system.scene;
  const Contact<D>& named = scene.contacts[contact];
  const contact::Surface<D>& slave = model.system.contacts[contact]->slave();
  int degree = slave.direction(0).degree();
  if constexpr (D == 3) degree = std::min(degree, slave.direction(1).degree());
  const int other = named.method.multipliers == contact::MultiplierSpace::reduced ? degree - 2 : degree;
  const auto* master = std::get_if<Faces>(&named.master);
  const double size = softer_modulus(scene, named) / model.system.stiffness[contact];
  const double both = compliance(scene, named.slave) + (master ? compliance(scene, *master) : 0); // 1/E*
  return size * both / (std::numbers::pi * std::pow(std::numbers::pi / 2, degree + other));
}

} // namespace

template <int D> double explicit_wear(const Model<D>& model, int contact) {
  const Scene<D>& scene = model.system.scene;
  const contact::Formulation<D>& formulation = *model.system.contacts[contact];
  const contact::History<D>& history = model.accepted.contacts[contact];
  if (!formulation.parameters().wears()) return 0;
  const contact::InterfaceLaw law = formulation.parameters().law_in(history.changes, model.accepted.penalty_factor);
  if (law.wear->update != contact::WearUpdate::after) return 0;
  // The bodies do not follow wear that varies between the points of an element.
  const bool averages = scene.contacts[contact].method.multipliers && law.enforcement == contact::Enforcement::penalty;
  const double bodies = averages ? alternating_compliance(model, contact) : 0;
  double most = 0;
  const auto take = [&](const auto& result, const Vec<D>& place) {
    if (result.worn == 0 || result.pressure <= 0) return;
    const contact::Interface at{.place = contact::place_of(place)};
    const double stiffness = -respond(law, result.gap - result.worn, at).rate;
    most = std::max(most, result.worn / result.pressure / (1 / stiffness + bodies));
  };
  const auto& places = formulation.points().reference;
  for (std::size_t i = 0; i < history.results.size(); ++i) take(history.results[i], places[i]);
  for (std::size_t a = 0; a < history.multiplier_results.size(); ++a)
    take(history.multiplier_results[a], places[formulation.multipliers()->points[a]]);
  return most;
}

template double explicit_wear(const Model<2>&, int);
template double explicit_wear(const Model<3>&, int);

} // namespace signorini::model
