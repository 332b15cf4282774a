#include "bind/model/model.hpp"
#include "base/words.hpp"
#include "bind/lua/open.hpp"
#include "bind/lua/wording/wording.hpp"
#include "model/checks/axis.hpp"
#include "model/diagnosis/weak_hold.hpp"
#include "model/scene/joins.hpp"
#include "model/steps/equilibrium.hpp"
#include "model/warnings/explicit_wear.hpp"
#include "model/warnings/peak_edge.hpp"
#include "model/warnings/state_warnings.hpp"

#include <algorithm>
#include <limits>

namespace signorini::bind {

namespace {

/// The names of the items in a list of the scene.
template <int D, auto list> std::vector<std::string> scene_names(const model::Model<D>& model) {
  return names_of(model.system.scene.*list);
}

template <int D> std::vector<std::string> driven_names(const model::Model<D>& model) {
  return names_of(model.system.drives.all());
}

template <int D> Body<D> body_of(const model::Model<D>& model, const std::string& name) {
  return model.system.scene.bodies[find_body(model, name)].body;
}

template <int D> int timings(const model::Model<D>& model, lua_State* L) {
  const model::Timings& spent = model.timings;
  push_fields(L, "bulk", spent.bulk, "contact", spent.contact, "linear", spent.linear, "factorization",
              spent.factorization, "solution", spent.solution, "search", model::search_seconds(model));
  return 1;
}

template <int D> std::vector<std::string> warnings(const model::Model<D>& model) {
  return worded(model.scene_warnings);
}

template <int D> void time_search(const model::Model<D>& model, bool wanted) {
  for (const auto& contact : model.system.contacts) contact->counters.times_search = wanted;
}

template <int D> int solver(const model::Model<D>& model, lua_State* L) {
  const solve::SolverStatistics done = model.linear.statistics();
  push_fields(L, "linear", solve::name_of(model.linear.kind()), "unknowns", model.system.unknowns.size(), "patterns",
              model.system.assembly.tangent().version, "factorizations", done.factorizations, "solutions",
              done.solutions, "iterations", done.iterations, "factor_operations", done.operations, "factor_memory",
              done.memory, "memory", model::memory(model));
  const auto& unknowns = model.system.unknowns;
  if (done.negative >= 0 && unknowns.free_displacements() == unknowns.size())
    set_field(L, "negative_eigenvalues", done.negative);
  if (done.rank_memory > 0) set_field(L, "rank_memory", done.rank_memory);
  return 1;
}

/// What became of each join.
template <int D> std::string joins_text(const model::Scene<D>& scene) {
  std::string result;
  const auto add = [&](const std::string& name, const auto&... words) {
    result += text(result.empty() ? "; joins: " : ", ", name, " ", words...);
  };
  for (const model::Join& join : scene.joins) add(join.name, "shares ", counted(join.pairs.size(), "control point"));
  for (const model::Tie& tie : scene.ties)
    if (tie.from_join)
      add(tie.name, "is tied, because ", worded(model::difference(scene, tie.slave.front(), tie.master.front())));
  return result;
}

/// The names of the parts that satisfy a condition, after a word.
template <class Part, class Condition>
std::string names_text(const char* word, const std::vector<Part>& parts, const Condition& holds) {
  std::string result;
  for (const Part& part : parts)
    if (holds(part)) result += text(result.empty() ? text("; ", word, ": ") : ", ", part.name);
  return result;
}

template <int D> std::string model_text(const model::Model<D>& model) {
  const auto& scene = model.system.scene;
  constexpr const char* kinds[] = {"plane-strain", "axisymmetric", "plane-stress"};
  const char* kind = D == 3 ? "solid" : kinds[static_cast<int>(scene.kind)];
  return text(
      kind, " model of ", listed(names_of(scene.bodies)), ": ", model.system.unknowns.dofs(), " degrees of freedom, ",
      model.system.unknowns.size(), " of them free, ", counted(scene.supports.size(), "support"), ", ",
      counted(scene.contacts.size(), "contact"), scene.ties.empty() ? "" : ", " + counted(scene.ties.size(), "tie"),
      joins_text(scene),
      names_text("on springs", scene.supports,
                 [](const auto& support) { return !support.spring.isZero(0) || !support.obstacle_spring.isZero(0); }),
      names_text("frees an obstacle", scene.supports,
                 [](const auto& support) {
                   return support.free_angle ||
                          (!support.obstacles.empty() && std::ranges::count(support.freed, true) > 0);
                 }),
      names_text("rotates an obstacle", scene.supports,
                 [](const auto& support) { return support.turns() && !support.obstacles.empty(); }),
      names_text("follows the deformation", scene.loads,
                 [](const auto& load) { return load.kind == model::LoadKind::follower_pressure; }));
}

template <int D>
constexpr Function model_entries[] = {
    {"__tostring", call<model_text<D>>},
    {"body_names", call<scene_names<D, &model::Scene<D>::bodies>>},
    {"support_names", call<scene_names<D, &model::Scene<D>::supports>>},
    {"load_names", call<scene_names<D, &model::Scene<D>::loads>>},
    {"contact_names", call<scene_names<D, &model::Scene<D>::contacts>>},
    {"tie_names", call<scene_names<D, &model::Scene<D>::ties>>},
    {"driven_names", call<driven_names<D>>},
    {"body", call<body_of<D>>},
    {"warnings", call<warnings<D>>},
    {"timings", call<timings<D>>},
    {"time_search", call<time_search<D>>},
    {"solver", call<solver<D>>},
};

template <int D> std::string snapshot_text(const Snapshot<D>& snapshot) {
  return text("snapshot of a model with ", snapshot.model->system.unknowns.dofs(), " degrees of freedom");
}

/// core.smallest_body(model): the diagonal of the bounding box of the smallest body's control points, and its name.
template <int D> int smallest_body(const model::Model<D>& model, lua_State* L) {
  double least = std::numeric_limits<double>::infinity();
  const std::string* smallest = nullptr;
  for (const auto& [name, body] : model.system.scene.bodies) {
    const MatrixX points = body->space().points();
    const double size = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
    if (size >= least) continue;
    least = size;
    smallest = &name;
  }
  push(L, least);
  push(L, *smallest);
  return 2;
}

/// core.rounding(model): the estimated rounding error of the residual, the largest norm of the forces of supports and
/// loads in all accepted states, or of the contacts at present, whether loads or contacts act at present, and the
/// residual of the accepted state.
template <int D> int rounding(const model::Model<D>& model, lua_State* L) {
  const double rounding = model::rounding_floor(model);
  push(L, rounding);
  push(L, std::max(model::force_norm(model), model::contact_norm(model)));
  push(L, model.external.norm() > 0 || model::contact_acts(model, rounding));
  const bool judged = model.path.force_scale > 0; // a step has been in balance
  push(L, judged ? model.unbalanced.norm() : 0.0);
  return 4;
}

/// core.off_axis(model, name, values): what is wrong with values of a support in an axisymmetric model; else nil.
template <int D>
std::optional<std::string> off_axis(const model::Model<D>& model, const std::string& name,
                                    const std::vector<double>& values) {
  if constexpr (D == 2) {
    const auto& drives = model.system.drives.all();
    const auto drive = std::ranges::find(drives, name, &model::Drive::name);
    if (drive == drives.end()) return std::nullopt;
    const Message wrong = model::off_axis(model.system, static_cast<int>(drive - drives.begin()), values);
    if (!wrong.code.empty()) return worded(wrong);
  }
  return std::nullopt;
}

/// core.is_peak_at_edge(model, contact): see peak_edge.hpp.
template <int D> bool is_peak_at_edge(const model::Model<D>& model, const std::string& name) {
  return model::is_peak_at_edge(model, find(model.system.scene.contacts, name, "contact"));
}

/// core.explicit_wear(model, contact): see explicit_wear.hpp.
template <int D> double explicit_wear(const model::Model<D>& model, const std::string& name) {
  return model::explicit_wear(model, find(model.system.scene.contacts, name, "contact"));
}

/// core.weak_hold(model): a warning if contacts alone hold a body and hold it weakly; nil otherwise.
template <int D> std::optional<std::string> weak_hold(model::Model<D>& model) {
  const auto warning = model::weak_hold(model);
  return warning ? std::optional(worded(*warning)) : std::nullopt;
}

/// The code of a warning and the names in it.
std::string subject(const Message& warning) {
  std::string all = warning.code;
  for (const auto& [name, value] : warning.data) {
    if (const auto* word = std::get_if<std::string>(&value)) all += " " + *word;
    if (const auto* parts = std::get_if<std::vector<Message>>(&value))
      for (const Message& part : *parts) all += " " + subject(part);
  }
  return all;
}

/// core.state_warnings(model, everything): the warnings about its accepted state as a list of { subject, text }; those
/// of two states with the same subject differ in figures only.
template <int D> int state_warnings(model::Model<D>& model, bool everything, lua_State* L) {
  push_list(L, model::state_warnings(model, everything),
            [&](const Message& warning) { push_fields(L, "subject", subject(warning), "text", worded(warning)); });
  return 1;
}

template <int D>
constexpr Function model_core[] = {
    {"rounding", call<rounding<D>>},
    {"smallest_body", call<smallest_body<D>>},
    {"off_axis", call<off_axis<D>>},
    {"is_deformed", call<model::is_deformed<D>>}, // whether bodies are deformed in the accepted state
    {"state_warnings", call<state_warnings<D>>},
    {"is_peak_at_edge", call<is_peak_at_edge<D>>},
    {"explicit_wear", call<explicit_wear<D>>},
    {"weak_hold", call<weak_hold<D>>},
};

template <int D> constexpr Function snapshot_entries[] = {{"__tostring", call<snapshot_text<D>>}};

} // namespace

void open_model(lua_State* L) {
  register_functions<Model<2>, Model<3>>(L, "core", model_core<2>, model_core<3>);
  register_type<Model<2>, Model<3>>(L, model_entries<2>, model_entries<3>);
  register_type<Snapshot<2>, Snapshot<3>>(L, snapshot_entries<2>, snapshot_entries<3>);
}

} // namespace signorini::bind
