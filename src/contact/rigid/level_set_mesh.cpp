// Marching tetrahedra (3D) or triangles (2D).

#include "base/error.hpp"
#include "contact/constants.hpp"
#include "contact/rigid/level_set.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace signorini::contact {

namespace {

/// Cells along the longest side of the box.
template <int D> constexpr int most_cells = D == 2 ? 160 : 40;

/// Corners of the simplices of a cell, the paths from corner 0 to its opposite along the axes; bit d of a corner's
/// number is set at the end of axis d (H. W. Kuhn, IBM J. Res. Dev. 4, 1960).
constexpr std::array<std::array<int, 3>, 2> triangles_of_cell = {{{0, 1, 3}, {0, 3, 2}}};
constexpr std::array<std::array<int, 4>, 6> tetrahedra_of_cell = {
    {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};
template <int D> constexpr const auto& simplices_of_cell() {
  if constexpr (D == 2)
    return triangles_of_cell;
  else
    return tetrahedra_of_cell;
}

template <int D> class March {
public:
  explicit March(const CompiledLevelSet<D>& f) : f_(f) {
    const Vec<D> sides = f.high - f.low;
    spacing_ = sides.maxCoeff() / most_cells<D>;
    int nodes = 1;
    for (int d = 0; d < D; ++d) {
      cells_[d] = std::max(1, static_cast<int>(std::ceil(sides(d) / spacing_ * (1 - cell_rounding))));
      step_(d) = sides(d) / cells_[d];
      stride_[d] = nodes;
      nodes *= cells_[d] + 1;
    }
    values_.resize(nodes);
    for (int node = 0; node < nodes; ++node) {
      const double value = values_[node] = f(position(node)).value;
      require(std::isfinite(value), "contact.level_set.not_finite", {{"value", value}, {"at", position(node)}});
    }
  }

  LevelMesh<D> run() {
    LevelMesh<D> mesh;
    mesh.spacing = spacing_;
    for (int node = 0; node < std::ssize(values_); ++node)
      if (starts_cell(node)) take_cell(node, mesh);
    if (points_.empty()) {
      const auto [least, most] = std::ranges::minmax(values_);
      fail("contact.level_set.no_zero", {{"least", least}, {"most", most}, {"spacing", spacing_}});
    }
    mesh.points.resize(D, static_cast<Eigen::Index>(points_.size()));
    for (std::size_t i = 0; i < points_.size(); ++i) mesh.points.col(static_cast<Eigen::Index>(i)) = points_[i];
    return mesh;
  }

private:
  int place(int node, int axis) const { return node / stride_[axis] % (cells_[axis] + 1); }
  Vec<D> position(int node) const {
    Vec<D> x;
    for (int d = 0; d < D; ++d) x(d) = f_.low(d) + place(node, d) * step_(d);
    return x;
  }
  bool starts_cell(int node) const {
    for (int d = 0; d < D; ++d)
      if (place(node, d) == cells_[d]) return false;
    return true;
  }
  bool outside(int node) const { return values_[node] > 0; }

  void take_cell(int node, LevelMesh<D>& mesh) {
    for (const auto& simplex : simplices_of_cell<D>()) {
      std::array<int, D + 1> corners;
      for (int k = 0; k <= D; ++k) {
        corners[k] = node;
        for (int d = 0; d < D; ++d)
          if (simplex[k] >> d & 1) corners[k] += stride_[d];
      }
      const auto middle = std::partition(corners.begin(), corners.end(), [&](int c) { return !outside(c); });
      if (middle == corners.begin() || middle == corners.end()) continue;
      take_simplex(corners, static_cast<int>(middle - corners.begin()), mesh);
    }
  }

  /// `inner` corners, which come first, are inside.
  void take_simplex(const std::array<int, D + 1>& corners, int inner, LevelMesh<D>& mesh) {
    std::vector<int> found; // of a quadrangle in 3D in cyclic order: (0,2) (0,3) (1,3) (1,2)
    for (int i = 0; i < inner; ++i)
      for (int k = inner; k <= D; ++k) {
        const int o = i % 2 == 1 ? inner + D - k : k;
        found.push_back(crossing(corners[i], corners[o]));
      }
    const Vec<D> out = position(corners[D]) - position(corners[0]); // from inside to outside
    std::array<int, D> piece;
    for (std::size_t first = 1; first + D - 1 <= found.size(); ++first) {
      piece[0] = found[0];
      for (int k = 1; k < D; ++k) piece[k] = found[first + k - 1];
      Eigen::Matrix<double, D, D - 1> sides;
      for (int k = 1; k < D; ++k) sides.col(k - 1) = points_[piece[k]] - points_[piece[0]];
      std::array<Vec<D>, D - 1> tangents;
      for (int k = 0; k < D - 1; ++k) tangents[k] = sides.col(k);
      if (normal_of<D>(tangents).dot(out) < 0) std::swap(piece[0], piece[1]);
      std::array<int, D> sorted = piece;
      std::ranges::sort(sorted);
      if (std::ranges::adjacent_find(sorted) == sorted.end()) mesh.simplices.push_back(piece);
    }
  }

  /// The number of the point on the edge between two nodes, of which the first is inside; a node where f = 0 is one
  /// point for all of its edges.
  int crossing(int inner, int outer) {
    if (values_[inner] == 0) outer = inner;
    const auto count = static_cast<long>(values_.size());
    const long key = std::min(inner, outer) * count + std::max(inner, outer);
    const auto [known, added] = known_.try_emplace(key, static_cast<int>(points_.size()));
    if (added) points_.push_back(root(position(inner), position(outer), values_[inner], values_[outer]));
    return known->second;
  }

  /// The zero between two points, by Newton's method with bisection.
  Vec<D> root(const Vec<D>& inner, const Vec<D>& outer, double inner_value, double outer_value) const {
    double low = 0, high = 1, t = inner_value == 0 ? 0 : inner_value / (inner_value - outer_value);
    LevelValue<D> at;
    for (int iteration = 0; iteration < most_edge_iterations; ++iteration) {
      at = f_(inner + t * (outer - inner));
      if (at.value == 0) break;
      (at.value > 0 ? high : low) = t;
      const double newton = t - at.value / at.gradient.dot(outer - inner);
      const double next = newton > low && newton < high ? newton : 0.5 * (low + high), change = std::abs(next - t);
      t = next;
      if (change <= edge_tolerance) break;
    }
    const Vec<D> place = inner + t * (outer - inner);
    at = f_(place);
    const double size = std::max(std::abs(inner_value), std::abs(outer_value));
    require(std::abs(at.value) <= jump_value * size, "contact.level_set.jump",
            {{"at", place}, {"before", inner_value}, {"after", outer_value}});
    require(at.gradient.norm() * spacing_ > least_gradient * size, "contact.level_set.no_gradient", {{"at", place}});
    return place;
  }

  const CompiledLevelSet<D>& f_;
  double spacing_;
  Vec<D> step_;
  std::array<int, D> cells_, stride_;
  std::vector<double> values_; ///< of f at the nodes, the first axis fastest
  std::vector<Vec<D>> points_;
  std::unordered_map<long, int> known_; ///< points by edge
};

} // namespace

template <int D> LevelMesh<D> march(const CompiledLevelSet<D>& f) {
  return March<D>(f).run();
}
template LevelMesh<2> march(const CompiledLevelSet<2>&);
template LevelMesh<3> march(const CompiledLevelSet<3>&);

} // namespace signorini::contact
