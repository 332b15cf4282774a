// Constants of contacts that a load path changes.

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
template <int D> void set_contact(model::Model<D>& model, const std::string& name, lua_State* L) {
  const int contact = find(model.system.scene.contacts, name, "contact");
  const contact::Changes changes = changes_of(model.present.contacts[contact], Arguments(L, 3, ""));
  const int other = model.system.scene.contacts[contact].other_pass;
  model::set_contact(model, contact, changes);
  if (other >= 0) model::set_contact(model, other, changes);
}

template <int D> constexpr Function contact_entries[] = {{"set_contact", call<set_contact<D>>}};

template <int D> void check(const model::Model<D>& model, const std::string& name, lua_State* L) {
  const int contact = find(model.system.scene.contacts, name, "contact");
  model::check_changes(model.system.scene.contacts[contact],
                       changes_of(model.present.contacts[contact], Arguments(L, 3, "")));
}

template <int D>
std::vector<Message> warnings_of(const model::Model<D>& model, const std::string& name, double mu, double offset) {
  const model::Scene<D>& scene = model.system.scene;
  return model::constant_warnings(scene, scene.contacts[find(scene.contacts, name, "contact")], mu, offset);
}

} // namespace

template <int D> std::span<const Function> contact_rows() {
  return contact_entries<D>;
}

template std::span<const Function> contact_rows<2>();
template std::span<const Function> contact_rows<3>();

int contact_problem(lua_State* L) {
  const auto name = to<std::string>(L, 2);
  try {
    if (const auto* solid = test_object<Model<3>>(L, 1))
      check(**solid, name, L);
    else
      check(*read_object<Model<2>>(L, 1), name, L);
  } catch (const Error& error) {
    push(L, worded(error));
    return 1;
  }
  return 0;
}

int contact_warnings(lua_State* L) {
  const auto name = to<std::string>(L, 2);
  const double mu = to<double>(L, 3), offset = to<double>(L, 4);
  const auto* solid = test_object<Model<3>>(L, 1);
  const std::vector<Message> warnings =
      solid ? warnings_of(**solid, name, mu, offset) : warnings_of(*read_object<Model<2>>(L, 1), name, mu, offset);
  push_list(L, warnings, [&](const Message& warning) { push(L, worded(warning)); });
  return 1;
}

} // namespace signorini::bind
