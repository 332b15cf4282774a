#include "model/model.hpp"

#include "base/error.hpp"
#include "base/timer.hpp"

#include <algorithm>
#include <limits>

namespace signorini::model {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

template <int D> Scene<D> checked(Scene<D> scene) {
  require(!scene.bodies.empty(), "bodies: a model needs at least one body");
  for (const Contact& contact : scene.contacts)
    require(
        !(contact.slave == contact.master), "contacts: '", contact.name,
        "' has the same face as slave and as master; a face cannot touch itself: name the other body's face as master");
  return scene;
}

} // namespace

template <int D>
Model<D>::Model(Scene<D> scene)
    : scene_(checked(std::move(scene))), unknowns_(scene_), assembly_(scene_, unknowns_),
      displacement_(VectorX::Zero(unknowns_.dofs())), accepted_(displacement_),
      targets_(scene_.supports.size() * D, 0.0), accepted_targets_(targets_) {
  const auto surface = [&](const FaceReference& face) {
    return contact::Surface<D>(scene_.bodies[at(face.body)].body->space(), face.side);
  };
  for (const Contact& contact : scene_.contacts)
    pairs_.emplace_back(surface(contact.slave), surface(contact.master), contact.law, contact.points);
  for (const auto& named : scene_.bodies) size_ = std::max(size_, named.body->space().points().cwiseAbs().maxCoeff());
  // Friction at points that touch later counts from where they would touch now.
  std::string why;
  assemble(nullptr, false, why);
  for (auto& pair : pairs_) pair.accept();
}

template <int D> void Model<D>::set_target(int support, int component, double displacement) {
  targets_[at(support * D + component)] = displacement;
}

template <int D> double Model<D>::accepted_target(int support, int component) const {
  return accepted_targets_[at(support * D + component)];
}

template <int D> solve::Outcome Model<D>::assemble(const VectorX* increment, bool tangent, std::string& why) {
  const auto inverted = assembly_.assemble(pairs_, displacement_, increment, tangent, timings_);
  if (!inverted) return solve::Outcome::converged;
  const auto& [body, inversion] = *inverted;
  why = text("an element of body '", scene_.bodies[at(body)].name, "' is inverted (J = ", inversion.jacobian,
             ") at X = (", inversion.point.transpose(), "); take smaller steps");
  return solve::Outcome::inverted_element;
}

template <int D> bool Model<D>::advance(const StepOptions& options, VectorX& increment, double& energy) {
  ScopedTimer timer(timings_.linear);
  if (!solver_ || solver_version_ != assembly_.pattern_version() || solver_asked_ != options.linear) {
    solver_ = solve::make_solver(options.linear, assembly_.pattern());
    solver_version_ = assembly_.pattern_version();
    solver_asked_ = options.linear;
  }
  if (unknowns_.size() > 0 && !solver_->factor(assembly_.values().data())) return false;
  VectorX step = -assembly_.residual()(unknowns_.free());
  const VectorX force = step;
  if (unknowns_.size() > 0 && !solver_->solve(step.data())) return false;
  if (!step.allFinite()) return false;
  energy = std::abs(force.dot(step));
  displacement_(unknowns_.free()) += step;
  displacement_ += increment;
  increment.setZero();
  return true;
}

/// 2-norm of the forces that the supports exert.
template <int D> double Model<D>::reaction_norm() const {
  return assembly_.residual()(unknowns_.prescribed()).norm();
}

/// What rounding leaves of the residual: ε |K| |x|.
template <int D> double Model<D>::rounding_floor() const {
  return std::numeric_limits<double>::epsilon() * assembly_.largest_diagonal() * size_;
}

template <int D> solve::NewtonReport Model<D>::solve_step(const StepOptions& options) {
  VectorX increment = VectorX::Zero(unknowns_.dofs());
  for (int s = 0; s < static_cast<int>(scene_.supports.size()); ++s)
    for (int c = 0; c < D; ++c)
      for (int dof : unknowns_.driven(s, c)) increment(dof) = targets_[at(s * D + c)] - displacement_(dof);
  const bool pending = (increment.array() != 0).any();
  bool first = pending;

  solve::NewtonSystem system;
  system.assemble = [&](bool tangent, std::string& why) {
    const VectorX* add = first ? &increment : nullptr;
    first = false;
    return assemble(add, tangent, why);
  };
  system.residual = [&] { return assembly_.residual()(unknowns_.free()).norm(); };
  system.scale = [&] { return std::max(force_scale_, reaction_norm()); };
  system.floor = [&] { return rounding_floor(); };
  system.advance = [&](double& energy) { return advance(options, increment, energy); };
  return solve::newton(system, options.newton, pending);
}

template <int D> void Model<D>::accept() {
  ScopedTimer timer(timings_.contact);
  for (auto& pair : pairs_) pair.accept();
  accepted_ = displacement_;
  accepted_targets_ = targets_;
  force_scale_ = std::max(force_scale_, reaction_norm());
}

template <int D> void Model<D>::rollback() {
  displacement_ = accepted_;
  targets_ = accepted_targets_;
  for (auto& pair : pairs_) pair.rollback();
  // Reactions and contact results belong to the state again.
  std::string why;
  assemble(nullptr, false, why);
}

template <int D>
Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic>> Model<D>::body_displacement(int body) const {
  return {displacement_.data() + unknowns_.offset(body), D, scene_.bodies[at(body)].body->functions()};
}

template <int D> Vec<D> Model<D>::reaction(int support) const {
  // In equilibrium f_int + f_c = f_ext, so the residual at a held degree of freedom is what the support adds.
  Vec<D> sum = Vec<D>::Zero();
  for (int c = 0; c < D; ++c)
    if (scene_.supports[at(support)].hold[at(c)] != Hold::free)
      for (int dof : unknowns_.of_support(support, c)) sum(c) += assembly_.residual()(dof);
  return sum;
}

template <int D> contact::Resultant<D> Model<D>::contact_resultant(int contact) const {
  return pairs_[at(contact)].resultant();
}

template <int D> double Model<D>::stored_energy() const {
  double sum = 0;
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b)
    sum += solid::stored_energy(*scene_.bodies[b].body, displacement_.data() + unknowns_.offset(static_cast<int>(b)));
  return sum;
}

template <int D> solve::LinearKind Model<D>::linear_kind() const {
  return solver_ ? solver_->kind() : solve::LinearKind::automatic;
}

template class Model<2>;

} // namespace signorini::model
