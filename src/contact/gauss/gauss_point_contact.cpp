#include "contact/gauss/gauss_point_contact.hpp"

#include "contact/gauss/history_transfer.hpp"
#include "contact/point/point_choice.hpp"
#include "os/timer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace signorini::contact {

template <int D> void GaussPointContact<D>::evaluate_part(int index, const Trial<D>& trial, bool tangent) {
  SumPart<D>& part = parts_[index];
  part.tangent = tangent;
  FootPoints<D> feet;
  for (std::size_t i = part.first; i < part.last; ++i) {
    if (i > part.first && points_.list[i].element != points_.list[i - 1].element) part.sums.close_element(tangent);
    if (!acts(points_, trial.present, i)) continue;
    PointResult<D>& result = trial.present.results[i];
    result = {};
    result.position = position(points_, faces_.slave, i);
    evaluate_point(i, trial, part, feet);
  }
  part.sums.close_element(tangent);
}

/// Evaluates the results of points at the displacements evaluated last, where the accepted state equals `present`.
template <int D>
void GaussPointContact<D>::evaluate_points(History<D>& present, const std::vector<std::size_t>& points,
                                           double penalty_factor) {
  const Controls controls;
  const Trial<D> trial{present, present, controls, penalty_factor};
  FootPoints<D> feet;
  std::optional<SumPart<D>> part; // of one element; its forces are not used
  int element = -1;
  for (const std::size_t i : points) {
    if (points_.list[i].element != element)
      part.emplace(SumPart<D>{0, 0, BlockSums<D>(faces_.slave, faces_.master, parameters_.pass)});
    element = points_.list[i].element;
    present.results[i] = {};
    present.results[i].position = position(points_, faces_.slave, i);
    evaluate_point(i, trial, *part, feet);
  }
}

template <int D>
bool GaussPointContact<D>::find_foot(std::size_t i, const Trial<D>& trial, SumPart<D>& part,
                                     FootPoints<D>& feet) const {
  const ScopedTimer timer(this->counters.times_search ? &part.search_seconds : nullptr);
  return contact::find_foot(faces_.master, trial.present.points[i], trial.present.results[i], feet.foot);
}

template <int D>
LocalGeometry<D> GaussPointContact<D>::geometry(std::size_t i, const Trial<D>& trial, FootPoints<D>& feet) const {
  faces_.master.functions(feet.foot, 1);
  LocalGeometry<D> geometry = point_geometry(points_, i, faces_, trial.present.results[i].position,
                                             trial.present.points[i].projection, feet.foot);
  geometry.offset = parameters_.offset(i, trial.present.changes);
  return geometry;
}

template <int D>
void GaussPointContact<D>::record(std::size_t i, const Trial<D>& trial, const LocalGeometry<D>& geometry,
                                  const LocalForce<D>& force, SumPart<D>& part, const FootPoints<D>& feet) const {
  PointResult<D>& result = trial.present.results[i];
  const double weight = points_.list[i].weight;
  result.state = force.state;
  result.gap = geometry.gap - geometry.offset;
  // Cauchy tractions, whatever the area on which the law's act: t da = T dA
  result.pressure = force.pressure / force.stretch;
  for (int k = 0; k < D - 1; ++k) result.tangents.col(k) = geometry.slave_tangent[k];
  result.friction = force.friction / force.stretch;
  result.force = weight * force.force;
  result.law_area = weight * force.measure;
  result.area = result.law_area * force.stretch;
  result.potential = parameters_.energy_share() * result.law_area * force.potential;
  part.sums.add(points_, i, feet.foot, geometry.slip_point ? &feet.slip_point : nullptr, force, part.tangent);
}

template <int D> void GaussPointContact<D>::gather(const Trial<D>&, bool) {
  hand_over(parts_, this->blocks_, this->counters.search_seconds);
}

template <int D> void GaussPointContact<D>::take_back(std::vector<Block>& blocks) {
  auto block = blocks.begin();
  for (SumPart<D>& part : parts_) part.sums.take_back(block);
  blocks.clear();
}

template <int D>
void GaussPointContact<D>::commit(History<D>& present, const History<D>& accepted, double penalty_factor) {
  double farthest = 0; // by which a point of the slave has approached the master
  const double master_moved = points_.sparse > 0 ? faces_.master_moved() : 0;
  for (std::size_t i = 0; i < points_.size() && points_.sparse > 0; ++i)
    if (acts(points_, present, i))
      farthest = std::max(farthest, (present.results[i].position - accepted.results[i].position).norm() + master_moved);
  Formulation<D>::commit(present, accepted, penalty_factor);
  if (points_.sparse > 0) choose_points(present, farthest, penalty_factor);
}

/// Changes the rules of elements for the next step. Points that begin to act take over histories and are evaluated;
/// the energy of springs changes by the error of quadrature, which counts as growth.
template <int D> void GaussPointContact<D>::choose_points(History<D>& present, double moved, double penalty_factor) {
  const std::vector<char> sparse =
      choose_sparse(points_, faces_.slave, present, moved, [&](std::span<const std::size_t> open, double distance) {
        return is_near(present, open, distance);
      });
  std::vector<std::size_t> all;
  for (std::size_t first = 0, last; first < points_.size(); first = last) {
    const int e = points_.list[first].element;
    std::vector<std::size_t> before, after;
    for (last = first; last < points_.size() && points_.list[last].element == e; ++last)
      (acts(points_, present, last) ? before : after).push_back(last);
    if (sparse[e] == present.sparse[e]) continue;
    recall(memories<D>(*this, present, before), *this, after, present);
    for (const std::size_t i : before) {
      present.growth -= present.results[i].potential;
      present.points[i] = {};
      present.results[i] = {};
    }
    all.insert(all.end(), after.begin(), after.end());
  }
  present.sparse = sparse;
  evaluate_points(present, all, penalty_factor);
  for (const std::size_t i : all) present.growth += present.results[i].potential;
}

/// True if one of some open points is nearer to contact than a distance. Where its bound does not tell, the point is
/// projected, so that the answer depends on the state alone: not on what a bound has been spent on, nor on a save.
template <int D>
bool GaussPointContact<D>::is_near(const History<D>& present, std::span<const std::size_t> points,
                                   double distance) const {
  FacePoint<D> foot;
  return std::any_of(points.begin(), points.end(), [&](std::size_t i) {
    const PointHistory<D>& point = present.points[i];
    if (point.cleared - faces_.travel >= distance) return false;
    const Projection<D> closest = faces_.master.project(present.results[i].position, point.projection, foot);
    // The sign at an end or a kink does not matter: contact is |g| away.
    const double gap = closest.foot == Foot::regular ? closest.gap : std::abs(closest.gap);
    return gap - parameters_.offset(i, present.changes) < distance;
  });
}

template <int D> double GaussPointContact<D>::memory() const {
  double sum = Formulation<D>::memory();
  for (const SumPart<D>& part : parts_) sum += part.sums.memory();
  return sum;
}

template class GaussPointContact<2>;
template class GaussPointContact<3>;

} // namespace signorini::contact
