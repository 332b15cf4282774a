#pragma once
// History and results of contact points: plain values, part of a model's state.

#include "contact/law/changes.hpp"
#include "contact/point/contact_points.hpp"
#include "contact/point/local.hpp"

#include <algorithm>
#include <iterator>

namespace signorini::contact {

/// Result of one contact point in an evaluation.
template <int D> struct PointResult {
  ContactState state = ContactState::open;
  Vec<D> position = Vec<D>::Zero(); ///< current slave point
  double gap = 0;                   ///< of an active point, less its offset
  bool beyond = false;              ///< its closest point is an open end of the master
  bool settled = true;              ///< the searches for its closest point and, once accepted, its slip point converged
  double pressure = 0;
  double area = 0; ///< to which the tractions refer: current; of mortar contact reference, in a half pass current
  /// Tangents of the slave face at a touching point, current, not of unit length
  Eigen::Matrix<double, D, D - 1> tangents = Eigen::Matrix<double, D, D - 1>::Zero();
  Vec<D> friction = Vec<D>::Zero();       ///< t_T; the traction on the slave is t_N n̄ − t_T
  Vec<D> force = Vec<D>::Zero();          ///< on the slave: traction × area
  double law_area = 0;                    ///< on which the law's tractions act: current or reference
  double potential = 0;                   ///< energy of springs or adhesion at this point, see potential()
  double slipped = 0;                     ///< of multipliers: by how far the trial slip is outside of Coulomb's cone
  double mu = 0;                          ///< coefficient of friction, see Slide
  FrictionFlaw flaw = FrictionFlaw::none; ///< see Slide
  double worn = 0;                        ///< depth by which it wears in the step
};

/// `area` per `law_area`: the law's pressure is `pressure` times this.
template <int D> double stretch(const PointResult<D>& point) {
  return point.law_area != 0 ? point.area / point.law_area : 1;
}

/// History of one contact point.
template <int D> struct PointHistory {
  Projection<D> projection; ///< start of the next closest-point projection
  double cleared = 0;       ///< value of Faces::travel up to which an open point stays open
  bool slips = false;       ///< has a slip point
  MasterPoint<D> slip;
  double limit = 0;               ///< μ t_N times the area in the accepted state
  double slipped = 0, recent = 0; ///< slip since the touch, and since the last whole step in which it stuck
  double worn = 0; ///< depth by which it has worn; slips and this of mortar contact Σ M_A γ_A, Σ M_A w_A
};

/// Bond of one contact point: history and result.
template <int D> struct PointBond {
  double opening = 0;            ///< δ
  double largest = 0;            ///< of all accepted states and this one
  double pressure = 0;           ///< its share of PointResult::pressure, negative where it pulls
  Vec<D> shear = Vec<D>::Zero(); ///< its share of PointResult::friction
  /// By formula: the fraction of its stiffness that is left, and the mode mix at which it fell last
  double left = 1, mix = 0;
  /// By formula: energy per area dissipated so far, what shear has of it, and the part left of the energy of separation
  double dissipated = 0, sheared = 0, remaining = 1;
};

/// Share of shear in the energy that a bond by formula has dissipated.
template <int D> double mix(const PointBond<D>& bond) {
  return bond.dissipated > 0 ? bond.sheared / bond.dissipated : 0;
}

/// Result of one multiplier of mortar contact in an evaluation; components as in mortar_law.hpp.
template <int D> struct MultiplierResult {
  ContactState state = ContactState::open;
  bool beyond = false;              ///< none of its points has a projection
  double area = 0;                  ///< a_A, reference, in a half pass current
  double gap = 0;                   ///< ḡ_A
  double pressure = 0;              ///< z_A
  double potential = 0;             ///< energy of its springs, see potential()
  Vec<D> friction = Vec<D>::Zero(); ///< t_A; the traction on the slave is Σ M_A (z_A n̄ − t_A)
  FaceCoordinates<D> components = FaceCoordinates<D>::Zero(); ///< of t_A
  FaceCoordinates<D> elastic = FaceCoordinates<D>::Zero();    ///< slip of its spring
  double slipped = 0;                                         ///< since the accepted state
  double mu = 0;                                              ///< coefficient of friction, see Slide
  FrictionFlaw flaw = FrictionFlaw::none;                     ///< see Slide
  double worn = 0;                                            ///< w_A of the step
};

/// History of one multiplier.
template <int D> struct MultiplierHistory {
  double cleared = 0; ///< value of Faces::travel up to which all its points stay open
  FaceCoordinates<D> elastic = FaceCoordinates<D>::Zero(); ///< slip of its spring in the accepted state
  double limit = 0;                                        ///< μ z_A a_A in the accepted state
  Vec<D> touch = Vec<D>::Zero();            ///< V*_A: the part of V_A before the multiplier touches in the present step
  double slipped = 0, recent = 0, worn = 0; ///< as those of a point
};

/// Numbers of consecutive contact points: whole elements.
struct PointRange {
  std::size_t first, last;
};

/// One entry per contact point in the first two lists, one per multiplier in the others.
template <int D> struct History {
  explicit History(const ContactPoints<D>& of, int multipliers = 0, bool bonded = false);

  std::vector<PointHistory<D>> points;
  std::vector<PointResult<D>> results;
  std::vector<MultiplierHistory<D>> multipliers;
  std::vector<MultiplierResult<D>> multiplier_results;
  std::vector<PointBond<D>> bonds = {}; ///< one per point of a cohesive contact, otherwise none
  std::vector<char> sparse = {};        ///< per slave element, true if its sparse rule acts; empty if there are none
  /// In ascending order, all but elements of sets that nothing has reached in the last evaluation: the others' points
  /// are open, have no foot and no past, and their results only the position in the accepted state.
  std::vector<PointRange> watched;
  Changes changes = {};
  /// Sums over all accepted steps, by the trapezoidal rule over each: work of friction, ∫ μ t_N dγ da; ∫∫ φ dA, the
  /// law's energy φ per area times the growth of the area A on which its tractions act, which no force does; and the
  /// work of changing offsets o, ∫∫ t_N do dA.
  double dissipated = 0, growth = 0, offset_work = 0;
  double debonding = 0; ///< energy that bonds have dissipated
  /// Of wear: volume ∫∫ dw da, and the energy ∫∫ t_N dw da that leaves with it, by the trapezoidal rule.
  double worn_volume = 0, wear = 0;
};

/// Adds the slip of an accepted step to a history of a point or multiplier; one that does not touch forgets its own.
template <class Any> void add_slip(Any& history, ContactState state, double slipped) {
  if (!touches(state)) slipped = history.slipped = 0;
  history.recent = state == ContactState::slip ? history.recent + slipped : 0;
  history.slipped += slipped;
}

/// True if point i acts: it belongs to the rule of its element.
template <int D> bool acts(const ContactPoints<D>& points, const History<D>& history, std::size_t i) {
  return history.sparse.empty() || (history.sparse[points.list[i].element] != 0) == points.list[i].sparse;
}

/// True if point i is watched.
template <int D> bool is_watched(const History<D>& history, std::size_t i) {
  const auto after = std::ranges::upper_bound(history.watched, i, {}, &PointRange::first);
  return after != history.watched.begin() && i < std::prev(after)->last;
}
/// The numbers of all watched points, for loops. (Clang 14 cannot compile the views of libstdc++ 12.)
class WatchedPoints {
public:
  explicit WatchedPoints(const std::vector<PointRange>& ranges)
      : first_(ranges.data()), last_(ranges.data() + ranges.size()) {}

  struct Iterator {
    const PointRange *range, *last;
    std::size_t i = range != last ? range->first : 0;

    std::size_t operator*() const { return i; }
    bool operator!=(std::default_sentinel_t) const { return range != last; }
    Iterator& operator++() {
      ++i;
      return skip_ends();
    }
    Iterator& skip_ends() {
      while (range != last && i == range->last)
        if (++range != last) i = range->first;
      return *this;
    }
  };
  Iterator begin() const { return Iterator{first_, last_}.skip_ends(); }
  std::default_sentinel_t end() const { return {}; }

private:
  const PointRange *first_, *last_;
};
template <int D> WatchedPoints watched_points(const History<D>& history) {
  return WatchedPoints(history.watched);
}
/// Adds a range behind all watched ones.
template <int D> void watch(History<D>& history, const PointRange& next) {
  if (!history.watched.empty() && history.watched.back().last == next.first)
    history.watched.back().last = next.last;
  else
    history.watched.push_back(next);
}
/// Makes all points watched, until the next evaluation.
template <int D> void watch_all(History<D>& history) {
  history.watched = {{0, history.points.size()}};
}

/// Sums over a contact. Largest pressure and penetration are over the points that are not open. The area, which is not
/// a sum over points, is that of contact_area.hpp.
template <int D> struct Resultant {
  Vec<D> force = Vec<D>::Zero(); ///< of the master on the slave
  double max_pressure = 0, max_penetration = 0;
  double max_wear = 0; ///< greatest depth of wear, also of open points
  int active = 0, slipping = 0;
};
template <int D> Resultant<D> resultant(const History<D>& history);

/// Constraints of a contact, which open and close: its multipliers or, without any, its points.
struct Constraint {
  ContactState state;
  bool beyond; ///< no closest point, because that is an open end of the master
  double gap;  ///< if not open
};
template <int D> int constraints(const History<D>& history);
template <int D> Constraint constraint(const History<D>& history, int index);

/// Bytes in memory.
template <int D> double memory(const History<D>& history);

/// Makes the next evaluation project all points: `cleared` of a history that is kept is worthless once settle() has
/// started the travel of its formulation again, or in another formulation.
template <int D> void look_everywhere(History<D>& history);

/// Drops the touches that another attempt of the step has foreseen.
template <int D> void forget_touches(History<D>& present, const History<D>& accepted);

/// Changes constants. The next evaluation projects all points.
template <int D> void change(History<D>& history, const Changes& changes);

} // namespace signorini::contact
