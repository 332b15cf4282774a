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

namespace {

/// Rules for the contacts in an evaluation of the present state; `guess`: it is the first guess of a step.
template <int D>
std::vector<contact::Controls> controls_of(const Model<D>& model, const InitialContact& initial, bool guess) {
  const contact::Controls all{.guessed = initial.tolerance, .onward = initial.onward};
  std::vector<contact::Controls> controls(model.system.contacts.size(), all);
  for (std::size_t k = 0; k < controls.size() && model.step; ++k) {
    controls[k].fixed_states = model.active_set.fixed(static_cast<int>(k));
    controls[k].all_stick = model.step->closing && model.step->closing->contacts[k];
    controls[k].foresees = guess && !controls[k].all_stick;
  }
  return controls;
}

} // namespace

template <int D> solve::Outcome evaluate(Model<D>& model, const EvaluationOptions& wanted, Message& why) {
  if (model.step)
    model.step->evaluated = false;
  else
    set_loads(model, model.targets);
  follow_angles(model.system.unknowns, model.present.displacement);
  // The first state of a step away from the accepted one is its guess.
  const bool guess =
      model.step && !model.step->guess_evaluated && model.present.displacement != model.accepted.displacement;
  if (guess) model.step->guess_evaluated = true;
  const std::vector<contact::Controls> controls = controls_of(model, wanted.initial, guess);
  const VectorX* before = nullptr;
  // Without contact the prediction saves no iterations, and an inflated ball bears longer steps without it.
  if (wanted.corrects && !model.system.contacts.empty())
    before = model.step->before.size() > 0 ? &model.step->before : &model.accepted.displacement;
  const auto inverted = model.system.assembly.assemble({model.present, model.accepted, controls, model.acting, before},
                                                       wanted.direction, wanted.tangent, model.timings);
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

template <int D> bool StepProblem<D>::factor(bool viscous) {
  ScopedTimer timer(model.timings.factorization);
  model.step->before = model.present.displacement;
  if (options.damping) damp(model);
  const Assembly<D>& assembly = model.system.assembly;
  // Constant factors of the bodies do not have a viscosity, which acts on all unknowns.
  const bool changed = viscous && !assembly.constant().values().empty();
  const bool replaced = changed && options.linear == solve::LinearKind::condensed;
  return model.linear.factor(tangent_of(assembly),
                             {replaced ? solve::LinearKind::automatic : options.linear,
                              changed || (options.damping && model.system.has_unconstrained()), options.mumps});
}

template <int D> bool StepProblem<D>::solve(VectorX& b, bool fully) {
  ScopedTimer timer(model.timings.solution);
  return model.linear.solve(b, fully) && b.allFinite();
}

namespace {

template <int D> solve::Outcome check_crossing(Model<D>& model, bool only_sets, Message& why) {
  ScopedTimer timer(model.timings.contact);
  const auto& contacts = model.system.contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const contact::Formulation<D>& contact = *contacts[k];
    if (only_sets && !contact.faces().master.set()) continue;
    if (crossed(contact, model.present.contacts[k], model.accepted.contacts[k]).empty()) continue;
    why = Message("model.step.crossed", {{"contact", model.system.scene.contacts[k].name}});
    return solve::Outcome::crossed;
  }
  return solve::Outcome::converged;
}

} // namespace

template <int D> solve::Outcome check_crossing(Model<D>& model, Message& why) {
  return check_crossing(model, false, why);
}

template <int D> solve::Outcome check_start(Model<D>& model, Message& why) {
  return check_crossing(model, true, why);
}

template <int D> double contact_norm(const Model<D>& model) {
  double sum = 0;
  for (const contact::History<D>& history : model.present.contacts)
    for (const std::size_t i : watched_points(history)) sum += history.results[i].force.squaredNorm();
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

/// [theory 10.2] ε |K| (|X| + |u|), in 3D four times as much, because a row sums about ten times as many products.
/// Errors of rows are independent, hence |K| is the 2-norm of the diagonal. Gaps are differences of positions with
/// errors of ε (|X| + |u|), which contact multiplies by its stiffness. Unconstrained bodies go farther than `far_away`:
/// |u| is limited, because otherwise their loads, too, would be rounding errors.
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
  double softest = std::numeric_limits<double>::infinity(), force = 0, pressure = 0;
  for (const NamedBody<D>& named : model.system.scene.bodies)
    softest = std::min(softest, named.body->material().constants().youngs_modulus);
  for (const contact::History<D>& history : model.present.contacts)
    for (const std::size_t i : watched_points(history)) {
      const contact::PointResult<D>& point = history.results[i];
      force += std::abs(point.pressure) * point.area;
      pressure = std::max(pressure, std::abs(point.pressure));
    }
  return force > rounding || pressure > noticeable_strain * softest;
}

template <int D> bool is_deformed(const Model<D>& model) {
  double bound = 0;
  for (const NamedBody<D>& named : model.system.scene.bodies)
    bound += 0.5 * named.body->material().constants().youngs_modulus * deformed_strain * deformed_strain *
             named.body->tables().volumes().sum();
  return model.system.assembly.bulk().account(model.accepted.displacement, model.accepted.internal).stored > bound;
}

template <int D> void begin_contacts(Model<D>& model, const ActiveSetOptions& options) {
  // With another penalty factor a step goes on from its last state, and with the touches that it has foreseen.
  std::vector<contact::History<D>>& histories = model.present.contacts.own();
  if (model.present.displacement == model.accepted.displacement)
    for (std::size_t k = 0; k < histories.size(); ++k) forget_touches(histories[k], model.accepted.contacts[k]);
  model.active_set.begin(model.system.contacts, histories, options);
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template struct StepProblem<D>;                                                                                      \
  template solve::Outcome evaluate(Model<D>&, const EvaluationOptions&, Message&);                                     \
  template void set_loads(Model<D>&, const VectorX&);                                                                  \
  template void take_residual(Model<D>&);                                                                              \
  template Tangent tangent_of(const Assembly<D>&);                                                                     \
  template double contact_norm(const Model<D>&);                                                                       \
  template double force_norm(const Model<D>&);                                                                         \
  template double largest_position(const Model<D>&);                                                                   \
  template double rounding_floor(const Model<D>&);                                                                     \
  template bool contact_acts(const Model<D>&, double);                                                                 \
  template bool is_deformed(const Model<D>&);                                                                          \
  template solve::Outcome check_crossing(Model<D>&, Message&);                                                         \
  template solve::Outcome check_start(Model<D>&, Message&);                                                            \
  template void begin_contacts(Model<D>&, const ActiveSetOptions&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
