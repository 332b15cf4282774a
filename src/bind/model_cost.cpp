// What a model costs, as plain tables: lua/signorini/cost.lua puts it into words.
#include "bind/model.hpp"
#include "model/cost.hpp"

namespace signorini::bind {

namespace {

template <int D> void push_bodies(lua_State* L, const model::Model<D>& model) {
  const auto& bodies = model.system.scene.bodies;
  lua_createtable(L, 0, static_cast<int>(bodies.size()));
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const model::BodyCost cost = model::body_cost(model, static_cast<int>(b));
    lua_createtable(L, 0, 6);
    set_field(L, "unknowns", cost.unknowns);
    set_field(L, "contact_layer", cost.contact_layer);
    set_field(L, "bulk", cost.unknowns - cost.contact_layer);
    set_field(L, "prescribed", cost.prescribed);
    set_field(L, "elements", cost.elements);
    set_field(L, "gauss_points", static_cast<int>(cost.gauss_points));
    lua_setfield(L, -2, bodies[b].name.c_str());
  }
  lua_setfield(L, -2, "bodies");
}

template <int D> void push_contacts(lua_State* L, const model::Model<D>& model) {
  const auto& scene = model.system.scene;
  lua_createtable(L, 0, static_cast<int>(scene.contacts.size()));
  for (std::size_t k = 0; k < scene.contacts.size(); ++k) {
    lua_createtable(L, 0, 2);
    set_field(L, "points", static_cast<int>(model.present.contacts[k].results.size()));
    set_field(L, "rigid", std::holds_alternative<model::ObstacleReference>(scene.contacts[k].master));
    lua_setfield(L, -2, scene.contacts[k].name.c_str());
  }
  lua_setfield(L, -2, "contacts");
}

template <int D> void push_memory(lua_State* L, const model::Model<D>& model) {
  const model::MemoryCost memory = model::memory_cost(model);
  set_field(L, "memory", memory.bodies + memory.contacts + memory.tangent + memory.factors);
  lua_createtable(L, 0, 4);
  set_field(L, "bodies", memory.bodies);
  set_field(L, "contacts", memory.contacts);
  set_field(L, "tangent", memory.tangent);
  set_field(L, "factors", memory.factors);
  lua_setfield(L, -2, "memory_of");
  set_field(L, "factors_are", memory.measured ? "measured" : "counted");
  set_field(L, "linear", solve::name_of(memory.solver));
}

template <int D> int cost(lua_State* L) {
  const model::Model<D>& model = *self<Model<D>>(L);
  lua_newtable(L);
  set_field(L, "unknowns", model.system.unknowns.size());
  set_field(L, "obstacles", static_cast<int>(model.system.scene.obstacles.size()));
  set_field(L, "nonzeros", model.system.assembly.pattern().entries());
  push_bodies(L, model);
  push_contacts(L, model);
  push_memory(L, model);
  return 1;
}

template <int D>
constexpr Function model_cost_entries[] = {
    {"cost_figures", cost<D>, "m:cost_figures()\nThe plain numbers behind m:cost."},
};

} // namespace

template <int D> std::span<const Function> cost_rows() {
  return model_cost_entries<D>;
}

template std::span<const Function> cost_rows<2>();
template std::span<const Function> cost_rows<3>();

} // namespace signorini::bind
