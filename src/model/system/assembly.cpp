#include "model/system/assembly.hpp"

#include "model/system/free_angles.hpp"
#include "os/parallel.hpp"
#include "os/timer.hpp"

namespace signorini::model {

namespace {

/// The unknowns of ties that a Cholesky factorization must leave to the end, and those of obstacles, at which bodies
/// have no stiffness.
template <int D>
std::vector<int> border_of(const Scene<D>& scene, const Unknowns<D>& unknowns, const contact::Ties<D>& ties) {
  std::vector<int> border = tie_border(scene, unknowns, ties);
  for (int dof = unknowns.obstacles(); dof < unknowns.displacements(); ++dof)
    if (const int i = unknowns.unknown(dof); i >= 0) border.push_back(i);
  return border;
}

} // namespace

template <int D>
Assembly<D>::Assembly(const Scene<D>& scene, const Unknowns<D>& unknowns, const contact::Formulations<D>& contacts,
                      const contact::Ties<D>& ties, const FollowerLoads<D>& followers, const Springs<D>& springs)
    : unknowns_(unknowns), contacts_(contacts), followers_(followers), springs_(springs),
      ties_(tie_terms(scene, unknowns, ties)), bulk_(scene, unknowns, ties_),
      constant_(unknowns, ties_, springs, bulk_),
      contact_(unknowns, contacts, border_of(scene, unknowns, ties), !bulk_.stiffness().empty()),
      product_(unknowns.dofs()) {
  forget_contacts();
}

template <int D> void Assembly<D>::forget_contacts() {
  set_pattern({});
  contact_.reset(tangent_.pattern.entries());
}

/// Sets the pattern to that of the bodies and ties and of groups of coupled unknowns.
template <int D> void Assembly<D>::set_pattern(const std::vector<std::vector<int>>& groups) {
  std::vector<int> moved;
  tangent_.set_pattern(solve::extend(bulk_.pattern(), groups, moved), bulk_.scratch_entries());
  for (int k = 0; k < bulk_.scratch_entries(); ++k) moved.push_back(tangent_.pattern.entries() + k);
  bulk_.locate(moved);
  constant_.locate(tangent_, std::move(moved));
  contact_.forget_positions();
  follower_positions_ = positions_of(followers_.parts(), unknowns_, tangent_.pattern);
}

template <int D>
std::optional<BodyInversion> Assembly<D>::assemble(const States<D>& states, const VectorX* direction, bool tangent,
                                                   Timings& timings) {
  const Evaluation<D> evaluation{states, direction, tangent, tangent_, product_};
  if (const auto inverted = add_bodies_and_evaluate_contacts(evaluation, timings)) return inverted;
  ScopedTimer timer(timings.contact);
  State<D>& present = states.present;
  contact_.watch();
  contact_.add(evaluation);
  ties_.multiply(present.displacement, present.force);
  springs_.multiply(present.displacement, present.force);
  if (direction) {
    ties_.multiply(*direction, product_);
    springs_.multiply(*direction, product_);
    add_moments(unknowns_, present.displacement, product_);
  }
  if (!tangent) return std::nullopt;
  // The part of the tangent of free angles that is due to the path of their markers
  if (!unknowns_.free_angles().empty()) tangent_.changed.reset();
  for (const FreeAngle<D>& angle : unknowns_.free_angles())
    tangent_.values[tangent_.on_diagonal[unknowns_.unknown(angle.dof)]] +=
        angle_curvature(angle, present.displacement, present.force);
  add_followers(evaluation);
  tangent_.find_diagonal_norm();
  return std::nullopt;
}

/// Contacts and shares of bodies are parallel tasks; if the contacts then need a new pattern, the bodies are assembled
/// again.
template <int D>
std::optional<BodyInversion> Assembly<D>::add_bodies_and_evaluate_contacts(const Evaluation<D>& evaluation,
                                                                           Timings& timings) {
  const auto& [present, accepted, controls, loads, before] = evaluation.states;
  struct ContactTask {
    std::size_t contact;
    int part;
    double seconds = 0;
  };
  std::vector<ContactTask> contact_tasks;
  std::vector<contact::Trial<D>> trials;
  std::vector<contact::History<D>>& histories = present.contacts.own();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    trials.push_back({histories[k], accepted.contacts[k], controls[k], present.penalty_factor,
                      present.displacement.data() + unknowns_.of_contact(k).extra, duration(evaluation.states)});
    for (int part = 0; part < contacts_[k]->parts(); ++part) contact_tasks.push_back({k, part});
  }
  const auto add_heads = [&](std::size_t contacts) {
    evaluation.states.present.force.setZero();
    if (evaluation.direction) product_.setZero();
    if (evaluation.tangent) constant_.copy_to(tangent_);
    parallel(static_cast<int>(contacts + bulk_.tasks().size()), [&](std::size_t i) {
      if (i >= contacts) return bulk_.add_head(i - contacts, evaluation);
      ContactTask& task = contact_tasks[i];
      ScopedTimer timer(task.seconds);
      contacts_[task.contact]->evaluate_part(task.part, trials[task.contact], evaluation.tangent);
    });
  };

  const Stopwatch watch;
  move(present.displacement);
  bulk_.start();
  add_heads(contact_tasks.size());
  double gathering = 0;
  {
    ScopedTimer timer(gathering);
    for (std::size_t k = 0; k < contacts_.size(); ++k) contacts_[k]->gather(trials[k], evaluation.tangent);
  }
  if (!contact_.locate(tangent_.pattern)) {
    set_pattern(contact_.groups());
    contact_.locate(tangent_.pattern);
    add_heads(0);
  }
  bulk_.add_tails(evaluation);

  // The elapsed time is divided in proportion to the times of the tasks.
  double bulk = 0, contact = gathering;
  for (const auto& task : bulk_.tasks()) bulk += task.seconds;
  for (const ContactTask& task : contact_tasks) contact += task.seconds;
  const double scale = watch.seconds() / (bulk + contact);
  timings.bulk += scale * bulk;
  timings.contact += scale * contact;
  for (const auto& task : bulk_.tasks())
    if (task.inverted) return task.inverted;
  return std::nullopt;
}

/// Adds −∂f/∂u to the tangent, and its product with the direction.
template <int D> void Assembly<D>::add_followers(const Evaluation<D>& evaluation) {
  if (!followers_.empty()) tangent_.changed.reset();
  const int* position = follower_positions_.data();
  for (const auto& part : followers_.parts()) {
    const auto entries = static_cast<Eigen::Index>(part.dofs.size() * part.dofs.size());
    if (evaluation.states.loads(part.target) != 0) {
      const MatrixX tangent = followers_.tangent(part, evaluation.states.present.displacement, evaluation.states.loads);
      if (evaluation.direction) product_(part.dofs) -= tangent * (*evaluation.direction)(part.dofs);
      for (Eigen::Index k = 0; k < entries; ++k)
        if (position[k] >= 0) tangent_.values[position[k]] -= tangent.data()[k];
    }
    position += entries;
  }
}

template <int D> double Assembly<D>::memory() const {
  return bulk_.memory() + constant_.memory() + contact_.memory() + bytes_of(tangent_.values) +
         bytes_of(tangent_.pattern.starts) + bytes_of(tangent_.pattern.rows) + bytes_of(ties_.couplings) +
         bytes_of(follower_positions_);
}

template <int D> void Assembly<D>::move(const VectorX& displacement) const {
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    contacts_[k]->move(displacement.data(), displacement.data() + unknowns_.of_contact(k).master);
}

template class Assembly<2>;
template class Assembly<3>;

} // namespace signorini::model
