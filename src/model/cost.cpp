#include "model/cost.hpp"

#include "model/linear_choice.hpp"
#include "solve/factor_estimate.hpp"

#include <set>

namespace signorini::model {

template <int D> BodyCost body_cost(const Model<D>& model, int index) {
  const solid::Body<D>& body = *model.system.scene.bodies[at(index)].body;
  const Unknowns<D>& unknowns = model.system.unknowns;
  std::set<int> all, layer;
  BodyCost cost{0, 0, 0, body.elements(), 0};
  const auto unknown = [&](int function, int component) {
    return unknowns.unknown(unknowns.offset(index) + D * function + component);
  };
  for (int function = 0; function < body.functions(); ++function)
    for (int c = 0; c < D; ++c) {
      if (unknown(function, c) < 0)
        ++cost.prescribed;
      else
        all.insert(unknown(function, c));
    }
  for (nurbs::Side side : body.space().contact())
    for (int function : body.space().face_functions(side))
      for (int c = 0; c < D; ++c)
        if (unknown(function, c) >= 0) layer.insert(unknown(function, c));
  cost.unknowns = static_cast<int>(all.size());
  cost.contact_layer = static_cast<int>(layer.size());
  for (int e = 0; e < body.elements(); ++e) cost.gauss_points += body.element(e).points;
  return cost;
}

template <int D> MemoryCost memory_cost(const Model<D>& model) {
  MemoryCost cost{0, 0, model.system.assembly.memory(), model.linear.statistics().memory, true, model.linear.kind()};
  for (const auto& named : model.system.scene.bodies) cost.bodies += static_cast<double>(named.body->memory());
  for (const auto& contact : model.system.contacts) cost.contacts += contact->memory();
  for (const State<D>* state : {&model.accepted, &model.present})
    for (const auto& history : state->contacts) cost.contacts += contact::memory(history);
  if (cost.factors == 0 && model.system.unknowns.size() > 0) {
    const solve::Pattern& pattern = model.system.assembly.pattern();
    constexpr bool damps = false;
    const solve::FactorEstimate estimate =
        solve::estimate_factor(first_choice(linear_facts(model.system), damps), pattern);
    cost.factors = estimate.memory;
    cost.solver = estimate.kind;
    cost.measured = false;
  }
  return cost;
}

template BodyCost body_cost(const Model<2>&, int);
template BodyCost body_cost(const Model<3>&, int);
template MemoryCost memory_cost(const Model<2>&);
template MemoryCost memory_cost(const Model<3>&);

} // namespace signorini::model
