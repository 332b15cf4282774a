// From one accepted step to the next: slip points, and the rules of elements.

#include "contact/gauss/gauss_point_contact.hpp"
#include "contact/gauss/history_transfer.hpp"
#include "contact/gauss/set_points.hpp"
#include "contact/point/point_choice.hpp"
#include "contact/point/unfold.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

template <int D>
void GaussPointContact<D>::commit(History<D>& present, const History<D>& accepted, double penalty_factor) {
  const InterfaceLaw law = parameters_.law_in(present.changes, penalty_factor);
  place_others(present);
  if (slides(law))
    for (const std::size_t i : watched_points(present)) advance_slip_point(i, present, accepted, law);
  else if (may_rub(*parameters_.law))
    release(present, accepted, parameters_.law_in(accepted.changes, penalty_factor).tangential);
  accept(present, accepted, penalty_factor);
}

/// Writes the positions of points that are not watched, which evaluations leave out.
template <int D> void GaussPointContact<D>::place_others(History<D>& present) const {
  for (std::size_t e = 0; e + 1 < points_.starts.size(); ++e) {
    if (is_watched(present, points_.starts[e])) continue;
    for (std::size_t i = points_.starts[e]; i < points_.starts[e + 1]; ++i)
      if (acts(points_, present, i)) present.results[i].position = position(points_, faces_.slave, i);
  }
}

/// Friction that a path switches off leaves no slip points: later friction starts at the foot points of its time. Its
/// springs' energy is dissipated.
template <int D>
void GaussPointContact<D>::release(History<D>& present, const History<D>& accepted, double tangential) const {
  for (const std::size_t i : watched_points(present)) {
    PointHistory<D>& point = present.points[i];
    const PointResult<D>& before = accepted.results[i];
    // A friction t on a fraction d of the area: d (t/d)²/(2 ε_T)
    const double friction = friction_of(accepted, i).norm() * stretch(before), fraction = rubbing(accepted, i);
    if (friction > 0)
      present.dissipated +=
          parameters_.energy_share() * before.law_area * friction * friction / (2 * tangential * fraction);
    point.slips = false;
    point.limit = point.slipped = point.recent = 0;
  }
}

/// Updates a point's slip point at the end of an accepted step.
template <int D>
void GaussPointContact<D>::advance_slip_point(std::size_t i, History<D>& history, const History<D>& accepted,
                                              const InterfaceLaw& law) const {
  const Master<D>& master = faces_.master;
  PointHistory<D>& point = history.points[i];
  PointResult<D>& result = history.results[i];
  const PointResult<D>& last = accepted.results[i];
  const double limit = rubbing(history, i) * result.mu * pressure_of(history, i) * result.area;
  const double before_slip = limit_before(point.limit, parameters_.friction(accepted.changes), law.friction,
                                          friction_of(accepted, i).norm() * last.area);
  point.limit = limit;
  double slip_of_step = 0;
  if (!touches(result.state)) {
    point.slips = false;
  } else if (!point.slips) {
    // The point was beyond the master's end before: friction starts at its present foot point.
    point.slips = true;
    point.slip = point.projection.point();
  } else if (result.state == ContactState::slip) {
    FacePoint<D> foot, slip_point;
    master.locate(point.projection.point(), foot);
    locate_slip(faces_, point.slip, foot, slip_point);
    const double before = (slip_point.position - foot.position).norm();
    double error = 0; // of the new slip point
    if (law.along) {
      // In the plane normal to n̄, x̄ᵐ − xᵐ(ξ_sl) decreases to t/ε_T; the difference is the slip.
      FacePoint<D> closest;
      master.locate(point.projection, closest);
      const Vec<D> n = contact_normal(master, point.projection, closest, result.position);
      const Vec<D> elastic = friction_of(history, i) * stretch(result) / law.tangential;
      const auto slip_from = [&](const Vec<D>& place) -> Vec<D> {
        const Vec<D> chord = foot.position - place;
        return chord - n.dot(chord) * n - elastic;
      };
      slip_of_step = slip_from(slip_point.position).norm();
      point.slip = master.along_normal(foot.position - elastic, n, point.projection, lookout(faces_, points_, i));
      locate_slip(faces_, point.slip, foot, slip_point);
      error = slip_from(slip_point.position).norm();
    } else {
      // |x̄ᵐ − xᵐ(ξ_sl)| decreases to μ t_N/ε_T; the difference is the slip Δγ.
      const double length = result.mu * pressure_of(history, i) * stretch(result) / law.tangential;
      slip_of_step = std::max(before - length, 0.0);
      point.slip = master.advance(point.slip, foot, length);
      error = std::abs(way_length(master, foot, point.slip) - length);
    }
    history.dissipated += parameters_.energy_share() * 0.5 * (before_slip + limit) * slip_of_step;
    // Distances are differences of positions, whose rounding errors exceed the tolerance where springs are very short.
    const double rounding = distance_rounding * (foot.position.norm() + slip_point.position.norm());
    if (slip_of_step > 0 && error > slip_tolerance * before + rounding) result.settled = false;
  }
  add_slip(point, result.state, slip_of_step);
}

/// Adds what the points have worn in an accepted step.
template <int D> void GaussPointContact<D>::wear(History<D>& present, const History<D>& accepted) const {
  const double share = parameters_.energy_share();
  for (const std::size_t i : watched_points(present)) {
    const PointResult<D>& result = present.results[i];
    const double before = pressure_of(accepted, i) * accepted.results[i].area;
    present.worn_volume += share * result.area * result.worn;
    present.wear += share * 0.5 * (before + pressure_of(present, i) * result.area) * result.worn;
    present.points[i].worn += result.worn;
  }
}

/// Evaluates the results of points at the displacements evaluated last, where the accepted state equals `present`.
template <int D>
void GaussPointContact<D>::evaluate_points(History<D>& present, const std::vector<std::size_t>& points,
                                           double penalty_factor) {
  const Controls controls;
  const Trial<D> trial{present, present, controls, penalty_factor};
  FootPoints<D> feet;
  const InterfaceLaw law = parameters_.law_in(present.changes, penalty_factor);
  std::optional<SumPart<D>> part; // of one element; its forces are not used
  int element = -1;
  for (const std::size_t i : points) {
    if (points_.list[i].element != element)
      part.emplace(
          SumPart<D>{.first = 0, .last = 0, .sums = {faces_.slave, faces_.master, parameters_.pass}, .law = law});
    element = points_.list[i].element;
    present.results[i] = {};
    present.results[i].position = position(points_, faces_.slave, i);
    evaluate_point(i, trial, *part, feet);
  }
}

template <int D>
void GaussPointContact<D>::accept(History<D>& present, const History<D>& accepted, double penalty_factor) {
  if (parameters_.wears()) wear(present, accepted);
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
      present.growth -= potential(*this, present, i);
      present.points[i] = {};
      present.results[i] = {};
    }
    all.insert(all.end(), after.begin(), after.end());
  }
  present.sparse = sparse;
  if (!all.empty()) watch_all(present);
  evaluate_points(present, all, penalty_factor);
  for (const std::size_t i : all) present.growth += potential(*this, present, i);
}

/// True if one of some open points is nearer to contact than a distance. Where its bound does not tell, the point is
/// projected, so that the answer depends on the state alone: not on what a bound has been spent on, nor on a save.
template <int D>
bool GaussPointContact<D>::is_near(const History<D>& present, std::span<const std::size_t> points,
                                   double distance) const {
  if (faces_.master.set() && is_far(*this, points_.list[points.front()].element, present, distance)) return false;
  FacePoint<D> foot;
  return std::any_of(points.begin(), points.end(), [&](std::size_t i) {
    const PointHistory<D>& point = present.points[i];
    if (point.cleared - faces_.travel >= distance) return false;
    const Projection<D> closest =
        faces_.master.project(present.results[i].position, point.projection, foot, lookout(faces_, points_, i));
    // The sign at an end or a kink does not matter: contact is |g| away.
    const double gap = closest.foot == Foot::regular ? closest.gap : std::abs(closest.gap);
    return gap - parameters_.offset(i, present) < distance;
  });
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template void GaussPointContact<D>::commit(History<D>&, const History<D>&, double);                                  \
  template void GaussPointContact<D>::accept(History<D>&, const History<D>&, double);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
