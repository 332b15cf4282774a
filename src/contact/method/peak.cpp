#include "contact/method/peak.hpp"

#include <algorithm>
#include <set>

namespace signorini::contact {

namespace {

/// What is closed of an element, seen along a direction: points per direction, and those that have a closed point.
struct Shadow {
  int points = 0;
  std::set<int> closed = {};
};

/// The elements' shadows along `direction`. Elements outside the region have no points.
template <int D>
std::vector<Shadow> shadows(const Formulation<D>& formulation, const History<D>& history, int direction) {
  const ContactPoints<D>& points = formulation.points();
  std::vector<Shadow> all(formulation.slave().elements());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!acts(points, history, i)) continue;
    const ContactPoint& point = points.list[i];
    const int per_direction = point.sparse ? points.sparse : points.full;
    Shadow& shadow = all[point.element];
    shadow.points = per_direction;
    if (history.results[i].state == ContactState::open || history.results[i].pressure <= 0) continue;
    shadow.closed.insert(direction == 0 ? point.number % per_direction : point.number / per_direction);
  }
  return all;
}

template <int D>
ZoneExtent extent_along(const Surface<D>& slave, const std::vector<Shadow>& all, int start, int direction) {
  const auto share = [](const Shadow& shadow) { return static_cast<double>(shadow.closed.size()) / shadow.points; };
  ZoneExtent result{share(all[start])};
  for (const bool onward : {false, true}) {
    int last = start;
    for (int e = slave.neighbor(start, direction, onward);; e = slave.neighbor(e, direction, onward)) {
      if (e < 0 || all[e].points == 0) {
        const Shadow& end = all[last];
        result.edges += onward ? end.closed.contains(end.points - 1) : end.closed.contains(0);
        break;
      }
      if (all[e].closed.empty()) break;
      result.elements += share(all[e]);
      last = e;
    }
  }
  return result;
}

} // namespace

template <int D> std::optional<PeakZone<D>> peak_zone(const Formulation<D>& formulation, const History<D>& history) {
  const auto peak = std::ranges::max_element(
      history.results, {}, [](const PointResult<D>& point) { return touches(point.state) ? point.pressure : 0; });
  if (peak == history.results.end() || !touches(peak->state) || peak->pressure <= 0) return std::nullopt;
  PeakZone<D> zone{formulation.points().list[static_cast<int>(peak - history.results.begin())].element, {}};
  for (int direction = 0; direction < D - 1; ++direction)
    zone.extent[direction] =
        extent_along(formulation.slave(), shadows(formulation, history, direction), zone.element, direction);
  return zone;
}

template <int D> double mean_pressure(const ContactPoints<D>& points, const History<D>& history) {
  double largest = 0, force = 0, area = 0;
  for (const std::size_t i : watched_points(history)) {
    if (acts(points, history, i)) {
      const PointResult<D>& result = history.results[i];
      const bool open = result.state == ContactState::open;
      force += open ? 0 : result.pressure * result.area;
      area += open ? points.list[i].weight * points.list[i].reference_area : result.area;
    }
    if (i + 1 < points.size() && points.list[i + 1].element == points.list[i].element) continue;
    if (area > 0) largest = std::max(largest, force / area);
    force = area = 0;
  }
  return largest;
}

template <int D> double mean_slip(const History<D>& history) {
  double sum = 0, area = 0;
  for (std::size_t i = 0; i < history.results.size(); ++i) {
    if (!touches(history.results[i].state)) continue; // nor do points that do not act
    sum += history.points[i].slipped * history.results[i].area;
    area += history.results[i].area;
  }
  return area > 0 ? sum / area : 0;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::optional<PeakZone<D>> peak_zone(const Formulation<D>&, const History<D>&);                             \
  template double mean_pressure(const ContactPoints<D>&, const History<D>&);                                           \
  template double mean_slip(const History<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
