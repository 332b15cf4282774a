#include "contact/face/surroundings.hpp"

#include "contact/constants.hpp"

#include <algorithm>

namespace signorini::contact {

namespace {

/// A point of a face and the outward unit normal there.
template <int D> struct Place { Vec<D> position, normal; };

/// The middle and the corners of an element.
template <int D> using Places = std::array<Place<D>, 1 + (1 << (D - 1))>;

template <int D> Places<D> places_of(const Surface<D>& surface, int element) {
  Places<D> places;
  FaceGeometry<D> point;
  for (std::size_t k = 0; k < places.size(); ++k) {
    FaceCoordinates<D> xi;
    for (int d = 0; d < D - 1; ++d) {
      const auto [from, to] = surface.interval(element, d);
      xi(d) = k == 0 ? 0.5 * (from + to) : ((k - 1) >> d) % 2 == 0 ? from : to;
    }
    surface.locate(element, xi, 1, point);
    places[k] = {point.position, outward(surface, point).normalized()};
  }
  return places;
}

/// True if two elements lie behind each other, or little in front, and do not look the same way.
template <int D> bool form_edge(const Places<D>& one, const Places<D>& other) {
  return std::ranges::all_of(one, [&](const Place<D>& here) {
    return std::ranges::all_of(other, [&](const Place<D>& there) {
      const Vec<D> way = there.position - here.position;
      const double rise = std::max(way.dot(here.normal), -way.dot(there.normal));
      return rise <= flat_sine * way.norm() && here.normal.dot(there.normal) <= least_facing_cosine;
    });
  });
}

/// Those of some elements that form an edge with one.
template <int D>
std::vector<int> across_edges(const std::vector<Places<D>>& places, int element, const std::vector<int>& others) {
  std::vector<int> list;
  for (const int other : others)
    if (form_edge<D>(places[element], places[other])) list.push_back(other);
  return list;
}

} // namespace

template <int D> Surroundings find_surroundings(const Surface<D>& set, const Surface<D>& extended) {
  std::vector<Places<D>> places;
  std::vector<std::vector<int>> having; // elements, by number of a control point
  for (int e = 0; e < extended.elements(); ++e) {
    places.push_back(places_of(extended, e));
    for (int k = 0; k < extended.functions_on(e); ++k) {
      const std::size_t node = extended.shared(extended.nodes(e)[k]);
      if (node >= having.size()) having.resize(node + 1);
      if (having[node].empty() || having[node].back() != e) having[node].push_back(e);
    }
  }
  Surroundings result;
  for (int e = 0; e < set.elements(); ++e) {
    FaceCoordinates<D> middle;
    for (int d = 0; d < D - 1; ++d) middle(d) = 0.5 * (set.interval(e, d)[0] + set.interval(e, d)[1]);
    const int number = extended.find_element(middle);
    std::vector<int> near;
    for (int k = 0; k < extended.functions_on(number); ++k) {
      const std::vector<int>& list = having[extended.shared(extended.nodes(number)[k])];
      near.insert(near.end(), list.begin(), list.end());
    }
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    result.numbers.push_back(number);
    result.list.push_back(across_edges<D>(places, number, near));
  }
  return result;
}

template Surroundings find_surroundings(const Surface<2>&, const Surface<2>&);
template Surroundings find_surroundings(const Surface<3>&, const Surface<3>&);

} // namespace signorini::contact
