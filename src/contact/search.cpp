#include "contact/search.hpp"

namespace signorini::contact {

template <int D> void ElementBoxes<D>::update(const Surface<D>& surface) {
  if (nodes_.empty()) {
    const int u = surface.direction(0).elements();
    leaves_.resize(at(surface.elements()));
    build(surface, {0, 0}, {u, surface.elements() / u});
  }
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    if (node.element >= 0) {
      surface.bounds(node.element, node.box.lower, node.box.upper);
      continue;
    }
    const Box &a = nodes_[i + 1].box, &b = nodes_[at(node.second)].box;
    node.box = {a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper)};
  }
}

/// Builds the tree of the elements first … last − 1 in both directions.
template <int D>
void ElementBoxes<D>::build(const Surface<D>& surface, std::array<int, 2> first, std::array<int, 2> last) {
  const std::size_t index = nodes_.size();
  nodes_.push_back({-1, -1, {Vec<D>::Zero(), Vec<D>::Zero()}});
  const int u = last[0] - first[0], v = last[1] - first[1];
  if (u == 1 && v == 1) {
    const int element = first[0] + surface.direction(0).elements() * first[1];
    nodes_[index].element = element;
    leaves_[at(element)] = static_cast<int>(index);
    return;
  }
  const std::size_t d = u >= v ? 0 : 1;
  std::array<int, 2> end = last, start = first;
  end[d] = start[d] = (first[d] + last[d]) / 2;
  build(surface, first, end);
  nodes_[index].second = static_cast<int>(nodes_.size());
  build(surface, start, last);
}

template class ElementBoxes<2>;
template class ElementBoxes<3>;

} // namespace signorini::contact
