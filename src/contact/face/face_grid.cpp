#include "contact/face/face_grid.hpp"

#include "base/error.hpp"
#include "contact/constants.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace signorini::contact {

namespace {

using Index2 = std::array<int, 2>;

/// A part in its orientation, with the indices of the whole's directions.
class TurnedPart {
public:
  TurnedPart(const FacePart& part, const nurbs::Orientation& way) : part_(&part), way_(way) {
    for (std::size_t k = 0; k < part.row.directions().size(); ++k) own_[k] = part.row.directions()[k].functions();
    functions_[way.to[0]] = own_[0];
    functions_[way.to[1]] = own_[1];
  }

  const nurbs::Orientation& way() const { return way_; }
  int functions(std::size_t d) const { return functions_[d]; }
  double orientation() const { return way_.mirrors() ? -part_->orientation : part_->orientation; }
  /// Index of the part's control point at an index of the whole's directions.
  int control_point(const Index2& index) const {
    Index2 own;
    for (std::size_t k = 0; k < 2; ++k) own[k] = way_.flip[k] ? own_[k] - 1 - index[way_.to[k]] : index[way_.to[k]];
    return own[0] + own_[0] * own[1];
  }
  int node(const Index2& index) const { return part_->nodes[control_point(index)]; }
  VectorX homogeneous(const Index2& index) const { return part_->row.homogeneous().col(control_point(index)); }
  /// The part's direction along direction d of the whole.
  std::size_t along(std::size_t d) const { return way_.to[0] == d ? 0 : 1; }
  const nurbs::Space1D& space(std::size_t d) const { return part_->row.directions()[along(d)]; }
  bool reversed(std::size_t d) const { return way_.flip[along(d)]; }

  /// Nodes of the border at an end of direction d.
  std::vector<int> border(std::size_t d, bool at_end) const {
    std::vector<int> nodes;
    for (int i = 0; i < functions_[1 - d]; ++i) {
      Index2 index;
      index[d] = at_end ? functions_[d] - 1 : 0;
      index[1 - d] = i;
      nodes.push_back(node(index));
    }
    return nodes;
  }

private:
  const FacePart* part_;
  nurbs::Orientation way_;
  Index2 own_{1, 1}, functions_{1, 1};
};

/// A part and its place in the grid of parts.
struct Placed {
  TurnedPart part;
  Index2 cell;
};

class Grid {
public:
  Grid(const std::vector<FacePart>& parts, const Message& list)
      : parts_(parts), list_(list), dimensions_(parts.front().row.parametric_dimension()), placed_(parts.size()) {
    place(0, nurbs::orientations(dimensions_).front(), {0, 0});
    // In order of placement each part takes its neighbors, behind its end first; so a ring of n parts is cut behind
    // the (n/2 + 1)-th, n/2 rounded down.
    for (std::size_t i = 0; i < order_.size(); ++i)
      for (int d = 0; d < dimensions_; ++d)
        for (const bool at_end : {true, false}) take_neighbor(order_[i], d, at_end);
    for (std::size_t i = 0; i < parts.size(); ++i)
      require(placed_[i].has_value(), turned_ ? "contact.faces.sides" : "contact.faces.apart",
              {{"list", list_}, {"face", parts[turned_ ? *turned_ : i].name}});
    normalize();
  }

  FaceGrid whole() const;

private:
  void place(std::size_t part, const nurbs::Orientation& way, const Index2& cell) {
    require(taken_.insert(cell).second, "contact.faces.grid", {{"list", list_}, {"face", parts_[part].name}});
    placed_[part].emplace(Placed{TurnedPart(parts_[part], way), cell});
    order_.push_back(part);
  }

  void take_neighbor(std::size_t from, std::size_t d, bool at_end) {
    Index2 cell = placed_[from]->cell;
    cell[d] += at_end ? 1 : -1;
    const std::vector<int> border = placed_[from]->part.border(d, at_end);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (placed_[i]) continue;
      for (const nurbs::Orientation& way : nurbs::orientations(dimensions_)) {
        const TurnedPart turned(parts_[i], way);
        if (turned.border(d, !at_end) != border) continue;
        if (turned.orientation() == parts_.front().orientation) return place(i, way, cell);
        turned_ = i;
      }
    }
  }

  /// Makes the lowest cell {0, 0}, and checks that all cells are taken.
  void normalize() {
    Index2 low = placed_[0]->cell, high = low;
    for (const auto& placed : placed_)
      for (std::size_t d = 0; d < 2; ++d) {
        low[d] = std::min(low[d], placed->cell[d]);
        high[d] = std::max(high[d], placed->cell[d]);
      }
    for (auto& placed : placed_)
      for (std::size_t d = 0; d < 2; ++d) placed->cell[d] -= low[d];
    for (std::size_t d = 0; d < 2; ++d) cells_[d] = high[d] - low[d] + 1;
    require(std::ssize(placed_) == cells_[0] * cells_[1], "contact.faces.grid",
            {{"list", list_}, {"face", parts_[order_.back()].name}});
  }

  /// The parts at index i of direction d have the same elements and functions along it.
  const TurnedPart& leading(std::size_t d, int i) const {
    const TurnedPart* first = nullptr;
    for (std::size_t k = 0; k < placed_.size(); ++k) {
      if (placed_[k]->cell[d] != i) continue;
      const TurnedPart& part = placed_[k]->part;
      if (!first) first = &part;
      require(part.space(d).elements() == first->space(d).elements() && part.functions(d) == first->functions(d),
              "contact.faces.mesh", {{"list", list_}, {"face", parts_[k].name}});
    }
    return *first;
  }

  const std::vector<FacePart>& parts_;
  const Message& list_;
  int dimensions_;
  std::vector<std::optional<Placed>> placed_;
  std::vector<std::size_t> order_;
  std::set<Index2> taken_;
  std::optional<std::size_t> turned_; ///< a part with a common border on the other side of its body
  Index2 cells_{1, 1};
};

/// Appends the elements of a space, with parameters and functions that continue those before.
void append(const nurbs::Space1D& space, bool reversed, std::vector<double>& breaks, std::vector<int>& smoothness,
            std::vector<nurbs::Element1D>& elements, int first_function) {
  const int count = space.elements(), last = space.functions() - 1;
  for (int i = 0; i < count; ++i) {
    const int e = reversed ? count - 1 - i : i;
    nurbs::Element1D element = space.element(e);
    if (reversed) {
      std::reverse(element.functions.begin(), element.functions.end());
      for (int& function : element.functions) function = last - function;
      element.extraction = element.extraction.reverse().eval();
    }
    for (int& function : element.functions) function += first_function;
    elements.push_back(std::move(element));
    const auto [from, to] = space.interval(e);
    breaks.push_back(breaks.back() + (to - from));
    smoothness.push_back(i + 1 < count ? space.smoothness()[reversed ? e : e + 1] : 0);
  }
}

FaceGrid Grid::whole() const {
  std::vector<nurbs::Space1D> directions;
  std::array<std::vector<int>, 2> first_function{std::vector<int>{0}, {0}}, first_element = first_function;
  Index2 size{1, 1};
  for (int d = 0; d < dimensions_; ++d) {
    std::vector<double> breaks;
    std::vector<int> smoothness{-1};
    std::vector<nurbs::Element1D> elements;
    for (int i = 0; i < cells_[d]; ++i) {
      const TurnedPart& part = leading(d, i);
      if (i == 0) breaks = {part.space(d).first()};
      append(part.space(d), part.reversed(d), breaks, smoothness, elements, first_function[d].back());
      first_function[d].push_back(first_function[d].back() + part.functions(d) - 1);
      first_element[d].push_back(static_cast<int>(elements.size()));
    }
    smoothness.back() = -1;
    size[d] = first_function[d].back() + 1;
    directions.emplace_back(std::move(breaks), std::move(smoothness), elements);
  }

  std::vector<int> nodes(size[0] * size[1], -1);
  MatrixX points(parts_.front().row.homogeneous().rows(), static_cast<Eigen::Index>(nodes.size()));
  const Eigen::Index weight = points.rows() - 1;
  for (const std::size_t k : order_) {
    const TurnedPart& part = placed_[k]->part;
    const Index2& cell = placed_[k]->cell;
    const Index2 from{first_function[0][cell[0]], first_function[1][cell[1]]};
    // A constant factor on all weights makes those on the borders equal.
    const auto each = [&](const auto& visit) {
      for (Index2 i{0, 0}; i[1] < part.functions(1); ++i[1])
        for (i[0] = 0; i[0] < part.functions(0); ++i[0]) visit(i, from[0] + i[0] + size[0] * (from[1] + i[1]));
    };
    double factor = 0;
    each([&](const Index2& i, int to) {
      if (nodes[to] < 0) return;
      const double ratio = points(weight, to) / part.homogeneous(i)(weight);
      if (factor == 0) factor = ratio;
      require(nodes[to] == part.node(i) && std::abs(ratio / factor - 1) <= same_weights, "contact.faces.mesh",
              {{"list", list_}, {"face", parts_[k].name}});
    });
    each([&](const Index2& i, int to) {
      if (nodes[to] >= 0) return;
      nodes[to] = part.node(i);
      points.col(to) = (factor == 0 ? 1 : factor) * part.homogeneous(i);
    });
  }

  FaceGrid result{nurbs::Row(directions, points), std::move(nodes), parts_.front().orientation, {}};
  for (const auto& placed : placed_) {
    const auto& [part, cell] = *placed;
    FacePlace place{part.way(), {1, 1}, {0, 0}, directions[0].elements()};
    for (int d = 0; d < dimensions_; ++d) {
      place.elements[part.along(d)] = part.space(d).elements();
      place.first[d] = first_element[d][cell[d]];
    }
    result.places.push_back(place);
  }
  return result;
}

} // namespace

int FacePlace::element(int f) const {
  const std::array<int, 2> own{f % elements[0], f / elements[0]};
  const auto there = way.turn(own, [&](std::size_t k, int i) { return elements[k] - 1 - i; });
  return first[0] + there[0] + width * (first[1] + there[1]);
}

int FacePlace::point(int number, int per_direction) const {
  const std::array<int, 2> own{number % per_direction, number / per_direction};
  const auto there = way.turn(own, [&](std::size_t, int i) { return per_direction - 1 - i; });
  return there[0] + per_direction * there[1];
}

FaceGrid arrange(const std::vector<FacePart>& parts, const Message& list) {
  return Grid(parts, list).whole();
}

} // namespace signorini::contact
