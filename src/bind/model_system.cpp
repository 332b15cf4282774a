// What Newton's method works with, for loops of a user's own: residual, tangent, unknowns, and why a step failed.
#include "bind/model.hpp"
#include "model/diagnosis.hpp"
#include "model/load_step.hpp"

#include <numeric>

namespace signorini::bind {

namespace {

/// Evaluates the present state. Throws where there is no residual.
template <int D> void evaluate(const Model<D>& model) {
  std::string why;
  const solve::Outcome outcome = model::evaluate(*model, why);
  require(outcome == solve::Outcome::converged, "the present state has no residual: ", why, "; call model:rollback()");
}

template <int D> int residual(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  evaluate(model);
  push(L, model->unbalanced);
  return 1;
}

template <int D> int tangent(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  evaluate(model);
  const solve::Pattern& pattern = model->system.assembly.pattern();
  const auto entries = static_cast<std::size_t>(pattern.entries());
  std::vector<int> rows, columns;
  for (std::size_t j = 0; j < static_cast<std::size_t>(pattern.size); ++j)
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k) {
      rows.push_back(pattern.rows[static_cast<std::size_t>(k)] + 1);
      columns.push_back(static_cast<int>(j) + 1);
    }
  const auto& values = model->system.assembly.values();
  lua_createtable(L, 0, 4);
  set_field(L, "size", pattern.size);
  set_field(L, "rows", rows);
  set_field(L, "columns", columns);
  set_field(L, "values", std::vector<double>(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(entries)));
  return 1;
}

template <int D> int unknowns(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const auto& numbers = model->system.unknowns;
  const auto& bodies = model->system.scene.bodies;
  lua_createtable(L, numbers.size(), 0);
  std::vector<char> seen(static_cast<std::size_t>(numbers.size()), 0);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (int i = 0; i < D * bodies[b].body->functions(); ++i) {
      const int unknown = numbers.unknown(numbers.offset(static_cast<int>(b)) + i);
      if (unknown < 0 || std::exchange(seen[static_cast<std::size_t>(unknown)], 1)) continue;
      lua_createtable(L, 0, 3);
      set_field(L, "body", bodies[b].name);
      set_field(L, "point", i / D + 1);
      set_field(L, "component", model::component_name(i % D));
      lua_rawseti(L, -2, unknown + 1);
    }
  return 1;
}

template <int D> int move(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const Argument argument{"du", "the change of each unknown"};
  const std::vector<double> change = read_numbers(L, 2, argument);
  const int count = model->system.unknowns.size();
  if (static_cast<int>(change.size()) != count)
    reject(L, 2, argument, text("a list of ", count, " numbers, as m:residual() is"));
  model::move_by(*model, Eigen::Map<const VectorX>(change.data(), count));
  return 0;
}

template <int D> int displacements(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  const auto& numbers = model->system.unknowns;
  VectorX values(numbers.size());
  for (int dof = numbers.dofs() - 1; dof >= 0; --dof)
    if (const int unknown = numbers.unknown(dof); unknown >= 0) values(unknown) = model->present.displacement(dof);
  push(L, values);
  return 1;
}

template <int D> int loose_bodies(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  std::vector<std::string> names;
  for (const model::LooseMotion& loose : model->system.loose()) {
    const std::string& name = model->system.scene.bodies[static_cast<std::size_t>(loose.body)].name;
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  push(L, names);
  return 1;
}

void push_spots(lua_State* L, const char* key, const std::vector<model::TroubleSpot>& spots) {
  lua_createtable(L, static_cast<int>(spots.size()), 0);
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const model::TroubleSpot& spot = spots[i];
    lua_createtable(L, 0, 7);
    set_field(L, "kind", spot.kind);
    set_field(L, spot.kind == "contact point" ? "contact" : "body", spot.where);
    set_field(L, spot.kind == "control point" ? "point" : "element", spot.index + 1);
    set_field(L, "X", spot.reference);
    set_field(L, "x", spot.current);
    set_field(L, "value", spot.value);
    set_field(L, "text", spot.text);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  lua_setfield(L, -2, key);
}

template <int D> int diagnose(lua_State* L) {
  const Model<D>& model = self<Model<D>>(L);
  require(model->step.has_value(), "no step to diagnose: call diagnose after a solve_step, iterate or solve_arc that "
                                   "failed, before model:rollback()");
  model::ControlsOn on;
  if (!lua_isnoneornil(L, 2)) {
    const Argument argument{"on", "names of controls that are on already"};
    for (int i = 1, count = read_list(L, 2, argument); i <= count; ++i) {
      lua_rawgeti(L, 2, i);
      on.insert(read_choice(
          L, -1, argument,
          {"step", "line_search", "damping", "active_set_changes", "arc_length", "penalty", "pseudo_transient"}));
      lua_pop(L, 1);
    }
  }
  const model::Diagnosis diagnosis = model::diagnose(*model, model->step->report, on);
  lua_createtable(L, 0, 5);
  set_field(L, "reason", solve::name_of(diagnosis.outcome));
  set_field(L, "message", diagnosis.message);
  set_field(L, "cure", diagnosis.cure);
  push_spots(L, "places", diagnosis.places);
  push_spots(L, "unbalanced", diagnosis.unbalanced);
  return 1;
}

template <int D>
constexpr Function model_system_entries[] = {
    {"residual", residual<D>,
     "m:residual()\n"
     "The unbalanced force f_int + f_c − f_ext at the present displacements and the present targets' loads: one "
     "number\n"
     "for each unknown (see m:unknowns). Prescribed displacements that no iteration has brought in yet do not count.\n"
     "Example: #model:residual()"},
    {"tangent", tangent<D>,
     "m:tangent()\n"
     "The derivative of m:residual by the unknowns as triplets, { size, rows, columns, values }: entry k of the "
     "matrix\n"
     "stands in rows[k], columns[k], counted from 1; column after column, rows rising.\n"
     "Example: model:tangent().size"},
    {"unknowns", unknowns<D>,
     "m:unknowns()\n"
     "What each unknown is: a list of { body, point, component }; of control points that move as one the first.\n"
     "Example: model:unknowns()[1].body  --> \"die\""},
    {"move", move<D>,
     "m:move(du)\n"
     "Adds a Δu of one's own to the unknowns, one number for each in the order of m:residual. The first move after\n"
     "m:set_target also brings the prescribed displacements to their targets: begin a step with a move of zeros.\n"
     "m:accept takes the state if its residual is as small as m:solve_step{} wants it; m:rollback forgets it;\n"
     "m:iterate and m:solve_step go on from it.\n"
     "Example: local zeros = {}\n"
     "         for i = 1, #model:residual() do zeros[i] = 0 end\n"
     "         model:move(zeros)\n"
     "         model:rollback()"},
    {"displacements", displacements<D>,
     "m:displacements()\n"
     "The present displacement of each unknown, in the order of m:unknowns: of control points that move as one that\n"
     "of the first.\n"
     "Example: #model:displacements()"},
    {"loose_bodies", loose_bodies<D>,
     "m:loose_bodies()\n"
     "The names of the bodies that can move as a whole in some way that no support stops: only contact can hold them.\n"
     "Example: model:loose_bodies()"},
    {"diagnose", diagnose<D>,
     "m:diagnose(on)\n"
     "Why the last solve_step, iterate or solve_arc failed; call it before m:rollback. Returns { reason, message, "
     "cure,\n"
     "places, unbalanced }: places is a list of { kind, body or contact, element or point, X, x, value, text }, the "
     "worst\n"
     "first: the element that is inverted, contact points whose states cycle or that leave the master, control points\n"
     "that move most in the direction of a singular or indefinite tangent; unbalanced: where the largest unbalanced\n"
     "forces are. reason: as of m:solve_step, or \"indefinite\". on: a list of controls that the cure need not name, "
     "of\n"
     "\"step\", \"line_search\", \"damping\", \"active_set_changes\", \"arc_length\", \"penalty\",\n"
     "\"pseudo_transient\"."},
};

} // namespace

template <int D> std::span<const Function> system_rows() {
  return model_system_entries<D>;
}

template std::span<const Function> system_rows<2>();
template std::span<const Function> system_rows<3>();

} // namespace signorini::bind
