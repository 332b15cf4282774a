#include "contact/gauss/gauss_point_contact.hpp"

#include "os/timer.hpp"

#include <optional>
#include <utility>

namespace signorini::contact {

template <int D>
GaussPointContact<D>::GaussPointContact(ContactSetting<D> setting, Pass pass)
    : Formulation<D>(std::move(setting)), pass_(pass) {
  for (const auto& [first, last] : pieces(this->points_))
    parts_.push_back({first, last, BlockSums<D>(this->slave(), this->master(), pass)});
}

template <int D> void GaussPointContact<D>::evaluate_part(int index, const Trial<D>& trial, bool tangent) {
  Part& part = parts_[index];
  part.tangent = tangent;
  Feet feet;
  for (std::size_t i = part.first; i < part.last; ++i) {
    const auto& list = this->points_.list;
    if (i > part.first && list[i].element != list[i - 1].element) part.sums.close_element(tangent);
    if (!acts(this->points_, trial.present, i)) continue;
    PointResult<D>& result = trial.present.results[i];
    result = {};
    result.position = position(this->points_, this->slave(), i);
    evaluate_point(i, trial, part, feet);
  }
  part.sums.close_element(tangent);
}

template <int D>
void GaussPointContact<D>::evaluate_points(History<D>& present, const std::vector<std::size_t>& points,
                                           double penalty_factor) {
  const Controls controls;
  const Trial<D> trial{present, present, controls, penalty_factor};
  Feet feet;
  std::optional<Part> part; // of one element; its forces are not used
  int element = -1;
  for (const std::size_t i : points) {
    if (this->points_.list[i].element != element)
      part.emplace(Part{0, 0, BlockSums<D>(this->slave(), this->master(), pass_)});
    element = this->points_.list[i].element;
    present.results[i] = {};
    present.results[i].position = position(this->points_, this->slave(), i);
    evaluate_point(i, trial, *part, feet);
  }
}

template <int D>
bool GaussPointContact<D>::find_foot(std::size_t i, const Trial<D>& trial, Part& part, Feet& at) const {
  PointResult<D>& result = trial.present.results[i];
  Projection<D>& projection = trial.present.points[i].projection;
  at.foot.settled = true;
  {
    const ScopedTimer timer(this->times_search_ ? &part.search_seconds : nullptr);
    projection = this->master().project(result.position, projection, at.foot);
  }
  result.beyond = projection.foot == Foot::none;
  result.settled = at.foot.settled;
  return !result.beyond;
}

template <int D> LocalGeometry<D> GaussPointContact<D>::geometry(std::size_t i, const Trial<D>& trial, Feet& at) const {
  this->master().functions(at.foot, 1);
  LocalGeometry<D> geometry =
      point_geometry(this->points_, i, this->slave(), this->master(), trial.present.results[i].position,
                     trial.present.points[i].projection, at.foot);
  geometry.offset = this->offset(i, trial.present);
  return geometry;
}

template <int D>
void GaussPointContact<D>::record(std::size_t i, const Trial<D>& trial, const LocalGeometry<D>& geometry,
                                  const LocalForce<D>& force, Part& part, const Feet& at) const {
  PointResult<D>& result = trial.present.results[i];
  const double weight = this->points_.list[i].weight;
  result.state = force.state;
  result.gap = geometry.gap - geometry.offset;
  // Cauchy tractions, whatever the area on which the law's act: t da = T dA
  result.pressure = force.pressure / force.stretch;
  for (int k = 0; k < D - 1; ++k) result.tangents.col(k) = geometry.slave_tangent[k];
  result.friction = force.friction / force.stretch;
  result.force = weight * force.force;
  result.law_area = weight * force.measure;
  result.area = result.law_area * force.stretch;
  result.potential = energy_share(pass_) * result.law_area * force.potential;
  part.sums.add(this->points_, i, at.foot, geometry.slip_point ? &at.slip_point : nullptr, force, part.tangent);
}

template <int D> void GaussPointContact<D>::gather(const Trial<D>&, bool) {
  for (Part& part : parts_) {
    part.blocks = part.sums.hand_over(this->blocks_);
    this->search_seconds_ += std::exchange(part.search_seconds, 0);
  }
}

template <int D> void GaussPointContact<D>::take_back(std::vector<Block>& blocks) {
  auto block = blocks.begin();
  for (Part& part : parts_)
    for (; part.blocks > 0; --part.blocks) part.sums.recycle(std::move(*block++));
  blocks.clear();
}

template <int D> double GaussPointContact<D>::memory() const {
  double sum = Formulation<D>::memory();
  for (const Part& part : parts_) sum += part.sums.memory();
  return sum;
}

template class GaussPointContact<2>;
template class GaussPointContact<3>;

} // namespace signorini::contact
