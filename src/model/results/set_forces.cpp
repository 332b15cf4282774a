#include "model/results/set_forces.hpp"

#include <algorithm>

namespace signorini::model {

template <int D> std::vector<PairForce<D>> set_forces(const Model<D>& model, int contact) {
  const Contact<D>& named = model.system.scene.contacts[contact];
  const contact::Formulation<D>& formulation = *model.system.contacts[contact];
  const contact::History<D>& history = model.present.contacts[contact];
  std::vector<int> bodies;
  for (const FaceReference& face : named.slave)
    if (std::ranges::find(bodies, face.body) == bodies.end()) bodies.push_back(face.body);
  std::ranges::sort(bodies);
  std::vector<PairForce<D>> forces;
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = a + 1; b < bodies.size(); ++b) forces.push_back({bodies[a], bodies[b]});

  const double share = formulation.parameters().energy_share(); // half passes compute both forces
  for (const std::size_t i : watched_points(history)) {
    const int element = history.points[i].projection.element;
    if (history.results[i].area == 0 || element < 0) continue;
    const int own = named.slave[formulation.slave().sheet(formulation.points().list[i].element)].body;
    const int other = named.slave[formulation.master().surface()->sheet(element)].body;
    for (PairForce<D>& pair : forces) {
      if (own == pair.first && other == pair.second) pair.force += share * history.results[i].force;
      if (own == pair.second && other == pair.first) pair.force -= share * history.results[i].force;
    }
  }
  return forces;
}

template <int D> double set_imbalance(const Model<D>& model, int contact) {
  Vec<D> sum = Vec<D>::Zero();
  double magnitudes = 0;
  for (const auto& result : model.present.contacts[contact].results) {
    sum += result.force;
    magnitudes += result.force.norm();
  }
  return magnitudes > 0 ? 2 * sum.norm() / magnitudes : 0;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::vector<PairForce<D>> set_forces(const Model<D>&, int);                                                 \
  template double set_imbalance(const Model<D>&, int);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
