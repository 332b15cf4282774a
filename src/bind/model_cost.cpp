// What a model costs and what could be saved, as plain tables: lua/signorini/cost.lua puts it into words.
#include "bind/model.hpp"
#include "model/cost.hpp"
#include "model/economy.hpp"
#include "model/revolution.hpp"
#include "model/symmetry.hpp"

namespace signorini::bind {

namespace {

/// Sets a field of the table on top of the stack to a list of tables, one per item, which fill(item) gives fields.
template <class Items, class Fill> void set_list(lua_State* L, const char* name, const Items& items, Fill fill) {
  lua_createtable(L, static_cast<int>(items.size()), 0);
  lua_Integer count = 0;
  for (const auto& item : items) {
    lua_newtable(L);
    fill(item);
    lua_rawseti(L, -2, ++count);
  }
  lua_setfield(L, -2, name);
}

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

template <int D> void push_planes(lua_State* L, const model::Model<D>& model) {
  std::vector<std::vector<model::Mirror>> choices;
  std::vector<model::Mirror> sure;
  for (const model::Mirror& mirror : model::find_mirrors(model)) {
    choices.push_back({mirror});
    if (mirror.driven.empty()) sure.push_back(mirror);
  }
  if (sure.size() > 1) choices.push_back(sure);
  set_list(L, "symmetries", choices, [&](const std::vector<model::Mirror>& planes) {
    set_field(L, "needs", model::unknowns_beside(model, planes));
    set_list(L, "planes", planes, [&](const model::Mirror& plane) {
      set_field(L, "axis", model::component_name(plane.axis));
      set_field(L, "place", plane.place);
      std::vector<std::string> driven;
      for (int support : plane.driven)
        driven.push_back(model.system.scene.supports[static_cast<std::size_t>(support)].name);
      set_field(L, "driven", driven);
    });
  });
}

void push_revolution(lua_State* L, const model::Model<3>& model) {
  const std::optional<model::Revolution> found = model::find_revolution(model);
  if (!found) return;
  lua_createtable(L, 0, 3);
  set_field(L, "axis", model::component_name(found->axis));
  set_field(L, "centre", VectorX(found->centre));
  set_field(L, "needs", model::unknowns_of_section(model, *found));
  lua_setfield(L, -2, "revolution");
}

template <int D> int cost(lua_State* L) {
  const model::Model<D>& model = *self<Model<D>>(L);
  const auto& bodies = model.system.scene.bodies;
  const auto body_name = [&](int body) { return bodies[static_cast<std::size_t>(body)].name; };
  lua_newtable(L);
  set_field(L, "dimension", D);
  set_field(L, "unknowns", model.system.unknowns.size());
  set_field(L, "obstacles", static_cast<int>(model.system.scene.obstacles.size()));
  set_field(L, "nonzeros", model.system.assembly.pattern().entries());
  push_bodies(L, model);
  push_contacts(L, model);
  push_memory(L, model);
  push_planes(L, model);
  if constexpr (D == 3) push_revolution(L, model);
  set_list(L, "stiff", model::find_stiff_bodies(model), [&](const model::StiffBody& stiff) {
    set_field(L, "body", body_name(stiff.body));
    set_field(L, "partner", body_name(stiff.partner));
    set_field(L, "ratio", stiff.ratio);
    set_field(L, "saves", stiff.unknowns);
  });
  const auto set_labels = [&](const char* name, const std::vector<model::LabelChoice>& choices) {
    set_list(L, name, choices, [&](const model::LabelChoice& choice) {
      set_field(L, "body", body_name(choice.body));
      set_field(L, "labels", choice.labels);
      if (choice.through) set_field(L, "through", *choice.through);
      set_field(L, "needs", choice.unknowns);
    });
  };
  set_labels("layers", model::find_layers(model));
  set_labels("idle_layers", model::find_idle_layers(model));
  set_list(L, "dense", model::find_dense_contacts(model), [&](const model::DenseContact& dense) {
    const auto& contact = model.system.scene.contacts[static_cast<std::size_t>(dense.contact)];
    set_field(L, "contact", contact.name);
    set_field(L, "points", contact.points);
    set_field(L, "enough", dense.enough);
    set_field(L, "needs", dense.points);
  });
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
