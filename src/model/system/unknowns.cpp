#include "model/system/unknowns.hpp"

#include "model/scene/contact_faces.hpp"
#include "model/scene/supports.hpp"
#include "model/scene/turning.hpp"

#include <algorithm>
#include <numeric>
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

namespace {

/// By degree of freedom of the displacements: index of the support that constrains or frees it; −1: none.
template <int D> std::vector<int> supports_of(const Scene<D>& scene, const Unknowns<D>& unknowns) {
  std::vector<int> result(unknowns.displacements(), -1);
  for (int s = 0; s < std::ssize(scene.supports); ++s)
    for (int c = 0; c < D; ++c)
      for (const int dof : unknowns.of_support(s, c))
        if (constrains(scene.supports[s], c, dof >= unknowns.obstacles())) result[dof] = s;
  return result;
}

} // namespace

template <int D>
Unknowns<D>::Unknowns(const Scene<D>& scene, const contact::Formulations<D>& contacts, const contact::Ties<D>& ties)
    : Dofs<D>(scene, contacts, ties), unknown_(this->dofs(), -1), constrained_(this->dofs(), false) {
  const Groups shared = coincident_points(scene);
  const int control_points = this->obstacles() / D;
  for (const std::vector<int>& points : supported_points(scene, shared))
    for (int c = 0; c < D; ++c) {
      std::vector<int>& list = of_support_.emplace_back();
      for (const int p : points)
        list.push_back((p < control_points ? D * p : this->obstacle_offset(p - control_points)) + c);
    }
  const std::vector<int> support_of = supports_of(scene, *this);
  std::vector<std::array<int, D>> translation(scene.supports.size()); // unknowns of rotating supports
  for (auto& list : translation) list.fill(-1);
  for (int dof = 0; dof < this->displacements(); ++dof) {
    const int s = support_of[dof], c = dof % D; // every body and obstacle has D components per control point
    const bool free = s < 0 || scene.supports[s].constraint[c] == Constraint::free;
    if (dof >= this->obstacles()) {
      constrained_[dof] = s < 0 || !free;
      if (!constrained_[dof]) unknown_[dof] = size_++;
      continue;
    }
    constrained_[dof] = s >= 0;
    if (!free) continue;
    const int first = D * shared.leader(dof / D) + c;
    int& own = s >= 0 ? translation[s][c] : unknown_[first];
    if (own < 0) own = size_++;
    unknown_[dof] = own;
  }
  for (const FreeAngle<D>& angle : this->free_angles()) {
    unknown_[angle.dof] = size_++;
    std::fill_n(constrained_.begin() + angle.markers, D * D + 1, false);
  }
  free_displacements_ = size_;
  std::iota(unknown_.begin() + this->displacements(), unknown_.end(), size_);
  size_ += this->dofs() - this->displacements();
  if (!this->free_angles().empty()) independent_ = unknown_;
  for (const FreeAngle<D>& angle : this->free_angles())
    std::fill_n(independent_.begin() + angle.markers, D * D, unknown(angle.dof));
}

template <int D> VectorX Unknowns<D>::gather(const VectorX& values) const {
  VectorX sums = VectorX::Zero(size_);
  for (int dof = 0; dof < this->dofs(); ++dof)
    if (const int i = unknown(dof); i >= 0) sums(i) += values(dof);
  return sums;
}

template <int D> VectorX Unknowns<D>::spread(const VectorX& values) const {
  VectorX all(this->dofs());
  for (int dof = 0; dof < this->dofs(); ++dof) {
    const int i = unknown(dof);
    all(dof) = i < 0 ? 0.0 : values(i);
  }
  return all;
}

template <int D> double Unknowns<D>::constrained_norm(const VectorX& values) const {
  double sum = 0;
  for (int dof = 0; dof < this->displacements(); ++dof)
    if (constrained(dof)) sum += values(dof) * values(dof);
  return std::sqrt(sum);
}

template class Dofs<2>;
template class Dofs<3>;
template class Unknowns<2>;
template class Unknowns<3>;

} // namespace signorini::model
