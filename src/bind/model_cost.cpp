// What a model is made of, in numbers: unknowns, elements, points, nonzeros, bytes. lua/signorini/cost.lua prints them.
#include "bind/model.hpp"
#include "model/linear_choice.hpp"
#include "solve/factor_estimate.hpp"

#include <set>

namespace signorini::bind {

namespace {

/// Unknowns that control points share count once; the contact layer's are those on the rows of the contact faces.
template <int D> void push_body_cost(lua_State* L, const model::Model<D>& model, int index) {
  const auto& unknowns = model.system.unknowns;
  const solid::Body<D>& body = *model.system.scene.bodies[static_cast<std::size_t>(index)].body;
  std::set<int> all, layer;
  int points = 0;
  for (int e = 0; e < body.elements(); ++e) points += body.element(e).points;
  const auto unknown = [&](int i) { return unknowns.unknown(unknowns.offset(index) + i); };
  int prescribed = 0;
  for (int i = 0; i < D * body.functions(); ++i)
    if (unknown(i) >= 0)
      all.insert(unknown(i));
    else
      ++prescribed;
  for (nurbs::Side side : body.space().contact())
    for (int function : body.space().face_functions(side))
      for (int i = D * function; i < D * (function + 1); ++i)
        if (unknown(i) >= 0) layer.insert(unknown(i));
  const auto unknowns_in_all = static_cast<int>(all.size()), in_layer = static_cast<int>(layer.size());
  push_fields(L, "unknowns", unknowns_in_all, "contact_layer", in_layer, "bulk", unknowns_in_all - in_layer,
              "prescribed", prescribed, "elements", body.elements(), "gauss_points", points);
}

/// Bytes of the factors as the linear solver has told; before that counted, for the solver that it would choose.
template <int D> double push_factors(lua_State* L, const model::Model<D>& model) {
  double memory = model.linear.statistics().memory;
  solve::LinearKind solver = model.linear.kind();
  const bool counted = memory == 0 && model.system.unknowns.size() > 0;
  if (counted) {
    constexpr bool damps = false;
    const auto estimate = solve::estimate_factor(model::first_choice(model::linear_facts(model.system), damps),
                                                 model.system.assembly.pattern());
    memory = estimate.memory;
    solver = estimate.kind;
  }
  set_fields(L, "factors_are", counted ? "counted" : "measured", "linear", solve::name_of(solver));
  return memory;
}

template <int D> int cost(const model::Model<D>& model, lua_State* L) {
  const model::Scene<D>& scene = model.system.scene;
  push_fields(L, "unknowns", model.system.unknowns.size(), "obstacles", static_cast<int>(scene.obstacles.size()),
              "nonzeros", model.system.assembly.pattern().entries());
  const double factors = push_factors(L, model), tangent = model.system.assembly.memory();
  double bodies = 0, contacts = 0;
  lua_newtable(L);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    bodies += static_cast<double>(scene.bodies[b].body->memory());
    push_body_cost(L, model, static_cast<int>(b));
    lua_setfield(L, -2, scene.bodies[b].name.c_str());
  }
  lua_setfield(L, -2, "bodies");
  lua_newtable(L);
  for (std::size_t k = 0; k < scene.contacts.size(); ++k) {
    contacts += model.system.contacts[k]->memory();
    for (const auto* state : {&model.accepted, &model.present}) contacts += contact::memory(state->contacts[k]);
    push_fields(L, "points", static_cast<int>(model.present.contacts[k].results.size()), "rigid",
                std::holds_alternative<model::ObstacleReference>(scene.contacts[k].master));
    lua_setfield(L, -2, scene.contacts[k].name.c_str());
  }
  lua_setfield(L, -2, "contacts");
  set_field(L, "memory", bodies + contacts + tangent + factors);
  push_fields(L, "bodies", bodies, "contacts", contacts, "tangent", tangent, "factors", factors);
  lua_setfield(L, -2, "memory_of");
  return 1;
}

template <int D> constexpr Function model_cost_entries[] = {{"cost", method<D, cost<D>>}};

} // namespace

template <int D> std::span<const Function> cost_rows() {
  return model_cost_entries<D>;
}

template std::span<const Function> cost_rows<2>();
template std::span<const Function> cost_rows<3>();

} // namespace signorini::bind
