#include "model/steps/model.hpp"

#include "base/error.hpp"
#include "model/checks/clearance.hpp"
#include "model/checks/idle_actions.hpp"
#include "model/checks/pressure.hpp"
#include "model/checks/scene_warnings.hpp"
#include "model/constants.hpp"
#include "model/scene/changed_contact.hpp"
#include "model/scene/joins.hpp"
#include "model/scene/ties.hpp"
#include "model/steps/equilibrium.hpp"
#include "model/steps/first_guess.hpp"
#include "os/timer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::model {

template <int D>
Model<D>::Model(Scene<D> scene, NotStarted)
    : system(std::move(scene)), accepted(system.start()), present(accepted),
      targets(accepted.targets), path{accepted.displacement, targets, accepted.displacement, targets}, acting(targets),
      dead(system.drives.force(targets)), external(dead), linear(linear_facts(system)),
      projected_volumes(system.scene.bodies.size()) {}

template <int D> Model<D>::Model(Scene<D> scene) : Model(std::move(scene), NotStarted{}) {
  check_pressures(system);
  // Friction at points that close later starts from their foot points in the initial state.
  Message why;
  evaluate(*this, {.tangent = false}, why);
  system.commit(present, accepted);
  accepted = present;
  scene_warnings = check_clearance<D>(system, accepted.contacts);
  for (Message& warning : model::scene_warnings<D>(system.scene, system.contacts, accepted.contacts))
    scene_warnings.push_back(std::move(warning));
  warn_of_joins(system.scene, scene_warnings);
  warn_of_ties(system.scene, system.ties, scene_warnings);
  warn_of_idle_actions(system, scene_warnings);
}

template <int D> void set_target(Model<D>& model, int drive, int component, double value) {
  model.targets(model.system.drives.target(drive, component)) = value;
  model.step.reset();
}

template <int D> double accepted_target(const Model<D>& model, int drive, int component) {
  return model.accepted.targets(model.system.drives.target(drive, component));
}

template <int D> void set_penalty_factor(Model<D>& model, double factor) {
  require(std::isfinite(factor) && factor > 0, "model.penalty.factor", {{"factor", factor}});
  model.present.penalty_factor = factor;
  model.step.reset(); // as for new targets: the present state is not in equilibrium any more
}

template <int D> void set_time(Model<D>& model, double time) {
  require(time >= model.accepted.time, "model.step.time", {{"time", time}, {"accepted", model.accepted.time}});
  const bool relaxed = std::isinf(time);
  if (relaxed) time = model.accepted.time;
  if (time == model.present.time && relaxed == model.present.relaxed) return;
  model.present.time = time;
  model.present.relaxed = relaxed;
  model.step.reset();
}

template <int D> void set_contact(Model<D>& model, int contact, const contact::Changes& changes) {
  check_changes(model.system.scene.contacts[contact], changes);
  if (model.present.contacts[contact].changes == changes) return;
  contact::change(model.present.contacts.own()[contact], changes);
  model.step.reset();
}

template <int D> bool settled(const Model<D>& model) {
  const State<D>&accepted = model.accepted, &present = model.present;
  const auto same_law = [](const auto& a, const auto& b) { return a.changes == b.changes; };
  return !model.step && present.displacement == accepted.displacement && model.targets == accepted.targets &&
         present.penalty_factor == accepted.penalty_factor && present.time == accepted.time && !present.relaxed &&
         std::ranges::equal(present.contacts, accepted.contacts, same_law);
}

/// The accepted force, without what nothing balances at the start of a path, where an offset or overlapping shapes
/// press: that force does no work of supports and loads.
template <int D> VectorX balanced_force(const Model<D>& model) {
  VectorX force = model.accepted.force.head(model.system.unknowns.displacements());
  if (model.path.force_scale > 0) return force;
  for (Eigen::Index dof = 0; dof < force.size(); ++dof)
    if (!model.system.unknowns.constrained(static_cast<int>(dof))) force(dof) = 0;
  return force;
}

/// Marks a step of move_by() as converged if the residual is below the default tolerance, otherwise throws Error.
template <int D> void check_equilibrium(Model<D>& model) {
  Message why;
  const solve::Outcome outcome = evaluate(model, {}, why);
  require(outcome == solve::Outcome::converged, "model.step.no_residual", {{"why", why}});
  const double tolerance = solve::NewtonOptions{}.tolerance * force_norm(model) + rounding_floor(model);
  require(model.unbalanced.norm() <= tolerance, "model.step.unbalanced",
          {{"residual", model.unbalanced.norm()}, {"tolerance", tolerance}});
  model.step->report.outcome = check_crossing(model, why);
}

template <int D> void accept(Model<D>& model) {
  if (!model.step) {
    require(settled(model), "model.accept.unsolved");
    return;
  }
  if (model.step->moved_by_user && model.step->report.outcome == solve::Outcome::iterating) check_equilibrium(model);
  const solve::Outcome outcome = model.step->report.outcome;
  require(outcome != solve::Outcome::iterating, "model.accept.iterating");
  require(outcome == solve::Outcome::converged, "model.accept.failed", {{"reason", solve::name_of(outcome)}});
  take_present(model);
}

template <int D> void take_present(Model<D>& model) {
  ScopedTimer timer(model.timings.contact);
  State<D>&accepted = model.accepted, &present = model.present;
  PathHistory& path = model.path;
  model.system.commit(present, accepted);
  const auto displacements = model.system.unknowns.displacements();
  const VectorX increment = present.displacement - accepted.displacement;
  record_increment(model, increment);
  path.work += 0.5 * (balanced_force(model) + present.force.head(displacements)).dot(increment.head(displacements));
  present.targets = model.targets;
  present.relaxed = false;
  accepted = present;
  path.force_scale = force_norm(model);
  model.definite = model.step->definite;
  model.step.reset();
}

template <int D> void rollback(Model<D>& model) {
  model.step.reset();
  model.definite = false;
  model.inversion.reset();
  model.present = model.accepted;
  model.targets = model.accepted.targets;
  set_loads(model, model.targets);
  // Reactions and contact results are those of the accepted state, bitwise.
  take_residual(model);
  model.system.return_to_accepted(model.accepted);
}

template <int D> Snapshot<D> snapshot(const Model<D>& model) {
  return {model.accepted, model.path, model.linear.beginning()};
}

template <int D> void restore(Model<D>& model, const Snapshot<D>& snapshot) {
  model.accepted = snapshot.state;
  for (auto& history : model.accepted.contacts.own()) look_everywhere(history); // the model may have been settled since
  model.path = snapshot.path;
  model.linear.begin_with(snapshot.linear);
  rollback(model);
}

template <int D> void settle(Model<D>& model) {
  rollback(model);
  model.system.settle(model.accepted);
  model.present = model.accepted;
  model.linear.forget();
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template struct Model<D>;                                                                                            \
  template void set_target(Model<D>&, int, int, double);                                                               \
  template double accepted_target(const Model<D>&, int, int);                                                          \
  template void set_penalty_factor(Model<D>&, double);                                                                 \
  template void set_time(Model<D>&, double);                                                                           \
  template void set_contact(Model<D>&, int, const contact::Changes&);                                                  \
  template bool settled(const Model<D>&);                                                                              \
  template void accept(Model<D>&);                                                                                     \
  template void take_present(Model<D>&);                                                                               \
  template void rollback(Model<D>&);                                                                                   \
  template Snapshot<D> snapshot(const Model<D>&);                                                                      \
  template void restore(Model<D>&, const Snapshot<D>&);                                                                \
  template void settle(Model<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
