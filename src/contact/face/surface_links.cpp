// Borders of a set of faces that share control points: ways across them.

#include "contact/face/surface.hpp"

#include <algorithm>

namespace signorini::contact {

namespace {

/// Numbers of the control points on a border that they have in common with others, along it.
template <int D> std::vector<int> border_nodes(const Surface<D>& surface, int sheet, int alpha, bool at_end) {
  const int nu = surface.direction(0, sheet).functions(), nv = D == 2 ? 1 : surface.direction(D - 2, sheet).functions();
  const int count = alpha == 0 ? nv : nu, step = alpha == 0 ? nu : 1;
  const int start = surface.first_function(sheet) + (at_end ? (alpha == 0 ? nu - 1 : nu * (nv - 1)) : 0);
  std::vector<int> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(surface.shared(start + i * step));
  return nodes;
}

/// The borders of elements that a border of a sheet consists of, along it, without those of its extension.
template <int D>
std::vector<ElementBorder> border_elements(const Surface<D>& surface, int sheet, int alpha, bool at_end) {
  std::vector<ElementBorder> list;
  for (int e = surface.first_element(sheet); e < surface.first_element(sheet + 1); ++e) {
    if (surface.neighbor(e, alpha, at_end) >= 0) continue;
    bool own = true;
    for (int d = 0; d < D - 1; ++d) {
      const auto [from, to] = surface.interval(e, d);
      own = own && from >= surface.sheet_data(sheet).extension.ends[d][0] &&
            to <= surface.sheet_data(sheet).extension.ends[d][1];
    }
    if (own) list.push_back({e, alpha, at_end});
  }
  return list;
}

} // namespace

template <int D> SheetLinks find_links(const Surface<D>& surface) {
  SheetLinks links;
  struct Side {
    int sheet, alpha;
    bool at_end;
    std::vector<int> nodes;
  };
  std::vector<Side> sides;
  for (int s = 0; s < surface.sheets(); ++s)
    for (int a = 0; a < D - 1; ++a)
      for (const bool at_end : {false, true}) {
        std::vector<int> nodes = border_nodes(surface, s, a, at_end);
        const bool pole = D == 3 && std::ranges::all_of(nodes, [&](int node) { return node == nodes.front(); });
        if (!pole) sides.push_back({s, a, at_end, std::move(nodes)});
      }
  const auto link = [&](const Side& one, const Side& other, bool reversed) {
    const std::vector<ElementBorder> from = border_elements(surface, one.sheet, one.alpha, one.at_end);
    std::vector<ElementBorder> to = border_elements(surface, other.sheet, other.alpha, other.at_end);
    if (reversed) std::ranges::reverse(to);
    for (std::size_t k = 0; k < from.size(); ++k) {
      links[from[k]] = {to[k], reversed};
      links[to[k]] = {from[k], reversed};
    }
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      const std::vector<int> forward = sides[j].nodes, backward(forward.rbegin(), forward.rend());
      if (sides[i].nodes != forward && sides[i].nodes != backward) continue;
      link(sides[i], sides[j], sides[i].nodes != forward);
      break;
    }
  }
  return links;
}

template <int D> bool is_linked(const Surface<D>& surface, int sheet, int alpha, bool at_end) {
  return !surface.links().empty() && surface.links().contains(border_elements(surface, sheet, alpha, at_end).front());
}

template <int D>
Entry<D> across(const Surface<D>& surface, int element, int alpha, bool at_end, const FaceCoordinates<D>& xi) {
  if (const int next = surface.neighbor(element, alpha, at_end); next >= 0) return {next, alpha, !at_end, xi};
  const auto found = surface.links().find({element, alpha, at_end});
  if (found == surface.links().end()) return {};
  const auto& [to, reversed] = found->second;
  Entry<D> entry{to[0], to[1], to[2] != 0, {}};
  entry.xi(entry.alpha) = surface.interval(entry.element, entry.alpha)[entry.at_end];
  if constexpr (D == 3) {
    const auto [from, last] = surface.interval(element, 1 - alpha);
    const auto [first, other] = surface.interval(entry.element, 1 - entry.alpha);
    const double way = (xi(1 - alpha) - from) / (last - from), part = reversed ? 1 - way : way;
    entry.xi(1 - entry.alpha) = (1 - part) * first + part * other;
  }
  return entry;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template SheetLinks find_links(const Surface<D>&);                                                                   \
  template bool is_linked(const Surface<D>&, int, int, bool);                                                          \
  template Entry<D> across(const Surface<D>&, int, int, bool, const FaceCoordinates<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
