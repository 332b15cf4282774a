#include "model/diagnosis/sliding.hpp"

#include "base/orthonormal.hpp"
#include "model/constants.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

/// True if a displacement d of a body is tangential at all touching points of a frictionless contact.
template <int D> bool slides(const Model<D>& model, std::size_t contact, std::size_t body, const Vec<D>& d) {
  const Contact<D>& named = model.system.scene.contacts[contact];
  if (model.system.contacts[contact]->parameters().friction(model.present.contacts[contact].changes) > 0 ||
      !acts_on(named, static_cast<int>(body)))
    return false;
  bool touches = false;
  for (const auto& point : model.present.contacts[contact].results) {
    if (point.state == contact::ContactState::open) continue;
    if (!contact::touches(point.state)) return false;
    if (residual_of(orthonormal(point.tangents), d).norm() > across_part * d.norm()) return false;
    touches = true;
  }
  return touches;
}

/// The only contact that acts on a body, with friction and without bonds; −1 if there is none, or another one as well.
template <int D> int only_contact(const Model<D>& model, int body) {
  int found = -1;
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k) {
    const contact::History<D>& history = model.present.contacts[k];
    if (!acts_on(model.system.scene.contacts[k], body) ||
        !model.system.contacts[k]->parameters().active(history.changes))
      continue;
    if (found >= 0 || !(model.system.contacts[k]->parameters().friction(history.changes) > 0) || !history.bonds.empty())
      return -1;
    found = static_cast<int>(k);
  }
  return found;
}

/// True if nothing prevents translations of a body in all directions.
template <int D> bool floats(const std::vector<UnconstrainedMotion>& motions, int body) {
  int translations = 0;
  for (const auto& [moved, motion] : motions) {
    if (moved != body) continue;
    const Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic>> points(motion.data(), D, motion.size() / D);
    translations += (points.colwise() - points.col(0)).isZero(0);
  }
  return translations == D;
}

/// Outward unit normals of the slave face at the points that touch in a state.
template <int D>
std::vector<Vec<D>> touching_normals(const contact::Formulation<D>& contact, const contact::History<D>& history) {
  std::vector<Vec<D>> normals;
  for (std::size_t i = 0; i < history.results.size(); ++i) {
    const auto& point = history.results[i];
    if (!contact::touches(point.state)) continue;
    std::array<Vec<D>, D - 1> tangents;
    for (int a = 0; a < D - 1; ++a) tangents[a] = point.tangents.col(a);
    const int sheet = contact.slave().sheet(contact.points().list[i].element);
    normals.push_back((contact.slave().sheet_data(sheet).orientation * contact::normal_of<D>(tangents)).normalized());
  }
  return normals;
}

} // namespace

template <int D> std::vector<Message> remedies_of_sliding(const Model<D>& model, const VectorX& direction) {
  const VectorX all = model.system.unknowns.spread(direction);
  for (std::size_t b = 0; b < model.system.scene.bodies.size(); ++b) {
    const auto& named = model.system.scene.bodies[b];
    const auto own = model.system.unknowns.of_body(static_cast<int>(b), all);
    const Vec<D> mean = own.rowwise().mean();
    if (mean.norm() * std::sqrt(static_cast<double>(own.cols())) < own_part * all.norm()) continue;
    for (std::size_t k = 0; k < model.system.scene.contacts.size(); ++k)
      if (slides(model, k, b, mean))
        return {
            Message("model.remedy.friction", {{"contact", model.system.scene.contacts[k].name}, {"body", named.name}})};
  }
  return {};
}

template <int D> Message exhausted_friction(const Model<D>& model) {
  const Scene<D>& scene = model.system.scene;
  const Unknowns<D>& unknowns = model.system.unknowns;
  if (!scene.joins.empty() || !scene.ties.empty() || !model.external.allFinite()) return {};
  const std::vector<UnconstrainedMotion> motions = unconstrained_motions(scene, unknowns);
  for (int b = 0; b < std::ssize(scene.bodies); ++b) {
    const int k = only_contact(model, b);
    if (k < 0 || !floats<D>(motions, b)) continue;
    const contact::Formulation<D>& contact = *model.system.contacts[k];
    const contact::History<D>& present = model.present.contacts[k];
    // In the state before the step, which is in equilibrium, if points touch there
    std::vector<Vec<D>> normals = touching_normals(contact, model.accepted.contacts[k]);
    if (normals.empty()) normals = touching_normals(contact, present);
    if (normals.empty()) continue;
    Vec<D> n = Vec<D>::Zero(), force = n;
    for (const Vec<D>& one : normals) n += one;
    n.normalize();
    double spread = 0;
    for (const Vec<D>& one : normals) spread = std::max(spread, std::acos(std::clamp(one.dot(n), -1.0, 1.0)));
    // Points in tension, which an iteration retains, do not hold the body.
    const bool sticks = std::ranges::any_of(present.results, [](const auto& point) {
      return point.state == contact::ContactState::stick && point.pressure > 0;
    });
    if (contact.parameters().by_formula()) continue; // its limit follows from the points' own pressures and slips
    const double mu = contact.parameters().friction(present.changes),
                 angle = std::atan(mu) + (sticks ? spread : -spread);
    for (int i = 0; i < scene.bodies[b].body->functions(); ++i)
      force += model.external.template segment<D>(unknowns.offset(b) + D * i);
    const double normal = (scene.contacts[k].slave.on(b) ? 1 : -1) * force.dot(n);
    const double demanded = (force - force.dot(n) * n).norm();
    if (normal > 0 && angle < std::acos(0) && demanded > normal * std::tan(angle))
      return Message("model.diagnosis.friction", {{"contact", scene.contacts[k].name},
                                                  {"body", scene.bodies[b].name},
                                                  {"ratio", demanded / normal},
                                                  {"normal", normal},
                                                  {"demanded", demanded},
                                                  {"mu", mu},
                                                  {"slip", sticks ? Message() : Message("model.diagnosis.slip")}});
  }
  return {};
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::vector<Message> remedies_of_sliding(const Model<D>&, const VectorX&);                                  \
  template Message exhausted_friction(const Model<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
