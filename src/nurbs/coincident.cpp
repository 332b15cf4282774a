#include "nurbs/coincident.hpp"

#include "base/error.hpp"
#include "base/groups.hpp"
#include "nurbs/constants.hpp"

#include <algorithm>
#include <iterator>

namespace signorini::nurbs {

namespace {

using Functions = std::vector<int>;

/// Positions of the control points and the tolerance for coincidence.
class Positions {
public:
  explicit Positions(const Discretization& space)
      : points_(space.points()), weights_(space.homogeneous().bottomRows(1).transpose()),
        tolerance_(same_place * (points_.rowwise().maxCoeff() - points_.rowwise().minCoeff()).maxCoeff()) {}

  bool same(const VectorX& a, const VectorX& b) const { return (a - b).norm() <= tolerance_; }
  bool same(int a, int b) const { return same(points_.col(a), points_.col(b)); }
  bool same_weight(int a, int b) const { return std::abs(weights_(a) - weights_(b)) <= same_place * weights_(a); }

  bool one_point(const Functions& line) const {
    return std::all_of(line.begin(), line.end(), [&](int function) { return same(line.front(), function); });
  }

private:
  MatrixX points_;
  VectorX weights_;
  double tolerance_;
};

/// Functions of a side as lines of control points along direction k; empty if the rows of a layer have no such lines.
std::vector<Functions> lines_along(const Discretization& space, Side side, int k) {
  const int through = space.through();
  const int rows = std::ssize(space.rows());
  std::vector<Functions> lines;
  if (side.direction == through) {
    // All in one row: index = first + i + n0·j
    const Functions all = space.face_functions(side);
    const int n0 = space.rows()[side.at_end ? rows - 1 : 0].direction(0).functions();
    const bool fastest = space.in_row(k) == 0;
    lines.resize(fastest ? all.size() / n0 : n0);
    for (std::size_t i = 0; i < all.size(); ++i) lines[fastest ? i / n0 : i % n0].push_back(all[i]);
    return lines;
  }
  for (int j = 0; j < rows; ++j) {
    const Functions cut = row_end(space, j, space.in_row(side.direction), side.at_end);
    if (k != through) {
      lines.push_back(cut);
      continue;
    }
    // Layer rows have different functions: there are no lines from row to row.
    if (!lines.empty() && cut.size() != lines.size()) return {};
    lines.resize(cut.size());
    for (std::size_t i = 0; i < cut.size(); ++i) lines[i].push_back(cut[i]);
  }
  return lines;
}

/// True if two rows have the same shape, possibly with different control points.
bool same_shape(const Row& a, const Row& b, const Positions& positions) {
  const std::vector<double> first = sites(a.direction(0)),
                            second = a.parametric_dimension() > 1 ? sites(a.direction(1)) : std::vector<double>{0};
  VectorX xi(a.parametric_dimension());
  for (double v : second)
    for (double u : first) {
      xi(xi.size() - 1) = v;
      xi(0) = u;
      if (!positions.same(evaluate(a, xi), evaluate(b, xi))) return false;
    }
  return true;
}

/// Throws Error if a contact face is the seam of a full revolution, which is not a surface of the body.
void check_contact(const Discretization& space, const Positions& positions) {
  if (!space.contact().empty() && same_shape(space.rows().front(), space.rows().back(), positions))
    fail("nurbs.body.seam", {{"face", name_of(space.contact().front())}});
}

/// Throws Error if a side of a solid that crosses a layer collapses along it: its intersections with the rows are the
/// same curve, but the rows have different functions on it.
void check_layers(const Discretization& space, Side side, const Positions& positions) {
  const int through = space.through();
  if (side.direction == through || space.parametric_dimension() == 2) return;
  const int a = space.in_row(side.direction);
  const Row lead = face(space.rows().front(), {a, side.at_end});
  const bool one_curve = std::all_of(space.rows().begin(), space.rows().end(), [&](const Row& row) {
    return same_shape(face(row, {a, side.at_end}), lead, positions);
  });
  if (crosses_layer(space, side) && one_curve && !positions.one_point(row_end(space, 0, a, side.at_end)))
    fail("nurbs.body.torn_layer", {{"face", name_of(side)}, {"contact", name_of(space.contact().front())}});
}

/// The edges of a solid: functions that two sides share.
std::vector<Functions> edges_of(const Discretization& space) {
  std::vector<Functions> edges;
  for (const Side& one : sides(space.parametric_dimension()))
    for (const Side& other : sides(space.parametric_dimension())) {
      if (one.direction >= other.direction) continue;
      Functions first = space.face_functions(one), second = space.face_functions(other), edge;
      std::sort(first.begin(), first.end());
      std::sort(second.begin(), second.end());
      std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(edge));
      edges.push_back(std::move(edge));
    }
  return edges;
}

} // namespace

std::vector<std::vector<int>> coincident_functions(const Discretization& space) {
  const Positions positions(space);
  Groups groups(space.functions());
  const auto unite = [&](const Functions& line) {
    for (int function : line) groups.unite(line.front(), function);
  };
  const int dimensions = space.parametric_dimension();

  check_contact(space, positions);
  for (const Side& side : sides(space.parametric_dimension())) {
    check_layers(space, side, positions);
    for (int k = 0; k < dimensions; ++k) {
      if (k == side.direction) continue;
      const std::vector<Functions> lines = lines_along(space, side, k);
      if (std::all_of(lines.begin(), lines.end(), [&](const Functions& line) { return positions.one_point(line); }))
        for (const Functions& line : lines) unite(line);
    }
  }
  if (dimensions == 3)
    for (const Functions& edge : edges_of(space))
      if (positions.one_point(edge)) unite(edge);

  for (int d : closed_directions(space)) {
    const Functions first = space.face_functions({d, false}), last = space.face_functions({d, true});
    for (std::size_t i = 0; i < first.size(); ++i) groups.unite(first[i], last[i]);
  }
  return groups.all();
}

std::vector<int> closed_directions(const Discretization& space) {
  const Positions positions(space);
  std::vector<int> closed;
  for (int d = 0; d < space.parametric_dimension(); ++d) {
    const Functions first = space.face_functions({d, false}), last = space.face_functions({d, true});
    // The sizes differ if one of the two carries a layer.
    if (std::equal(first.begin(), first.end(), last.begin(), last.end(),
                   [&](int a, int b) { return positions.same(a, b) && positions.same_weight(a, b); }))
      closed.push_back(d);
  }
  return closed;
}

} // namespace signorini::nurbs
