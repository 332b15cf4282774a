#include "model/linear_choice.hpp"

namespace signorini::model {

template <int D> bool has_potential(const Scene<D>& scene) {
  return std::all_of(scene.contacts.begin(), scene.contacts.end(),
                     [](const Contact<D>& contact) { return std::holds_alternative<contact::Adhesion>(contact.law); });
}

template <int D> solve::LinearKind first_choice(const Scene<D>& scene, const solve::Pattern& pattern) {
  const bool linear =
      std::all_of(scene.bodies.begin(), scene.bodies.end(), [](const auto& named) { return named.body->linear(); });
  if (linear && !scene.contacts.empty()) return solve::LinearKind::condensed;
  return has_potential(scene) ? solve::symmetric_choice(pattern) : solve::LinearKind::automatic;
}

template bool has_potential(const Scene<2>&);
template bool has_potential(const Scene<3>&);
template solve::LinearKind first_choice(const Scene<2>&, const solve::Pattern&);
template solve::LinearKind first_choice(const Scene<3>&, const solve::Pattern&);

} // namespace signorini::model
