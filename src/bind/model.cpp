#include "bind/model.hpp"
#include "base/words.hpp"
#include "bind/open.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

template <class Items> int push_names(lua_State* L, const Items& items) {
  push(L, names_of(items));
  return 1;
}

template <int D> int body_names(lua_State* L) {
  return push_names(L, self<Model<D>>(L)->system.scene.bodies);
}

template <int D> int support_names(lua_State* L) {
  return push_names(L, self<Model<D>>(L)->system.scene.supports);
}

template <int D> int contact_names(lua_State* L) {
  return push_names(L, self<Model<D>>(L)->system.scene.contacts);
}

template <int D> int body_of(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const int index = find_body(L, model, read_string(L, 2, {"name", "a body"}));
  push_object<Body<D>>(L, model->system.scene.bodies[static_cast<std::size_t>(index)].body);
  return 1;
}

template <int D> int load_names(lua_State* L) {
  return push_names(L, self<Model<D>>(L)->system.scene.loads);
}

template <int D> int driven_names(lua_State* L) {
  return push_names(L, self<Model<D>>(L)->system.drives.all());
}

template <int D> int warnings(lua_State* L) {
  push(L, model::warnings(*self<Model<D>>(L)));
  return 1;
}

template <int D> int timings(lua_State* L) {
  const model::Timings& timings = self<Model<D>>(L)->timings;
  lua_createtable(L, 0, 6);
  set_field(L, "bulk", timings.bulk);
  set_field(L, "contact", timings.contact);
  set_field(L, "linear", timings.linear);
  set_field(L, "factorisation", timings.factorisation);
  set_field(L, "solution", timings.solution);
  set_field(L, "search", model::search_seconds(*self<Model<D>>(L)));
  return 1;
}

template <int D> int time_search(lua_State* L) {
  const bool wanted = read_flag(L, 2, {"wanted", "whether to take the time"});
  for (const auto& contact : self<Model<D>>(L)->system.contacts) contact->time_search(wanted);
  return 0;
}

template <int D> int solver(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const solve::SolverStatistics statistics = model->linear.statistics();
  lua_createtable(L, 0, 8);
  set_field(L, "linear", solve::name_of(model->linear.kind()));
  set_field(L, "unknowns", model->system.unknowns.size());
  set_field(L, "patterns", model->system.assembly.pattern_version());
  set_field(L, "factorisations", statistics.factorisations);
  set_field(L, "solutions", statistics.solutions);
  set_field(L, "iterations", statistics.iterations);
  set_field(L, "factor_memory", statistics.memory);
  set_field(L, "memory", model::memory(*model));
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
    {"__tostring", model_text<D>,
     "model\nWhat sg.model returns: the scene with its accepted state and the present one; print(model) tells its "
     "size and its\nparts, where stages have moved them and which contacts touch; tostring(model) its size.\n"
     "model:run takes it along a load path; help \"results\" and help \"verbs\" list the other methods."},
    {"body_names", body_names<D>,
     "m:body_names()\nThe names of the bodies, sorted.\n"
     "Example: model:body_names()  --> {\"die\", \"slab\"}"},
    {"support_names", support_names<D>,
     "m:support_names()\nThe names of the supports, sorted.\n"
     "Example: model:support_names()  --> {\"bed\", \"grip\"}"},
    {"contact_names", contact_names<D>,
     "m:contact_names()\nThe names of the contacts, sorted.\n"
     "Example: model:contact_names()  --> {\"interface\"}"},
    {"body", body_of<D>,
     "m:body(name)\nA body of the model.\n"
     "Example: model:body \"slab\""},
    {"load_names", load_names<D>,
     "m:load_names()\nThe names of the loads, sorted.\n"
     "Example: model:load_names()  --> {}"},
    {"driven_names", driven_names<D>,
     "m:driven_names()\nThe names of what stages can move: supports that drive or rotate, then loads.\n"
     "Example: model:driven_names()  --> {\"grip\"}"},
    {"warnings", warnings<D>,
     "m:warnings()\n"
     "Returns a list of sentences on what is probably not meant. About the scene, which sg.model prints as well:\n"
     "bodies that overlap before the first step by more than 1 % of the thickness of the thinner one, Poisson's "
     "ratios\n"
     "that lock, mu above 3, penalties above 1e8 times the stiffness of an element, contacts that act twice. About "
     "the\n"
     "present state: linear elastic bodies that are turned inside out. run.warnings begins with them.\n"
     "Example: model:warnings()  --> {}"},
    {"timings", timings<D>,
     "m:timings()\n"
     "Seconds so far: { bulk, contact, linear, factorisation, solution, search }. linear consists of factorisation "
     "and\n"
     "solution, but for a few vectors (with linear = \"kept\" a solution renews the factorisation when it pays). "
     "search is\n"
     "part of contact, summed over threads: closest points and the tree of boxes, while m:time_search(true).\n"
     "Example: model:timings().linear"},
    {"time_search", time_search<D>,
     "m:time_search(wanted)\n"
     "Whether m:timings takes account of the contacts' search from now on: true or false, as at first. A clock is "
     "read\n"
     "twice for each contact point that is projected, about 50 ns.\n"
     "Example: model:time_search(true)"},
    {"solver", solver<D>,
     "m:solver()\n"
     "{ linear, unknowns, patterns, factorisations, solutions, iterations, factor_memory, memory }: the linear solver\n"
     "in use, the size of its systems, how many sparse patterns were analysed; then what was done since the model was\n"
     "made: numerical factorisations, right-hand sides, iterations of GMRES where a factorisation was kept; bytes of\n"
     "the present factors, and of the bodies' tables with the tangent and its patterns.\n"
     "Example: model:solver().linear"},
};

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
