#include "bind/model/iteration_report.hpp"

namespace signorini::bind {

/// What an iteration changes.
struct IterationMarks {
  std::size_t residuals = 0, parts = 0;
  int iterations = 0, factorizations = 0, gmres = 0;
  std::vector<contact::ContactState> states; ///< of all contact points or multipliers
};

namespace {

template <int D> IterationMarks marks_of(const model::Model<D>& model) {
  IterationMarks marks;
  const solve::SolverStatistics linear = model.linear.statistics();
  marks.factorizations = linear.factorizations;
  marks.gmres = linear.iterations;
  for (const auto& history : model.present.contacts)
    for (int i = 0; i < constraints(history); ++i) marks.states.push_back(constraint(history, i).state);
  if (!model.step) return marks;
  const solve::NewtonReport& report = model.step->report;
  marks.residuals = report.residuals.size();
  marks.parts = report.parts.size();
  marks.iterations = report.iterations;
  return marks;
}

template <int D>
void push_iteration(lua_State* L, const model::Model<D>& model, double goal, const IterationMarks& now,
                    const IterationMarks& before) {
  const model::Step& step = *model.step;
  const solve::NewtonReport& report = step.report;
  int active = 0, slipping = 0, changed = 0;
  for (const contact::ContactState state : now.states) {
    active += state != contact::ContactState::open;
    slipping += state == contact::ContactState::slip;
  }
  for (std::size_t i = 0; i < now.states.size(); ++i) changed += now.states[i] != before.states[i];
  const bool solved = now.iterations > before.iterations, evaluated = now.residuals > before.residuals;
  push_fields(L, "first", before.residuals == 0 && before.iterations == 0, "iteration", now.iterations - solved,
              "contact", !now.states.empty(), "active", active, "slipping", slipping, "changed", changed, "reason",
              solve::name_of(report.outcome), "goal", goal, "tolerance", report.tolerance);
  if (evaluated) set_field(L, "residual", report.residuals.back());
  if (solved) set_fields(L, "energy", report.energies.back(), "linear", solve::name_of(model.linear.kind()));
  if (solved && now.factorizations > before.factorizations) set_field(L, "factored", true);
  if (solved && now.gmres > before.gmres) set_field(L, "gmres", now.gmres - before.gmres);
  if (now.parts > before.parts) set_field(L, "part", report.parts.back());
  if (solved && step.pseudo_damping() > 0) set_field(L, "damping", step.pseudo_damping());
}

/// Calls the function below its one argument; its error, which may be any value, is thrown as a C++ exception, which
/// the step in progress passes on.
void call_protected(lua_State* L, int results) {
  if (lua_pcall(L, 1, results, 0) == LUA_OK) return;
  push_error_text(L, -1);
  fail(to<std::string>(L, -1));
}

} // namespace

template <int D> model::AfterIteration iteration_printer(lua_State* L, const model::Model<D>& model, double goal) {
  return [L, &model, goal, before = marks_of(model)]() mutable {
    const IterationMarks now = marks_of(model);
    if (now.residuals < before.residuals || now.iterations < before.iterations) { // a new step has begun
      before.residuals = before.parts = 0;
      before.iterations = 0;
    }
    push_require(L);
    push(L, "signorini.run.verbose");
    call_protected(L, 1);
    lua_getfield(L, -1, "iteration");
    push_iteration(L, model, goal, now, before);
    call_protected(L, 0);
    lua_pop(L, 1);
    before = now;
  };
}

template model::AfterIteration iteration_printer(lua_State*, const model::Model<2>&, double);
template model::AfterIteration iteration_printer(lua_State*, const model::Model<3>&, double);

} // namespace signorini::bind
