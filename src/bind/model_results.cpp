#include "bind/model.hpp"
#include "model/contact_pressure.hpp"
#include "model/profile.hpp"
#include "model/sample.hpp"

namespace signorini::bind {

namespace {

/// Sets the components of a force by name.
template <int D> void set_force(lua_State* L, const Vec<D>& force) {
  for (int k = 0; k < D; ++k) set_field(L, text("f", model::component_name(k)).c_str(), force(k));
}

/// Of a support or a load.
template <int D> int reaction(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const auto name = to<std::string>(L, 2);
  const std::vector<std::string> loads = names_of(model->system.scene.loads);
  const auto load = static_cast<int>(std::find(loads.begin(), loads.end(), name) - loads.begin());
  const bool loaded = load < static_cast<int>(loads.size());
  const int support = loaded ? -1 : find_support(L, model, name);
  const Vec<D> force = loaded ? model::load_resultant(*model, load) : model::reaction(*model, support);
  push(L, VectorX(force));
  set_force<D>(L, force);
  if (!loaded && model->system.scene.supports[static_cast<std::size_t>(support)].rotates) {
    const double moment = model::moment(*model, support);
    push(L, moment);
    lua_rawseti(L, -2, D + 1);
    set_field(L, "moment", moment);
  }
  return 1;
}

template <int D> int contact_resultant(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const auto contact = static_cast<std::size_t>(find_contact(L, model, to<std::string>(L, 2)));
  const auto sum = contact::resultant(model->present.contacts[contact]);
  push_fields(L, "area", sum.area, "max_pressure", sum.max_pressure, "max_penetration", sum.max_penetration, "active",
              sum.active, "slipping", sum.slipping);
  set_force<D>(L, sum.force);
  const auto set_tally = [&](const char* name, const char* place, const auto& tally) {
    set_field(L, name, static_cast<int>(tally.count));
    if (tally.count > 0) set_field(L, place, VectorX(tally.latest));
  };
  set_tally("unsettled", "unsettled_at", model->system.contacts[contact]->unsettled());
  set_tally("crossed", "crossed_at", model->system.contacts[contact]->crossed());
  return 1;
}

template <int D> int profile(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const model::Profile all = model::profile<D>(*model, find_contact(L, model, to<std::string>(L, 2)));
  push_fields(L, "x", all.x, "y", all.y, "X", all.reference_x, "Y", all.reference_y, "area", all.area, "pressure",
              all.pressure, "traction", all.traction, "gap", all.gap, "state", all.state);
  if (D == 3)
    set_fields(L, "z", all.z, "Z", all.reference_z, "tx", all.traction_x, "ty", all.traction_y, "tz", all.traction_z);
  return 1;
}

/// Index of the body at stack index 2, which is a name or a body; in an axisymmetric model the body that it was made
/// of.
template <int D> int body_of_argument(lua_State* L, const Model<D>& model) {
  if (lua_isstring(L, 2)) return find_body(L, model, to<std::string>(L, 2));
  const Body<D>& wanted = read_object<Body<D>>(L, 2, {"body", "a body or its name"});
  const auto& bodies = model->system.scene.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (&bodies[b].body->space() == &wanted->space()) return static_cast<int>(b);
  throw ArgumentError(text(function_name(L), ": this body is not part of the model"));
}

template <int D> int sample(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const int body = body_of_argument<D>(L, model);
  const auto name = to<std::string>(L, 3);
  const auto point = to<VectorX>(L, 4);
  if (point.size() != D)
    reject(L, 4, {"xi", "parametric coordinates"},
           D == 2 ? "a list of 2 numbers {xi1, xi2}" : "a list of 3 numbers {xi1, xi2, xi3}");
  if (name == "contact_pressure")
    push(L, model::sample_contact_pressure(*model, body, point));
  else
    push(L, model::sample(*model, body, model::find_field<D>(name), point));
  return 1;
}

template <int D> int energy(const model::Model<D>& model, lua_State* L) {
  const model::Energies now = model::energies(model);
  push_fields(L, "stored", now.stored, "contact", now.contact, "friction", now.friction, "work", now.work);
  return 1;
}

template <int D>
constexpr Function model_results_entries[] = {
    {"reaction", reaction<D>},        {"contact_resultant", contact_resultant<D>},
    {"profile", profile<D>},          {"sample", sample<D>},
    {"energy", method<D, energy<D>>},
};

} // namespace

template <int D> std::span<const Function> result_rows() {
  return model_results_entries<D>;
}

template std::span<const Function> result_rows<2>();
template std::span<const Function> result_rows<3>();

} // namespace signorini::bind
