#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"
#include "bind/scene.hpp"
#include "model/sample.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

using model::Hold;

int support_of_argument(lua_State* L) {
  return find_support(L, self<Model>(L), read_string(L, 2, {"name", "a support"}));
}

int contact_of_argument(lua_State* L) {
  return find_contact(L, self<Model>(L), read_string(L, 2, {"name", "a contact"}));
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

// ── sg.model ─────────────────────────────────────────────────────────────────────────────────────────────────────────

std::vector<model::NamedBody<2>> read_bodies(lua_State* L, const Options& o) {
  std::vector<model::NamedBody<2>> bodies;
  o.each("bodies", "the bodies by name", [&](const std::string& name, int index, const Argument& entry) {
    const Body& body = read_object<Body>(L, index, entry);
    for (const auto& other : bodies)
      if (other.body == body)
        throw ArgumentError(text(function_name(L), ": bodies.", name, " is the same body as bodies.", other.name,
                                 ": make one with sg.body for each"));
    bodies.push_back({name, body});
  });
  return bodies;
}

int index_of(lua_State* L, const model::Scene<2>& scene, const Place& place, const std::string& where) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (scene.bodies[b].body == place.body) return static_cast<int>(b);
  throw ArgumentError(text(function_name(L), ": ", where, " is on a body that is not in bodies: add it there"));
}

model::FaceReference read_face(lua_State* L, const model::Scene<2>& scene, const Options& o, const char* key,
                               const char* meaning) {
  const Place& place = o.object<Place>(key, meaning);
  const Argument argument = o.argument(key, meaning);
  if (!place.side) reject(L, o.push_value(key), argument, "a face", "a corner has no surface to touch");
  return {index_of(L, scene, place, argument.name), *place.side};
}

void read_components(lua_State* L, const Options& o, const char* key, const char* meaning, Hold hold,
                     model::Support<2>& support) {
  if (!o.has(key)) return;
  for (char letter : o.choice(key, meaning, {"x", "y", "xy"})) {
    Hold& component = support.hold[letter == 'x' ? 0 : 1];
    if (component != Hold::free)
      throw ArgumentError(text(function_name(L), ": ", o.path(), " both fixes and drives ", letter,
                               ": a component is either fixed or driven, take it out of one of the two"));
    component = hold;
  }
}

model::Support<2> read_support(lua_State* L, const model::Scene<2>& scene, const std::string& name, int index,
                               const Argument& entry) {
  const Options o(L, index, {"on", "fix", "drive"}, false, entry.name);
  model::Support<2> support;
  support.name = name;
  const Argument on = o.argument("on", "a face, a list of faces, or a corner");
  const auto add = [&](int at) {
    const Place& place = read_object<Place>(L, at, on);
    support.on.push_back({index_of(L, scene, place, on.name), place.functions});
  };
  const int value = o.push_value("on");
  if (lua_istable(L, value)) {
    const int count = read_list(L, value, on);
    if (count == 0) reject(L, value, on, "a face, a list of faces, or a corner");
    for (int i = 1; i <= count; ++i) {
      lua_rawgeti(L, value, i);
      add(-1);
      lua_pop(L, 1);
    }
  } else {
    add(value);
  }
  read_components(L, o, "fix", "components that stay", Hold::fixed, support);
  read_components(L, o, "drive", "components that stages move", Hold::driven, support);
  if (support.hold == std::array<Hold, 2>{})
    throw ArgumentError(text(function_name(L), ": ", entry.name, " holds nothing: add fix = \"xy\" or drive = \"xy\""));
  return support;
}

/// Gauss points per slave element: 3(p+1), p the full degree along the slave face (thesis 7.1.1).
int default_points(const model::Scene<2>& scene, const model::FaceReference& slave) {
  const auto& space = scene.bodies[static_cast<std::size_t>(slave.body)].body->space();
  return 3 * (space.face_patch(slave.side).direction(0).degree() + 1);
}

model::Contact read_contact(lua_State* L, const model::Scene<2>& scene, const std::string& name, int index,
                            const Argument& entry) {
  const Options o(L, index, {"slave", "master", "penalty", "friction", "points"}, false, entry.name);
  model::Contact contact;
  contact.name = name;
  contact.slave = read_face(L, scene, o, "slave", "the face that is integrated over");
  contact.master = read_face(L, scene, o, "master", "the face that is projected onto");
  if (contact.slave == contact.master)
    throw ArgumentError(text(function_name(L), ": ", entry.name, ".master is the same face as ", entry.name,
                             ".slave; a face cannot touch itself: name a face of the other body"));
  contact.law.normal = o.positive("penalty", "normal penalty, pressure per length");
  if (o.has("friction")) {
    const Options friction = o.table("friction", {"mu", "penalty"});
    contact.law.friction = friction.non_negative("mu", "Coulomb's coefficient of friction");
    contact.law.tangential = friction.positive("penalty", "tangential penalty, pressure per length");
  }
  contact.points = o.integer("points", "Gauss points per slave element", 1, 100, default_points(scene, contact.slave));
  return contact;
}

/// Names become columns ("grip.fx") and stage keys, so no two things share one and none is a key of a stage.
void check_name(lua_State* L, const model::Scene<2>& scene, const std::string& name, const Argument& entry) {
  const auto clash = [&](const auto& items) {
    return std::any_of(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  };
  if (clash(scene.supports))
    throw ArgumentError(text(function_name(L), ": ", entry.name, " has the name of a support: columns such as '", name,
                             ".fx' would mean both; choose another name"));
  if (name == "name" || name == "steps")
    throw ArgumentError(text(function_name(L), ": ", entry.name, " cannot be called '", name,
                             "', which is a key of stages: choose another name"));
}

int make_model(lua_State* L) {
  const Options o(L, 1, {"bodies", "supports", "contacts"});
  model::Scene<2> scene;
  scene.bodies = read_bodies(L, o);
  if (o.has("supports"))
    o.each("supports", "the supports by name", [&](const std::string& name, int index, const Argument& entry) {
      check_name(L, scene, name, entry);
      scene.supports.push_back(read_support(L, scene, name, index, entry));
    });
  if (o.has("contacts"))
    o.each("contacts", "the contacts by name", [&](const std::string& name, int index, const Argument& entry) {
      check_name(L, scene, name, entry);
      scene.contacts.push_back(read_contact(L, scene, name, index, entry));
    });
  push_object<Model>(L, std::make_shared<model::Model<2>>(std::move(scene)));
  return 1;
}

// ── The path's verbs ─────────────────────────────────────────────────────────────────────────────────────────────────

template <class Items> int push_names(lua_State* L, const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.name);
  push(L, names);
  return 1;
}

int body_names(lua_State* L) {
  return push_names(L, self<Model>(L)->scene().bodies);
}

int support_names(lua_State* L) {
  return push_names(L, self<Model>(L)->scene().supports);
}

int contact_names(lua_State* L) {
  return push_names(L, self<Model>(L)->scene().contacts);
}

int body_of(lua_State* L) {
  const Model& model = self<Model>(L);
  const int index = find_body(L, model, read_string(L, 2, {"name", "a body"}));
  push_object<Body>(L, model->scene().bodies[static_cast<std::size_t>(index)].body);
  return 1;
}

std::vector<int> driven_components(const Model& model, int support) {
  std::vector<int> components;
  const auto& hold = model->scene().supports[static_cast<std::size_t>(support)].hold;
  for (int c = 0; c < 2; ++c)
    if (hold[static_cast<std::size_t>(c)] == Hold::driven) components.push_back(c);
  return components;
}

int driven(lua_State* L) {
  std::vector<std::string> names;
  for (int c : driven_components(self<Model>(L), support_of_argument(L))) names.push_back(model::component_name(c));
  push(L, names);
  return 1;
}

int set_target(lua_State* L) {
  const Model& model = self<Model>(L);
  const int support = support_of_argument(L);
  const std::vector<int> components = driven_components(model, support);
  const Argument argument{"displacement", "one number per driven component"};
  const std::vector<double> values = read_numbers(L, 3, argument);
  if (values.size() != components.size())
    reject(L, 3, argument, text("a list of ", components.size(), components.size() == 1 ? " number" : " numbers"));
  for (std::size_t i = 0; i < values.size(); ++i) model->set_target(support, components[i], values[i]);
  return 0;
}

int target(lua_State* L) {
  const Model& model = self<Model>(L);
  const int support = support_of_argument(L);
  std::vector<double> values;
  for (int c : driven_components(model, support)) values.push_back(model->accepted_target(support, c));
  push(L, values);
  return 1;
}

int solve_step(lua_State* L) {
  const Model& model = self<Model>(L);
  model::StepOptions options;
  if (!lua_isnoneornil(L, 2)) {
    const Options o(L, 2, {"tolerance", "iterations", "linear"});
    options.newton.tolerance =
        o.positive("tolerance", "relative residual that counts as zero", options.newton.tolerance);
    options.newton.iterations =
        o.integer("iterations", "most iterations in one step", 1, 1'000'000, options.newton.iterations);
    options.linear = solve::linear_kind(o.choice("linear", "linear solver", {"auto", "klu", "umfpack"}, "auto"));
  }
  const solve::NewtonReport report = model->solve_step(options);
  lua_createtable(L, 0, 6);
  set_field(L, "converged", report.outcome == solve::Outcome::converged);
  set_field(L, "reason", solve::name_of(report.outcome));
  set_field(L, "iterations", report.iterations);
  set_field(L, "message", report.message);
  set_field(L, "residuals", report.residuals);
  set_field(L, "energies", report.energies);
  return 1;
}

int accept(lua_State* L) {
  self<Model>(L)->accept();
  return 0;
}

int rollback(lua_State* L) {
  self<Model>(L)->rollback();
  return 0;
}

// ── What the present state looks like ────────────────────────────────────────────────────────────────────────────────

int reaction(lua_State* L) {
  const Model& model = self<Model>(L);
  push(L, VectorX(model->reaction(support_of_argument(L))));
  return 1;
}

int contact_resultant(lua_State* L) {
  const Model& model = self<Model>(L);
  const auto sum = model->contact_resultant(contact_of_argument(L));
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

int profile(lua_State* L) {
  const Model& model = self<Model>(L);
  const model::Profile profile = model::profile(*model, contact_of_argument(L));
  lua_createtable(L, 0, 6);
  set_field(L, "x", profile.x);
  set_field(L, "y", profile.y);
  set_field(L, "pressure", profile.pressure);
  set_field(L, "traction", profile.traction);
  set_field(L, "gap", profile.gap);
  set_field(L, "state", profile.state);
  return 1;
}

int sample(lua_State* L) {
  const Model& model = self<Model>(L);
  int body = -1;
  if (const Body* object = test_object<Body>(L, 2)) {
    const auto& bodies = model->scene().bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (bodies[b].body == *object) body = static_cast<int>(b);
    if (body < 0) throw ArgumentError(text(function_name(L), ": this body is not part of the model"));
  } else {
    body = find_body(L, model, read_string(L, 2, {"body", "a body or its name"}));
  }
  const auto& field = model::find_field<2>(read_string(L, 3, {"field", "such as \"uy\" or \"von_mises\""}));
  push(L, model::sample(*model, body, field, read_point(L, 4, {"xi", "parametric coordinates"}, 2, 2)));
  return 1;
}

int energy(lua_State* L) {
  lua_createtable(L, 0, 1);
  set_field(L, "stored", self<Model>(L)->stored_energy());
  return 1;
}

int timings(lua_State* L) {
  const model::Timings& timings = self<Model>(L)->timings();
  lua_createtable(L, 0, 3);
  set_field(L, "bulk", timings.bulk);
  set_field(L, "contact", timings.contact);
  set_field(L, "linear", timings.linear);
  return 1;
}

int solver(lua_State* L) {
  const Model& model = self<Model>(L);
  lua_createtable(L, 0, 3);
  set_field(L, "linear", solve::name_of(model->linear_kind()));
  set_field(L, "unknowns", model->unknowns().size());
  set_field(L, "patterns", model->patterns());
  return 1;
}

int tostring(lua_State* L) {
  const Model& model = self<Model>(L);
  const auto& scene = model->scene();
  std::string names;
  for (const auto& body : scene.bodies) names += (names.empty() ? "" : ", ") + body.name;
  push(L, text("plane-strain model of ", names, ": ", model->unknowns().dofs(), " degrees of freedom, ",
               model->unknowns().size(), " of them free, ", scene.supports.size(), " supports, ", scene.contacts.size(),
               scene.contacts.size() == 1 ? " contact" : " contacts"));
  return 1;
}

constexpr Function functions[] = {
    {"model", wrap<make_model>,
     "sg.model{ bodies, supports, contacts }\n"
     "A scene, plane strain, unit depth. All three are tables by name:\n"
     "  bodies   = { die = die, slab = slab }\n"
     "  supports = { bed = { on = slab:face \"south\", fix = \"xy\" },\n"
     "               grip = { on = {die:face \"west\", die:face \"east\"}, drive = \"xy\" } }\n"
     "  contacts = { interface = { slave = die:face \"south\", master = slab:face \"north\", penalty = 100,\n"
     "                             friction = { mu = 0.2, penalty = 100 }, points = 3(p+1) } }\n"
     "on: a face, a list of faces (their reactions add up), or a corner. fix, drive: \"x\", \"y\" or \"xy\"; stages "
     "move\n"
     "what is driven. slave: the face that is integrated over with `points` Gauss points per element; master: the "
     "face\n"
     "that it is projected onto. penalty: pressure per length. An open end of the master is no contact."},
};

constexpr Function rows[] = {
    {"__tostring", wrap<tostring>, "tostring(m)\nThe model's parts and size in words."},
    {"body_names", wrap<body_names>, "m:body_names()\nThe names of the bodies, sorted."},
    {"support_names", wrap<support_names>, "m:support_names()\nThe names of the supports, sorted."},
    {"contact_names", wrap<contact_names>, "m:contact_names()\nThe names of the contacts, sorted."},
    {"body", wrap<body_of>, "m:body(name)\nA body of the model."},
    {"driven", wrap<driven>, "m:driven(support)\nThe components that a support drives: {\"x\", \"y\"}."},
    {"set_target", wrap<set_target>,
     "m:set_target(support, {ux, uy})\nDisplacement of a driven support at the end of the next step, one per driven "
     "component."},
    {"target", wrap<target>, "m:target(support)\nDisplacement of a driven support in the last accepted state."},
    {"solve_step", wrap<solve_step>,
     "m:solve_step{ tolerance = 1e-10, iterations = 25, linear = \"auto\" }\n"
     "Newton's method from the accepted state to the targets; accepts nothing. Returns { converged, reason, "
     "iterations,\n"
     "message, residuals, energies }; reason is \"converged\", \"iterations\", \"diverged\", \"inverted\", "
     "\"singular\", "
     "\"nan\" or\n"
     "\"interrupted\". linear: \"auto\", \"klu\" or \"umfpack\"."},
    {"accept", wrap<accept>, "m:accept()\nMakes the present state the accepted one; slip points advance."},
    {"rollback", wrap<rollback>, "m:rollback()\nReturns to the accepted state."},
    {"reaction", wrap<reaction>, "m:reaction(support)\nThe force {fx, fy} that a support exerts on its bodies."},
    {"contact_resultant", wrap<contact_resultant>,
     "m:contact_resultant(contact)\n"
     "{ fx, fy, area, max_pressure, max_penetration, active, slipping }: the force that the master exerts on the "
     "slave,\n"
     "the current area in contact, extremes, and how many contact points touch and slip."},
    {"profile", wrap<profile>,
     "m:profile(contact)\n"
     "Lists along the slave face, one entry per contact point: x, y (current), pressure, traction (tangential), gap,\n"
     "state (\"open\", \"stick\", \"slip\")."},
    {"sample", wrap<sample>,
     "m:sample(body, field, {xi1, xi2})\nA field's value at a parametric point of a body (or its name); fields as in "
     "sg.picture."},
    {"energy", wrap<energy>, "m:energy()\n{ stored }: the energy stored in the bodies, per unit depth."},
    {"timings", wrap<timings>,
     "m:timings()\nSeconds so far: { bulk, contact, linear }; linear is factorisation and solve."},
    {"solver", wrap<solver>,
     "m:solver()\n{ linear, unknowns, patterns }: the linear solver in use, the size of its "
     "systems, how many sparse patterns were analysed."},
};

} // namespace

int find_body(lua_State* L, const Model& model, const std::string& name) {
  return find(L, model->scene().bodies, name, "body");
}

int find_support(lua_State* L, const Model& model, const std::string& name) {
  return find(L, model->scene().supports, name, "support");
}

int find_contact(lua_State* L, const Model& model, const std::string& name) {
  return find(L, model->scene().contacts, name, "contact");
}

void open_model(lua_State* L) {
  register_functions(L, "sg", functions);
  register_type<Model>(L, rows);
}

} // namespace signorini::bind
