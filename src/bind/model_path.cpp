#include "bind/checkpoint.hpp"
#include "bind/model.hpp"
#include "model/arc.hpp"
#include "model/load_step.hpp"

namespace signorini::bind {

namespace {

/// The support or load that is called `name`; one that nothing drives has no components.
template <int D> model::Drive drive_of_argument(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const std::string name = read_string(L, 2, {"name", "a support or a load"});
  for (const model::Drive& drive : model->system.drives.all())
    if (drive.name == name) return drive;
  return {name, find_support(L, model, name), -1, 0, {}};
}

/// Index into Drives::all() of a drive with components.
template <int D> int index_of(const Model<D>& model, const model::Drive& drive) {
  const auto& all = model->system.drives.all();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].name == drive.name) return static_cast<int>(i);
  return -1;
}

template <int D> int driven(lua_State* L) {
  push(L, drive_of_argument<D>(L).components);
  return 1;
}

template <int D> int set_target(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const model::Drive drive = drive_of_argument<D>(L);
  if (drive.components.empty())
    throw ArgumentError(
        text(function_name(L), ": name '", drive.name,
             "': this support drives nothing: give it drive = ", "\"x\", \"xy\" or the like in sg.model"));
  const Argument argument{"target", "one number per driven component"};
  const std::vector<double> values = read_numbers(L, 3, argument);
  const std::size_t count = drive.components.size();
  if (values.size() != count) reject(L, 3, argument, text("a list of ", count, count == 1 ? " number" : " numbers"));
  for (std::size_t i = 0; i < count; ++i)
    model::set_target(*model, index_of(model, drive), static_cast<int>(i), values[i]);
  return 0;
}

template <int D> int target(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const model::Drive drive = drive_of_argument<D>(L);
  std::vector<double> values;
  for (std::size_t i = 0; i < drive.components.size(); ++i)
    values.push_back(model::accepted_target(*model, index_of(model, drive), static_cast<int>(i)));
  push(L, values);
  return 1;
}

/// What solve_step and iterate take.
const std::vector<std::string> step_keys = {"tolerance", "iterations",        "line_search",        "linear",
                                            "predictor", "freeze_active_set", "active_set_changes", "augmented",
                                            "damping",   "pseudo_transient"};

void read_newton(const Options& o, model::StepOptions& options) {
  options.newton.tolerance = o.positive("tolerance", "relative residual that counts as zero", options.newton.tolerance);
  options.newton.iterations =
      o.integer("iterations", "most iterations in one step", 1, 1'000'000, options.newton.iterations);
  options.linear = solve::linear_kind(o.string("linear", "linear solver", "auto"));
}

model::Predictor read_predictor(const Options& o) {
  const std::string name = o.choice("predictor", "first guess of a step", {"tangent", "constant", "linear"}, "tangent");
  return name == "tangent"    ? model::Predictor::tangent
         : name == "constant" ? model::Predictor::constant
                              : model::Predictor::linear;
}

model::StepOptions read_step_options(lua_State* L) {
  model::StepOptions options;
  if (lua_isnoneornil(L, 2)) return options;
  const Options o(L, 2, step_keys);
  read_newton(o, options);
  options.newton.line_search = solve::line_search_kind(
      o.choice("line_search", "how Newton's moves are shortened", {"none", "residual", "energy"}, "none"));
  options.predictor = read_predictor(o);
  options.active_set.freeze =
      o.non_negative("freeze_active_set", "part of its first value below which |f·Δu| frees the active set", 0.0);
  options.active_set.changes = o.integer(
      "active_set_changes", "most changes of a contact point's state in a step; 0: no limit", 0, 1'000'000, 0);
  if (o.has("augmented")) {
    const Options augmented = o.table("augmented", {"penetration", "loops"});
    options.augmented.penetration =
        augmented.positive("penetration", "largest penetration, as a part of the largest body's size", 1e-6);
    options.augmented.loops = augmented.integer("loops", "most augmentations in a step", 1, 1'000'000, 100);
  }
  options.damping = o.flag("damping", "whether to damp bodies that only contact holds", false);
  options.pseudo_transient = o.flag("pseudo_transient", "whether bodies move as in a viscous medium", false);
  if (options.pseudo_transient && options.newton.line_search != solve::LineSearchKind::none)
    throw ArgumentError(
        text(function_name(L), ": pseudo_transient finds the length of its moves by itself: take ", "line_search out"));
  return options;
}

int push_report(lua_State* L, const solve::NewtonReport& report) {
  lua_createtable(L, 0, 8);
  set_field(L, "converged", report.outcome == solve::Outcome::converged);
  set_field(L, "reason", solve::name_of(report.outcome));
  set_field(L, "iterations", report.iterations);
  set_field(L, "message", report.message);
  set_field(L, "residuals", report.residuals);
  set_field(L, "energies", report.energies);
  set_field(L, "parts", report.parts);
  return 1;
}

template <int D> int solve_step(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  return push_report(L, model::solve_step(*model, read_step_options(L)));
}

template <int D> int iterate(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  return push_report(L, model::iterate(*model, read_step_options(L)));
}

template <int D> int solve_arc(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  model::StepOptions options;
  const Options o(L, 2, {"length", "tolerance", "iterations", "linear"});
  const double length =
      o.positive("length", "distance from the accepted state, root mean square of the displacement over all bodies");
  read_newton(o, options);
  push_report(L, model::solve_arc(*model, options, length));
  set_field(L, "fraction", model->step->fraction);
  return 1;
}

template <int D> int set_penalty_factor(lua_State* L) {
  model::set_penalty_factor(*self<Model<D>>(L), read_number(L, 2, {"factor", "of all penalty parameters"}));
  return 0;
}

template <int D> int penalty_factor(lua_State* L) {
  push(L, self<Model<D>>(L)->present.penalty_factor);
  return 1;
}

template <int D> int last_length(lua_State* L) {
  push(L, model::last_length(*self<Model<D>>(L)));
  return 1;
}

template <int D> int accept(lua_State* L) {
  model::accept(*self<Model<D>>(L));
  return 0;
}

template <int D> int rollback(lua_State* L) {
  model::rollback(*self<Model<D>>(L));
  return 0;
}

template <int D> int snapshot(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  push_object(L, Snapshot<D>{model, model::snapshot(*model)});
  return 1;
}

template <int D> int restore(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const Argument argument{"snapshot", "made by model:snapshot()"};
  const Snapshot<D>& snapshot = read_object<Snapshot<D>>(L, 2, argument);
  if (snapshot.model != model) reject(L, 2, argument, "a snapshot of this model", "it was taken of another model");
  model::restore(*model, snapshot.state);
  return 0;
}

template <int D> int snapshot_tostring(lua_State* L) {
  push(L, text("snapshot of a model with ", self<Snapshot<D>>(L).model->system.unknowns.dofs(), " degrees of freedom"));
  return 1;
}

template <int D>
constexpr Function model_path_entries[] = {
    {"driven", driven<D>,
     "m:driven(name)\n"
     "The components that stages move, in order: {\"x\", \"y\"} (in 3D also \"z\") of a driven support or a\n"
     "traction,\n"
     "{\"angle\"} of a support that rotates (after its driven components), {\"pressure\"}.\n"
     "Example: model:driven \"grip\"  --> {\"x\", \"y\"}"},
    {"set_target", set_target<D>,
     "m:set_target(name, {ux, uy, …})\n"
     "What the components of a support or load shall be at the end of the next step: lengths,\n"
     "degrees, force per area.\n"
     "Example: model:set_target(\"grip\", {0, -0.11})"},
    {"target", target<D>,
     "m:target(name)\nWhat the components of a support or load are in the last accepted state.\n"
     "Example: model:target \"grip\""},
    {"solve_step", solve_step<D>,
     "m:solve_step{ tolerance = 1e-10, iterations = 25, line_search = \"none\", linear = \"auto\", predictor = "
     "\"tangent\",\n"
     "  freeze_active_set = 0, active_set_changes = 0, augmented = { penetration = 1e-6, loops = 100 }, damping = "
     "false,\n"
     "  pseudo_transient = false }\n"
     "Newton's method from the present state, after m:accept and m:rollback the accepted one, to the targets; accepts\n"
     "nothing. Returns { converged, reason,\n"
     "iterations, message, residuals, energies, parts }; reason is \"converged\", \"iterations\", \"diverged\",\n"
     "\"cycling\", \"lost_projection\", \"inverted\", \"singular\", \"nan\", \"line_search\", \"penetration\" or\n"
     "\"interrupted\". linear: \"auto\"; \"klu\", \"umfpack\";\n"
     "\"kept\" (a factorisation serves several systems as preconditioner, where one is dear); \"condensed\" (linear\n"
     "elastic bodies: all but the contact unknowns are eliminated once). line_search: \"residual\" (non-monotone),\n"
     "\"energy\"; predictor: \"constant\", \"linear\" (goes on as the last step did). freeze_active_set: states of\n"
     "contact points stay as they were until |f·Δu| has fallen to this part of its first value (thesis 4.5.2);\n"
     "active_set_changes: a point that changes its state more often is held, one that slips as sticking, until the\n"
     "others have converged (0: never).\n"
     "augmented: pressures are augmented until no point that presses is farther from the master, on either side, than\n"
     "this part of the largest body's size.\n"
     "damping: keeps bodies that only contact holds from flying off; the state that it leads to is in equilibrium.\n"
     "pseudo_transient: bodies move as in a viscous medium until they rest (pseudo-transient continuation), in up to "
     "40\n"
     "times as many iterations, past a loss of stability to the equilibrium behind it; without line_search.\n"
     "Example: model:set_target(\"grip\", {0, -0.11})\n"
     "         if model:solve_step{}.converged then model:accept() else model:rollback() end"},
    {"iterate", iterate<D>,
     "m:iterate{ … }\n"
     "One iteration of m:solve_step, with the same arguments: evaluates, and unless that ends it solves and moves. "
     "The\n"
     "first one after m:accept, m:rollback, m:restore, m:set_target or m:set_penalty_factor begins a step. Returns "
     "what m:solve_step\n"
     "returns, so far; reason is \"iterating\" while it goes on.\n"
     "Example: model:set_target(\"grip\", {0, -0.12})\n"
     "         repeat local now = model:iterate{} until now.reason ~= \"iterating\""},
    {"set_penalty_factor", set_penalty_factor<D>,
     "m:set_penalty_factor(factor)\n"
     "Multiplies the penalty parameters of all contacts, as sg.model got them, from now on: for penalties that grow\n"
     "along the path. m:rollback returns to that of the accepted state.\n"
     "Example: model:set_penalty_factor(0.5)"},
    {"penalty_factor", penalty_factor<D>,
     "m:penalty_factor()\nWhat m:set_penalty_factor was told last; 1.\n"
     "Example: finer:penalty_factor()  --> 1.0"},
    {"solve_arc", solve_arc<D>,
     "m:solve_arc{ length, tolerance = 1e-10, iterations = 25, linear = \"auto\" }\n"
     "Goes a given distance from the accepted state along the path that leads to the targets; how far along it is\n"
     "an unknown, so that turning points can be passed. The distance is the root mean square of the displacement\n"
     "over the volume of all bodies, a length that does not depend on the mesh (a rigid obstacle counts like all\n"
     "bodies together). Accepts nothing; the targets become those reached. Returns what solve_step returns and\n"
     "fraction: 0 at the accepted state, 1 at the targets.\n"
     "Example: model:set_target(\"grip\", {0, -0.13})\n"
     "         local result = model:solve_arc{ length = 0.01 }\n"
     "         if result.converged then model:accept() else model:rollback() end"},
    {"last_length", last_length<D>,
     "m:last_length()\n"
     "Root mean square over all bodies of the last accepted step's displacement, the scale for arc lengths.\n"
     "Example: model:last_length()"},
    {"accept", accept<D>,
     "m:accept()\n"
     "Makes the present state the accepted one; slip points advance. An error when the step under way has not\n"
     "converged, or new targets wait for one.\n"
     "Example: model:rollback()\n"
     "         model:set_target(\"grip\", {0, -0.1})\n"
     "         if model:solve_step{}.converged then model:accept() end"},
    {"rollback", rollback<D>,
     "m:rollback()\nReturns to the accepted state: displacements, targets, penalties, contact. Call it after a step "
     "that failed.\n"
     "Example: model:rollback()"},
    {"snapshot", snapshot<D>,
     "m:snapshot()\nA copy of the accepted state with its contact history, for m:restore. Call it between steps.\n"
     "Example: before = model:snapshot()"},
    {"restore", restore<D>,
     "m:restore(snapshot)\nReturns to a state that m:snapshot() has kept.\n"
     "Example: model:restore(model:snapshot())"},
    {"save", save<D>,
     "m:save(path)\n"
     "Writes the model with its accepted state to a file for sg.load, whole or not at all. From here on the model and\n"
     "one that is loaded give the same bits; for that the model forgets factorisations and patterns, so that the next\n"
     "step takes a little longer. An error while a step, targets or\n"
     "penalties are not accepted.\n"
     "Example: model:save \"pressed.sgn\""},
};

template <int D>
constexpr Function snapshot_rows[] = {
    {"__tostring", snapshot_tostring<D>, "snapshot\nWhat m:snapshot returns, a state that m:restore returns to."},
};

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
