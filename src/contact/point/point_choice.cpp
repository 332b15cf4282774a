#include "contact/point/point_choice.hpp"

#include "contact/constants.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace signorini::contact {

namespace {

/// What the acting points of an element have in common.
struct ElementState {
  std::vector<std::size_t> points;   ///< that act
  int listed = 0;                    ///< number of points of both rules
  std::optional<ContactState> state; ///< of the first
  bool mixed = false;
  bool touching = false, apart = false;                             ///< one of the points is
  double least = std::numeric_limits<double>::infinity(), most = 0; ///< pressure
};

} // namespace

template <int D>
std::vector<char> choose_sparse(const ContactPoints<D>& points, const Surface<D>& slave, const History<D>& history,
                                double moved, const IsNear& is_near) {
  std::vector<ElementState> elements(slave.elements());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ElementState& element = elements[points.list[i].element];
    ++element.listed;
    if (!acts(points, history, i)) continue;
    const PointResult<D>& result = history.results[i];
    element.points.push_back(i);
    if (!element.state) element.state = result.state;
    element.mixed = element.mixed || result.state != *element.state;
    (touches(result.state) ? element.touching : element.apart) = true;
    element.least = std::min(element.least, result.pressure);
    element.most = std::max(element.most, result.pressure);
  }
  const auto power = [](int n) { return D == 2 ? n : n * n; };
  const int all = power(points.full) + power(points.sparse);
  std::vector<char> sparse = history.sparse;
  for (int e = 0; e < std::ssize(sparse); ++e) {
    const ElementState& element = elements[e];
    bool full = element.listed < all || element.mixed || !element.state;
    for (int alpha = 0; alpha < D - 1 && !full; ++alpha)
      for (const bool at_end : {false, true}) {
        const int next = slave.neighbor(e, alpha, at_end);
        if (next < 0) continue;
        full = full || (touches(*element.state) ? elements[next].apart : elements[next].touching);
      }
    const double caution = sparse[e] ? 1 : rule_hysteresis;
    if (!full && touches(*element.state)) full = element.least < caution * border_pressure * element.most;
    if (!full && !touches(*element.state)) {
      Vec<D> lower, upper;
      bounds(slave.bezier(e), lower, upper);
      full =
          is_near(element.points, caution * std::max(border_motion * moved, border_distance * (upper - lower).norm()));
    }
    sparse[e] = !full;
  }
  return sparse;
}

template std::vector<char> choose_sparse(const ContactPoints<2>&, const Surface<2>&, const History<2>&, double,
                                         const IsNear&);
template std::vector<char> choose_sparse(const ContactPoints<3>&, const Surface<3>&, const History<3>&, double,
                                         const IsNear&);

} // namespace signorini::contact
