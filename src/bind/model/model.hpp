#pragma once
// Lookup of the parts of a model by name.

#include "bind/lua/functions.hpp"
#include "bind/scene/scene.hpp"

namespace signorini::bind {

/// The names of bodies, supports or contacts, in order.
template <class Items> std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names(items.size());
  std::transform(items.begin(), items.end(), names.begin(), [](const auto& item) { return item.name; });
  return names;
}

/// Index in a list of named items. Throws an error that lists the names; `kind`: of the items.
template <class Items> int find(const Items& items, const std::string& name, const char* kind) {
  const std::vector<std::string> names = names_of(items);
  if (const auto found = std::ranges::find(names, name); found != names.end())
    return static_cast<int>(found - names.begin());
  const std::string hint = did_you_mean(name, names);
  fail("the model has no ", kind, " '", name, "'", hint,
       names.empty() ? "" : (hint.empty() ? "; it has " : " It has ") + one_of(names));
}

/// Index of a body of a model by name.
template <int D> int find_body(const model::Model<D>& model, const std::string& name) {
  return find(model.system.scene.bodies, name, "body");
}

/// Indices of the bodies with a name: one body, or the parts "name.1", "name.2", … of a body of several patches.
template <int D> std::vector<int> find_bodies(const model::Model<D>& model, const std::string& name) {
  const auto& bodies = model.system.scene.bodies;
  std::vector<int> parts;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].name == name) return {static_cast<int>(b)};
    if (bodies[b].name.starts_with(name + ".")) parts.push_back(static_cast<int>(b));
  }
  if (parts.empty()) parts.push_back(find_body(model, name)); // which throws
  return parts;
}

} // namespace signorini::bind
