#include "bind/model.hpp"

namespace signorini::bind {

namespace {

/// The support or load that is called `name`; one that nothing drives has no components.
template <int D> model::Drive drive_of_argument(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const std::string name = read_string(L, 2, {"name", "a support or a load"});
  for (const model::Drive& drive : model->drives().all())
    if (drive.name == name) return drive;
  return {name, find_support(L, model, name), -1, 0, {}};
}

/// Index into Drives::all() of a drive with components.
template <int D> int index_of(const Model<D>& model, const model::Drive& drive) {
  const auto& all = model->drives().all();
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
  const Argument argument{"target", "one number per driven component"};
  const std::vector<double> values = read_numbers(L, 3, argument);
  const std::size_t count = drive.components.size();
  if (values.size() != count) reject(L, 3, argument, text("a list of ", count, count == 1 ? " number" : " numbers"));
  for (std::size_t i = 0; i < count; ++i) model->set_target(index_of(model, drive), static_cast<int>(i), values[i]);
  return 0;
}

template <int D> int target(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const model::Drive drive = drive_of_argument<D>(L);
  std::vector<double> values;
  for (std::size_t i = 0; i < drive.components.size(); ++i)
    values.push_back(model->accepted_target(index_of(model, drive), static_cast<int>(i)));
  push(L, values);
  return 1;
}

void read_newton(const Options& o, model::StepOptions& options) {
  options.newton.tolerance = o.positive("tolerance", "relative residual that counts as zero", options.newton.tolerance);
  options.newton.iterations =
      o.integer("iterations", "most iterations in one step", 1, 1'000'000, options.newton.iterations);
  options.linear = solve::linear_kind(o.string("linear", "linear solver", "auto"));
}

int push_report(lua_State* L, const solve::NewtonReport& report) {
  lua_createtable(L, 0, 7);
  set_field(L, "converged", report.outcome == solve::Outcome::converged);
  set_field(L, "reason", solve::name_of(report.outcome));
  set_field(L, "iterations", report.iterations);
  set_field(L, "message", report.message);
  set_field(L, "residuals", report.residuals);
  set_field(L, "energies", report.energies);
  return 1;
}

template <int D> int solve_step(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  model::StepOptions options;
  if (!lua_isnoneornil(L, 2)) read_newton(Options(L, 2, {"tolerance", "iterations", "linear"}), options);
  return push_report(L, model->solve_step(options));
}

template <int D> int solve_arc(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  model::StepOptions options;
  const Options o(L, 2, {"length", "tolerance", "iterations", "linear"});
  const double length = o.positive("length", "distance from the accepted state, 2-norm over all control points");
  read_newton(o, options);
  push_report(L, model->solve_arc(options, length));
  set_field(L, "fraction", model->arc_fraction());
  return 1;
}

template <int D> int last_length(lua_State* L) {
  push(L, self<Model<D>>(L)->last_length());
  return 1;
}

template <int D> int accept(lua_State* L) {
  self<Model<D>>(L)->accept();
  return 0;
}

template <int D> int rollback(lua_State* L) {
  self<Model<D>>(L)->rollback();
  return 0;
}

template <int D> int snapshot(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  push_object(L, Snapshot<D>{model, model->snapshot()});
  return 1;
}

template <int D> int restore(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const Argument argument{"snapshot", "made by model:snapshot()"};
  const Snapshot<D>& snapshot = read_object<Snapshot<D>>(L, 2, argument);
  if (snapshot.model != model) reject(L, 2, argument, "a snapshot of this model", "it was taken of another model");
  model->restore(snapshot.state);
  return 0;
}

template <int D> int snapshot_tostring(lua_State* L) {
  push(L, text("snapshot of a model with ", self<Snapshot<D>>(L).model->unknowns().dofs(), " degrees of freedom"));
  return 1;
}

template <int D>
constexpr Function rows[] = {
    {"driven", wrap<driven<D>>,
     "m:driven(name)\n"
     "The components that stages move, in order: {\"x\", \"y\"} (in 3D also \"z\") of a driven support or a\n"
     "traction, \n"
     "{\"angle\"} of a support that rotates (after its driven components), {\"pressure\"}."},
    {"set_target", wrap<set_target<D>>,
     "m:set_target(name, {ux, uy, …})\n"
     "What the components of a support or load shall be at the end of the next step: lengths,\n"
     "degrees, force per area."},
    {"target", wrap<target<D>>,
     "m:target(name)\nWhat the components of a support or load are in the last accepted state."},
    {"solve_step", wrap<solve_step<D>>,
     "m:solve_step{ tolerance = 1e-10, iterations = 25, linear = \"auto\" }\n"
     "Newton's method from the accepted state to the targets; accepts nothing. Returns { converged, reason,\n"
     "iterations, message, residuals, energies }; reason is \"converged\", \"iterations\", \"diverged\",\n"
     "\"inverted\", \"singular\", \"nan\" or \"interrupted\". linear: \"auto\"; \"klu\", \"umfpack\"; \"cholmod\",\n"
     "\"banded\" (symmetric tangents only); \"kept\" (a factorisation serves several systems as preconditioner,\n"
     "where one is dear); \"condensed\" (linear elastic bodies: all but the contact unknowns are eliminated once)."},
    {"solve_arc", wrap<solve_arc<D>>,
     "m:solve_arc{ length, tolerance = 1e-10, iterations = 25, linear = \"auto\" }\n"
     "Goes a given distance (2-norm of the control points' displacements) from the accepted state along the path\n"
     "that leads to the targets; how far along it is an unknown, so that turning points can be passed. Accepts\n"
     "nothing; the targets become those reached. Returns what solve_step returns and fraction: 0 at the accepted\n"
     "state, 1 at the targets."},
    {"last_length", wrap<last_length<D>>,
     "m:last_length()\n2-norm of the last accepted step's displacements: the scale for arc lengths."},
    {"accept", wrap<accept<D>>, "m:accept()\nMakes the present state the accepted one; slip points advance."},
    {"rollback", wrap<rollback<D>>, "m:rollback()\nReturns to the accepted state."},
    {"snapshot", wrap<snapshot<D>>,
     "m:snapshot()\nA copy of the accepted state with its contact history, for m:restore. Call it between steps."},
    {"restore", wrap<restore<D>>, "m:restore(snapshot)\nReturns to a state that m:snapshot() has kept."},
};

template <int D>
constexpr Function snapshot_rows[] = {
    {"__tostring", wrap<snapshot_tostring<D>>, "tostring(s)\nWhat it is."},
};

} // namespace

template <int D> std::span<const Function> path_rows() {
  return rows<D>;
}

void open_snapshots(lua_State* L) {
  register_type<Snapshot<2>, Snapshot<3>>(L, snapshot_rows<2>, snapshot_rows<3>);
}

template std::span<const Function> path_rows<2>();
template std::span<const Function> path_rows<3>();

} // namespace signorini::bind
