#include "model/system/dofs.hpp"

#include "model/scene/turning.hpp"

#include <utility>

namespace signorini::model {

template <int D>
Dofs<D>::Dofs(const Scene<D>& scene, const contact::Formulations<D>& contacts, const contact::Ties<D>& ties) {
  for (const auto& named : scene.bodies) offsets_.push_back(std::exchange(dofs_, dofs_ + D * named.body->functions()));
  obstacles_ = dofs_;
  for (int k = 0; k < std::ssize(scene.obstacles); ++k) {
    obstacle_offsets_.push_back(std::exchange(dofs_, dofs_ + D));
    const auto turn = turn_of(scene, k);
    if (!turn) continue;
    if (turn->free) free_angles_.push_back({k, dofs_ + D * D, dofs_, turn->axis, turn->turning.arm});
    dofs_ += D * (turn->free ? D + 1 : D);
  }
  displacements_ = dofs_;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto* obstacle = std::get_if<ObstacleReference>(&scene.contacts[k].master);
    of_contacts_.push_back({obstacle ? obstacle_offset(obstacle->obstacle) : 0, dofs_});
    dofs_ += contacts[k]->extra_unknowns();
  }
  for (const contact::Tie<D>& tie : ties) of_ties_.push_back(std::exchange(dofs_, dofs_ + tie.multipliers()));
}

template <int D> Vec<D> Dofs<D>::resultant(const VectorX& values) const {
  if (obstacle_offsets_.empty()) return values.head(displacements_).reshaped(D, Eigen::AutoSize).rowwise().sum();
  Vec<D> sum = values.head(obstacles_).reshaped(D, Eigen::AutoSize).rowwise().sum();
  for (const int translation : obstacle_offsets_) sum += values.template segment<D>(translation);
  return sum;
}

template class Dofs<2>;
template class Dofs<3>;

} // namespace signorini::model
