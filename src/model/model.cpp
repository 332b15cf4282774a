#include "model/model.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "base/timer.hpp"
#include "base/words.hpp"
#include "model/clearance.hpp"
#include "model/scene_warnings.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

template <int D> Scene<D> checked(Scene<D> scene) {
  require(!scene.bodies.empty(), "bodies: a model needs at least one body");
  for (const Contact<D>& contact : scene.contacts) {
    const auto* face = std::get_if<FaceReference>(&contact.master);
    require(
        !face || !(contact.slave == *face), "contacts: '", contact.name,
        "' has the same face as slave and as master; a face cannot touch itself: name the other body's face as master");
  }
  for (const auto& named : scene.bodies)
    require(named.body->kind() == scene.kind, "bodies: '", named.name,
            "' is not of the scene's kind (plane strain or axisymmetric)");
  return scene;
}

} // namespace

template <int D>
Model<D>::Model(Scene<D> scene)
    : scene_(checked(std::move(scene))), unknowns_(scene_), drives_(scene_, unknowns_), assembly_(scene_, unknowns_),
      displacement_(VectorX::Zero(unknowns_.dofs())), accepted_(displacement_), last_increment_(displacement_),
      targets_(drives_.start()), accepted_targets_(targets_), previous_targets_(targets_), present_(targets_),
      external_(drives_.force(targets_)), linear_(linear_facts(scene_)) {
  const auto surface = [&](const FaceReference& face) {
    return contact::Surface<D>(scene_.bodies[at(face.body)].body->space(), face.side);
  };
  for (Contact<D>& contact : scene_.contacts) {
    const auto* face = std::get_if<FaceReference>(&contact.master);
    contact::Master<D> master = face ? contact::Master<D>(surface(*face))
                                     : contact::Master<D>(scene_.obstacles[at(std::get<1>(contact.master).obstacle)]);
    pairs_.emplace_back(surface(contact.slave), std::move(master), contact.law, contact.points,
                        scene_.kind == solid::Kind::axisymmetric, contact.where);
    contact.where = {}; // it may refer to what only lives while the model is made
  }
  for (const auto& obstacle : scene_.obstacles) size_ = std::max(size_, contact::largest_coordinate<D>(obstacle));
  for (const auto& named : scene_.bodies) {
    const MatrixX points = named.body->space().points();
    size_ = std::max(size_, points.cwiseAbs().maxCoeff());
    const double radius = (points.colwise() - points.rowwise().mean()).colwise().norm().maxCoeff();
    extent_ = std::max(extent_, 2 * radius);
  }
  // Friction at points that touch later counts from where they would touch now.
  std::string why;
  assemble(nullptr, false, why);
  for (auto& pair : pairs_) pair.accept();
  accepted_force_ = force_;
  scene_warnings_ = check_clearance(scene_, pairs_);
  for (std::string& warning : scene_warnings(scene_, pairs_)) scene_warnings_.push_back(std::move(warning));
}

template <int D> void Model<D>::set_target(int drive, int component, double value) {
  targets_(drives_.target(drive, component)) = value;
  step_.reset();
}

/// The step from the accepted targets as a multiple of the last accepted one; nothing where the path bends.
template <int D> std::optional<double> Model<D>::straight_ratio(const VectorX& step) const {
  const VectorX last = accepted_targets_ - previous_targets_;
  if (!(last.squaredNorm() > 0)) return std::nullopt;
  const double ratio = step.dot(last) / last.squaredNorm();
  constexpr double straight = 1e-6;
  if ((step - ratio * last).norm() > straight * step.norm()) return std::nullopt;
  return ratio;
}

template <int D> void Model<D>::set_penalty_factor(double factor) {
  require(std::isfinite(factor) && factor > 0, "the penalty's factor must be positive, got ", factor);
  for (auto& pair : pairs_) pair.scale_penalty(factor);
  penalty_factor_ = factor;
  step_.reset(); // as for new targets: what has converged is no equilibrium any more
}

template <int D> void Model<D>::time_search(bool wanted) {
  for (auto& pair : pairs_) pair.time_search(wanted);
}

template <int D> double Model<D>::search_seconds() const {
  double sum = 0;
  for (const auto& pair : pairs_) sum += pair.search_seconds();
  return sum;
}

template <int D> double Model<D>::accepted_target(int drive, int component) const {
  return accepted_targets_(drives_.target(drive, component));
}

template <int D> solve::Outcome Model<D>::assemble(const VectorX* direction, bool tangent, std::string& why) {
  const auto inverted = assembly_.assemble(pairs_, displacement_, direction, tangent, timings_);
  force_ = assembly_.residual();
  residual_ = force_ - external_;
  unbalanced_ = unknowns_.gather(residual_);
  if (!inverted) return solve::Outcome::converged;
  inverted_ = inverted;
  const auto& [body, inversion] = *inverted;
  why = text("element ", inversion.element + 1, " of body '", scene_.bodies[at(body)].name,
             "' is inverted (J = ", inversion.jacobian, ") at X = ", coordinates(inversion.point));
  return solve::Outcome::inverted_element;
}

template <int D> bool Model<D>::settled() const {
  return !step_ && displacement_ == accepted_ && targets_ == accepted_targets_ &&
         penalty_factor_ == accepted_penalty_factor_;
}

template <int D> void Model<D>::accept() {
  if (!step_) {
    require(settled(), "no step has been solved since targets or penalties were changed: solve one, or roll back");
    return;
  }
  if (step_->lead && step_->report.outcome == solve::Outcome::iterating) judge_lead();
  const solve::Outcome outcome = step_->report.outcome;
  require(outcome != solve::Outcome::iterating, "the step is not in equilibrium yet: iterate on until its reason is "
                                                "\"converged\", or roll back");
  require(outcome == solve::Outcome::converged, "the step has failed (", solve::name_of(outcome),
          "), its state is not in equilibrium: roll back");
  ScopedTimer timer(timings_.contact);
  for (auto& pair : pairs_) pair.accept();
  // How far this step's rate of displacement, Δu for the same Δtargets, is from the last one's
  const VectorX increment = displacement_ - accepted_, step = targets_ - accepted_targets_;
  const std::optional<double> ratio = straight_ratio(step);
  bend_ = ratio ? (increment - *ratio * last_increment_).norm() / increment.norm() : 1;
  last_increment_ = increment;
  previous_targets_ = accepted_targets_;
  work_ += 0.5 * (accepted_force_ + force_).dot(last_increment_);
  accepted_force_ = force_;
  accepted_ = displacement_;
  accepted_targets_ = targets_;
  accepted_penalty_factor_ = penalty_factor_;
  force_scale_ = force_norm();
  step_.reset();
}

template <int D> void Model<D>::rollback() {
  step_.reset();
  inverted_.reset();
  displacement_ = accepted_;
  targets_ = present_ = accepted_targets_;
  external_ = drives_.force(present_);
  set_penalty_factor(accepted_penalty_factor_);
  for (auto& pair : pairs_) pair.hold({});
  // Reactions and contact results belong to the state again, with the bits that they had.
  force_ = accepted_force_;
  residual_ = force_ - external_;
  unbalanced_ = unknowns_.gather(residual_);
  assembly_.move(pairs_, displacement_);
  for (auto& pair : pairs_) pair.rollback();
}

template <int D> void Model<D>::settle() {
  rollback();
  for (auto& pair : pairs_) pair.settle();
  assembly_.forget_contacts();
  linear_.forget();
}

template <int D> Snapshot<D> Model<D>::snapshot() const {
  Snapshot<D> kept{accepted_,          last_increment_, accepted_targets_, previous_targets_,        {},
                   force_scale_,       work_,           accepted_force_,   accepted_penalty_factor_, bend_,
                   linear_.beginning()};
  for (const auto& pair : pairs_) kept.contacts.push_back(pair.history());
  return kept;
}

template <int D> void Model<D>::restore(const Snapshot<D>& snapshot) {
  accepted_ = snapshot.displacement;
  last_increment_ = snapshot.last_increment;
  accepted_targets_ = snapshot.targets;
  previous_targets_ = snapshot.previous_targets;
  bend_ = snapshot.bend;
  accepted_penalty_factor_ = snapshot.penalty_factor;
  for (std::size_t k = 0; k < pairs_.size(); ++k) pairs_[k].restore(snapshot.contacts[k]);
  force_scale_ = snapshot.force_scale;
  work_ = snapshot.work;
  accepted_force_ = snapshot.force;
  linear_.begin_with(snapshot.automatic);
  rollback();
}

template <int D>
Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic>> Model<D>::body_displacement(int body) const {
  return {displacement_.data() + unknowns_.offset(body), D, scene_.bodies[at(body)].body->functions()};
}

template <int D> Vec<D> Model<D>::reaction(int index) const {
  // In equilibrium f_int + f_c − f_ext = 0 but for what the supports add.
  const Support<D>& support = scene_.supports[at(index)];
  Vec<D> sum = Vec<D>::Zero();
  for (int c = 0; c < D; ++c)
    if (support.hold[at(c)] != Hold::free || support.rotates)
      for (int dof : unknowns_.of_support(index, c)) sum(c) += residual_(dof);
  return sum;
}

template <int D> contact::Resultant<D> Model<D>::contact_resultant(int contact) const {
  return pairs_[at(contact)].resultant();
}

template <int D> Energies Model<D>::energies() const {
  Energies sum{0, 0, 0, work_};
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b)
    sum.stored +=
        solid::stored_energy(*scene_.bodies[b].body, displacement_.data() + unknowns_.offset(static_cast<int>(b)));
  for (const contact::Pair<D>& pair : pairs_) {
    sum.contact += pair.potential();
    sum.friction += pair.dissipated();
  }
  return sum;
}

template <int D> std::vector<std::string> Model<D>::warnings() const {
  std::vector<std::string> warnings = scene_warnings_;
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
    const auto& [name, body] = scene_.bodies[b];
    if (!body->linear()) continue; // others refuse to be inverted
    const auto worst = solid::worst_inversion(*body, displacement_.data() + unknowns_.offset(static_cast<int>(b)));
    if (worst)
      warnings.push_back(text("bodies.", name, ": the linear elastic body is turned inside out in element ",
                              worst->element + 1, " (det F = ", number(worst->jacobian),
                              ") at X = ", coordinates(worst->point),
                              ", far beyond small strains. Hint: take sg.neo_hookean, or "
                              "smaller loads and displacements"));
  }
  return warnings;
}

template <int D> double Model<D>::memory() const {
  double bytes = assembly_.memory();
  for (const auto& named : scene_.bodies) bytes += static_cast<double>(named.body->memory());
  return bytes;
}

template class Model<2>;
template class Model<3>;

} // namespace signorini::model
