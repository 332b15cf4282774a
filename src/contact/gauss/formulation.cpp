#include "contact/gauss/formulation.hpp"

#include "contact/gauss/history_transfer.hpp"
#include "contact/point/crossing.hpp"
#include "contact/point/point_choice.hpp"
#include "os/timer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::contact {

template <int D>
Formulation<D>::Formulation(ContactSetting<D> setting)
    : slave_(std::move(setting.slave)), master_(std::move(setting.master)), accepted_master_(master_),
      points_(slave_, setting.points, setting.revolved, setting.where,
              setting.adaptive ? (2 * setting.points + 2) / 3 : 0),
      start_(setting.start) {
  if (!start_.interference) return;
  for (const double gap : gaps(History<D>(points_))) overlap_.push_back(std::max(0.0, -gap));
}

template <int D> void Formulation<D>::move(const double* slave_displacement, const double* master_displacement) {
  travel_ += slave_.move(slave_displacement);
  double master_moved;
  {
    const ScopedTimer timer(times_search_ ? &search_seconds_ : nullptr);
    master_moved = master_.move(master_displacement, slave_.points());
  }
  travel_ += master_moved;
  take_back(blocks_);
}

template <int D> void Formulation<D>::return_to_accepted() {
  accepted_master_ = master_;
}

template <int D> void Formulation<D>::append_slave(int element, std::vector<int>& dofs) const {
  const int* nodes = slave().nodes(element);
  for (int a = 0; a < slave().functions_on(element); ++a)
    for (int c = 0; c < D; ++c) dofs.push_back(D * slave().body_function(nodes[a]) + c);
}

template <int D>
void Formulation<D>::append_master(int element, const Offsets& offsets, std::vector<int>& dofs, bool and_next) const {
  if (master().rigid()) {
    for (int c = 0; c < D * master().functions_on(0); ++c) dofs.push_back(offsets.master + c);
    return;
  }
  const Surface<D>& face = *master().surface();
  const int* nodes = face.nodes(element);
  for (int a = 0; a < face.functions_on(element); ++a)
    for (int c = 0; c < D; ++c) dofs.push_back(offsets.master + D * face.body_function(nodes[a]) + c);
  for (int alpha = 0; alpha < D - 1 && and_next; ++alpha)
    for (bool at_end : {false, true})
      if (const int next = face.neighbor(element, alpha, at_end); next >= 0) append_master(next, offsets, dofs);
}

template <int D>
void Formulation<D>::append_dofs(const Block& block, const Offsets& offsets, std::vector<int>& dofs) const {
  if (block.group >= 0) {
    for (const int node : block.slave_nodes)
      for (int c = 0; c < D; ++c) dofs.push_back(D * slave().body_function(node) + c);
    for (const int node : block.master_nodes)
      for (int c = 0; c < D; ++c)
        dofs.push_back(offsets.master + D * (master().rigid() ? node : master().surface()->body_function(node)) + c);
    for (const int number : block.extra) dofs.push_back(offsets.extra + number);
    return;
  }
  append_slave(block.slave_element, dofs);
  append_master(block.master_element, offsets, dofs);
  for (const int number : block.extra) dofs.push_back(offsets.extra + number);
  if (block.slip_element >= 0) append_master(block.slip_element, offsets, dofs);
}

template <int D> void Formulation<D>::commit(History<D>& present, const History<D>& accepted, double penalty_factor) {
  commit_points(present, accepted, penalty_factor);
  const double master_moved = master_.moved_since(accepted_master_, slave_.points());
  double farthest = 0; // by which a point of the slave has approached the master
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!acts(points_, present, i)) continue;
    const PointResult<D>&before = accepted.results[i], &after = present.results[i];
    present.growth += growth(before, after);
    present.offset_work += share() * 0.5 * (before.pressure * before.area + after.pressure * after.area) *
                           (offset(i, present) - offset(i, accepted));
    if (!present.results[i].settled) unsettled_ = {unsettled_.count + 1, points_.reference[i]};
    farthest = std::max(farthest, (after.position - before.position).norm() + master_moved);
  }
  for (std::size_t a = 0; a < present.multipliers.size(); ++a)
    present.growth += growth(accepted.multiplier_results[a], present.multiplier_results[a]);
  return_to_accepted();
  if (points_.sparse > 0) choose_points(present, farthest, penalty_factor);
}

/// Changes the rules of elements for the next step. Points that begin to act take over histories and are evaluated;
/// the energy of springs changes by the error of quadrature, which counts as growth.
template <int D> void Formulation<D>::choose_points(History<D>& present, double moved, double penalty_factor) {
  const std::vector<char> sparse =
      choose_sparse(points_, slave_, present, moved, [&](std::span<const std::size_t> open, double distance) {
        return is_near(present, open, distance, penalty_factor);
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

/// Whether one of some open points is nearer to contact than a distance. Where its bound does not tell, the point is
/// projected, so that the answer depends on the state alone: not on what a bound has been spent on, nor on a save.
template <int D>
bool Formulation<D>::is_near(const History<D>& present, std::span<const std::size_t> points, double distance,
                             double penalty_factor) const {
  FacePoint<D> foot;
  return std::any_of(points.begin(), points.end(), [&](std::size_t i) {
    const PointHistory<D>& point = present.points[i];
    if (point.cleared - travel_ >= distance) return false;
    const Projection<D> closest = master_.project(present.results[i].position, point.projection, foot);
    // The sign at an end or a kink does not matter: contact is |g| away. t_N > 0 below a gap of o + λ_N/ε_N
    const double gap = closest.foot == Foot::regular ? closest.gap : std::abs(closest.gap);
    return gap - offset(i, present) - point.multiplier / (penalty_factor * penalty(present)) < distance;
  });
}

template <int D> std::vector<int> Formulation<D>::crossed(const History<D>& present, const History<D>& accepted) const {
  std::vector<int> numbers;
  const double master_moved = master_.moved_since(accepted_master_, slave_.points());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double moved = (present.results[i].position - accepted.results[i].position).norm() + master_moved;
    if (acts(points_, present, i) && has_crossed(i, present, accepted, moved)) numbers.push_back(static_cast<int>(i));
  }
  return numbers;
}

/// Whether a point of an active contact has passed through the master since the accepted state, when it came closer to
/// it by at most `moved`. Points at a larger distance need no test.
template <int D>
bool Formulation<D>::has_crossed(std::size_t i, const History<D>& present, const History<D>& accepted,
                                 double moved) const {
  const PointHistory<D>& point = present.points[i];
  const PointResult<D>& result = present.results[i];
  if (!active(present) || !active(accepted)) return false;
  const double touching = offset(i, present);
  const double least = point.cleared > 0 ? point.cleared - travel_ + touching : point.projection.gap; // distance
  if (moved <= 0 || least > moved || result.beyond) return false;
  if (result.state == ContactState::stick || result.state == ContactState::slip) return false;
  const Vec<D> outward = slave().outward(tangents(points_, slave(), i)).normalized();
  return contact::has_crossed(accepted_master_, master_, accepted.results[i].position, result.position, outward,
                              point.projection, std::min(0.0, touching));
}

template <int D> void Formulation<D>::settle(History<D>& accepted) {
  travel_ = 0;
  return_to_accepted();
  look_everywhere(accepted);
  for (std::size_t i = 0; i < points_.size(); ++i) accepted.results[i].position = position(points_, slave(), i);
}

template <int D> std::vector<double> Formulation<D>::gaps(const History<D>& history) const {
  std::vector<double> gaps;
  FacePoint<D> foot;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Projection<D> found = master().project(history.results[i].position, history.points[i].projection, foot);
    // Beyond an open end the distance has no sign.
    gaps.push_back((found.foot == Foot::none ? std::abs(found.gap) : found.gap) - offset(i, history));
  }
  return gaps;
}

template <int D> double Formulation<D>::memory() const {
  const auto bytes = [](const auto& list) { return static_cast<double>(list.capacity() * sizeof(list[0])); };
  double sum = bytes(points_.list) + bytes(points_.values) + bytes(points_.reference) + bytes(blocks_);
  for (const Block& block : blocks_) sum += bytes(block.force) + bytes(block.matrix);
  return sum;
}

template class Formulation<2>;
template class Formulation<3>;

} // namespace signorini::contact
