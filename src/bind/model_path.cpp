#include "base/words.hpp"
#include "bind/model.hpp"
#include "bind/wording/wording.hpp"
#include "model/arc.hpp"
#include "model/checkpoint.hpp"
#include "model/load_step.hpp"

namespace signorini::bind {

namespace {

/// Index into Drives::all() of the support or load that the first argument names; -1 of one that nothing drives.
template <int D> int drive_of_argument(lua_State* L, const Model<D>& model) {
  const auto name = to<std::string>(L, 2);
  const std::vector<std::string> driven = names_of(model->system.drives.all());
  const auto found = std::find(driven.begin(), driven.end(), name);
  if (found != driven.end()) return static_cast<int>(found - driven.begin());
  find_support(L, model, name); // or it says which there are
  return -1;
}

template <int D> std::vector<std::string> components(const Model<D>& model, int drive) {
  if (drive < 0) return {};
  return model->system.drives.all()[static_cast<std::size_t>(drive)].components;
}

template <int D> int driven(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  push(L, components(model, drive_of_argument(L, model)));
  return 1;
}

template <int D> int set_target(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const int drive = drive_of_argument(L, model);
  if (drive < 0)
    throw ArgumentError(text(function_name(L), ": name '", to<std::string>(L, 2),
                             "': this support drives nothing: give it drive = \"x\", \"xy\" or the like in sg.model"));
  const auto values = to<std::vector<double>>(L, 3);
  const std::size_t count = components(model, drive).size();
  if (values.size() != count)
    reject(L, 3, {"target", "one number per driven component"}, text("a list of ", counted(count, "number")));
  for (std::size_t i = 0; i < count; ++i) model::set_target(*model, drive, static_cast<int>(i), values[i]);
  return 0;
}

template <int D> int target(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const int drive = drive_of_argument(L, model);
  std::vector<double> values(components(model, drive).size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = model::accepted_target(*model, drive, static_cast<int>(i));
  push(L, values);
  return 1;
}

/// What model:solve_arc takes, too.
model::StepOptions read_newton(const Arguments& a) {
  model::StepOptions options;
  options.newton.tolerance = a.get<double>("tolerance");
  options.newton.iterations = a.get<int>("iterations");
  options.linear = solve::linear_kind(a.get<std::string>("linear"));
  return options;
}

model::Predictor read_predictor(const Arguments& a) {
  const auto name = a.get<std::string>("predictor");
  return name == "tangent"    ? model::Predictor::tangent
         : name == "constant" ? model::Predictor::constant
                              : model::Predictor::linear;
}

model::StepOptions read_step_options(lua_State* L) {
  const Arguments a(L, 2);
  model::StepOptions options = read_newton(a);
  options.newton.line_search = solve::line_search_kind(a.get<std::string>("line_search"));
  options.predictor = read_predictor(a);
  options.active_set = {.freeze = a.get("freeze_active_set", 0.0), .changes = a.get<int>("active_set_changes")};
  if (a.has("augmented")) {
    const Arguments augmented = a.table("augmented");
    options.augmented = {.penetration = augmented.get<double>("penetration"), .loops = augmented.get<int>("loops")};
  }
  options.damping = a.get<bool>("damping");
  options.pseudo_transient = a.get<bool>("pseudo_transient");
  return options;
}

int push_report(lua_State* L, const solve::NewtonReport& report) {
  push_fields(L, "converged", report.outcome == solve::Outcome::converged, "reason", solve::name_of(report.outcome),
              "iterations", report.iterations, "message", worded_in_one(report.messages), "residuals", report.residuals,
              "energies", report.energies, "parts", report.parts);
  return 1;
}

template <int D> int solve_step(model::Model<D>& model, lua_State* L) {
  return push_report(L, model::solve_step(model, read_step_options(L)));
}

template <int D> int iterate(model::Model<D>& model, lua_State* L) {
  return push_report(L, model::iterate(model, read_step_options(L)));
}

template <int D> int solve_arc(model::Model<D>& model, lua_State* L) {
  const Arguments a(L, 2);
  push_report(L, model::solve_arc(model, read_newton(a), a.get<double>("length")));
  set_field(L, "fraction", model.step->fraction);
  return 1;
}

template <int D> void set_penalty_factor(model::Model<D>& model, lua_State* L) {
  model::set_penalty_factor(model, to<double>(L, 2));
}

template <int D> int snapshot(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  push_object(L, Snapshot<D>{model, model::snapshot(*model)});
  return 1;
}

template <int D> int restore(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const Snapshot<D>& snapshot = read_object<Snapshot<D>>(L, 2, {"snapshot"});
  if (snapshot.model != model) reject(L, 2, {"snapshot"}, "a snapshot of this model", "it was taken of another model");
  model::restore(*model, snapshot.state);
  return 0;
}

template <int D> int snapshot_tostring(lua_State* L) {
  push(L, text("snapshot of a model with ", self<Snapshot<D>>(L).model->system.unknowns.dofs(), " degrees of freedom"));
  return 1;
}

template <int D> void save(model::Model<D>& model, lua_State* L) {
  model::save(model, to<std::string>(L, 2));
}

template <int D>
constexpr Function model_path_entries[] = {
    {"driven", driven<D>},
    {"set_target", set_target<D>},
    {"target", target<D>},
    {"solve_step", method<D, solve_step<D>>},
    {"iterate", method<D, iterate<D>>},
    {"solve_arc", method<D, solve_arc<D>>},
    {"set_penalty_factor", method<D, set_penalty_factor<D>>},
    {"penalty_factor", method<D, [](const auto& model) { return model.present.penalty_factor; }>},
    {"last_length", method<D, model::last_length<D>>},
    {"accept", method<D, model::accept<D>>},
    {"rollback", method<D, model::rollback<D>>},
    {"snapshot", snapshot<D>},
    {"restore", restore<D>},
    {"save", method<D, save<D>>},
};

template <int D> constexpr Function snapshot_rows[] = {{"__tostring", snapshot_tostring<D>}};

} // namespace

template <int D> std::span<const Function> path_rows() {
  return model_path_entries<D>;
}

void open_snapshots(lua_State* L) {
  register_type<Snapshot<2>, Snapshot<3>>(L, snapshot_rows<2>, snapshot_rows<3>);
}

template std::span<const Function> path_rows<2>();
template std::span<const Function> path_rows<3>();

} // namespace signorini::bind
