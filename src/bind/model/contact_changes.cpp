// Constants of contacts that a load path changes.

#include "bind/lua/open.hpp"
#include "bind/lua/wording/wording.hpp"
#include "bind/model/model.hpp"
#include "model/checks/scene_warnings.hpp"
#include "model/scene/changed_contact.hpp"

namespace signorini::bind {

namespace {

/// The constants of a contact that an argument changes.
template <int D> contact::Changes changes_of(const contact::History<D>& history, const Arguments& a) {
  contact::Changes changes = history.changes;
  const auto read = [](const Arguments& from, const char* key, auto& value) {
    using Value = typename std::decay_t<decltype(value)>::value_type;
    if (from.has(key)) value = from.get<Value>(key);
  };
  read(a, "active", changes.active);
  read(a, "offset", changes.offset);
  read(a, "penalty", changes.normal);
  if (a.has("friction")) {
    const Arguments friction = a.table("friction");
    read(friction, "mu", changes.friction);
    read(friction, "penalty", changes.tangential);
  }
  changes.overlap = a.get("overlap", changes.overlap);
  return changes;
}

/// Both half passes have the same constants.
template <int D> void set_contact(model::Model<D>& model, const std::string& name, const Arguments& a) {
  const int contact = find(model.system.scene.contacts, name, "contact");
  const contact::Changes changes = changes_of(model.present.contacts[contact], a);
  const int other = model.system.scene.contacts[contact].other_pass;
  model::set_contact(model, contact, changes);
  if (other >= 0) model::set_contact(model, other, changes);
}

template <int D> constexpr Function contact_entries[] = {{"set_contact", call<set_contact<D>>}};

/// core.contact_problem(model, contact, values): why the contact cannot have these constants; nil if it can.
template <int D>
std::optional<std::string> contact_problem(const model::Model<D>& model, const std::string& name, const Arguments& a) {
  const int contact = find(model.system.scene.contacts, name, "contact");
  try {
    model::check_changes(model.system.scene.contacts[contact], changes_of(model.present.contacts[contact], a));
  } catch (const Error& error) {
    return worded(error);
  }
  return std::nullopt;
}

/// core.contact_warnings(model, contact, mu, offset): sentences on a coefficient of friction that looks like an angle,
/// and on an offset that is large against the bodies.
template <int D>
std::vector<std::string> contact_warnings(const model::Model<D>& model, const std::string& name, double mu,
                                          double offset) {
  const model::Scene<D>& scene = model.system.scene;
  return worded(model::constant_warnings(scene, scene.contacts[find(scene.contacts, name, "contact")], mu, offset));
}

template <int D>
constexpr Function contact_core_entries[] = {{"contact_problem", call<contact_problem<D>>},
                                             {"contact_warnings", call<contact_warnings<D>>}};

} // namespace

void open_changes(lua_State* L) {
  register_functions<Model<2>, Model<3>>(L, "core", contact_core_entries<2>, contact_core_entries<3>);
  register_type<Model<2>, Model<3>>(L, contact_entries<2>, contact_entries<3>);
}

} // namespace signorini::bind
