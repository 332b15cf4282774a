#include "contact/gauss/contact_area.hpp"

#include "contact/point/point_geometry.hpp"
#include "contact/tie/polygon.hpp"
#include "solid/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::contact {

namespace {

constexpr double no_gap = std::numeric_limits<double>::infinity();
/// A touching point has an open gap if E g/h exceeds this fraction of its pressure, h the length of its element. On
/// Hertz's line contact (N2) gaps that multipliers leave inside the contact reach 0.05, those of the fringe 3 and more.
constexpr double open_gap = 0.1;

/// The points of a slave face that act, as a grid across the borders of elements.
template <int D> class PointGrid {
public:
  PointGrid(const Formulation<D>& formulation, const History<D>& history)
      : slave_(formulation.slave()), points_(formulation.points()), per_direction_(slave_.elements()),
        first_(slave_.elements()) {
    behind_[0] = shares_behind(points_.full);
    if (points_.sparse > 0) behind_[1] = shares_behind(points_.sparse);
    for (int e = 0; e < slave_.elements(); ++e) {
      const bool few = !history.sparse.empty() && history.sparse[e];
      per_direction_[e] = few ? points_.sparse : points_.full;
      first_[e] = numbers_.size();
      numbers_.resize(numbers_.size() + (D == 2 ? per_direction_[e] : per_direction_[e] * per_direction_[e]), -1);
    }
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (const ContactPoint& point = points_.list[i]; acts(points_, history, i))
        numbers_[first_[point.element] + point.number] = static_cast<int>(i);
  }

  /// The next point along a direction; −1 at an end of the face or of the contact's region, and next to an element
  /// with another rule.
  int next(int i, int direction, bool forward) const {
    const ContactPoint& point = points_.list[i];
    const int n = per_direction_[point.element], step = direction == 0 ? 1 : n;
    const int own = point.number / step % n, last = forward ? n - 1 : 0;
    if (own != last) return numbers_[first_[point.element] + point.number + (forward ? step : -step)];
    const int element = slave_.neighbor(point.element, direction, forward);
    if (element < 0 || per_direction_[element] != n) return -1;
    return numbers_[first_[element] + point.number + (forward ? -1 : 1) * (n - 1) * step];
  }

  /// The part of a point's Gauss weight on one side of it.
  double share(int i, int direction, bool forward) const {
    const ContactPoint& point = points_.list[i];
    const int n = per_direction_[point.element], own = direction == 0 ? point.number % n : point.number / n;
    const double behind = behind_[point.sparse][own];
    return forward ? 1 - behind : behind;
  }

private:
  /// Weights are lengths of consecutive parts of the element, each of which contains its point (Chebyshev, Markov,
  /// Stieltjes): the share of each before its point.
  static std::vector<double> shares_behind(int count) {
    std::vector<double> shares;
    double before = 0;
    const solid::QuadratureRule rule = solid::gauss_legendre(count, 0, 1);
    for (std::size_t k = 0; k < rule.points.size(); before += rule.weights[k++])
      shares.push_back((rule.points[k] - before) / rule.weights[k]);
    return shares;
  }

  const Surface<D>& slave_;
  const ContactPoints<D>& points_;
  std::vector<int> per_direction_; ///< by element, as the next
  std::vector<std::size_t> first_;
  std::vector<int> numbers_;                  ///< of points; −1 outside the region
  std::array<std::vector<double>, 2> behind_; ///< of the full and the sparse rule
};

/// The part of the unit square inside, with straight borders between the zeros of values that are linear along its
/// sides. Values counter-clockwise; is_inside(k): true if corner k is inside.
template <class Inside> double negative_part(const std::array<double, 4>& values, const Inside& is_inside) {
  constexpr std::array<std::array<double, 2>, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  Polygon part;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t other = (k + 1) % 4;
    const Vec<2> from(corners[k][0], corners[k][1]), to(corners[other][0], corners[other][1]);
    if (is_inside(k)) part.push_back(from);
    if (is_inside(k) == is_inside(other)) continue;
    const double own = std::abs(values[k]), sum = own + std::abs(values[other]);
    part.push_back(from + (sum > 0 ? own / sum : 0.5) * (to - from));
  }
  return part.size() < 3 ? 0 : area(part);
}

template <int D> class AreaInside {
public:
  AreaInside(const Formulation<D>& formulation, const History<D>& history, bool reference, double modulus)
      : formulation_(formulation), history_(history), reference_(reference), modulus_(modulus),
        grid_(formulation, history), gap_(history.results.size(), std::nan("")) {}

  ContactArea run() {
    const std::size_t count = history_.results.size();
    result_.inside.resize(count);
    for (const std::size_t i : watched_points(history_))
      result_.inside[i] = history_.results[i].state != ContactState::open;
    const auto& law = formulation_.parameters().law;
    // Points decide by themselves on a pressure with multipliers that are unknowns.
    if (!law || law->enforcement != Enforcement::multipliers) clear_fringe();
    sort_elements();
    const auto& list = formulation_.points().list;
    bool uniform = false;
    for (std::size_t i = 0; i < count; ++i) {
      if (i == 0 || list[i].element != list[i - 1].element) uniform = is_uniform(list[i].element);
      if (!acts(formulation_.points(), history_, i) || (uniform && !result_.inside[i])) continue;
      if (const double part = uniform ? 1 : part_inside(static_cast<int>(i)); part > 0)
        result_.area += part * area_of(i);
    }
    return std::move(result_);
  }

private:
  /// Calls visit(j) for the neighbors of a point.
  template <class Visit> void each_neighbor(int i, const Visit& visit) const {
    for (int d = 0; d < D - 1; ++d)
      for (const bool forward : {false, true})
        if (const int j = grid_.next(i, d, forward); j >= 0) visit(j);
  }

  enum class Inside : unsigned char { unknown, none, some, all };

  /// The gap less the offset; infinite beyond the end of the master.
  double gap(int i) {
    double& gap = gap_[i];
    if (!std::isnan(gap)) return gap;
    const PointResult<D>& result = history_.results[i];
    if (result.state != ContactState::open) return gap = result.gap;
    FacePoint<D> foot;
    const Projection<D> found =
        formulation_.master().project(position(formulation_, history_, i), history_.points[i].projection, foot,
                                      lookout(formulation_.faces(), formulation_.points(), i));
    return gap = found.foot == Foot::none ? no_gap : found.gap - formulation_.parameters().offset(i, history_);
  }

  /// Length of a point's element.
  double length_of(std::size_t i) const {
    Vec<D> lower, upper;
    bounds(formulation_.slave().bezier(formulation_.points().list[i].element), lower, upper);
    return (upper - lower).norm();
  }

  void clear_fringe() {
    const auto is_wide = [&](int i) {
      const PointResult<D>& result = history_.results[i];
      return result_.inside[i] && touches(result.state) &&
             modulus_ * result.gap > open_gap * length_of(i) * result.pressure;
    };
    std::vector<int> fringe;
    const auto move_out = [&](int i) {
      result_.inside[i] = false;
      fringe.push_back(i);
    };
    for (int i = 0; i < std::ssize(gap_); ++i)
      if (acts(formulation_.points(), history_, i) && history_.results[i].state == ContactState::open)
        each_neighbor(i, [&](int j) {
          if (is_wide(j)) move_out(j);
        });
    while (!fringe.empty()) {
      const int i = fringe.back();
      fringe.pop_back();
      each_neighbor(i, [&](int j) {
        if (is_wide(j)) move_out(j);
      });
    }
  }

  /// Sorts elements by whether none, all or some of their points are inside.
  void sort_elements() {
    elements_.assign(formulation_.slave().elements(), Inside::unknown);
    for (std::size_t i = 0; i < history_.results.size(); ++i) {
      if (!acts(formulation_.points(), history_, i)) continue;
      Inside& element = elements_[formulation_.points().list[i].element];
      const Inside own = result_.inside[i] ? Inside::all : Inside::none;
      element = element == Inside::unknown || element == own ? own : Inside::some;
    }
  }

  /// True if all points of an element and of its neighbors are inside, or none.
  bool is_uniform(int element) const {
    const Inside own = elements_[element];
    if (own == Inside::some) return false;
    const auto differs = [&](int other) { return other >= 0 && elements_[other] != own; };
    const Surface<D>& face = formulation_.slave();
    for (const bool first : {false, true}) {
      const int a = face.neighbor(element, 0, first);
      if (differs(a)) return false;
      if constexpr (D == 3)
        for (const bool second : {false, true})
          if (differs(face.neighbor(element, 1, second)) || (a >= 0 && differs(face.neighbor(a, 1, second))))
            return false;
    }
    return true;
  }

  /// On what a point's traction acts; of an open point, on what it would act.
  double area_of(std::size_t i) const {
    const PointResult<D>& result = history_.results[i];
    if (result.area != 0) return result.area;
    const ContactPoint& point = formulation_.points().list[i];
    if (reference_) return point.weight * point.reference_area;
    return point.weight *
           slave_measure(formulation_.points(), formulation_.slave(), i, position(formulation_, history_, i));
  }

  /// The part of a point's area that is inside, by halves on a curve, by quarters on a surface.
  double part_inside(int i) {
    double part = 0;
    for (const bool first : {false, true}) {
      const int a = grid_.next(i, 0, first);
      const double share = grid_.share(i, 0, first);
      if constexpr (D == 2) {
        part += share * cell_inside({i, a, a, i});
      } else {
        for (const bool second : {false, true})
          part += share * grid_.share(i, 1, second) *
                  cell_inside({i, a, a < 0 ? -1 : grid_.next(a, 1, second), grid_.next(i, 1, second)});
      }
    }
    return part;
  }

  /// The part inside of a cell of neighboring points, the first of which takes the place of those that are missing.
  double cell_inside(std::array<int, 4> corners) {
    const bool inside = result_.inside[corners[0]];
    bool mixed = false, held = false;
    for (int& corner : corners) {
      if (corner < 0) corner = corners[0];
      mixed = mixed || (result_.inside[corner] != 0) != inside;
      const ContactState state = history_.results[corner].state;
      held = held || (state != ContactState::open && !touches(state));
    }
    if (!mixed || held) return inside;
    std::array<double, 4> gaps;
    for (std::size_t k = 0; k < 4; ++k) {
      const double own = gap(corners[k]);
      if (own == no_gap) return inside;
      gaps[k] = result_.inside[corners[k]] ? -std::max(-own, 0.0) : std::max(own, 0.0);
    }
    return negative_part(gaps, [&](std::size_t k) { return result_.inside[corners[k]] != 0; });
  }

  const Formulation<D>& formulation_;
  const History<D>& history_;
  bool reference_;
  double modulus_;
  PointGrid<D> grid_;
  std::vector<double> gap_; ///< NaN: not known
  std::vector<Inside> elements_;
  ContactArea result_;
};

} // namespace

template <int D>
ContactArea contact_area(const Formulation<D>& formulation, const History<D>& history, bool reference, double modulus) {
  for (const std::size_t i : watched_points(history))
    if (history.results[i].state != ContactState::open)
      return AreaInside<D>(formulation, history, reference, modulus).run();
  return {.inside = std::vector<char>(history.results.size())};
}

template ContactArea contact_area(const Formulation<2>&, const History<2>&, bool, double);
template ContactArea contact_area(const Formulation<3>&, const History<3>&, bool, double);

} // namespace signorini::contact
