#include "model/model.hpp"

#include "base/error.hpp"
#include "base/timer.hpp"
#include "model/clearance.hpp"

#include <algorithm>
#include <limits>

namespace signorini::model {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

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
      targets_(drives_.start()), accepted_targets_(targets_), present_(targets_), external_(drives_.force(targets_)) {
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
  for (const auto& named : scene_.bodies) size_ = std::max(size_, named.body->space().points().cwiseAbs().maxCoeff());
  // Friction at points that touch later counts from where they would touch now.
  std::string why;
  assemble(nullptr, false, why);
  for (auto& pair : pairs_) pair.accept();
  accepted_force_ = assembly_.residual();
  require_clearance(scene_, pairs_);
}

template <int D> void Model<D>::set_target(int drive, int component, double value) {
  targets_(drives_.target(drive, component)) = value;
}

template <int D> double Model<D>::accepted_target(int drive, int component) const {
  return accepted_targets_(drives_.target(drive, component));
}

template <int D> solve::Outcome Model<D>::assemble(const VectorX* direction, bool tangent, std::string& why) {
  const auto inverted = assembly_.assemble(pairs_, displacement_, direction, tangent, timings_);
  residual_ = assembly_.residual() - external_;
  unbalanced_ = unknowns_.gather(residual_);
  if (!inverted) return solve::Outcome::converged;
  const auto& [body, inversion] = *inverted;
  why = text("an element of body '", scene_.bodies[at(body)].name, "' is inverted (J = ", inversion.jacobian,
             ") at X = (", inversion.point.transpose(), "); take smaller steps");
  return solve::Outcome::inverted_element;
}

/// Whether the tangent is symmetric: all but the penalty law, whose traction acts on the current area, have a
/// potential.
template <int D> bool has_potential(const Scene<D>& scene) {
  return std::all_of(scene.contacts.begin(), scene.contacts.end(),
                     [](const Contact<D>& contact) { return std::holds_alternative<contact::Adhesion>(contact.law); });
}

/// What two solvers have done in turn; size and cost are those of the later one.
solve::SolverStatistics sum(const solve::SolverStatistics& before, const solve::SolverStatistics& now) {
  solve::SolverStatistics result = now;
  result.factorisations += before.factorisations;
  result.solutions += before.solutions;
  result.iterations += before.iterations;
  return result;
}

/// The linear solver for the present pattern. Where all bodies are linear elastic only the contacts' part of the
/// tangent changes: unless told otherwise, the rest is factored once.
template <int D> solve::LinearSolver& Model<D>::solver(const StepOptions& options) {
  const bool can_condense = assembly_.linear() && !pairs_.empty();
  require(options.linear != solve::LinearKind::condensed || can_condense,
          "linear = \"condensed\" needs bodies that are all linear elastic, and a contact: use \"auto\"");
  const bool condense = options.linear == solve::LinearKind::condensed ||
                        (options.linear == solve::LinearKind::automatic && can_condense);
  const bool same = solver_ && solver_asked_ == options.linear;
  const bool same_contacts = solver_contacts_ == assembly_.contact_version();
  // A growing pattern need not make an end of what a solver has.
  const bool fits =
      same && (solver_version_ == assembly_.pattern_version() || (!condense && solver_->adopt(assembly_.pattern())));
  if (!fits || (condense && !same_contacts)) {
    if (solver_) past_solvers_ = sum(past_solvers_, solver_->statistics());
    if (condense) {
      const auto& values = assembly_.constant_values();
      const solve::Condensation condensation{{values.begin(), values.begin() + assembly_.pattern().entries()},
                                             assembly_.contact_unknowns()};
      solver_ = solve::make_solver(solve::LinearKind::condensed, assembly_.pattern(), &condensation);
    } else {
      const bool symmetric = options.linear == solve::LinearKind::automatic && has_potential(scene_);
      solver_ = solve::make_solver(symmetric ? solve::symmetric_choice(assembly_.pattern()) : options.linear,
                                   assembly_.pattern());
    }
  }
  if (!fits || !same_contacts) solver_->watch(assembly_.contact_unknowns());
  solver_version_ = assembly_.pattern_version();
  solver_contacts_ = assembly_.contact_version();
  solver_asked_ = options.linear;
  return *solver_;
}

template <int D> bool Model<D>::factor(const StepOptions& options) {
  return unknowns_.size() == 0 || solver(options).factor(assembly_.values().data());
}

template <int D> bool Model<D>::advance(const StepOptions& options, VectorX& increment, double& energy) {
  ScopedTimer timer(timings_.linear);
  if (!factor(options)) return false;
  VectorX step = -unbalanced_;
  if (unknowns_.size() > 0 && !solver_->solve(step.data())) return false;
  if (!step.allFinite()) return false;
  energy = std::abs(unbalanced_.dot(step));
  displacement_ += unknowns_.spread(step) + increment;
  increment.setZero();
  present_ = targets_;
  return true;
}

/// What Newton's loop needs, around a way to assemble and one to advance.
template <int D>
solve::NewtonSystem Model<D>::system(std::function<solve::Outcome(bool, std::string&)> assemble,
                                     std::function<bool(double&)> advance) const {
  solve::NewtonSystem system;
  system.assemble = std::move(assemble);
  system.advance = std::move(advance);
  system.residual = [this] { return unbalanced_.norm(); };
  system.scale = [this] { return force_norm(); };
  system.floor = [this] { return rounding_floor(); };
  return system;
}

/// Size of the forces of the run so far: of supports and loads, in the accepted states and now.
template <int D> double Model<D>::force_norm() const {
  return std::max({force_scale_, unknowns_.held_norm(residual_), external_.norm()});
}

/// What rounding leaves of the residual: ε |K| |x|, in space four times as much, where a row adds up some ten times as
/// many products.
template <int D> double Model<D>::rounding_floor() const {
  return (D == 2 ? 1 : 4) * std::numeric_limits<double>::epsilon() * assembly_.largest_diagonal() * size_;
}

template <int D> solve::NewtonReport Model<D>::solve_step(const StepOptions& options) {
  VectorX increment = drives_.displacement(targets_) - drives_.displacement(present_);
  external_ = drives_.force(targets_);
  const bool pending = (increment.array() != 0).any();
  bool first = pending;
  const auto assemble_step = [&](bool tangent, std::string& why) {
    const solve::Outcome outcome = assemble(first ? &increment : nullptr, tangent, why);
    if (first) unbalanced_ += unknowns_.gather(assembly_.product());
    first = false;
    return outcome;
  };
  const auto step = [&](double& energy) { return advance(options, increment, energy); };
  return solve::newton(system(assemble_step, step), options.newton, pending);
}

/// Brings the prescribed displacements and loads from present_ to other targets.
template <int D> void Model<D>::move_targets(const VectorX& targets) {
  displacement_ += drives_.displacement(targets) - drives_.displacement(present_);
  external_ = drives_.force(targets);
  present_ = targets;
}

template <int D>
bool Model<D>::advance_arc(const StepOptions& options, const VectorX& direction, double length, VectorX& tangent,
                           double& energy) {
  ScopedTimer timer(timings_.linear);
  if (unknowns_.size() == 0 || !factor(options)) return false;
  // K δ₁ = −f,  K δ₂ = −∂f/∂λ with ∂f/∂λ = K_p ∂u_p/∂λ − ∂f_ext/∂λ
  const VectorX force = -unbalanced_;
  const VectorX change = -unknowns_.gather(assembly_.product() - drives_.force(direction));
  VectorX first = force, second = change;
  if (!solver_->solve(first.data()) || !solver_->solve(second.data())) return false;
  if (!first.allFinite() || !second.allFinite()) return false;
  const VectorX step = unknowns_.spread(first), free_rate = unknowns_.spread(second);
  const VectorX rate = free_rate + drives_.rate(present_, direction);
  double lambda;
  if (tangent.size() == 0) {
    // Predictor: along the curve's tangent, on in the sense of the last step
    const bool back = rate.dot(last_increment_) < 0;
    lambda = (back ? -1 : 1) * length / rate.norm();
    tangent = rate / (back ? -rate.norm() : rate.norm());
  } else {
    // t·(u + δ₁ + δλ (δ₂ + ∂u_p/∂λ) − u₀) = length
    lambda = (length - tangent.dot(displacement_ - accepted_ + step)) / tangent.dot(rate);
  }
  if (!std::isfinite(lambda)) return false;
  energy = std::abs((force + lambda * change).dot(first + lambda * second));
  displacement_ += step + lambda * free_rate;
  arc_fraction_ += lambda;
  move_targets(accepted_targets_ + arc_fraction_ * direction);
  return true;
}

template <int D> solve::NewtonReport Model<D>::solve_arc(const StepOptions& options, double length) {
  const VectorX direction = targets_ - accepted_targets_;
  require((direction.array() != 0).any(), "an arc needs a path: set a target other than the accepted one");
  require(length > 0, "an arc's length must be positive, got ", length);
  arc_fraction_ = 0;
  VectorX rate, tangent;
  const auto assemble_rate = [&](bool wanted, std::string& why) {
    rate = drives_.rate(present_, direction);
    return assemble(wanted ? &rate : nullptr, wanted, why);
  };
  const auto step = [&](double& energy) { return advance_arc(options, direction, length, tangent, energy); };
  const solve::NewtonReport report = solve::newton(system(assemble_rate, step), options.newton, true);
  targets_ = present_;
  return report;
}

template <int D> void Model<D>::accept() {
  ScopedTimer timer(timings_.contact);
  for (auto& pair : pairs_) pair.accept();
  last_increment_ = displacement_ - accepted_;
  work_ += 0.5 * (accepted_force_ + assembly_.residual()).dot(last_increment_);
  accepted_force_ = assembly_.residual();
  accepted_ = displacement_;
  accepted_targets_ = targets_;
  force_scale_ = force_norm();
}

template <int D> void Model<D>::rollback() {
  displacement_ = accepted_;
  targets_ = present_ = accepted_targets_;
  external_ = drives_.force(present_);
  for (auto& pair : pairs_) pair.rollback();
  // Reactions and contact results belong to the state again.
  std::string why;
  assemble(nullptr, false, why);
}

template <int D> Snapshot<D> Model<D>::snapshot() const {
  Snapshot<D> kept{accepted_, last_increment_, accepted_targets_, {}, force_scale_, work_, accepted_force_};
  for (const auto& pair : pairs_) kept.contacts.push_back(pair.history());
  return kept;
}

template <int D> void Model<D>::restore(const Snapshot<D>& snapshot) {
  accepted_ = snapshot.displacement;
  last_increment_ = snapshot.last_increment;
  accepted_targets_ = snapshot.targets;
  for (std::size_t k = 0; k < pairs_.size(); ++k) pairs_[k].restore(snapshot.contacts[k]);
  force_scale_ = snapshot.force_scale;
  work_ = snapshot.work;
  accepted_force_ = snapshot.force;
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

template <int D> solve::LinearKind Model<D>::linear_kind() const {
  return solver_ ? solver_->kind() : solve::LinearKind::automatic;
}

template <int D> solve::SolverStatistics Model<D>::solver_statistics() const {
  return solver_ ? sum(past_solvers_, solver_->statistics()) : past_solvers_;
}

template <int D> double Model<D>::memory() const {
  double bytes = assembly_.memory();
  for (const auto& named : scene_.bodies) bytes += static_cast<double>(named.body->memory());
  return bytes;
}

template class Model<2>;
template class Model<3>;

} // namespace signorini::model
