#include "model/scene/default_penalty.hpp"

#include "model/constants.hpp"
#include "model/scene/contact_faces.hpp"
#include "model/scene/element_size.hpp"
#include "model/scene/thickness.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

template <int D> double contact_stiffness(const Scene<D>& scene, const Contact<D>& contact) {
  return softer_modulus(scene, contact) / element_size(scene, contact.slave, contact.points, contact.where);
}

namespace {

template <int D> double penalty_alone(const Scene<D>& scene, const Contact<D>& contact) {
  const auto through = [&](const Faces& faces) { return youngs_modulus(scene, faces) / thickness(scene, faces); };
  double softer = through(contact.slave);
  if (const auto* face = std::get_if<Faces>(&contact.master)) softer = std::min(softer, through(*face));
  return default_penalty_alone * std::max(contact_stiffness(scene, contact), softer);
}

/// True if the slave is the stiffer one of two bodies.
template <int D> bool has_stiffer_slave(const Scene<D>& scene, const Contact<D>& contact) {
  const auto* master = std::get_if<Faces>(&contact.master);
  return master && youngs_modulus(scene, contact.slave) > youngs_modulus(scene, *master);
}

/// E/h of the softer body.
template <int D> double softer_stiffness(const Scene<D>& scene, const Contact<D>& contact) {
  if (!has_stiffer_slave(scene, contact)) return contact_stiffness(scene, contact);
  const auto& master = std::get<Faces>(contact.master);
  return youngs_modulus(scene, master) / element_size(scene, master, contact.points);
}

/// Chooses functions that the softer body can follow: the slave's own if it is not the stiffer body, otherwise linear
/// ones, each on so many elements that they are not more than the functions of the master.
template <int D> void choose_multipliers(const Scene<D>& scene, Contact<D>& contact) {
  auto& multipliers = contact.method.multipliers;
  const bool stiffer = has_stiffer_slave(scene, contact);
  if (multipliers == contact::MultiplierSpace::automatic)
    multipliers = stiffer ? contact::MultiplierSpace::linear : contact::MultiplierSpace::equal;
  if (multipliers != contact::MultiplierSpace::linear || !stiffer) return;
  const double elements = pitch(scene, std::get<Faces>(contact.master)) / element_size(scene, contact.slave, 2);
  contact.method.unknown.joined = std::max(1, static_cast<int>(std::ceil(elements - 1e-6)));
}

} // namespace

template <int D> double default_penalty(const Scene<D>& scene, const Contact<D>& contact) {
  const double own = penalty_alone(scene, contact);
  return contact.other_pass < 0 ? own : std::min(own, penalty_alone(scene, scene.contacts[contact.other_pass]));
}

template <int D> void set_default_penalties(Scene<D>& scene) {
  for (Contact<D>& contact : scene.contacts) {
    contact::InterfaceLaw* law = penalty_law(contact);
    if (contact::InterfaceLaw& own = contact.method.law; own.pressure && may_rub(own) && own.tangential == 0)
      own.tangential = default_penalty(scene, contact);
    if (!law) continue;
    const bool alone = law->enforcement == contact::Enforcement::penalty;
    if (!alone && contact.method.multipliers) {
      contact.method.unknown.scale = default_penalty_ratio * softer_stiffness(scene, contact);
      choose_multipliers(scene, contact);
    }
    if (law->normal == 0) {
      law->normal = alone ? default_penalty(scene, contact) : default_penalty_ratio * softer_stiffness(scene, contact);
      contact.default_penalty = true;
    }
    if (law->tangential == 0 && (!alone || contact::may_rub(*law))) law->tangential = law->normal;
    auto& bond = contact.method.bond;
    if (bond && bond->softening == contact::Softening::bilinear && bond->stiffness == 0) bond->stiffness = law->normal;
  }
}

template double default_penalty(const Scene<2>&, const Contact<2>&);
template double default_penalty(const Scene<3>&, const Contact<3>&);
template double contact_stiffness(const Scene<2>&, const Contact<2>&);
template double contact_stiffness(const Scene<3>&, const Contact<3>&);
template void set_default_penalties(Scene<2>&);
template void set_default_penalties(Scene<3>&);

} // namespace signorini::model
