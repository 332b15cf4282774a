#include "model/linear_choice.hpp"

namespace signorini::model {

template <int D> LinearFacts linear_facts(const Scene<D>& scene) {
  const bool linear =
      std::all_of(scene.bodies.begin(), scene.bodies.end(), [](const auto& named) { return named.body->linear(); });
  // The penalty law has none, since its traction acts on the current area.
  const bool potential = std::all_of(scene.contacts.begin(), scene.contacts.end(), [](const Contact<D>& contact) {
    return std::holds_alternative<contact::Adhesion>(contact.law);
  });
  return {linear && !scene.contacts.empty(), potential};
}

bool can_condense(const LinearFacts& facts, bool damps) {
  return !damps && facts.constant_bulk;
}

solve::LinearKind first_choice(const LinearFacts& facts, const solve::Pattern& pattern, bool damps) {
  if (can_condense(facts, damps)) return solve::LinearKind::condensed;
  return facts.potential ? solve::symmetric_choice(pattern) : solve::LinearKind::automatic;
}

template LinearFacts linear_facts(const Scene<2>&);
template LinearFacts linear_facts(const Scene<3>&);

} // namespace signorini::model
