#include "bind/contact_profile.hpp"
#include "bind/model.hpp"
#include "model/contact_pressure.hpp"
#include "model/profile.hpp"
#include "model/sample.hpp"

namespace signorini::bind {

namespace {

template <int D> int contact_of_argument(lua_State* L) {
  return find_contact(L, self<Model<D>>(L), read_string(L, 2, {"name", "a contact"}));
}

/// Pushes a force as a list with its components by name.
template <int D> void push_force(lua_State* L, const Vec<D>& force) {
  push(L, VectorX(force));
  for (int k = 0; k < D; ++k) set_field(L, text("f", model::component_name(k)).c_str(), force(k));
}

/// Of a support or a load.
template <int D> int reaction(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const std::string name = read_string(L, 2, {"name", "a support or a load"});
  const auto& loads = model->system.scene.loads;
  for (std::size_t i = 0; i < loads.size(); ++i)
    if (loads[i].name == name) {
      push_force<D>(L, model::load_resultant(*model, static_cast<int>(i)));
      return 1;
    }
  const int support = find_support(L, model, name);
  push_force<D>(L, model::reaction(*model, support));
  if (model->system.scene.supports[static_cast<std::size_t>(support)].rotates) {
    const double moment = model::moment(*model, support);
    push(L, moment);
    lua_rawseti(L, -2, D + 1);
    set_field(L, "moment", moment);
  }
  return 1;
}

template <int D> int contact_resultant(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const int contact = contact_of_argument<D>(L);
  const auto sum = contact::resultant(model->present.contacts[static_cast<std::size_t>(contact)]);
  const contact::Formulation<D>& formulation = *model->system.contacts[static_cast<std::size_t>(contact)];
  lua_createtable(L, 0, 12);
  for (int k = 0; k < D; ++k) set_field(L, text("f", model::component_name(k)).c_str(), sum.force(k));
  set_field(L, "area", sum.area);
  set_field(L, "max_pressure", sum.max_pressure);
  set_field(L, "max_penetration", sum.max_penetration);
  set_field(L, "active", sum.active);
  set_field(L, "slipping", sum.slipping);
  const auto push_tally = [&](const char* name, const char* place, const auto& tally) {
    set_field(L, name, static_cast<int>(tally.count));
    if (tally.count > 0) set_field(L, place, VectorX(tally.latest));
  };
  push_tally("unsettled", "unsettled_at", formulation.unsettled());
  push_tally("crossed", "crossed_at", formulation.crossed());
  return 1;
}

template <int D> int profile(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const model::Profile profile = model::profile<D>(*model, contact_of_argument<D>(L));
  lua_createtable(L, 0, 14);
  set_field(L, "x", profile.x);
  set_field(L, "y", profile.y);
  set_field(L, "X", profile.reference_x);
  set_field(L, "Y", profile.reference_y);
  set_field(L, "area", profile.area);
  set_field(L, "pressure", profile.pressure);
  set_field(L, "traction", profile.traction);
  set_field(L, "gap", profile.gap);
  set_field(L, "state", profile.state);
  if (D == 3) {
    set_field(L, "z", profile.z);
    set_field(L, "Z", profile.reference_z);
    set_field(L, "tx", profile.traction_x);
    set_field(L, "ty", profile.traction_y);
    set_field(L, "tz", profile.traction_z);
  }
  seal_profile(L);
  return 1;
}

/// Index of the body at stack index 2, which is a name or a body; in an axisymmetric model the body that it was made
/// of.
template <int D> int body_of_argument(lua_State* L, const Model<D>& model) {
  if (!has_type(L, 2, Type<Body<D>>::name))
    return find_body(L, model, read_string(L, 2, {"body", "a body or its name"}));
  const Body<D>& wanted = read_object<Body<D>>(L, 2, {"body", "a body or its name"});
  const auto& bodies = model->system.scene.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (&bodies[b].body->space() == &wanted->space()) return static_cast<int>(b);
  throw ArgumentError(text(function_name(L), ": this body is not part of the model"));
}

template <int D> int sample(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const int body = body_of_argument<D>(L, model);
  const std::string name = read_string(L, 3, {"field", "such as \"uy\" or \"von_mises\""});
  const Argument argument{"xi", "parametric coordinates"};
  const char* expected = D == 2 ? "a list of 2 numbers {xi1, xi2}" : "a list of 3 numbers {xi1, xi2, xi3}";
  if (!lua_istable(L, 4)) reject(L, 4, argument, expected, "put the coordinates into braces");
  if (read_list(L, 4, argument, expected) != D) reject(L, 4, argument, expected);
  const VectorX point = read_point(L, 4, argument, D, D);
  if (name == "contact_pressure")
    push(L, model::sample_contact_pressure(*model, body, point));
  else
    push(L, model::sample(*model, body, model::find_field<D>(name), point));
  return 1;
}

template <int D> int energy(lua_State* L) {
  const model::Energies energies = model::energies(*self<Model<D>>(L));
  lua_createtable(L, 0, 4);
  set_field(L, "stored", energies.stored);
  set_field(L, "contact", energies.contact);
  set_field(L, "friction", energies.friction);
  set_field(L, "work", energies.work);
  return 1;
}

template <int D>
constexpr Function model_results_entries[] = {
    {"reaction", reaction<D>,
     "m:reaction(name)\n"
     "The force {fx, fy} ({fx, fy, fz} in 3D) that a support exerts on its bodies, and with it the moment about the\n"
     "centre (in 3D about the axis) of a support that rotates; the force of a load. Also by name: fx, fy, fz, moment.\n"
     "Example: model:reaction(\"grip\").fy"},
    {"contact_resultant", contact_resultant<D>,
     "m:contact_resultant(contact)\n"
     "{ fx, fy, fz, area, max_pressure, max_penetration, active, slipping, unsettled, crossed }: the force on the "
     "slave (fz\n"
     "in 3D), the current area in contact, extremes, and how many contact points touch and slip.\n"
     "unsettled: how often, in all accepted states so far, the search for a point's closest point or slip point ended\n"
     "at a limit of iterations; then unsettled_at is the reference position of the latest such point. crossed,\n"
     "crossed_at: the same of points that had gone through the master since the state before, unseen by contact.\n"
     "Example: model:contact_resultant(\"interface\").area"},
    {"profile", profile<D>,
     "m:profile(contact)\n"
     "Lists along the slave face, one entry per contact point: x, y (current), X, Y (reference), area (that the\n"
     "traction acts on), pressure, traction (tangential; in the plane positive along the face's xi: on the slave it\n"
     "acts the other way), gap, state (\"open\", \"stick\", \"slip\", \"adhesion\"). Where a point slips |traction| "
     "is\n"
     "mu pressure.\n"
     "In 3D also z, Z, and tx, ty, tz, the components of the tangential traction t_T, whose size is `traction`; on\n"
     "the slave acts -t_T. Another name is an error.\n"
     "Example: model:profile(\"interface\").pressure"},
    {"sample", sample<D>,
     "m:sample(body, field, {xi1, xi2})\n"
     "A field's value at a parametric point ({xi1, xi2, xi3} in 3D) of a body (or its name); fields as in\n"
     "sg.picture. contact_pressure is that between the contact points of a slave face, which xi must lie on.\n"
     "Example: model:sample(\"slab\", \"uy\", {0.5, 1})"},
    {"energy", energy<D>,
     "m:energy()\n"
     "{ stored, contact, friction, work }: the energy in the bodies; in the springs of penalty laws, or of adhesion;\n"
     "dissipated by friction in all accepted steps; done by supports and loads in all accepted steps (trapezoidal\n"
     "rule). Per unit depth in plane strain. work = stored + contact + friction as steps become small, but for what\n"
     "the growth of the slave's area takes: see share/doc/theory.md, What is measured.\n"
     "Example: model:energy().stored"},
};

} // namespace

template <int D> std::span<const Function> result_rows() {
  return model_results_entries<D>;
}

template std::span<const Function> result_rows<2>();
template std::span<const Function> result_rows<3>();

} // namespace signorini::bind
