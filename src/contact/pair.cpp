#include "contact/pair.hpp"

#include "base/error.hpp"
#include "base/timer.hpp"
#include "contact/crossing.hpp"
#include "solid/quadrature.hpp"

#include <algorithm>
#include <utility>

namespace signorini::contact {

namespace {

constexpr double slip_tolerance = 1e-6; ///< how far a slip point may be off the cone, in parts of its trial distance

void check(const PenaltyLaw& law) {
  require(law.normal > 0, "penalty must be positive (pressure per length), got ", law.normal);
  require(law.friction >= 0, "friction: mu must not be negative, got ", law.friction);
  require(law.friction == 0 || law.tangential > 0, "friction: penalty must be positive (pressure per length), got ",
          law.tangential);
}

} // namespace

template <int D>
Pair<D>::Pair(Surface<D> slave, Master<D> master, Law law, int points, bool revolved, const Region<D>& where)
    : slave_(std::move(slave)), master_(std::move(master)), accepted_master_(master_), law_(law), revolved_(revolved) {
  std::visit([](const auto& constants) { check(constants); }, law);
  if (const auto* penalty = std::get_if<PenaltyLaw>(&law)) penalty_ = *penalty;
  FacePoint<D> face;
  LocalGeometry<D> reference;
  LocalRow<D> derivative;
  reference.revolved = revolved;
  for (int e = 0; e < slave_.elements(); ++e) {
    std::array<solid::QuadratureRule, D - 1> rules;
    int count = 1;
    for (int a = 0; a < D - 1; ++a) {
      const auto [from, to] = slave_.interval(e, a);
      rules[static_cast<std::size_t>(a)] = solid::gauss_legendre(points, from, to);
      count *= points;
    }
    for (int q = 0; q < count; ++q) {
      FaceCoordinates<D> xi;
      double weight = 1;
      for (int a = 0, rest = q; a < D - 1; ++a, rest /= points) {
        const auto& rule = rules[static_cast<std::size_t>(a)];
        xi(a) = rule.points[static_cast<std::size_t>(rest % points)];
        weight *= rule.weights[static_cast<std::size_t>(rest % points)];
      }
      slave_.locate(e, xi, 1, face);
      if (where && !where(face.position)) continue;
      slave_.functions(face, 1);
      const int n = slave_.functions_on(e);
      reference.slave = face.position;
      reference.slave_tangent = face.tangent;
      points_.push_back({e, q, weight, slave_measure(reference, derivative), values_.size()});
      reference_positions_.push_back(face.position);
      values_.insert(values_.end(), face.value.begin(), face.value.begin() + n);
      for (const auto& values : face.derivative) values_.insert(values_.end(), values.begin(), values.begin() + n);
    }
  }
  require(!points_.empty(), "where holds nowhere on the slave face: it must return true for the reference positions ",
          "that take part");
  accepted_.resize(points_.size());
  memory_.resize(points_.size());
  results_.resize(points_.size());
  previous_slave_ = slave_.points();
  accepted_positions_ = reference_positions_;
  // Pieces of whole elements with about equally many points; in the plane a contact is small.
  const std::size_t widest = at(D * (slave_.most_functions() + 2 * master_.most_functions()) * (2 * D - 1));
  const std::size_t pieces = D == 2 ? 1 : 32;
  for (std::size_t i = 1, first = 0; i <= points_.size(); ++i)
    if (i == points_.size() ||
        (points_[i].element != points_[i - 1].element && (i - first) * pieces >= points_.size())) {
      parts_.push_back({first, i});
      parts_.back().rows.resize(widest);
      first = i;
    }
  shares_.assign(parts_.size(), 0);
}

template <int D> void Pair<D>::move(const double* slave_displacement, const double* master_displacement) {
  slave_.move(slave_displacement);
  const double moved = [&] {
    const ScopedTimer timer(times_search_ ? &search_seconds_ : nullptr);
    return master_.move(master_displacement);
  }();
  // A surface point is a convex combination of control points: none moves farther than the farthest of those.
  travel_ += std::sqrt((slave_.points() - previous_slave_).colwise().squaredNorm().maxCoeff()) + moved;
  previous_slave_ = slave_.points();
  // The last evaluation's groups go back to where they came from, for their memory.
  auto group = groups_.begin();
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for (; shares_[p] > 0; --shares_[p]) parts_[p].spare.push_back(std::move(*group++));
  groups_.clear();
}

template <int D>
void Pair<D>::evaluate(const double* slave_displacement, const double* master_displacement, bool tangent) {
  move(slave_displacement, master_displacement);
  for (int part = 0; part < parts(); ++part) evaluate_part(part, tangent);
  gather();
}

template <int D> void Pair<D>::evaluate_part(int index, bool tangent) {
  Part& part = parts_[static_cast<std::size_t>(index)];
  std::size_t first = 0; // group of the present slave element
  const auto multiply = [&] {
    if constexpr (D == 3)
      for (std::size_t g = first; g < part.groups.size() && tangent; ++g) part.products[g - first].finish();
    first = part.groups.size();
  };
  for (std::size_t i = part.first; i < part.last; ++i) {
    if (i > part.first && points_[i].element != points_[i - 1].element) multiply();
    evaluate_point(i, tangent, part);
  }
  multiply();
}

template <int D> void Pair<D>::gather() {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    std::vector<Group>& groups = parts_[p].groups;
    shares_[p] = groups.size();
    for (Group& group : groups) groups_.push_back(std::move(group));
    groups.clear();
    search_seconds_ += std::exchange(parts_[p].search_seconds, 0);
  }
}

template <int D> Vec<D> Pair<D>::position(std::size_t i) const {
  const Point& point = points_[i];
  const int* nodes = slave_.nodes(point.element);
  const double* values = values_.data() + point.values;
  Vec<D> sum = Vec<D>::Zero();
  for (int a = 0, n = slave_.functions_on(point.element); a < n; ++a) sum += values[a] * slave_.points().col(nodes[a]);
  return sum;
}

template <int D> std::array<Vec<D>, D - 1> Pair<D>::tangents(std::size_t i) const {
  const Point& point = points_[i];
  const int n = slave_.functions_on(point.element);
  const int* nodes = slave_.nodes(point.element);
  const double* values = values_.data() + point.values;
  std::array<Vec<D>, D - 1> result;
  for (int k = 0; k < D - 1; ++k) {
    Vec<D>& tangent = result[static_cast<std::size_t>(k)];
    tangent.setZero();
    for (int a = 0; a < n; ++a) tangent += values[(k + 1) * n + a] * slave_.points().col(nodes[a]);
  }
  return result;
}

/// Adds one contact point to the results and groups.
template <int D> void Pair<D>::evaluate_point(std::size_t i, bool tangent, Part& part) {
  FacePoint<D> master, slip_point;
  LocalGeometry<D> geometry;
  geometry.revolved = revolved_;
  LocalForce<D> force;
  const Point& point = points_[i];
  Memory& memory = memory_[i];
  PointResult<D>& result = results_[i];
  geometry.slave = position(i);
  result = {};
  result.position = geometry.slave;
  Held held = penalty_ && holds() ? held_[i] : Held::free;
  if (held == Held::free ? travel_ + guessed_ < memory.cleared : held == Held::open) return;

  {
    const ScopedTimer timer(times_search_ ? &part.search_seconds : nullptr);
    memory.projection = master_.project(geometry.slave, memory.projection, master);
  }
  const Foot foot = memory.projection.foot;
  const double gap = memory.projection.gap;
  result.beyond = foot == Foot::none;
  result.settled = master.settled;
  if (result.beyond) return;
  if (penalty_) {
    // t_N = λ_N − ε_N g > 0 below a distance of λ_N/ε_N
    const double distance = gap - memory.multiplier / penalty_->normal;
    memory.cleared = foot == Foot::regular && master.settled && distance > 0 ? travel_ + distance : 0;
    if (held == Held::free && std::abs(distance) < guessed_) held = Held::stick;
    if (held == Held::free && distance >= 0) return;
    if (held == Held::free && landing_) held = Held::stick;
    if (foot != Foot::regular && gap == 0) return; // no direction
  }

  geometry.slave_tangent = tangents(i);
  master_.functions(master, 1);
  geometry.master = &master;
  geometry.foot = foot;
  geometry.along = memory.projection.along;
  geometry.gap = gap;
  geometry.normal = foot == Foot::regular ? master_.normal(master) : Vec<D>((geometry.slave - master.position) / gap);
  geometry.reference_measure = point.reference;
  geometry.multiplier = memory.multiplier;
  geometry.held = held;
  geometry.tie = tie_;
  geometry.fade = master_.fade(memory.projection.xi, geometry.fade_rate);
  geometry.slip_point = nullptr;
  if (friction() && !memory.slips) remember_touch(i);
  if (friction() && memory.slips) {
    master_.locate(memory.slip, slip_point);
    geometry.slip_point = &slip_point.position;
  }
  if (penalty_)
    penalty_force(*penalty_, geometry, force);
  else
    adhesion_force(std::get<Adhesion>(law_), geometry, force);
  result.state = force.state;
  result.gap = gap;
  result.pressure = force.pressure;
  for (int k = 0; k < D - 1; ++k) result.tangents.col(k) = geometry.slave_tangent[static_cast<std::size_t>(k)];
  result.friction = force.friction;
  result.force = point.weight * force.force;
  result.area = point.weight * force.measure;
  result.potential = result.area * force.potential;
  add(point, master, geometry.slip_point ? &slip_point : nullptr, force, tangent, part);
}

/// A point that touches first slips from where it would have touched in the accepted state.
template <int D> void Pair<D>::remember_touch(std::size_t i) {
  Memory& memory = memory_[i];
  FacePoint<D> point;
  const Projection<D> projection = accepted_master_.project(accepted_positions_[i], memory.projection, point);
  if (projection.foot == Foot::none) return;
  memory.slips = true;
  memory.slip = projection.xi;
}

template <int D> void Pair<D>::accept() {
  if (friction())
    for (std::size_t i = 0; i < points_.size(); ++i) advance(i);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!results_[i].settled) ++unsettled_, unsettled_position_ = reference_positions_[i];
    if (has_crossed(i)) ++crossed_, crossed_position_ = reference_positions_[i];
  }
  accepted_master_ = master_;
  accepted_travel_ = travel_;
  accepted_ = memory_;
  accepted_results_ = results_;
}

/// Whether a point has gone through the master since the accepted state. Hardly any is looked at: one that is farther
/// from the master than the two have moved towards each other cannot have.
template <int D> bool Pair<D>::has_crossed(std::size_t i) const {
  const Memory& memory = memory_[i];
  const double moved = travel_ - accepted_travel_;
  const double least = memory.cleared > 0 ? memory.cleared - travel_ : memory.projection.gap; // distance
  if (moved <= 0 || least > moved || results_[i].beyond) return false;
  if (results_[i].state == ContactState::stick || results_[i].state == ContactState::slip) return false;
  const Vec<D> outward = slave_.outward(tangents(i)).normalized();
  return contact::has_crossed(accepted_master_, master_, accepted_results_[i].position, results_[i].position, outward,
                              memory.projection);
}

/// Moves a point's slip point to where it stands at the end of an accepted step.
template <int D> void Pair<D>::advance(std::size_t i) {
  Memory& memory = memory_[i];
  PointResult<D>& result = results_[i];
  accepted_positions_[i] = result.position;
  const double limit = penalty_->friction * result.pressure * result.area, limit_before = memory.limit;
  memory.limit = limit;
  if (result.state == ContactState::open) {
    memory.slips = false;
  } else if (!memory.slips) {
    // It came from beyond the master's end: friction counts from here.
    memory.slips = true;
    memory.slip = memory.projection.xi;
  } else if (result.state == ContactState::slip) {
    FacePoint<D> foot;
    foot.xi = memory.projection.xi;
    master_.locate(foot.xi, foot);
    FacePoint<D> slip_point;
    master_.locate(memory.slip, slip_point);
    // |x̄ᵐ − xᵐ(ξ_sl)| falls to μ t_N/ε_T; the difference is the slip Δγ.
    const double length = penalty_->friction * result.pressure / penalty_->tangential;
    const double before = (slip_point.position - foot.position).norm(), slipped = std::max(before - length, 0.0);
    dissipated_ += 0.5 * (limit_before + limit) * slipped;
    memory.slip = master_.advance(memory.slip, foot, length);
    master_.locate(memory.slip, slip_point);
    const double after = (slip_point.position - foot.position).norm();
    if (slipped > 0 && std::abs(after - length) > slip_tolerance * before) result.settled = false;
  }
}

template <int D> void Pair<D>::rollback() {
  memory_ = accepted_;
  results_ = accepted_results_;
  accepted_travel_ = travel_;
}

template <int D> void Pair<D>::settle() {
  travel_ = 0;
  for (Memory& memory : accepted_) memory.cleared = 0;
  accepted_master_ = master_;
  for (std::size_t i = 0; i < points_.size(); ++i) accepted_results_[i].position = accepted_positions_[i] = position(i);
  rollback();
}

template <int D> void Pair<D>::augment() {
  if (!penalty_) return;
  for (std::size_t i = 0; i < points_.size(); ++i) memory_[i].multiplier = results_[i].pressure;
}

template <int D> void Pair<D>::scale_penalty(double factor) {
  if (!penalty_) return;
  const PenaltyLaw& given = std::get<PenaltyLaw>(law_);
  penalty_->normal = factor * given.normal;
  penalty_->tangential = factor * given.tangential;
  // A softer penalty holds up a multiplier's pressure to a larger gap.
  for (auto* memories : {&accepted_, &memory_})
    for (Memory& memory : *memories)
      if (memory.multiplier > 0) memory.cleared = 0;
}

template <int D> typename Pair<D>::History Pair<D>::history() const {
  return {accepted_, accepted_master_, accepted_positions_, accepted_results_, dissipated_};
}

template <int D> void Pair<D>::restore(const History& history) {
  accepted_ = history.memory;
  accepted_master_ = history.master;
  accepted_positions_ = history.positions;
  accepted_results_ = history.results;
  dissipated_ = history.dissipated;
  rollback();
}

template <int D> Resultant<D> Pair<D>::resultant() const {
  Resultant<D> sum;
  for (const PointResult<D>& point : results_) {
    sum.force += point.force;
    if (point.state == ContactState::open) continue;
    sum.area += point.area;
    sum.max_pressure = std::max(sum.max_pressure, point.pressure);
    sum.max_penetration = std::max(sum.max_penetration, -point.gap);
    ++sum.active;
    if (point.state == ContactState::slip) ++sum.slipping;
  }
  return sum;
}

template <int D> double Pair<D>::stiffness() const {
  double sum = 0;
  const auto add = [&](double area, double slope) { sum += area * slope * area * slope; };
  const double steepest = penalty_ ? std::max(penalty_->normal, friction() ? penalty_->tangential : 0) : 0;
  for (const PointResult<D>& point : results_)
    if (!penalty_)
      add(point.area, contact::stiffness(std::get<Adhesion>(law_), point.gap));
    else if (point.state != ContactState::open)
      add(point.area, steepest);
  return std::sqrt(sum);
}

template <int D> double Pair<D>::potential() const {
  double sum = 0;
  for (const PointResult<D>& point : results_) sum += point.potential;
  return sum;
}

template <int D> std::vector<double> Pair<D>::gaps() const {
  std::vector<double> gaps;
  FacePoint<D> master;
  for (std::size_t i = 0; i < points_.size(); ++i)
    gaps.push_back(master_.project(results_[i].position, memory_[i].projection, master).gap);
  return gaps;
}

template <int D> double Pair<D>::memory() const {
  const auto bytes = [](const auto& list) { return static_cast<double>(list.capacity() * sizeof(list[0])); };
  double sum = bytes(points_) + bytes(values_) + bytes(accepted_) + bytes(memory_) + bytes(results_) +
               bytes(accepted_results_) + bytes(reference_positions_) + bytes(accepted_positions_) + bytes(groups_);
  for (const Group& group : groups_) sum += bytes(group.force) + bytes(group.matrix);
  for (const Part& part : parts_) sum += bytes(part.spare) + bytes(part.rows) + bytes(part.products);
  return sum;
}

template class Pair<2>;
template class Pair<3>;

} // namespace signorini::contact
