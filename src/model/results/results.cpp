#include "model/results/results.hpp"

#include "base/error.hpp"
#include "model/scene/turning.hpp"

#include <algorithm>
#include <numbers>

namespace signorini::model {

template <int D>
Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic>> body_displacement(const Model<D>& model, int body) {
  return model.system.unknowns.of_body(body, model.present.displacement);
}

template <int D> Vec<D> reaction(const Model<D>& model, int index) {
  // In equilibrium f_int + f_c − f_ext is the reaction of the supports.
  const Scene<D>& scene = model.system.scene;
  const Unknowns<D>& unknowns = model.system.unknowns;
  const Support<D>& support = scene.supports[index];
  const int bodies = scene.obstacles.empty() ? unknowns.dofs() : unknowns.obstacle_offset(0);
  Vec<D> sum = Vec<D>::Zero();
  for (int c = 0; c < D; ++c) {
    if (support.constraint[c] != Constraint::free || support.rotates)
      for (int dof : unknowns.of_support(index, c))
        if (dof < bodies) sum(c) += model.residual(dof);
    for (const int obstacle : support.obstacles)
      if (holder_of(scene, obstacle, c) == &support) sum(c) += model.residual(unknowns.obstacle_offset(obstacle) + c);
  }
  VectorX held = VectorX::Zero(model.system.unknowns.dofs());
  model.system.springs.multiply(model.present.displacement, held, index);
  return sum - model.system.unknowns.resultant(held);
}

template <int D> double moment(const Model<D>& model, int support) {
  return model.system.drives.moment(support, model.present.targets, model.residual);
}

template <int D> std::vector<std::pair<std::string, double>> free_motion(const Model<D>& model, int index) {
  const Support<D>& support = model.system.scene.supports[index];
  const Unknowns<D>& unknowns = model.system.unknowns;
  std::vector<std::pair<std::string, double>> motion;
  for (const int obstacle : support.obstacles) {
    for (int c = 0; c < D; ++c)
      if (support.freed[c])
        motion.emplace_back("u" + component_name(c),
                            model.present.displacement(unknowns.obstacle_offset(obstacle) + c));
    for (const FreeAngle<D>& angle : unknowns.free_angles())
      if (support.free_angle && angle.obstacle == obstacle)
        motion.emplace_back("angle", model.present.displacement(angle.dof) / angle.arm * 180 / std::numbers::pi);
  }
  return motion;
}

template <int D> Vec<D> load_resultant(const Model<D>& model, int load) {
  const VectorX targets = model.system.drives.only(load, model.present.targets);
  VectorX force = model.system.drives.force(targets);
  model.system.followers.add_force(model.present.displacement, targets, force);
  return model.system.unknowns.resultant(force);
}

template <int D> Energies energies(const Model<D>& model) {
  const VectorX& displacement = model.present.displacement;
  const solid::Account bulk = model.system.assembly.bulk().account(displacement, model.present.internal);
  Energies sum{model.system.springs.energy(displacement) + bulk.stored, 0, 0, model.path.work};
  sum.viscous = bulk.viscous;
  for (std::size_t k = 0; k < model.present.contacts.size(); ++k) {
    const contact::History<D>& history = model.present.contacts[k];
    sum.contact += contact::potential(*model.system.contacts[k], history);
    sum.friction += history.dissipated;
    sum.debonding += history.debonding;
    sum.wear += history.wear;
    sum.growth += history.growth;
    sum.work += history.offset_work;
  }
  return sum;
}

template <int D> double imbalance(const Model<D>& model, int pass) {
  const int other = model.system.scene.contacts[pass].other_pass;
  const Vec<D> here = contact::resultant(model.present.contacts[pass]).force;
  const Vec<D> there = contact::resultant(model.present.contacts[other]).force;
  const double larger = std::max(here.norm(), there.norm());
  return larger > 0 ? (here + there).norm() / larger : 0;
}

template <int D> double search_seconds(const Model<D>& model) {
  double sum = 0;
  for (const auto& contact : model.system.contacts) sum += contact->counters.search_seconds;
  return sum;
}

template <int D> double memory(const Model<D>& model) {
  double bytes = model.system.assembly.memory();
  for (const auto& named : model.system.scene.bodies) bytes += static_cast<double>(named.body->memory());
  for (const contact::Tie<D>& tie : model.system.ties) bytes += tie.memory();
  return bytes;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic>> body_displacement(const Model<D>&, int);         \
  template Vec<D> reaction(const Model<D>&, int);                                                                      \
  template double moment(const Model<D>&, int);                                                                        \
  template std::vector<std::pair<std::string, double>> free_motion(const Model<D>&, int);                              \
  template Vec<D> load_resultant(const Model<D>&, int);                                                                \
  template Energies energies(const Model<D>&);                                                                         \
  template double imbalance(const Model<D>&, int);                                                                     \
  template double search_seconds(const Model<D>&);                                                                     \
  template double memory(const Model<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
