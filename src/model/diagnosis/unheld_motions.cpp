#include "model/diagnosis/unheld_motions.hpp"

#include "model/diagnosis/weak_directions.hpp"
#include "model/system/rigid_motions.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

/// A motion of a body by unknown; empty if a support prevents it.
template <int D> VectorX by_unknown(const Unknowns<D>& unknowns, int body, const VectorX& motion) {
  VectorX all = VectorX::Zero(unknowns.size());
  for (Eigen::Index i = 0; i < motion.size(); ++i) {
    if (motion(i) == 0) continue;
    const int unknown = unknowns.unknown(unknowns.offset(body) + static_cast<int>(i));
    if (unknown < 0) return {};
    all(unknown) = motion(i);
  }
  return all;
}

} // namespace

template <int D> Message unheld_motions(const Model<D>& model, int body) {
  constexpr double rounding = 1e-10; // of a sum over entries of K, relative to its diagonal
  const Scene<D>& scene = model.system.scene;
  const Unknowns<D>& unknowns = model.system.unknowns;
  const Assembly<D>& assembly = model.system.assembly;
  MatrixX points = scene.bodies[body].body->space().points();
  points += unknowns.of_body(body, model.present.displacement);

  const int translations = scene.kind == solid::Kind::axisymmetric ? 1 : D;
  const double least = rounding * assembly.tangent().diagonal().cwiseAbs().maxCoeff();
  std::vector<std::string> moves, turns;
  const std::vector<VectorX> motions = rigid_motions<D>(points, scene.kind);
  for (int m = 0; m < std::ssize(motions); ++m) {
    const VectorX motion = by_unknown(unknowns, body, motions[m]);
    if (motion.size() == 0) continue;
    const double stiffness = motion.dot(VectorX(times(assembly.tangent().pattern, assembly.tangent().values, motion)));
    if (!(std::abs(stiffness) <= least * motion.squaredNorm())) continue; // also where it is not a number
    if (m < translations)
      moves.push_back(component_name(translations == 1 ? 1 : m));
    else
      turns.push_back(component_name(D == 2 ? 2 : m - translations));
  }
  if (moves.size() + turns.size() < 2) return {};
  const std::string& name = scene.bodies[body].name;
  if (turns.empty()) return Message("model.diagnosis.unheld_moves", {{"body", name}, {"moves", moves}});
  if (moves.empty()) return Message("model.diagnosis.unheld_turns", {{"body", name}, {"turns", turns}});
  return Message("model.diagnosis.unheld", {{"body", name}, {"moves", moves}, {"turns", turns}});
}

template Message unheld_motions(const Model<2>&, int);
template Message unheld_motions(const Model<3>&, int);

} // namespace signorini::model
