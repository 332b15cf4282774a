// First touch of mortar contact: the slip of a step that multipliers leave out because they are open until then
// [theory 7.2].

#include "contact/mortar/mortar_contact.hpp"

namespace signorini::contact {

/// The gap of a point in the accepted state, less its offset there. A point without a foot there has the gap to the
/// plane that touches the master at its present foot, from which it is `now` away.
template <int D> double MortarContact<D>::gap_before(std::size_t i, const Trial<D>& trial, double now) const {
  const Vec<D>&from = trial.accepted.results[i].position, &to = trial.present.results[i].position;
  Projection<D> before = trial.accepted.points[i].projection;
  FacePoint<D> foot, foot_before;
  if (!trial.accepted.points[i].slips) before = faces_.accepted.project(from, before, foot); // not projected there
  if (before.foot != Foot::none) return before.gap - parameters_.offset(i, trial.accepted.changes);
  const Projection<D>& present = trial.present.points[i].projection;
  faces_.master.locate(present, foot);
  faces_.accepted.locate(present, foot_before);
  const Vec<D> way = (from - foot_before.position) - (to - foot.position);
  const Vec<D> out = to - foot.position;
  const Vec<D> normal = present.foot == Foot::regular ? faces_.master.normal(foot) : Vec<D>(out / present.gap);
  return now + parameters_.offset(i, trial.present.changes) - parameters_.offset(i, trial.accepted.changes) +
         normal.dot(way);
}

/// Moves the former feet of the points to where they are at the fraction Σ M_A s*_A of the step, and reduces V*_A by
/// the slip that V_A then lacks: it remains where multipliers with common points touch at different times. Feet deform
/// with the master, which V*_A does not.
template <int D> void MortarContact<D>::move_slip_points(const Trial<D>& trial) {
  FacePoint<D> foot, slip_point;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    PointHistory<D>& point = trial.present.points[i];
    const PointResult<D>& result = trial.present.results[i];
    const int element = points_.list[i].element;
    const auto on = functions_.on(element);
    const double* values = functions_.at_point(i);
    double fraction = 0;
    for (std::size_t a = 0; a < on.size(); ++a) fraction += values[a] * weighted_[on[a]].fraction;
    if (fraction == 0 || element_sums_.skipped(element) || result.beyond || !point.slips) continue;
    const Master<D>& master = faces_.master;
    master.locate(point.projection, foot);
    master.locate(point.slip, slip_point);
    const Vec<D> before = slip_point.position;
    const Projection<D> moved =
        master.project(before + fraction * (foot.position - before), point.projection, slip_point);
    FaceCoordinates<D> rate;
    if (moved.foot == Foot::none) continue;
    point.slip = moved.point();
    const double area = points_.list[i].weight * measure(i, result.position) * master.fade(point.projection.xi, rate);
    for (std::size_t a = 0; a < on.size(); ++a)
      if (const double whole = weighted_[on[a]].sums.area; whole > 0)
        trial.present.multipliers[on[a]].touch -= (values[a] * area / whole) * (slip_point.position - before);
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template double MortarContact<D>::gap_before(std::size_t, const Trial<D>&, double) const;                            \
  template void MortarContact<D>::move_slip_points(const Trial<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
