#include "model/default_penalty.hpp"

#include "base/index.hpp"
#include "model/constants.hpp"
#include "model/element_size.hpp"

#include <algorithm>

namespace signorini::model {

namespace {

template <int D> double default_penalty(const Scene<D>& scene, const Contact<D>& contact) {
  double softer = youngs_modulus(scene, contact.slave);
  if (const auto* face = std::get_if<Faces>(&contact.master)) softer = std::min(softer, youngs_modulus(scene, *face));
  // ε = 10 E/h
  return default_penalty_ratio * softer / element_size(scene, contact.slave, contact.points, contact.where);
}

} // namespace

template <int D> void set_default_penalties(Scene<D>& scene) {
  for (Contact<D>& contact : scene.contacts) {
    contact::PenaltyLaw* law = contact::penalty_law(contact.method);
    if (!law || law->enforcement == contact::Enforcement::penalty) continue;
    const double usual = default_penalty(scene, contact);
    if (auto* mortar = std::get_if<contact::MortarLaw>(&contact.method)) mortar->scale = usual;
    if (law->normal == 0) {
      law->normal = usual;
      contact.default_penalty = true;
    }
    if (law->tangential == 0) law->tangential = law->normal;
  }
}

template void set_default_penalties(Scene<2>&);
template void set_default_penalties(Scene<3>&);

} // namespace signorini::model
