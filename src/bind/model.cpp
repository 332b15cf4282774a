#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"
#include "bind/scene.hpp"
#include "model/sample.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

template <int D> int contact_of_argument(lua_State* L) {
  return find_contact(L, self<Model<D>>(L), read_string(L, 2, {"name", "a contact"}));
}

template <class Items> int find(lua_State* L, const Items& items, const std::string& name, const char* kind) {
  std::vector<std::string> names;
  for (const auto& item : items) {
    if (item.name == name) return static_cast<int>(names.size());
    names.push_back(item.name);
  }
  throw ArgumentError(text(function_name(L), ": the model has no ", kind, " '", name, "'", did_you_mean(name, names),
                           names.empty() ? "" : "; it has " + one_of(names)));
}

// ── The path's verbs ─────────────────────────────────────────────────────────────────────────────────────────────────

template <class Items> int push_names(lua_State* L, const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.name);
  push(L, names);
  return 1;
}

template <int D> int body_names(lua_State* L) {
  return push_names(L, self<Model<D>>(L)->scene().bodies);
}

template <int D> int support_names(lua_State* L) {
  return push_names(L, self<Model<D>>(L)->scene().supports);
}

template <int D> int contact_names(lua_State* L) {
  return push_names(L, self<Model<D>>(L)->scene().contacts);
}

template <int D> int body_of(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const int index = find_body(L, model, read_string(L, 2, {"name", "a body"}));
  push_object<Body<D>>(L, model->scene().bodies[static_cast<std::size_t>(index)].body);
  return 1;
}

template <int D> int load_names(lua_State* L) {
  return push_names(L, self<Model<D>>(L)->scene().loads);
}

template <int D> int driven_names(lua_State* L) {
  return push_names(L, self<Model<D>>(L)->drives().all());
}

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

// ── What the present state looks like ────────────────────────────────────────────────────────────────────────────────

/// Of a support or a load.
template <int D> int reaction(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const std::string name = read_string(L, 2, {"name", "a support or a load"});
  const auto& loads = model->scene().loads;
  for (std::size_t i = 0; i < loads.size(); ++i)
    if (loads[i].name == name) {
      push(L, VectorX(model->load_resultant(static_cast<int>(i))));
      return 1;
    }
  const int support = find_support(L, model, name);
  VectorX force = model->reaction(support);
  if (model->scene().supports[static_cast<std::size_t>(support)].rotates) {
    force.conservativeResize(3);
    force(2) = model->moment(support);
  }
  push(L, force);
  return 1;
}

template <int D> int contact_resultant(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const auto sum = model->contact_resultant(contact_of_argument<D>(L));
  lua_createtable(L, 0, 7);
  set_field(L, "fx", sum.force(0));
  set_field(L, "fy", sum.force(1));
  set_field(L, "area", sum.area);
  set_field(L, "max_pressure", sum.max_pressure);
  set_field(L, "max_penetration", sum.max_penetration);
  set_field(L, "active", sum.active);
  set_field(L, "slipping", sum.slipping);
  return 1;
}

template <int D> int profile(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const model::Profile profile = model::profile(*model, contact_of_argument<D>(L));
  lua_createtable(L, 0, 9);
  set_field(L, "x", profile.x);
  set_field(L, "y", profile.y);
  set_field(L, "X", profile.reference_x);
  set_field(L, "Y", profile.reference_y);
  set_field(L, "area", profile.area);
  set_field(L, "pressure", profile.pressure);
  set_field(L, "traction", profile.traction);
  set_field(L, "gap", profile.gap);
  set_field(L, "state", profile.state);
  return 1;
}

template <int D> int sample(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  int body = -1;
  if (const Body<D>* object = test_object<Body<D>>(L, 2)) {
    const auto& bodies = model->scene().bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (&bodies[b].body->space() == &(*object)->space()) body = static_cast<int>(b); // the same when revolved
    if (body < 0) throw ArgumentError(text(function_name(L), ": this body is not part of the model"));
  } else {
    body = find_body(L, model, read_string(L, 2, {"body", "a body or its name"}));
  }
  const auto& field = model::find_field<D>(read_string(L, 3, {"field", "such as \"uy\" or \"von_mises\""}));
  push(L, model::sample(*model, body, field, read_point(L, 4, {"xi", "parametric coordinates"}, 2, 2)));
  return 1;
}

template <int D> int energy(lua_State* L) {
  lua_createtable(L, 0, 1);
  set_field(L, "stored", self<Model<D>>(L)->stored_energy());
  return 1;
}

template <int D> int timings(lua_State* L) {
  const model::Timings& timings = self<Model<D>>(L)->timings();
  lua_createtable(L, 0, 3);
  set_field(L, "bulk", timings.bulk);
  set_field(L, "contact", timings.contact);
  set_field(L, "linear", timings.linear);
  return 1;
}

template <int D> int solver(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  lua_createtable(L, 0, 3);
  set_field(L, "linear", solve::name_of(model->linear_kind()));
  set_field(L, "unknowns", model->unknowns().size());
  set_field(L, "patterns", model->patterns());
  return 1;
}

template <int D> int tostring(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const auto& scene = model->scene();
  std::string names;
  for (const auto& body : scene.bodies) names += (names.empty() ? "" : ", ") + body.name;
  const bool revolved = scene.kind == solid::Kind::axisymmetric;
  push(L, text(revolved ? "axisymmetric" : "plane-strain", " model of ", names, ": ", model->unknowns().dofs(),
               " degrees of freedom, ", model->unknowns().size(), " of them free, ", scene.supports.size(),
               " supports, ", scene.contacts.size(), scene.contacts.size() == 1 ? " contact" : " contacts"));
  return 1;
}

template <int D> int snapshot_tostring(lua_State* L) {
  push(L, text("snapshot of a model with ", self<Snapshot<D>>(L).model->unknowns().dofs(), " degrees of freedom"));
  return 1;
}

template <int D>
constexpr Function rows[] = {
    {"__tostring", wrap<tostring<D>>, "tostring(m)\nThe model's parts and size in words."},
    {"body_names", wrap<body_names<D>>, "m:body_names()\nThe names of the bodies, sorted."},
    {"support_names", wrap<support_names<D>>, "m:support_names()\nThe names of the supports, sorted."},
    {"contact_names", wrap<contact_names<D>>, "m:contact_names()\nThe names of the contacts, sorted."},
    {"body", wrap<body_of<D>>, "m:body(name)\nA body of the model."},
    {"load_names", wrap<load_names<D>>, "m:load_names()\nThe names of the loads, sorted."},
    {"driven_names", wrap<driven_names<D>>,
     "m:driven_names()\nThe names of what stages can move: supports that drive or rotate, then loads."},
    {"driven", wrap<driven<D>>,
     "m:driven(name)\nThe components that stages move, in order: {\"x\", \"y\"} of a driven support or a traction,\n"
     "{\"angle\"} of a support that rotates (after its driven components), {\"pressure\"}."},
    {"set_target", wrap<set_target<D>>,
     "m:set_target(name, {ux, uy})\nWhat the components of a support or load shall be at the end of the next step: "
     "lengths,\n"
     "degrees, force per area."},
    {"target", wrap<target<D>>,
     "m:target(name)\nWhat the components of a support or load are in the last accepted state."},
    {"solve_step", wrap<solve_step<D>>,
     "m:solve_step{ tolerance = 1e-10, iterations = 25, linear = \"auto\" }\n"
     "Newton's method from the accepted state to the targets; accepts nothing. Returns { converged, reason, "
     "iterations,\n"
     "message, residuals, energies }; reason is \"converged\", \"iterations\", \"diverged\", \"inverted\", "
     "\"singular\", "
     "\"nan\" or\n"
     "\"interrupted\". linear: \"auto\", \"klu\", \"umfpack\", \"cholmod\" (symmetric tangents only), or "
     "\"condensed\" (linear\n"
     "elastic bodies: all but the contact unknowns are eliminated once; what \"auto\" takes there)."},
    {"solve_arc", wrap<solve_arc<D>>,
     "m:solve_arc{ length, tolerance = 1e-10, iterations = 25, linear = \"auto\" }\n"
     "Goes a given distance (2-norm of the control points' displacements) from the accepted state along the path that\n"
     "leads to the targets; how far along it is an unknown, so that turning points can be passed. Accepts nothing; "
     "the\n"
     "targets become those reached. Returns what solve_step returns and fraction: 0 at the accepted state, 1 at the "
     "targets."},
    {"last_length", wrap<last_length<D>>,
     "m:last_length()\n2-norm of the last accepted step's displacements: the scale for arc lengths."},
    {"accept", wrap<accept<D>>, "m:accept()\nMakes the present state the accepted one; slip points advance."},
    {"rollback", wrap<rollback<D>>, "m:rollback()\nReturns to the accepted state."},
    {"snapshot", wrap<snapshot<D>>,
     "m:snapshot()\nA copy of the accepted state with its contact history, for m:restore. Call it between steps."},
    {"restore", wrap<restore<D>>, "m:restore(snapshot)\nReturns to a state that m:snapshot() has kept."},
    {"reaction", wrap<reaction<D>>,
     "m:reaction(name)\nThe force {fx, fy} that a support exerts on its bodies, and with it the moment about the "
     "centre "
     "of a\n"
     "support that rotates; the force of a load."},
    {"contact_resultant", wrap<contact_resultant<D>>,
     "m:contact_resultant(contact)\n"
     "{ fx, fy, area, max_pressure, max_penetration, active, slipping }: the force that the master exerts on the "
     "slave,\n"
     "the current area in contact, extremes, and how many contact points touch and slip."},
    {"profile", wrap<profile<D>>,
     "m:profile(contact)\n"
     "Lists along the slave face, one entry per contact point: x, y (current), X, Y (reference), area (that the "
     "traction\n"
     "acts on), pressure, traction (tangential), gap, state (\"open\", \"stick\", \"slip\", \"adhesion\")."},
    {"sample", wrap<sample<D>>,
     "m:sample(body, field, {xi1, xi2})\nA field's value at a parametric point of a body (or its name); fields as in "
     "sg.picture."},
    {"energy", wrap<energy<D>>, "m:energy()\n{ stored }: the energy stored in the bodies, per unit depth."},
    {"timings", wrap<timings<D>>,
     "m:timings()\nSeconds so far: { bulk, contact, linear }; linear is factorisation and solve."},
    {"solver", wrap<solver<D>>,
     "m:solver()\n{ linear, unknowns, patterns }: the linear solver in use, the size of its "
     "systems, how many sparse patterns were analysed."},
};

template <int D>
constexpr Function snapshot_rows[] = {
    {"__tostring", wrap<snapshot_tostring<D>>, "tostring(s)\nWhat it is."},
};

} // namespace

template <int D> int find_body(lua_State* L, const Model<D>& model, const std::string& name) {
  return find(L, model->scene().bodies, name, "body");
}

template <int D> int find_support(lua_State* L, const Model<D>& model, const std::string& name) {
  return find(L, model->scene().supports, name, "support");
}

template <int D> int find_contact(lua_State* L, const Model<D>& model, const std::string& name) {
  return find(L, model->scene().contacts, name, "contact");
}

void open_model(lua_State* L) {
  register_type<Model<2>>(L, rows<2>);
  register_type<Snapshot<2>>(L, snapshot_rows<2>);
}

} // namespace signorini::bind
