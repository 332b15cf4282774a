#pragma once
// The methods of a model by subject, and how they find its parts by name.

#include "bind/functions.hpp"
#include "bind/scene.hpp"

namespace signorini::bind {

/// What takes a model along its path: targets, steps, accepting and rolling back, snapshots.
template <int D> std::span<const Function> path_rows();
/// What Newton's method works with: residual, tangent, unknowns, diagnosis.
template <int D> std::span<const Function> system_rows();
/// What a model's present state looks like: forces, profiles, samples, energies.
template <int D> std::span<const Function> result_rows();
/// What a model costs, and what could be saved.
template <int D> std::span<const Function> cost_rows();

/// A method as Lua calls it, made of a function of a model, or of a model and Lua's stack with the other arguments: it
/// pushes what that returns, if anything; an int is the number of values that stand on the stack already.
template <int D, auto function> int method(lua_State* L) {
  model::Model<D>& model = *self<Model<D>>(L);
  if constexpr (requires { function(model, L); }) {
    if constexpr (std::is_same_v<decltype(function(model, L)), int>) return function(model, L);
    function(model, L);
    return 0;
  } else if constexpr (std::is_void_v<decltype(function(model))>) {
    function(model);
    return 0;
  } else {
    push(L, function(model));
    return 1;
  }
}

/// Makes the type of snapshots.
void open_snapshots(lua_State* L);

/// The names of bodies, supports or contacts, in order.
template <class Items> std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names(items.size());
  std::transform(items.begin(), items.end(), names.begin(), [](const auto& item) { return item.name; });
  return names;
}

/// Index into a list of named items. Throws ArgumentError that lists the names; `kind` says what they are.
template <class Items> int find(lua_State* L, const Items& items, const std::string& name, const char* kind) {
  const std::vector<std::string> names = names_of(items);
  if (const auto found = std::find(names.begin(), names.end(), name); found != names.end())
    return static_cast<int>(found - names.begin());
  const std::string hint = did_you_mean(name, names);
  throw ArgumentError(text(function_name(L), ": the model has no ", kind, " '", name, "'", hint,
                           names.empty() ? "" : (hint.empty() ? "; it has " : " It has ") + one_of(names)));
}

/// Index of a model's body, support or contact by name.
template <int D> int find_body(lua_State* L, const Model<D>& model, const std::string& name) {
  return find(L, model->system.scene.bodies, name, "body");
}
template <int D> int find_support(lua_State* L, const Model<D>& model, const std::string& name) {
  return find(L, model->system.scene.supports, name, "support");
}
template <int D> int find_contact(lua_State* L, const Model<D>& model, const std::string& name) {
  return find(L, model->system.scene.contacts, name, "contact");
}

} // namespace signorini::bind
