// What Newton's method works with, for loops of a user's own: residual, tangent, unknowns, and why a step failed.
#include "bind/model.hpp"
#include "bind/wording/wording.hpp"
#include "model/diagnosis.hpp"
#include "model/load_step.hpp"

#include <numeric>

namespace signorini::bind {

namespace {

/// Evaluates the present state. Throws where there is no residual.
template <int D> void evaluate(model::Model<D>& model) {
  Message why;
  const solve::Outcome outcome = model::evaluate(model, why);
  signorini::require(outcome == solve::Outcome::converged, "model.step.no_residual", {{"why", why}});
}

template <int D> VectorX residual(model::Model<D>& model) {
  evaluate(model);
  return model.unbalanced;
}

template <int D> int tangent(model::Model<D>& model, lua_State* L) {
  evaluate(model);
  const solve::Pattern& pattern = model.system.assembly.pattern();
  std::vector<int> rows, columns;
  for (std::size_t j = 0; j < static_cast<std::size_t>(pattern.size); ++j)
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k) {
      rows.push_back(pattern.rows[static_cast<std::size_t>(k)] + 1);
      columns.push_back(static_cast<int>(j) + 1);
    }
  const auto values = model.system.assembly.values().begin();
  push_fields(L, "size", pattern.size, "rows", rows, "columns", columns, "values",
              std::vector<double>(values, values + pattern.entries()));
  return 1;
}

template <int D> int unknowns(const model::Model<D>& model, lua_State* L) {
  const auto& numbers = model.system.unknowns;
  const auto& bodies = model.system.scene.bodies;
  lua_createtable(L, numbers.size(), 0);
  std::vector<char> seen(static_cast<std::size_t>(numbers.size()), 0);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (int i = 0; i < D * bodies[b].body->functions(); ++i) {
      const int unknown = numbers.unknown(numbers.offset(static_cast<int>(b)) + i);
      if (unknown < 0 || std::exchange(seen[static_cast<std::size_t>(unknown)], 1)) continue;
      push_fields(L, "body", bodies[b].name, "point", i / D + 1, "component", model::component_name(i % D));
      lua_rawseti(L, -2, unknown + 1);
    }
  return 1;
}

template <int D> void move(model::Model<D>& model, lua_State* L) {
  const auto change = to<VectorX>(L, 2);
  const int count = model.system.unknowns.size();
  if (change.size() != count) reject(L, 2, {"du"}, text("a list of ", count, " numbers, as model:residual() is"));
  model::move_by(model, change);
}

template <int D> VectorX displacements(const model::Model<D>& model) {
  const auto& numbers = model.system.unknowns;
  VectorX values(numbers.size());
  for (int dof = numbers.dofs() - 1; dof >= 0; --dof)
    if (const int unknown = numbers.unknown(dof); unknown >= 0) values(unknown) = model.present.displacement(dof);
  return values;
}

template <int D> std::vector<std::string> loose_bodies(model::Model<D>& model) {
  std::vector<std::string> names;
  for (const model::LooseMotion& loose : model.system.loose()) {
    const std::string& name = model.system.scene.bodies[static_cast<std::size_t>(loose.body)].name;
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  return names;
}

void push_spots(lua_State* L, const char* key, const std::vector<model::TroubleSpot>& spots) {
  lua_createtable(L, static_cast<int>(spots.size()), 0);
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const model::TroubleSpot& spot = spots[i];
    push_fields(L, "kind", spot.kind, spot.kind == "contact point" ? "contact" : "body", spot.where,
                spot.kind == "control point" ? "point" : "element", spot.index + 1, "X", spot.reference, "x",
                spot.current, "value", spot.value, "text", worded(spot.what));
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_setfield(L, -2, key);
}

template <int D> int diagnose(model::Model<D>& model, lua_State* L) {
  require(model.step.has_value(), "no step to diagnose: call diagnose after a solve_step, iterate or solve_arc that "
                                  "failed, before model:rollback()");
  const auto on = to<std::vector<std::string>>(L, 2);
  const model::Diagnosis diagnosis = model::diagnose(model, model.step->report, {on.begin(), on.end()});
  push_fields(L, "reason", solve::name_of(diagnosis.outcome), "message", worded_in_one(diagnosis.messages), "cure",
              worded_in_one(diagnosis.cures));
  push_spots(L, "places", diagnosis.places);
  push_spots(L, "unbalanced", diagnosis.unbalanced);
  return 1;
}

template <int D>
constexpr Function model_system_entries[] = {
    {"residual", method<D, residual<D>>},           {"tangent", method<D, tangent<D>>},
    {"unknowns", method<D, unknowns<D>>},           {"move", method<D, move<D>>},
    {"displacements", method<D, displacements<D>>}, {"loose_bodies", method<D, loose_bodies<D>>},
    {"diagnose", method<D, diagnose<D>>},
};

} // namespace

template <int D> std::span<const Function> system_rows() {
  return model_system_entries<D>;
}

template std::span<const Function> system_rows<2>();
template std::span<const Function> system_rows<3>();

} // namespace signorini::bind
