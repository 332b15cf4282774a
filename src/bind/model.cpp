#include "bind/model.hpp"
#include "base/words.hpp"
#include "bind/open.hpp"
#include "bind/wording/wording.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

/// The method that returns the names of what part(model) lists.
template <int D, auto part> int names(lua_State* L) {
  push(L, names_of(part(*self<Model<D>>(L))));
  return 1;
}

template <int D> int body_of(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const int index = find_body(L, model, to<std::string>(L, 2));
  push_object<Body<D>>(L, model->system.scene.bodies[static_cast<std::size_t>(index)].body);
  return 1;
}

template <int D> int timings(const model::Model<D>& model, lua_State* L) {
  const model::Timings& spent = model.timings;
  push_fields(L, "bulk", spent.bulk, "contact", spent.contact, "linear", spent.linear, "factorisation",
              spent.factorisation, "solution", spent.solution, "search", model::search_seconds(model));
  return 1;
}

template <int D> int warnings(const model::Model<D>& model, lua_State* L) {
  push(L, worded(model::warnings(model)));
  return 1;
}

template <int D> void time_search(const model::Model<D>& model, lua_State* L) {
  for (const auto& contact : model.system.contacts) contact->time_search(to<bool>(L, 2));
}

template <int D> int solver(const model::Model<D>& model, lua_State* L) {
  const solve::SolverStatistics done = model.linear.statistics();
  push_fields(L, "linear", solve::name_of(model.linear.kind()), "unknowns", model.system.unknowns.size(), "patterns",
              model.system.assembly.pattern_version(), "factorisations", done.factorisations, "solutions",
              done.solutions, "iterations", done.iterations, "factor_memory", done.memory, "memory",
              model::memory(model));
  return 1;
}

template <int D> int model_text(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const auto& scene = model->system.scene;
  std::string names;
  for (const auto& body : scene.bodies) names += (names.empty() ? "" : ", ") + body.name;
  const char* kind = D == 3 ? "solid" : scene.kind == solid::Kind::axisymmetric ? "axisymmetric" : "plane-strain";
  push(L, text(kind, " model of ", names, ": ", model->system.unknowns.dofs(), " degrees of freedom, ",
               model->system.unknowns.size(), " of them free, ", counted(scene.supports.size(), "support"), ", ",
               counted(scene.contacts.size(), "contact")));
  return 1;
}

template <int D>
constexpr Function model_entries[] = {
    {"__tostring", model_text<D>},
    {"body_names", names < D, [](const auto& model) -> auto& {return model.system.scene.bodies;
} // namespace
>
} // namespace signorini::bind
, {"support_names", names < D, [](const auto& model) -> auto& {return model.system.scene.supports;
}
>
}
, {"load_names", names < D, [](const auto& model) -> auto& {return model.system.scene.loads;
}
>
}
, {"contact_names", names < D, [](const auto& model) -> auto& {return model.system.scene.contacts;
}
>
}
, {"driven_names", names < D, [](const auto& model) -> auto& {return model.system.drives.all();
}
>
}
, {"body", body_of<D>}, {"warnings", method<D, warnings<D>>}, {"timings", method<D, timings<D>>},
    {"time_search", method<D, time_search<D>>}, {"solver", method<D, solver<D>>},
}
;

/// All methods, subject by subject.
template <int D> std::vector<Function> all_rows() {
  std::vector<Function> all;
  for (const std::span<const Function> part : {std::span<const Function>(model_entries<D>), path_rows<D>(),
                                               system_rows<D>(), result_rows<D>(), cost_rows<D>()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

} // namespace

void open_model(lua_State* L) {
  register_type<Model<2>, Model<3>>(L, all_rows<2>(), all_rows<3>());
  open_snapshots(L);
}

} // namespace signorini::bind
