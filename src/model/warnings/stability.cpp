#include "model/warnings/stability.hpp"

#include "model/checks/constants.hpp"
#include "model/constants.hpp"
#include "model/diagnosis/weak_directions.hpp"
#include "model/stability/inertia.hpp"
#include "model/steps/equilibrium.hpp"
#include "model/warnings/neutral_motion.hpp"

#include <algorithm>
#include <numeric>

namespace signorini::model {

namespace {

VectorX times(const Stiffness& k, const VectorX& u) {
  return model::times(k.pattern, k.values, u);
}

Stiffness symmetric_part(Stiffness k) {
  solve::add_transpose(k.pattern, k.values.data());
  for (double& value : k.values) value *= 0.5;
  return k;
}

/// The square root of the diagonal, in place of inertia: lengths that make stiffnesses comparable.
VectorX scale_of(const Stiffness& k) {
  VectorX diagonal(k.pattern.size);
  for (int i = 0; i < k.pattern.size; ++i) diagonal(i) = std::abs(k.values[k.pattern.find(i, i)]);
  const double largest = diagonal.maxCoeff();
  for (double& value : diagonal)
    if (value < neutral_stiffness * largest) value = largest;
  return diagonal.cwiseSqrt();
}

/// D⁻¹ K D⁻¹.
Stiffness scaled(Stiffness k, const VectorX& d) {
  for (int j = 0; j < k.pattern.size; ++j)
    for (int i = k.pattern.starts[j]; i < k.pattern.starts[j + 1]; ++i) k.values[i] /= d(j) * d(k.pattern.rows[i]);
  return k;
}

Stiffness shifted(const Stiffness& k, double shift) {
  return {k.pattern, model::shifted(k.pattern, k.values, shift)};
}

/// The eigenvector with the most negative eigenvalue λ of a symmetric K: with the shift s > −λ at which K + s I becomes
/// positive definite, found by bisection of its logarithm, inverse iteration converges like (s + λ)/s.
VectorX most_negative(const Stiffness& k, solve::LinearKind kind) {
  constexpr double enough = 1.2, most = 1e6; // far above the number of entries of a row
  double below = neutral_stiffness, above = 1;
  while (above < most && !is_definite(shifted(k, above), kind)) {
    below = above;
    above *= 10;
  }
  while (above > enough * below) {
    const double middle = std::sqrt(below * above);
    (is_definite(shifted(k, middle), kind) ? above : below) = middle;
  }
  return null_direction(k.pattern, shifted(k, above).values, k.pattern.size, kind).direction;
}

/// True if an unsymmetric K has a negative eigenvalue near a direction, by iteration with Rayleigh's quotient.
bool has_negative_eigenvalue(const Stiffness& k, VectorX u, solve::LinearKind kind) {
  constexpr int most = 6;
  constexpr double exact = 1e-6;
  const auto solver = solve::make_solver(kind, k.pattern);
  for (int i = 0; i < most; ++i) {
    const VectorX product = times(k, u);
    const double value = u.dot(product);
    if ((product - value * u).norm() <= exact * std::abs(value)) return value < -neutral_stiffness;
    if (!solver->factor(shifted(k, -value).values.data()) || !solver->solve(u.data())) return false;
    u.normalize();
  }
  return false;
}

/// True if the state lies where a law softens in one direction only: its tangent holds there alone.
template <int D> bool is_one_sided(const Model<D>& model) {
  for (const NamedBody<D>& named : model.system.scene.bodies)
    if (named.body->internal_variables() > 0) return true;
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k)
    if (const contact::Bonds<D>* bonds = model.system.contacts[k]->bonds())
      for (std::size_t i = 0; i < bonds->closest.size(); ++i)
        if (const double damage = bonds->damage(model.accepted.contacts[k], i); damage > 0 && damage < 1) return true;
  return false;
}

/// What moves most, and of a body where and along what.
template <int D> Message described(System<D>& system, const VectorX& direction) {
  const Unknowns<D>& unknowns = system.unknowns;
  const VectorX all = unknowns.spread(direction);
  double most = 0;
  Message found("");
  for (std::size_t b = 0; b < system.scene.bodies.size(); ++b) {
    const auto& [name, body] = system.scene.bodies[b];
    const MatrixX points = body->space().points();
    for (int a = 0; a < body->functions(); ++a) {
      const Vec<D> move = all.segment<D>(unknowns.offset(static_cast<int>(b)) + D * a);
      if (move.norm() <= most) continue;
      most = move.norm();
      Vec<D> along = move / most;
      for (double& component : along) component = std::round(100 * component) / 100 + 0.0;
      found = Message("model.warning.unstable",
                      {{"name", name}, {"place", VectorX(points.col(a))}, {"along", VectorX(along)}});
    }
  }
  for (const UnconstrainedObstacle& motion : system.unconstrained_obstacles())
    if (std::abs(all(motion.dof)) > most) {
      most = std::abs(all(motion.dof));
      found = Message("model.warning.unstable_obstacle", {{"name", support_of(system.scene, unknowns, motion)}});
    }
  return found;
}

} // namespace

template <int D> void warn_of_instability(Model<D>& model, std::vector<Message>& warnings) {
  System<D>& system = model.system;
  const int displacements = system.unknowns.free_displacements();
  // The stiffness of linear bodies does not change, so that only contacts which alone hold a body can be unstable.
  const bool constant = system.followers.empty() && std::ranges::all_of(system.scene.bodies, [](const auto& named) {
                          return named.body->linear();
                        });
  if (displacements == 0 || model.definite || (constant && !system.has_unconstrained()) || is_one_sided(model)) return;
  // With a loose tolerance the state is not an equilibrium.
  if (model.unbalanced.size() > 0 && model.unbalanced.norm() > loose_balance * force_norm(model)) return;
  Message why;
  const bool evaluated =
      evaluate(model, {.initial = {gap_rounding * largest_position(model)}}, why) == solve::Outcome::converged;
  if (evaluated && model.linear.proves_definite(tangent_of(system.assembly))) return rollback(model);
  const Stiffness k =
      displacement_stiffness(system, system.assembly.tangent().pattern, system.assembly.tangent().values);
  rollback(model);
  if (!evaluated || std::ranges::all_of(k.values, [](double value) { return value == 0; })) return;
  const bool by_mumps = model.linear.kind() == solve::LinearKind::mumps;
  const solve::LinearKind kind = by_mumps ? solve::LinearKind::mumps : solve::LinearKind::umfpack;
  const VectorX lengths = scale_of(k);
  const Stiffness comparable = scaled(k, lengths), symmetric = symmetric_part(comparable);
  if (is_definite(shifted(symmetric, neutral_stiffness), kind)) return;
  const VectorX mode = most_negative(symmetric, kind);
  if (!(mode.dot(times(symmetric, mode)) < -neutral_stiffness)) return;
  if (!solve::is_symmetric(k.pattern, k.values.data()) && !has_negative_eigenvalue(comparable, mode, kind)) return;
  const VectorX u = mode.cwiseQuotient(lengths).normalized();
  VectorX direction = VectorX::Zero(system.unknowns.size()); // zero for multipliers
  direction.head(displacements) = u;
  if (is_neutral(model, direction, u.dot(times(k, u)))) return;
  warnings.push_back(described(system, direction));
}

template void warn_of_instability(Model<2>&, std::vector<Message>&);
template void warn_of_instability(Model<3>&, std::vector<Message>&);

} // namespace signorini::model
