#include "model/steps/equilibrium.hpp"

#include "base/error.hpp"
#include "model/constants.hpp"
#include "model/system/free_angles.hpp"
#include "os/timer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace signorini::model {

template <int D> solve::Outcome evaluate(Model<D>& model, const VectorX* direction, bool tangent, Message& why) {
  follow_angles(model.system.unknowns, model.present.displacement);
  // The first state of a step away from the accepted one is its guess, except for contacts that damping closes.
  const bool guess = model.step && !model.step->foreseen && model.present.displacement != model.accepted.displacement;
  for (auto& control : model.controls) control.foresees = guess && !control.landing;
  if (guess) model.step->foreseen = true;
  const auto inverted = model.system.assembly.assemble({model.present, model.accepted, model.controls, model.acting},
                                                       direction, tangent, model.timings);
  take_residual(model);
  if (!inverted) return solve::Outcome::converged;
  model.inversion = inverted;
  const auto& [body, inversion] = *inverted;
  why = Message("model.step.inverted", {{"element", inversion.element},
                                        {"body", model.system.scene.bodies[body].name},
                                        {"jacobian", inversion.jacobian},
                                        {"place", inversion.point}});
  return solve::Outcome::inverted_element;
}

template <int D> void set_loads(Model<D>& model, const VectorX& targets) {
  model.acting = targets;
  model.dead = model.system.drives.force(targets);
}

template <int D> void take_residual(Model<D>& model) {
  model.external = model.dead;
  model.system.followers.add_force(model.present.displacement, model.acting, model.external);
  model.residual = model.present.force - model.external;
  add_moments(model.system.unknowns, model.present.displacement, model.residual);
  model.unbalanced = model.system.unknowns.gather(model.residual);
}

namespace {

/// Adds the damping of unconstrained bodies and obstacles to the tangent.
template <int D> void damp(Model<D>& model) {
  System<D>& system = model.system;
  if (!system.has_unconstrained()) return;
  const double small = small_stride * system.extent;
  const VectorX diagonal = system.assembly.tangent().diagonal();
  VectorX shift = damping(system.scene, system.unknowns, system.unconstrained(), diagonal, model.residual,
                          strides(system.scene, system.contacts, model.present, small));
  damp_obstacles(system.scene, system.unknowns, system.unconstrained_obstacles(), diagonal, model.residual,
                 system.contacts, model.present, obstacle_stride * system.extent, shift);
  system.assembly.add_diagonal(shift);
}

/// Whether an unconstrained body or obstacle takes part in a contact.
template <int D> bool has_unconstrained(System<D>& system, const Contact<D>& contact) {
  const auto* obstacle = std::get_if<ObstacleReference>(&contact.master);
  const auto acts = [&](const UnconstrainedMotion& motion) { return acts_on(contact, motion.body); };
  const auto is_master = [&](const UnconstrainedObstacle& motion) { return motion.obstacle == obstacle->obstacle; };
  return std::ranges::any_of(system.unconstrained(), acts) ||
         (obstacle && std::ranges::any_of(system.unconstrained_obstacles(), is_master));
}

} // namespace

template <int D> Tangent tangent_of(const Assembly<D>& assembly) {
  const SparseTangent& tangent = assembly.tangent();
  return {tangent.values,
          tangent.pattern,
          tangent.version,
          assembly.constant().values(),
          assembly.contact().unknowns(),
          assembly.contact().version()};
}

template <int D> bool factor(Model<D>& model, const StepOptions& options) {
  ScopedTimer timer(model.timings.factorization);
  if (options.damping) damp(model);
  const Assembly<D>& assembly = model.system.assembly;
  // The viscosity of pseudo-transient continuation acts on all unknowns; constant factors of the bodies do not have it.
  const bool viscous = !assembly.constant().values().empty() && model.step->pseudo_time.damping() > 0;
  const bool chosen = !viscous || options.linear != solve::LinearKind::condensed;
  return model.linear.factor(tangent_of(assembly),
                             {chosen ? options.linear : solve::LinearKind::automatic,
                              viscous || (options.damping && model.system.has_unconstrained()), options.mumps});
}

template <int D> bool solve_for(Model<D>& model, VectorX& b, bool fully) {
  ScopedTimer timer(model.timings.solution);
  return model.linear.solve(b, fully);
}

template <int D> solve::Outcome check_crossing(Model<D>& model, Message& why) {
  ScopedTimer timer(model.timings.contact);
  const auto& contacts = model.system.contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (!contacts[k]->crossed(model.present.contacts[k], model.accepted.contacts[k]).empty()) {
      why = Message("model.step.crossed", {{"contact", model.system.scene.contacts[k].name}});
      return solve::Outcome::crossed;
    }
  return solve::Outcome::converged;
}

template <int D>
solve::NewtonSystem newton_system(Model<D>& model, std::function<solve::Outcome(bool, Message&)> assemble,
                                  std::function<bool(double&)> advance) {
  solve::NewtonSystem system;
  system.assemble = std::move(assemble);
  system.advance = std::move(advance);
  system.residual = [&] { return model.unbalanced.norm(); };
  system.scale = [&] { return force_norm(model); };
  system.floor = [&] { return rounding_floor(model); };
  system.conclude = [&](Message& why) { return check_crossing(model, why); };
  return system;
}

template <int D> double contact_norm(const Model<D>& model) {
  double sum = 0;
  for (const contact::History<D>& history : model.present.contacts)
    for (const contact::PointResult<D>& point : history.results) sum += point.force.squaredNorm();
  return std::sqrt(sum);
}

template <int D> double force_norm(const Model<D>& model) {
  const double outside =
      std::max({model.path.force_scale, model.system.unknowns.constrained_norm(model.residual), model.external.norm()});
  const double inside = contact_norm(model);
  return outside < self_balanced * inside ? inside : outside;
}

template <int D> double largest_position(const Model<D>& model) {
  const auto displacement = model.present.displacement.head(model.system.unknowns.displacements());
  return model.system.size + displacement.template lpNorm<Eigen::Infinity>();
}

/// ε |K| (|X| + |u|), in 3D four times as much, because a row sums about ten times as many products. Errors of rows are
/// independent, hence |K| is the 2-norm of the diagonal. Gaps are differences of positions with errors of ε (|X| +
/// |u|), which contact multiplies by its stiffness. Unconstrained bodies go farther than `far_away`: |u| is limited,
/// because otherwise their loads, too, would be rounding errors.
template <int D> double rounding_floor(const Model<D>& model) {
  const System<D>& system = model.system;
  const State<D>& state = model.present;
  double stiffness = system.assembly.tangent().diagonal_norm;
  for (std::size_t k = 0; k < system.contacts.size(); ++k)
    stiffness = std::max(stiffness, system.contacts[k]->stiffness(state.contacts[k], state.penalty_factor));
  double position = largest_position(model);
  if (const double far = far_away * system.size; position > far)
    position = std::min(position, far + system.drives.displacement(model.targets).template lpNorm<Eigen::Infinity>());
  return (D == 2 ? 1 : 4) * std::numeric_limits<double>::epsilon() * stiffness * position;
}

template <int D> bool contact_acts(const Model<D>& model, double rounding) {
  constexpr double noticeable = 1e-9; // strain
  double softest = std::numeric_limits<double>::infinity(), force = 0, pressure = 0;
  for (const NamedBody<D>& named : model.system.scene.bodies)
    softest = std::min(softest, named.body->material().constants().youngs_modulus);
  for (const contact::History<D>& history : model.present.contacts)
    for (const contact::PointResult<D>& point : history.results) {
      force += std::abs(point.pressure) * point.area;
      pressure = std::max(pressure, std::abs(point.pressure));
    }
  return force > rounding || pressure > noticeable * softest;
}

template <int D> bool is_deformed(const Model<D>& model) {
  double bound = 0;
  for (const NamedBody<D>& named : model.system.scene.bodies)
    bound += 0.5 * named.body->material().constants().youngs_modulus * deformed_strain * deformed_strain *
             named.body->tables().volumes().sum();
  return model.system.energy.of_all(model.accepted.displacement, model.accepted.internal) > bound;
}

template <int D> bool begin_contacts(Model<D>& model, const ActiveSetOptions& options, bool damping) {
  System<D>& system = model.system;
  model.controls.assign(system.contacts.size(), {});
  // With another penalty factor a step goes on from its last state, and with the touches that it has foreseen.
  const bool begins = model.present.displacement == model.accepted.displacement;
  for (std::size_t k = 0; k < system.contacts.size() && begins; ++k)
    forget_touches(model.present.contacts[k], model.accepted.contacts[k]);
  model.active_set.begin(system.contacts, model.present.contacts, options, model.controls);
  bool any = false;
  for (std::size_t k = 0; k < system.contacts.size() && damping; ++k) {
    const Contact<D>& contact = system.scene.contacts[k];
    const bool falls = system.contacts[k]->active(model.present.contacts[k]) &&
                       resultant(model.present.contacts[k]).active == 0 && has_unconstrained(system, contact);
    model.controls[k].landing = falls;
    any = any || falls;
  }
  return any;
}

template <int D> void judge_lead(Model<D>& model) {
  Message why;
  const solve::Outcome outcome = evaluate(model, nullptr, true, why);
  require(outcome == solve::Outcome::converged, "model.step.no_residual", {{"why", why}});
  const double tolerance = solve::NewtonOptions{}.tolerance * force_norm(model) + rounding_floor(model);
  require(model.unbalanced.norm() <= tolerance, "model.step.unbalanced",
          {{"residual", model.unbalanced.norm()}, {"tolerance", tolerance}});
  model.step->report.outcome = check_crossing(model, why);
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template solve::Outcome evaluate(Model<D>&, const VectorX*, bool, Message&);                                         \
  template void set_loads(Model<D>&, const VectorX&);                                                                  \
  template void take_residual(Model<D>&);                                                                              \
  template Tangent tangent_of(const Assembly<D>&);                                                                     \
  template bool factor(Model<D>&, const StepOptions&);                                                                 \
  template bool solve_for(Model<D>&, VectorX&, bool);                                                                  \
  template solve::Outcome check_crossing(Model<D>&, Message&);                                                         \
  template solve::NewtonSystem newton_system(Model<D>&, std::function<solve::Outcome(bool, Message&)>,                 \
                                             std::function<bool(double&)>);                                            \
  template double contact_norm(const Model<D>&);                                                                       \
  template double force_norm(const Model<D>&);                                                                         \
  template double largest_position(const Model<D>&);                                                                   \
  template double rounding_floor(const Model<D>&);                                                                     \
  template bool contact_acts(const Model<D>&, double);                                                                 \
  template bool is_deformed(const Model<D>&);                                                                          \
  template bool begin_contacts(Model<D>&, const ActiveSetOptions&, bool);                                              \
  template void judge_lead(Model<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
