#include "base/words.hpp"
#include "bind/lua/open.hpp"
#include "bind/lua/wording/wording.hpp"
#include "bind/model/iteration_report.hpp"
#include "bind/model/model.hpp"
#include "model/checks/axis.hpp"
#include "model/diagnosis/diagnosis.hpp"
#include "model/files/checkpoint.hpp"
#include "model/gradients/neighbors.hpp"
#include "model/scene/turning.hpp"
#include "model/steps/arc.hpp"
#include "model/steps/equilibrium.hpp"
#include "model/steps/load_step.hpp"

#include <algorithm>
#include <limits>

namespace signorini::bind {

namespace {

/// Index into Drives::all() of the support or load of this name; -1 for a support without drive.
template <int D> int find_drive(const model::Model<D>& model, const std::string& name) {
  const auto& drives = model.system.drives.all();
  for (std::size_t i = 0; i < drives.size(); ++i)
    if (drives[i].name == name) return static_cast<int>(i);
  find(model.system.scene.supports, name, "support"); // throws an error that lists the supports
  return -1;
}

template <int D> std::vector<std::string> driven(const model::Model<D>& model, const std::string& name) {
  const int drive = find_drive(model, name);
  return drive < 0 ? std::vector<std::string>() : model.system.drives.all()[drive].components;
}

template <int D> void set_target(model::Model<D>& model, const std::string& name, lua_State* L) {
  const int drive = find_drive(model, name);
  require(drive >= 0, "name '", name,
          "': this support has no driven component: add drive = \"x\" or similar in sg.model");
  const auto values = to<std::vector<double>>(L, 3);
  const std::size_t count = driven(model, name).size();
  if (values.size() != count)
    reject(L, 3, {"target", "one number per driven component"}, text("a list of ", counted(count, "number")));
  if (const Message wrong = model::off_axis(model.system, drive, values); !wrong.code.empty())
    require(false, worded(wrong));
  for (std::size_t i = 0; i < count; ++i) model::set_target(model, drive, static_cast<int>(i), values[i]);
}

template <int D> std::vector<double> target(const model::Model<D>& model, const std::string& name) {
  const int drive = find_drive(model, name);
  std::vector<double> values(driven(model, name).size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = model::accepted_target(model, drive, static_cast<int>(i));
  return values;
}

/// Options that model:solve_arc has as well.
model::StepOptions read_newton(const Arguments& a) {
  model::StepOptions options;
  options.newton.tolerance = a.get<double>("tolerance");
  options.newton.iterations = a.get<int>("iterations");
  options.linear = solve::linear_kind(a.get<std::string>("linear"));
  if (a.has("mumps")) {
    const Arguments how = a.table("mumps");
    options.mumps.settings.low_rank = how.get("low_rank", 0.0);
    options.mumps.settings.single = how.get<std::string>("precision") == "single";
    options.mumps.settings.folder = how.get("out_of_core", std::string());
    options.mumps.reuse = how.get<bool>("reuse");
  }
  return options;
}

model::StepOptions read_step_options(const Arguments& a) {
  model::StepOptions options = read_newton(a);
  options.newton.line_search = solve::line_search_kind(a.get<std::string>("line_search"));
  options.predictor =
      choice<model::Predictor>(a.get<std::string>("predictor"), {"tangent", "constant", "linear", "quadratic"});
  options.active_set = {.freeze = a.get("freeze_active_set", 0.0), .changes = a.get<int>("active_set_changes")};
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

/// Prints the last iteration, if `verbose`.
template <int D> model::AfterIteration printer(const model::Model<D>& model, const Arguments& a, lua_State* L) {
  if (!a.get<bool>("verbose")) return {};
  return iteration_printer(L, model, a.get<double>("tolerance"));
}

template <int D> int solve_step(model::Model<D>& model, const Arguments& a, lua_State* L) {
  return push_report(L, model::solve_step(model, read_step_options(a), printer(model, a, L)));
}

template <int D> int iterate(model::Model<D>& model, const Arguments& a, lua_State* L) {
  return push_report(L, model::iterate(model, read_step_options(a), printer(model, a, L)));
}

template <int D> int solve_arc(model::Model<D>& model, const Arguments& a, lua_State* L) {
  const model::ArcReport report =
      model::solve_arc(model, read_newton(a), a.get<double>("length"), printer(model, a, L));
  push_report(L, report);
  set_field(L, "fraction", report.fraction);
  return 1;
}

/// core.follow_run(model, { plus, minus, step, size, factored, begun, … of model:solve_step }): see
/// gradients/neighbors.hpp; a table { passes, renewed, begun, defect, forces, kinks, share, reach, contact, place }, or
/// { failure }.
template <int D> int follow_run(model::Model<D>& model, const Arguments& a, lua_State* L) {
  const auto optional = [&](const char* key) { return a.has(key) ? &*a.object<Model<D>>(key) : nullptr; };
  const model::Neighbors<D> neighbors{*a.object<Model<D>>("plus"), *a.object<Model<D>>("minus"), a.get<double>("step"),
                                      a.get<double>("size"),       optional("factored"),         optional("begun")};
  const model::FollowReport<D> report = model::follow_run(model, neighbors, read_step_options(a));
  if (!report.failure.code.empty()) {
    push_fields(L, "failure", worded(report.failure));
    return 1;
  }
  push_fields(L, "passes", report.passes, "renewed", report.renewed, "begun", report.begun, "defect", report.defect,
              "forces", report.forces, "kinks", report.kinks.points, "share", report.kinks.share, "reach",
              report.kinks.reach);
  if (report.kinks.contact >= 0) {
    set_field(L, "contact", model.system.scene.contacts[report.kinks.contact].name);
    set_field(L, "place", std::vector<double>(report.kinks.place.begin(), report.kinks.place.end()));
  }
  return 1;
}

/// core.neighbor_difference(model, other): see gradients/neighbors.hpp; nil if there is none.
template <int D> std::optional<std::string> neighbor_difference(const Model<D>& model, const Model<D>& other) {
  const Message found = model::difference(*model, *other);
  return found.code.empty() ? std::nullopt : std::optional(worded(found));
}

template <int D> Snapshot<D> snapshot(const Model<D>& model) {
  return {model, model::snapshot(*model)};
}

template <int D> void restore(const Model<D>& model, const Snapshot<D>& snapshot, lua_State* L) {
  if (snapshot.model != model)
    reject(L, 2, {"snapshot"}, "a snapshot of this model",
           model->origin ? "its layers have moved since (adapt), or it belongs to another model"
                         : "it belongs to another model");
  model::restore(*model, snapshot.state);
}

// ── Parts of Newton's method for user-defined loops, and diagnosis ───────────────────────────────────────────────────

/// The residual by unknown, after an evaluation of the present state. That of an accepted state begins a step, with
/// slips that start there; afterwards results are again those of the step that led there. Throws when the residual
/// cannot be evaluated.
template <int D> VectorX residual(model::Model<D>& model) {
  const bool accepted = model::settled(model);
  Message why;
  const solve::Outcome outcome = model::evaluate(model, {}, why);
  VectorX unbalanced = model.unbalanced;
  if (accepted) model::rollback(model);
  signorini::require(outcome == solve::Outcome::converged, "model.step.no_residual", {{"why", why}});
  return unbalanced;
}

template <int D> int tangent(model::Model<D>& model, lua_State* L) {
  residual(model);
  const solve::Pattern& pattern = model.system.assembly.tangent().pattern;
  std::vector<int> rows, columns;
  for (int j = 0; j < pattern.size; ++j)
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k) {
      rows.push_back(pattern.rows[k] + 1);
      columns.push_back(static_cast<int>(j) + 1);
    }
  const auto values = model.system.assembly.tangent().values.begin();
  push_fields(L, "size", pattern.size, "rows", rows, "columns", columns, "values",
              std::vector<double>(values, values + pattern.entries()));
  return 1;
}

template <int D> int unknowns(const model::Model<D>& model, lua_State* L) {
  const auto& numbers = model.system.unknowns;
  const auto& bodies = model.system.scene.bodies;
  lua_createtable(L, numbers.size(), 0);
  std::vector<char> seen(numbers.size(), 0);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (int i = 0; i < D * bodies[b].body->functions(); ++i) {
      const int unknown = numbers.unknown(numbers.offset(static_cast<int>(b)) + i);
      if (unknown < 0 || std::exchange(seen[unknown], 1)) continue;
      push_fields(L, "body", bodies[b].name, "point", i / D + 1, "component", model::component_name(i % D));
      lua_rawseti(L, -2, unknown + 1);
    }
  const auto add = [&](int obstacle, int dof, const std::string& component) {
    const int unknown = numbers.unknown(dof);
    if (unknown < 0) return;
    push_fields(L, "support", model::support_of(model.system.scene, obstacle, component), "component", component);
    lua_rawseti(L, -2, unknown + 1);
  };
  for (int k = 0; k < std::ssize(model.system.scene.obstacles); ++k)
    for (int c = 0; c < D; ++c) add(k, numbers.obstacle_offset(k) + c, model::component_name(c));
  for (const model::FreeAngle<D>& angle : numbers.free_angles()) add(angle.obstacle, angle.dof, "angle");
  return 1;
}

template <int D> void move(model::Model<D>& model, const VectorX& change, lua_State* L) {
  const int count = model.system.unknowns.size();
  if (change.size() != count)
    reject(L, 2, {"du"}, text("a list of ", count, " numbers, as many as model:residual() has"));
  model::move_by(model, change);
}

template <int D> VectorX displacements(const model::Model<D>& model) {
  const auto& numbers = model.system.unknowns;
  VectorX values(numbers.size());
  for (int dof = numbers.dofs() - 1; dof >= 0; --dof)
    if (const int unknown = numbers.unknown(dof); unknown >= 0) values(unknown) = model.present.displacement(dof);
  return values;
}

/// Names of the bodies, and of the supports of obstacles.
template <int D> std::vector<std::string> unconstrained_bodies(model::Model<D>& model) {
  std::vector<std::string> names;
  for (const model::UnconstrainedMotion& unconstrained : model.system.unconstrained()) {
    const std::string& name = model.system.scene.bodies[unconstrained.body].name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  for (const model::UnconstrainedObstacle& motion : model.system.unconstrained_obstacles()) {
    const std::string& name = model::support_of(model.system.scene, model.system.unknowns, motion);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

void push_spots(lua_State* L, const char* key, const std::vector<model::FailurePlace>& spots) {
  push_list(L, spots, [&](const model::FailurePlace& spot) {
    push_fields(L, "kind", spot.kind, spot.kind == "contact point" ? "contact" : "body", spot.where,
                spot.kind == "control point" ? "point" : "element", spot.index + 1, "X", spot.reference, "x",
                spot.current, "value", spot.value, "text", worded(spot.what));
  });
  lua_setfield(L, -2, key);
}

template <int D> int diagnose(model::Model<D>& model, const std::vector<std::string>& on, lua_State* L) {
  require(model.step.has_value(), "no step to diagnose: call diagnose after a solve_step, iterate or solve_arc that "
                                  "failed, before model:rollback()");
  const model::Diagnosis diagnosis = model::diagnose(model, model.step->report, {on.begin(), on.end()});
  const std::string reason = diagnosis.friction_exhausted ? "friction_exhausted" : solve::name_of(diagnosis.outcome);
  push_fields(L, "reason", reason, "message", worded_in_one(diagnosis.messages), "cure",
              worded_in_one(diagnosis.remedies));
  push_spots(L, "places", diagnosis.places);
  push_spots(L, "unbalanced", diagnosis.unbalanced);
  return 1;
}

/// model:set_time(time or "relaxed")
template <int D> int set_time(model::Model<D>& model, lua_State* L) {
  const bool relaxed = lua_type(L, 2) == LUA_TSTRING;
  model::set_time(model, relaxed ? std::numeric_limits<double>::infinity() : to<double>(L, 2));
  return 0;
}

template <int D>
constexpr Function model_path_entries[] = {
    {"driven", call<driven<D>>},
    {"set_target", call<set_target<D>>},
    {"target", call<target<D>>},
    {"solve_step", call<solve_step<D>>},
    {"iterate", call<iterate<D>>},
    {"solve_arc", call<solve_arc<D>>},
    {"set_penalty_factor", call<model::set_penalty_factor<D>>},
    {"penalty_factor", call<[](const model::Model<D>& model) { return model.present.penalty_factor; }>},
    {"set_time", call<set_time<D>>},
    {"time", call<[](const model::Model<D>& model) { return model.present.time; }>},
    {"last_length", call<model::last_length<D>>},
    {"accept", call<model::accept<D>>},
    {"rollback", call<model::rollback<D>>},
    {"snapshot", call<snapshot<D>>},
    {"restore", call<restore<D>>},
    {"save", call<[](model::Model<D>& model, const std::string& file) { model::save(model, file); }>},
    {"residual", call<residual<D>>},
    {"tangent", call<tangent<D>>},
    {"unknowns", call<unknowns<D>>},
    {"move", call<move<D>>},
    {"displacements", call<displacements<D>>},
    {"unconstrained_bodies", call<unconstrained_bodies<D>>},
    {"diagnose", call<diagnose<D>>},
};

template <int D>
constexpr Function model_path_core[] = {
    {"follow_run", call<follow_run<D>>},
    {"neighbor_difference", call<neighbor_difference<D>>},
};

} // namespace

void open_path(lua_State* L) {
  register_functions<Model<2>, Model<3>>(L, "core", model_path_core<2>, model_path_core<3>);
  register_type<Model<2>, Model<3>>(L, model_path_entries<2>, model_path_entries<3>);
}

} // namespace signorini::bind
