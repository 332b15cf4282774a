#include "model/linear_choice.hpp"

namespace signorini::model {

namespace {

/// Whether the tangent is symmetric: all but the penalty law, whose traction acts on the current area, have a
/// potential.
template <int D> bool has_potential(const Scene<D>& scene) {
  return std::all_of(scene.contacts.begin(), scene.contacts.end(),
                     [](const Contact<D>& contact) { return std::holds_alternative<contact::Adhesion>(contact.law); });
}

} // namespace

template <int D> bool can_condense(const Scene<D>& scene, bool damps) {
  return !damps && !scene.contacts.empty() &&
         std::all_of(scene.bodies.begin(), scene.bodies.end(), [](const auto& named) { return named.body->linear(); });
}

template <int D> solve::LinearKind first_choice(const Scene<D>& scene, const solve::Pattern& pattern, bool damps) {
  if (can_condense(scene, damps)) return solve::LinearKind::condensed;
  return has_potential(scene) ? solve::symmetric_choice(pattern) : solve::LinearKind::automatic;
}

template bool can_condense(const Scene<2>&, bool);
template bool can_condense(const Scene<3>&, bool);
template solve::LinearKind first_choice(const Scene<2>&, const solve::Pattern&, bool);
template solve::LinearKind first_choice(const Scene<3>&, const solve::Pattern&, bool);

} // namespace signorini::model
