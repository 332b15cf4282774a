#include "model/checks/scene_warnings.hpp"

#include "base/error.hpp"
#include "model/constants.hpp"
#include "model/scene/element_size.hpp"
#include "model/scene/thickness.hpp"
#include "solid/quadrature_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace signorini::model {

namespace {

/// The softest element behind several faces.
template <int D> PenaltyRatio ratio_behind(const Scene<D>& scene, const Faces& faces) {
  PenaltyRatio softest{0, std::numeric_limits<double>::infinity(), {}};
  for (const FaceReference& face : faces)
    if (const double stiffness = element_stiffness(scene, face); stiffness < softest.stiffness)
      softest = {0, stiffness, scene.bodies[face.body].name};
  return softest;
}

/// The lowest degree of a body's functions, and a direction with this degree.
template <int D> std::pair<int, int> lowest_degree(const nurbs::Discretization& space) {
  std::pair<int, int> lowest{nurbs::max_degree, 0};
  for (int e = 0; e < space.elements(); ++e)
    for (int d = 0; d < D; ++d) lowest = std::min(lowest, {space.degree(e, d), d});
  return lowest;
}

/// Volumetric locking: a cantilever of 20 × 2 elements with degree 1 in the thickness direction has 0.67 of the exact
/// deflection at ν = 0.45, 0.26 at 0.49; errors of force according to scripts/stability/locking.lua are 14 % for L1 at
/// ν = 0.49, 3 % for N2 at 0.499, 1.5 % for N3 at 0.4999.
template <int D> void warn_of_locking(const Scene<D>& scene, std::vector<Message>& warnings) {
  for (const NamedBody<D>& named : scene.bodies) {
    // Under plane stress the thickness adjusts the volume.
    if (named.body->volumetric() == solid::Volumetric::projected || scene.kind == solid::Kind::plane_stress) continue;
    const double nu = named.body->material().constants().poissons_ratio;
    const auto [degree, direction] = lowest_degree<D>(named.body->space());
    const double most = degree > 2 ? locking_higher : locking_quadratic;
    if (nu <= most && (degree > 1 || nu < locking_linear)) continue;
    const Message remedy = degree > 1   ? Message("model.locking.nu", {{"nu", most}})
                           : nu <= most ? Message("model.locking.degree")
                                        : Message("model.locking.both", {{"nu", most}});
    warnings.push_back(
        Message("model.warning.locking",
                {{"body", named.name}, {"nu", nu}, {"degree", degree}, {"direction", direction}, {"remedy", remedy}}));
  }
}

void warn_of_friction(const std::string& name, double mu, std::vector<Message>& warnings) {
  if (mu <= most_friction) return;
  Message hint;
  if (mu < 90)
    hint = Message("model.warning.friction_angle", {{"angle", mu}, {"mu", std::tan(mu * std::numbers::pi / 180)}});
  warnings.push_back(Message("model.warning.friction", {{"contact", name}, {"mu", mu}, {"hint", hint}}));
}

template <int D>
void warn_of_offset(const Scene<D>& scene, const Contact<D>& contact, double offset, std::vector<Message>& warnings) {
  const double part = std::abs(offset) / thinner_body(scene, contact);
  if (part > large_offset)
    warnings.push_back(Message("model.warning.offset",
                               {{"contact", contact.name}, {"offset", offset}, {"percent", std::round(100 * part)}}));
}

template <int D>
void warn_of_stiffness(const Scene<D>& scene, const Contact<D>& contact, double penalty,
                       std::vector<Message>& warnings) {
  const PenaltyRatio found = penalty_ratio(scene, contact, penalty);
  if (found.ratio < beyond_rounding) return;
  warnings.push_back(Message("model.warning.stiffness", {{"contact", contact.name},
                                                         {"penalty", penalty},
                                                         {"ratio", found.ratio},
                                                         {"body", found.body},
                                                         {"stiffness", found.stiffness}}));
}

/// Multipliers on a stiff face with small elements require more of the soft master than its functions can follow: they
/// oscillate, and Newton's method cycles.
template <int D>
void warn_of_stiff_slave(const Scene<D>& scene, const Contact<D>& contact, std::vector<Message>& warnings) {
  const contact::InterfaceLaw* law = penalty_law(contact);
  const auto* face = std::get_if<Faces>(&contact.master);
  if (!face || !law || law->enforcement != contact::Enforcement::multipliers) return;
  const double ratio = youngs_modulus(scene, contact.slave) / youngs_modulus(scene, *face);
  const bool linear = contact.method.multipliers == contact::MultiplierSpace::linear;
  if (linear || ratio < stiff_slave || pitch(scene, *face) < pitch(scene, contact.slave)) return;
  warnings.push_back(Message("model.warning.stiff_slave", {{"contact", contact.name},
                                                           {"slave", scene.bodies[contact.slave.front().body].name},
                                                           {"master", scene.bodies[face->front().body].name},
                                                           {"ratio", ratio}}));
}

/// Bodies whose control points have weights so different that Gauss points miss their geometry.
template <int D> void warn_of_weights(const Scene<D>& scene, std::vector<Message>& warnings) {
  for (const NamedBody<D>& named : scene.bodies) {
    const nurbs::Discretization& space = named.body->space();
    const double ratio = solid::weight_ratio(space);
    if (ratio <= usual_weights) continue;
    if (const double error = solid::volume_error(space); error > most_quadrature_error)
      warnings.push_back(
          Message("model.warning.weights", {{"body", named.name}, {"ratio", ratio}, {"percent", 100 * error}}));
  }
}

/// Loads on faces that bend too sharply within their elements for the points of loads.
template <int D> void warn_of_areas(const Scene<D>& scene, std::vector<Message>& warnings) {
  for (const Load& load : scene.loads)
    for (int b = 0; b < std::ssize(scene.bodies); ++b) {
      std::vector<nurbs::Side> faces;
      for (const FaceReference& face : load.on)
        if (face.body == b) faces.push_back(face.side);
      if (faces.empty()) continue;
      if (const double error = solid::area_error(*scene.bodies[b].body, faces); error > most_quadrature_error)
        warnings.push_back(Message("model.warning.area", {{"load", load.name}, {"percent", 100 * error}}));
    }
}

/// Between few points a face is free to bend into the master.
template <int D>
void warn_of_few_points(const Contact<D>& contact, const contact::Surface<D>& slave, std::vector<Message>& warnings) {
  int degree = 0;
  for (int e = 0; e < slave.elements(); ++e)
    for (int alpha = 0; alpha < D - 1; ++alpha) degree = std::max(degree, slave.degree(e, alpha));
  if (contact.points < degree)
    warnings.push_back(Message("model.warning.few_points",
                               {{"contact", contact.name}, {"points", contact.points}, {"degree", degree}}));
}

/// Length of the cohesive zone: E G/σ² in a thick body, where A. Turon et al. (Eng. Fract. Mech. 74, 2007) compare
/// factors, and (E G/σ²)^¼ h^¾ in a thin one of thickness h (J. G. Williams, H. Hadavinia, J. Mech. Phys. Solids 50,
/// 2002). Bodies with fewer than three elements in it pull off element by element.
template <int D>
void warn_of_coarse_bonds(const Scene<D>& scene, const Contact<D>& contact, std::vector<Message>& warnings) {
  const auto& bond = contact.method.bond;
  if (!bond) return;
  const double strength = bond->strength, energy = bond->energy;
  const double softer = softer_modulus(scene, contact);
  const double thinner = thinner_body(scene, contact);
  const double thick = softer * energy / (strength * strength);
  const double zone = std::min(thick, std::pow(thick, 0.25) * std::pow(thinner, 0.75));
  const double size = element_size(scene, contact.slave, 2), least = zone_elements * size;
  if (least <= zone) return;
  // The strength of a zone of the least length
  const double needed = thick > zone ? std::pow(least / std::pow(thinner, 0.75), 4) : least;
  warnings.push_back(Message("model.warning.coarse_bonds", {{"contact", contact.name},
                                                            {"size", size},
                                                            {"zone", zone},
                                                            {"least", zone_elements},
                                                            {"strength", std::sqrt(softer * energy / needed)}}));
}

/// Contact points as pairs of element and index; without `points` only elements, with index 0.
template <int D> std::set<std::pair<int, int>> places(const contact::Formulation<D>& contact, bool points) {
  std::set<std::pair<int, int>> result;
  for (const contact::ContactPoint& point : contact.points().list)
    result.insert({point.element, points ? point.number : 0});
  return result;
}

/// Points close to the master that are too far from it for a bond.
template <int D>
void warn_of_missing_bonds(const Scene<D>& scene, const Contact<D>& contact, const contact::Formulation<D>& formulation,
                           std::vector<Message>& warnings) {
  if (!formulation.bonds()) return;
  const double close = most_seam_distance * element_size(scene, contact.slave, 2);
  int count = 0;
  double farthest = 0;
  for (const contact::Projection<D>& bond : formulation.bonds()->closest) {
    const double distance = std::abs(bond.gap);
    if (bond.foot != contact::Foot::none || bond.element < 0 || distance > close) continue;
    ++count;
    farthest = std::max(farthest, distance);
  }
  if (count > 0)
    warnings.push_back(
        Message("model.warning.missing_bonds", {{"contact", contact.name}, {"count", count}, {"distance", farthest}}));
}

/// True if two contacts act on the same points at the start. Adhesion and a penalty may do so.
/// Half passes act on their slave only.
template <int D>
bool act_twice(const Contact<D>& a, const Contact<D>& b, const contact::Formulation<D>& first,
               const contact::Formulation<D>& second) {
  if (a.method.law.adhesion.has_value() != b.method.law.adhesion.has_value() || !a.start.active || !b.start.active)
    return false;
  const auto* master = a.other_pass < 0 ? std::get_if<Faces>(&a.master) : nullptr;
  if (master && *master == b.slave && b.master == decltype(b.master)(a.slave)) return true; // slave and master swapped
  if (const auto* other = std::get_if<Faces>(&b.master); master && other && (is_set(a) || is_set(b)))
    return std::ranges::any_of(a.slave, [&](const FaceReference& one) {
      return std::ranges::any_of(*master,
                                 [&](const auto& face) { return may_touch(a, one, face) && may_touch(b, one, face); });
    });
  const bool points = a.points == b.points;
  if (!(a.master == b.master) || !(points ? a.slave.meets(b.slave) : a.slave == b.slave)) return false;
  const auto here = places(first, points), there = places(second, points);
  return std::any_of(here.begin(), here.end(), [&](const auto& place) { return there.contains(place); });
}

template <int D>
void warn_of_twins(const Scene<D>& scene, const contact::Formulations<D>& contacts, std::vector<Message>& warnings) {
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (std::size_t k = i + 1; k < contacts.size(); ++k) {
      const Contact<D>&a = scene.contacts[i], &b = scene.contacts[k];
      if (!act_twice(a, b, *contacts[i], *contacts[k])) continue;
      const auto* master = std::get_if<Faces>(&a.master);
      warnings.push_back(Message("model.warning.twins", {{"first", a.name},
                                                         {"second", b.name},
                                                         {"slave", faces_message(scene, a.slave)},
                                                         {"master", master ? faces_message(scene, *master)
                                                                           : Message("model.face.obstacle")}}));
    }
}

template <int D> void warn_of_shapes(const Scene<D>& scene, std::vector<Message>& warnings) {
  for (const Support<D>& support : scene.supports)
    if (support.shape_error > most_shape_error)
      warnings.push_back(
          Message("model.warning.shape", {{"support", support.name}, {"percent", 100 * support.shape_error}}));
}

} // namespace

template <int D> PenaltyRatio penalty_ratio(const Scene<D>& scene, const Contact<D>& contact, double penalty) {
  PenaltyRatio softest = ratio_behind(scene, contact.slave);
  if (const auto* face = std::get_if<Faces>(&contact.master)) {
    const PenaltyRatio other = ratio_behind(scene, *face);
    if (other.stiffness < softest.stiffness) softest = other;
  }
  softest.ratio = penalty / softest.stiffness;
  return softest;
}

template <int D>
std::vector<Message> constant_warnings(const Scene<D>& scene, const Contact<D>& contact, double mu, double offset) {
  std::vector<Message> warnings;
  warn_of_friction(contact.name, mu, warnings);
  warn_of_offset(scene, contact, offset, warnings);
  return warnings;
}

template <int D>
std::vector<Message> scene_warnings(const Scene<D>& scene, const contact::Formulations<D>& contacts,
                                    const std::vector<contact::History<D>>& histories) {
  std::vector<Message> warnings;
  warn_of_locking(scene, warnings);
  warn_of_weights(scene, warnings);
  warn_of_areas(scene, warnings);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    warn_of_friction(scene.contacts[k].name, contacts[k]->parameters().friction(histories[k].changes), warnings);
    warn_of_stiffness(scene, scene.contacts[k], contacts[k]->parameters().penalty(histories[k].changes), warnings);
    warn_of_stiff_slave(scene, scene.contacts[k], warnings);
    warn_of_few_points(scene.contacts[k], contacts[k]->slave(), warnings);
    warn_of_coarse_bonds(scene, scene.contacts[k], warnings);
    warn_of_missing_bonds(scene, scene.contacts[k], *contacts[k], warnings);
    warn_of_offset(scene, scene.contacts[k], contacts[k]->parameters().offset(histories[k].changes), warnings);
  }
  warn_of_twins(scene, contacts, warnings);
  warn_of_shapes(scene, warnings);
  return warnings;
}

Message function_warning(const std::string& load, double error) {
  if (error <= most_quadrature_error) return {};
  return Message("model.warning.load_function", {{"load", load}, {"percent", 100 * error}});
}

template PenaltyRatio penalty_ratio(const Scene<2>&, const Contact<2>&, double);
template PenaltyRatio penalty_ratio(const Scene<3>&, const Contact<3>&, double);
template std::vector<Message> constant_warnings(const Scene<2>&, const Contact<2>&, double, double);
template std::vector<Message> constant_warnings(const Scene<3>&, const Contact<3>&, double, double);
template std::vector<Message> scene_warnings(const Scene<2>&, const contact::Formulations<2>&,
                                             const std::vector<contact::History<2>>&);
template std::vector<Message> scene_warnings(const Scene<3>&, const contact::Formulations<3>&,
                                             const std::vector<contact::History<3>>&);

} // namespace signorini::model
