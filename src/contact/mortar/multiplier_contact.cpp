#include "contact/mortar/multiplier_contact.hpp"

#include "contact/constants.hpp"
#include "contact/mortar/multiplier_rows.hpp"
#include "contact/point/frame.hpp"
#include "contact/point/unfold.hpp"

#include <algorithm>
#include <utility>

namespace signorini::contact {

template <int D>
MultiplierContact<D>::MultiplierContact(ContactSetting<D> setting, const InterfaceLaw& law, MultiplierSpace multipliers,
                                        const UnknownMultipliers& constants)
    : GaussPointContact<D>(setting, law),
      functions_(faces_.slave, points_, setting.points, multipliers, constants.joined), each_(may_rub(law) ? D : 1),
      scale_(constants.scale > 0 ? constants.scale : law.normal),
      couplings_(parts_.size(), CouplingSums<D>(faces_, functions_, each_, scale_)),
      conditions_(faces_.slave.elements()), areas_(functions_.areas(points_)) {}

/// λ at point i, without friction its first component alone.
template <int D> Vec<D> MultiplierContact<D>::multiplier_at(std::size_t i, const double* unknowns) const {
  Vec<D> sum = Vec<D>::Zero();
  const double* values = functions_.at_point(i);
  for (const int a : functions_.on(points_.list[i].element)) {
    for (int k = 0; k < each_; ++k) sum(k) += *values * scale_ * unknowns[a * each_ + k];
    ++values;
  }
  return sum;
}

template <int D> void MultiplierContact<D>::evaluate_part(int index, const Trial<D>& trial, bool tangent) {
  const SumPart<D>& part = parts_[index];
  for (std::size_t i = part.first; i < part.last; ++i)
    if (const int e = points_.list[i].element; i == part.first || points_.list[i - 1].element != e)
      start_conditions(e, tangent);
  GaussPointContact<D>::evaluate_part(index, trial, tangent);
}

/// The block of the conditions of the multipliers on an element, with their proximal terms.
template <int D> void MultiplierContact<D>::start_conditions(int element, bool tangent) {
  Block& block = conditions_[element];
  block.slave_element = block.master_element = block.slip_element = -1;
  block.group = element;
  block.extra.clear();
  for (const int a : functions_.on(element))
    for (int k = 0; k < each_; ++k) block.extra.push_back(a * each_ + k);
  block.rows = block.columns = std::ssize(block.extra);
  block.force.assign(block.rows, 0.0);
  block.matrix.assign(tangent ? block.rows * block.columns : 0, 0.0);
  int row = 0;
  for (const int a : functions_.on(element))
    for (int k = 0; k < each_ && tangent; ++k)
      block.matrix[row++ * (block.columns + 1)] =
          -proximal_contact * scale_ * areas_[a] / static_cast<double>(functions_.support(a).size());
}

/// Multipliers without a contact point are zero.
template <int D> void MultiplierContact<D>::add_unused(const Trial<D>& trial, bool tangent) {
  const double area = scale_ * *std::max_element(areas_.begin(), areas_.end());
  for (int a = 0; a < functions_.count(); ++a) {
    if (areas_[a] > 0) continue;
    Block block{-1, -1};
    block.group = faces_.slave.elements() + a;
    block.rows = block.columns = each_;
    block.matrix.assign(tangent ? each_ * each_ : 0, 0.0);
    for (int k = 0; k < each_; ++k) {
      block.extra.push_back(a * each_ + k);
      block.force.push_back(-area * trial.extra[a * each_ + k]);
      if (tangent) block.matrix[k * (each_ + 1)] = -area;
    }
    this->blocks_.push_back(std::move(block));
  }
}

/// Adds ∫ M_A c dA of a point, with its area per parametric area, and the derivative with respect to χ.
template <int D>
void MultiplierContact<D>::add_condition(std::size_t i, double area, const PointCondition<D>& condition, bool tangent) {
  const int e = points_.list[i].element, count = std::ssize(functions_.on(e));
  Block& block = conditions_[e];
  const double* values = functions_.at_point(i);
  const double w = points_.list[i].weight * area;
  Eigen::Map<RowMajorX> matrix(block.matrix.data(), tangent ? block.rows : 0, tangent ? block.columns : 0);
  for (int a = 0; a < count; ++a) {
    if (values[a] == 0) continue;
    for (int k = 0; k < each_; ++k) block.force[a * each_ + k] += w * values[a] * condition.residual(k);
    for (int b = 0; b < count && tangent; ++b)
      matrix.block(a * each_, b * each_, each_, each_) +=
          (w * values[a] * values[b] * scale_) * condition.of_multiplier.topLeftCorner(each_, each_);
  }
}

template <int D>
void MultiplierContact<D>::evaluate_point(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet) {
  PointHistory<D>& point = trial.present.points[i];
  const Vec<D> multiplier = multiplier_at(i, trial.extra);
  const PointCondition<D> open = open_condition<D>(multiplier, frictional());
  const double reference = points_.list[i].reference_area;
  const FixedContactState state = trial.controls.fixed(static_cast<int>(i));
  const InterfaceLaw& law = *part.law;
  // A point with a pressure is closed up to the gap pressure/ε, and is projected: the weight of its condition depends
  // on whether it is beyond an end.
  const double closed_up_to = multiplier.norm() / law.normal;
  const bool clear = faces_.travel + trial.controls.guessed + closed_up_to < point.cleared &&
                     closed_up_to <= distance_rounding * trial.present.results[i].position.norm();
  if (!parameters_.active(trial.present.changes) || state == FixedContactState::open ||
      (state == FixedContactState::free && clear)) {
    add_condition(i, reference, open, part.tangent);
    return;
  }
  const bool opposite = this->find_foot(i, trial, part, feet);
  const Foot foot = point.projection.foot;
  const double distance = point.projection.gap - parameters_.offset(i, trial.present);
  point.cleared = foot == Foot::regular && feet.foot.settled && distance > 0 ? faces_.travel + distance : 0;
  if (!opposite || (foot != Foot::regular && point.projection.gap == 0)) {
    // Beyond an end the conditions do not count, but keep the system regular.
    add_condition(i, proximal_contact * reference, open, part.tangent);
    return;
  }
  LocalGeometry<D> geometry = this->geometry(i, trial, feet);
  const double pressure = frictional() ? geometry.normal.dot(multiplier) : multiplier(0);
  const auto closed = trial.controls.closed(static_cast<int>(i), distance - pressure / law.normal);
  if (!closed) {
    add_condition(i, reference, open, part.tangent);
    return;
  }
  if (geometry.fade < 1) add_condition(i, proximal_contact * reference, open, part.tangent);
  transmit(i, trial, multiplier, this->closed_geometry(i, trial, law, *closed, feet), part, feet);
}

/// Adds the traction λ + c of a closed point, and its conditions.
template <int D>
void MultiplierContact<D>::transmit(std::size_t i, const Trial<D>& trial, const Vec<D>& multiplier,
                                    const LocalGeometry<D>& geometry, SumPart<D>& part, FootPoints<D>& feet) {
  const Vec<D>& n = geometry.normal;
  LocalForce<D> force;
  const GapRows<D> gap = gap_rows(geometry, force.shift);
  const PointCondition<D> condition = closed_condition(*part.law, geometry, multiplier, frictional(), gap, force.shift);
  const Vec<D> own = multiplier + condition.residual, traction = frictional() ? own : Vec<D>(own(0) * n);
  LocalRow<D> measure_row = LocalRow<D>::Zero();
  force.measure = geometry.reference_measure;
  fade_area(geometry, force.shift, force.measure, measure_row);
  force.state = condition.state;
  force.mu = condition.mu;
  force.flaw = condition.flaw;
  force.worn = condition.worn;
  force.potential = 0;
  force.pressure = n.dot(traction);
  force.friction = force.pressure * n - traction;
  force.stretch = 1;
  force.force = force.measure * traction;
  force.tangent = traction * measure_row;
  if (frictional())
    force.tangent += force.measure * condition.rows;
  else
    force.tangent += force.measure * (n * condition.rows.row(0) + force.pressure * gap.normal);
  this->record(i, trial, geometry, force, part, feet);
  trial.present.results[i].slipped = condition.slipped;
  add_condition(i, force.measure, condition, part.tangent);
  if (!part.tangent) return;
  CoupledPoint<D> coupled{&feet.foot, geometry.slip_point ? &feet.slip_point : nullptr,
                          force.measure * (Mat<D>::Identity() + condition.of_multiplier),
                          force.measure * condition.rows + condition.residual * measure_row};
  if (!frictional()) coupled.direction.col(0) = force.measure * n;
  couplings_[&part - parts_.data()].add(points_, i, coupled);
}

template <int D> void MultiplierContact<D>::gather(const Trial<D>& trial, bool tangent) {
  GaussPointContact<D>::gather(trial, tangent);
  for (CouplingSums<D>& sums : couplings_) sums.hand_over(this->blocks_);
  for (Block& block : conditions_)
    if (!block.extra.empty()) this->blocks_.push_back(std::move(block));
  add_unused(trial, tangent);
}

template <int D> void MultiplierContact<D>::take_back(std::vector<Block>& blocks) {
  auto block = blocks.begin();
  for (SumPart<D>& part : parts_) part.sums.take_back(block);
  for (CouplingSums<D>& sums : couplings_) sums.take_back(block);
  for (; block != blocks.end(); ++block)
    if (block->group < faces_.slave.elements()) conditions_[block->group] = std::move(*block);
  blocks.clear();
}

/// The slip point after a slip in the plane normal to n̄, in which it is exact although the master is curved.
template <int D>
MasterPoint<D> MultiplierContact<D>::slipped_to(const PointHistory<D>& point, const Vec<D>& slip) const {
  const Master<D>& master = faces_.master;
  FacePoint<D> foot, found;
  master.locate(point.projection, foot);
  locate_slip(faces_, point.slip, foot, found);
  const Vec<D> goal = found.position + slip;
  return master.along_normal(goal, master.normal(foot), point.projection);
}

/// The direction in which a point slips: that of its friction or, with an ellipse, of its normal (t_i/μ_i²).
template <int D>
Vec<D> MultiplierContact<D>::slip_direction(std::size_t i, const PointHistory<D>& point,
                                            const PointResult<D>& result) const {
  if constexpr (D == 3)
    if (const auto& ellipse = parameters_.law->ellipse) {
      FacePoint<D> foot;
      faces_.master.locate(point.projection, foot);
      const Vec<D> along = result.tangents * points_.axis(i);
      const Frame<D> frame = frame_of<D>(contact_normal(faces_.master, point.projection, foot, result.position), along);
      const Vec<2> normal = (frame.axes.transpose() * result.friction).cwiseQuotient(ellipse->cwiseAbs2());
      return (frame.axes * normal).normalized();
    }
  return result.friction.normalized();
}

/// Sums the work of friction, ∫ μ p dγ by the trapezoidal rule. A point that slipped gets the slip point with which its
/// trial friction y is on Coulomb's cone: its friction does not change while nothing moves.
template <int D>
void MultiplierContact<D>::commit(History<D>& present, const History<D>& accepted, double penalty_factor) {
  const double friction = parameters_.friction(present.changes), before = parameters_.friction(accepted.changes);
  for (std::size_t i = 0; i < points_.size() && frictional(); ++i) {
    PointHistory<D>& point = present.points[i];
    const PointResult<D>&result = present.results[i], &last = accepted.results[i];
    const bool closed = touches(result.state);
    const double limit = closed ? result.mu * std::max(0.0, result.pressure) * result.area : 0;
    if (!closed || !point.slips || limit == 0) {
      point.slip = point.projection.point();
    } else if (result.state == ContactState::slip) {
      const double before_slip = limit_before(point.limit, before, friction, last.friction.norm() * last.area);
      present.dissipated += 0.5 * (before_slip + limit) * result.slipped;
      point.slip = slipped_to(point, result.slipped * slip_direction(i, point, result));
    }
    point.slips = closed;
    point.limit = limit;
    add_slip(point, result.state, result.slipped);
  }
  this->accept(present, accepted, penalty_factor);
}

template <int D> double MultiplierContact<D>::memory() const {
  return GaussPointContact<D>::memory() + functions_.memory();
}

template class MultiplierContact<2>;
template class MultiplierContact<3>;

} // namespace signorini::contact
