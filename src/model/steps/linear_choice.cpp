#include "model/steps/linear_choice.hpp"

namespace signorini::model {

template <int D> LinearFacts linear_facts(const System<D>& system) {
  const Scene<D>& scene = system.scene;
  const bool linear =
      std::all_of(scene.bodies.begin(), scene.bodies.end(), [](const auto& named) { return named.body->linear(); });
  const bool potential = std::all_of(system.contacts.begin(), system.contacts.end(),
                                     [](const auto& contact) { return contact->has_potential(); });
  const bool multipliers = std::any_of(system.contacts.begin(), system.contacts.end(),
                                       [](const auto& contact) { return contact->extra_unknowns() > 0; });
  return {linear && system.followers.empty() && !(scene.contacts.empty() && scene.ties.empty()), multipliers,
          potential && system.followers.conservative()};
}

bool can_condense(const LinearFacts& facts, bool damps) {
  return !damps && facts.constant_bulk;
}

solve::LinearKind first_choice(const LinearFacts& facts, bool damps) {
  if (can_condense(facts, damps)) return solve::LinearKind::condensed;
  return facts.potential ? solve::LinearKind::reuse : solve::LinearKind::automatic;
}

template LinearFacts linear_facts(const System<2>&);
template LinearFacts linear_facts(const System<3>&);

} // namespace signorini::model
