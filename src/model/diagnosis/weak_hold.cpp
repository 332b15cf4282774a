#include "model/diagnosis/weak_hold.hpp"

#include "base/orthonormal.hpp"
#include "model/steps/equilibrium.hpp"
#include "solve/eigenpairs.hpp"

#include <algorithm>

namespace signorini::model {

namespace {

/// Motions by unknown, and the name of what moves in each.
struct FreeMotions {
  MatrixX columns;
  std::vector<std::string> names;
};

template <int D> FreeMotions free_motions(System<D>& system) {
  const Unknowns<D>& unknowns = system.unknowns;
  const auto& bodies = system.unconstrained();
  const auto& obstacles = system.unconstrained_obstacles();
  FreeMotions motions{MatrixX::Zero(unknowns.size(), static_cast<Eigen::Index>(bodies.size() + obstacles.size())), {}};
  for (const auto& [body, motion] : bodies) {
    const auto column = static_cast<Eigen::Index>(motions.names.size());
    for (Eigen::Index i = 0; i < motion.size(); ++i)
      if (const int unknown = unknowns.unknown(unknowns.offset(body) + static_cast<int>(i)); unknown >= 0)
        motions.columns(unknown, column) = motion(i);
    motions.names.push_back(system.scene.bodies[body].name);
  }
  for (const UnconstrainedObstacle& motion : obstacles) {
    motions.columns(unknowns.unknown(motion.dof), static_cast<Eigen::Index>(motions.names.size())) = 1;
    motions.names.push_back(support_of(system.scene, unknowns, motion));
  }
  return motions;
}

/// Mᵀ K⁻¹ M of the accepted state; empty if K is singular.
template <int D> std::optional<MatrixX> compliance(Model<D>& model, const MatrixX& motions) {
  Message why;
  if (evaluate(model, {}, why) != solve::Outcome::converged) return std::nullopt;
  // Another solver than the path's, whose choices depend on what it has solved.
  LinearSolution solution(linear_facts(model.system));
  const bool by_mumps = model.linear.kind() == solve::LinearKind::mumps;
  if (!solution.factor(tangent_of(model.system.assembly),
                       {by_mumps ? solve::LinearKind::mumps : solve::LinearKind::automatic, true}))
    return std::nullopt;
  MatrixX moved = motions;
  for (Eigen::Index j = 0; j < motions.cols(); ++j) {
    VectorX b = motions.col(j);
    if (!solution.solve(b)) return std::nullopt;
    moved.col(j) = b;
  }
  return MatrixX(motions.transpose().lazyProduct(moved));
}

/// The name of what moves most in the motion M c, `m` being M.
const std::string& most_moved(const FreeMotions& motions, const MatrixX& m, const VectorX& c) {
  const VectorX shares = motions.columns.transpose().lazyProduct(m.lazyProduct(c));
  Eigen::Index largest = 0;
  shares.cwiseAbs().maxCoeff(&largest);
  return motions.names[largest];
}

} // namespace

template <int D> std::optional<Message> weak_hold(Model<D>& model) {
  // Relative to the body's stiffness: far above rounding errors of a sum over K's entries
  constexpr double rounding = 1e-12;
  System<D>& system = model.system;
  if (!settled(model) || !system.has_unconstrained()) return std::nullopt;
  for (std::size_t k = 0; k < system.contacts.size(); ++k)
    if (system.contacts[k]->parameters().friction(model.present.contacts[k].changes) > 0) return std::nullopt;

  const FreeMotions motions = free_motions(system);
  const MatrixX m = orthonormal(motions.columns);
  const auto found = compliance(model, m);
  const VectorX diagonal = system.assembly.tangent().diagonal();
  rollback(model);
  if (!found) return Message("model.warning.unheld", {{"name", motions.names.front()}});
  const MatrixX symmetric = 0.5 * (*found + found->transpose());
  const auto [least, worst] = solve::least_eigenpair(symmetric);
  const auto [minus_most, weakest] = solve::least_eigenpair(-symmetric);
  const VectorX direction = m.lazyProduct(weakest);
  const double stiffness = direction.cwiseAbs2().dot(diagonal);
  if (std::max(-minus_most, -least) * rounding * stiffness > 1)
    return Message("model.warning.unheld", {{"name", most_moved(motions, m, -minus_most > -least ? weakest : worst)}});
  return std::nullopt;
}

template std::optional<Message> weak_hold(Model<2>&);
template std::optional<Message> weak_hold(Model<3>&);

} // namespace signorini::model
