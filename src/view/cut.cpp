#include "view/cut.hpp"

#include "base/error.hpp"
#include "base/warning.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>

namespace signorini::view {
namespace {

/// Signed distances of points to a plane, positive on the removed side; zero within the tolerance.
VectorX distances(const Points& points, const CutPlane& plane, double tolerance) {
  const Vec<3> normal = plane.normal.normalized();
  VectorX result = (normal.transpose() * (points.colwise() - plane.point)).transpose();
  return (result.array().abs() <= tolerance).select(0, result);
}

/// A point between two others, given by index, at the fraction `t`.
struct Mix {
  int from, to;
  double t;

  Vec<3> of(const Points& points) const { return points.col(from) + t * (points.col(to) - points.col(from)); }
  double of(const VectorX& values) const { return values[from] + t * (values[to] - values[from]); }
};

/// The intersection of the plane and an edge between points on different sides.
Mix crossing(int from, int to, const VectorX& distance) {
  return {from, to, distance[from] / (distance[from] - distance[to])};
}

/// Collects vertices and triangles of a surface.
struct Builder {
  std::vector<Vec<3>> points, normals, vectors;
  std::vector<double> values;
  std::vector<std::array<int, 3>> triangles;

  void fan(int first) {
    for (int k = first + 2; k < std::ssize(points); ++k) triangles.push_back({first, k - 1, k});
  }

  Surface surface() const {
    const auto columns = [](const std::vector<Vec<3>>& list) {
      return Points(Eigen::Map<const Points>(list.empty() ? nullptr : list.front().data(), 3,
                                             static_cast<Eigen::Index>(list.size())));
    };
    Surface result{columns(points), columns(normals), {}, {}, columns(vectors)};
    result.values = Eigen::Map<const VectorX>(values.data(), static_cast<Eigen::Index>(values.size()));
    result.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t)
      result.triangles.col(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
    return result;
  }
};

/// The segment of the plane within a triangle of a list of points; empty if they only touch.
std::optional<std::array<Mix, 2>> trace(const std::array<int, 3>& triangle, const VectorX& distance) {
  std::vector<Mix> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const int a = triangle[k], b = triangle[(k + 1) % 3];
    if ((distance[a] < 0) != (distance[b] < 0)) ends.push_back(crossing(a, b, distance));
  }
  if (ends.size() < 2) return std::nullopt;
  return std::array{ends[0], ends[1]};
}

SurfaceLine segment(const std::array<Mix, 2>& ends, const Lattice& lattice, const Vec<3>& normal, double spacing) {
  SurfaceLine line{Points(3, 2), Points(3, 2), spacing};
  line.points << ends[0].of(lattice.points), ends[1].of(lattice.points);
  line.normals << normal, normal;
  return line;
}

/// Index of a lattice point from its three counts.
struct LatticeIndex {
  int side;
  int operator()(int i, int j, int k) const { return i + side * (j + side * k); }
};

/// Kuhn's subdivision of a cube into six tetrahedra, each along one path of edges from corner 0 to corner 7 (H. W.
/// Kuhn, IBM J. Res. Dev. 4, 1960). Bits of a corner count its steps along ξ¹ ξ² ξ³. Neighbors share the diagonals of
/// their faces.
constexpr int tetrahedra[6][4] = {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}};

/// The intersection of the plane and a tetrahedron: empty, a triangle, or a quadrilateral.
std::vector<Mix> section(const std::array<int, 4>& corners, const VectorX& distance) {
  std::vector<int> kept, gone;
  for (int corner : corners) (distance[corner] < 0 ? kept : gone).push_back(corner);
  if (kept.empty() || gone.empty()) return {};
  if (kept.size() == 2)
    return {crossing(kept[0], gone[0], distance), crossing(kept[0], gone[1], distance),
            crossing(kept[1], gone[1], distance), crossing(kept[1], gone[0], distance)};
  std::vector<Mix> polygon;
  for (int a : kept)
    for (int b : gone) polygon.push_back(crossing(a, b, distance));
  return polygon;
}

void add_section(Builder& builder, const Lattice& lattice, const VectorX& distance, const Vec<3>& normal) {
  const int n = lattice.divisions;
  const LatticeIndex at{n + 1};
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        for (const auto& tetrahedron : tetrahedra) {
          std::array<int, 4> corners{};
          std::transform(tetrahedron, tetrahedron + 4, corners.begin(),
                         [&](int c) { return at(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)); });
          const int first = std::ssize(builder.points);
          for (const Mix& mix : section(corners, distance)) {
            builder.points.push_back(mix.of(lattice.points));
            builder.normals.push_back(normal);
            if (lattice.values.size() > 0) builder.values.push_back(mix.of(lattice.values));
          }
          builder.fan(first);
        }
}

/// The intersection of the plane and the six sides of an element.
void add_borders(std::vector<SurfaceLine>& lines, const Lattice& lattice, const VectorX& distance,
                 const Vec<3>& normal) {
  const int n = lattice.divisions, half = n / 2;
  const LatticeIndex at{n + 1};
  for (int across = 0; across < 3; ++across) {
    const auto index = [&](int depth, int u, int v) {
      return across == 0 ? at(depth, u, v) : across == 1 ? at(u, depth, v) : at(u, v, depth);
    };
    const double spacing = (lattice.points.col(index(n, half, half)) - lattice.points.col(index(0, half, half))).norm();
    for (int end : {0, n})
      for (int v = 0; v < n; ++v)
        for (int u = 0; u < n; ++u) {
          const int a = index(end, u, v), b = index(end, u + 1, v), c = index(end, u + 1, v + 1),
                    d = index(end, u, v + 1);
          for (const std::array<int, 3>& triangle : {std::array{a, b, c}, std::array{a, c, d}})
            if (const auto ends = trace(triangle, distance)) lines.push_back(segment(*ends, lattice, normal, spacing));
        }
  }
}

/// Keeps the vectors of the first surface only.
Surface joined(const Surface& a, const Surface& b) {
  Surface both;
  const Eigen::Index n = a.points.cols();
  both.points.resize(3, n + b.points.cols());
  both.points << a.points, b.points;
  both.normals.resize(3, both.points.cols());
  both.normals << a.normals, b.normals;
  both.triangles.resize(3, a.triangles.cols() + b.triangles.cols());
  both.triangles << a.triangles, b.triangles.array() + static_cast<int>(n);
  both.values.resize(a.values.size() + b.values.size());
  both.values << a.values, b.values;
  if (a.vectors.cols() > 0) both.vectors.setZero(3, both.points.cols()), both.vectors.leftCols(n) = a.vectors;
  return both;
}

/// Keeps the control points on the remaining side and the net lines between them.
void keep_control_points(Body& left, const Body& body, const VectorX& distance) {
  std::vector<int> kept, place(static_cast<std::size_t>(distance.size()), -1);
  for (int i = 0; i < distance.size(); ++i)
    if (distance[i] <= 0) place[static_cast<std::size_t>(i)] = std::ssize(kept), kept.push_back(i);
  left.control_points = body.control_points(Eigen::all, kept);
  for (const auto& [a, b] : body.net_lines) {
    const int from = place[static_cast<std::size_t>(a)], to = place[static_cast<std::size_t>(b)];
    if (from >= 0 && to >= 0) left.net_lines.push_back({from, to});
  }
}

/// The edge that contains a point.
std::array<int, 2> edge_of(const Mix& mix) {
  return {std::min(mix.from, mix.to), std::max(mix.from, mix.to)};
}

/// Joins segments of triangles at shared edges.
std::vector<std::deque<Mix>> joined(const std::vector<std::array<Mix, 2>>& pieces) {
  std::map<std::array<int, 2>, std::vector<std::size_t>> at_edge;
  for (std::size_t n = 0; n < pieces.size(); ++n)
    for (const Mix& end : pieces[n]) at_edge[edge_of(end)].push_back(n);
  std::vector<bool> used(pieces.size());
  /// The other end of an unused segment that starts at this one.
  const auto next = [&](const Mix& end) -> std::optional<Mix> {
    for (std::size_t n : at_edge[edge_of(end)]) {
      if (used[n]) continue;
      used[n] = true;
      return pieces[n][edge_of(pieces[n][0]) == edge_of(end) ? 1 : 0];
    }
    return std::nullopt;
  };
  std::vector<std::deque<Mix>> ways;
  for (std::size_t n = 0; n < pieces.size(); ++n) {
    if (used[n]) continue;
    used[n] = true;
    std::deque<Mix>& way = ways.emplace_back(pieces[n].begin(), pieces[n].end());
    while (const auto end = next(way.back())) way.push_back(*end);
    while (const auto end = next(way.front())) way.push_front(*end);
  }
  return ways;
}

SurfaceLine line_of(const std::deque<Mix>& way, const Points& points, const Points& normals, double spacing = 0) {
  const auto count = static_cast<Eigen::Index>(way.size());
  SurfaceLine line{Points(3, count), Points::Zero(3, count), spacing};
  for (Eigen::Index i = 0; i < count; ++i) {
    line.points.col(i) = way[static_cast<std::size_t>(i)].of(points);
    if (normals.cols() > 0) line.normals.col(i) = way[static_cast<std::size_t>(i)].of(normals).stableNormalized();
  }
  return line;
}

} // namespace

Surface cut(const Surface& surface, const CutPlane& plane, double tolerance) {
  const VectorX distance = distances(surface.points, plane, tolerance);
  const bool valued = surface.values.size() > 0;
  Builder builder;
  for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
    const int first = std::ssize(builder.points);
    const auto add = [&](const Mix& mix) {
      builder.points.push_back(mix.of(surface.points));
      if (surface.normals.cols() > 0) builder.normals.push_back(mix.of(surface.normals).stableNormalized());
      if (surface.vectors.cols() > 0) builder.vectors.push_back(mix.of(surface.vectors));
      if (valued) builder.values.push_back(mix.of(surface.values));
    };
    // Sutherland–Hodgman clipping of the triangle
    for (int k = 0; k < 3; ++k) {
      const int a = surface.triangles(k, t), b = surface.triangles((k + 1) % 3, t);
      if (distance[a] <= 0) add({a, a, 0});
      if (distance[a] * distance[b] < 0) add(crossing(a, b, distance));
    }
    builder.fan(first);
  }
  return builder.surface();
}

std::vector<SurfaceLine> cut(const std::vector<SurfaceLine>& lines, const CutPlane& plane, double tolerance) {
  std::vector<SurfaceLine> parts;
  for (const SurfaceLine& line : lines) {
    const VectorX distance = distances(line.points, plane, tolerance);
    std::deque<Mix> part;
    const auto finish = [&] {
      if (part.size() > 1) parts.push_back(line_of(part, line.points, line.normals, line.spacing));
      part.clear();
    };
    for (int i = 0; i < line.points.cols(); ++i) {
      if (i > 0 && distance[i - 1] * distance[i] < 0) part.push_back(crossing(i - 1, i, distance));
      if (distance[i] <= 0)
        part.push_back({i, i, 0});
      else
        finish();
    }
    finish();
  }
  return parts;
}

RigidSurface cut(const RigidSurface& rigid, const CutPlane& plane, double tolerance) {
  RigidSurface left{cut(rigid.surface, plane, tolerance), traces(rigid.surface, plane, tolerance)};
  for (SurfaceLine& part : cut(rigid.rim, plane, tolerance)) left.rim.push_back(std::move(part));
  return left;
}

std::vector<SurfaceLine> zeros(const Surface& surface, const VectorX& values) {
  std::vector<std::array<Mix, 2>> pieces;
  for (const auto& t : surface.triangles.colwise())
    if (const auto ends = trace({t[0], t[1], t[2]}, values)) pieces.push_back(*ends);
  std::vector<SurfaceLine> lines;
  for (const std::deque<Mix>& way : joined(pieces)) lines.push_back(line_of(way, surface.points, surface.normals));
  return lines;
}

std::vector<SurfaceLine> traces(const Surface& surface, const CutPlane& plane, double tolerance) {
  return zeros(surface, distances(surface.points, plane, tolerance));
}

std::optional<CutPlane> crossed_mirror(const Points& points, int axis) {
  constexpr double rounding = 1e-6;
  if (points.cols() == 0) return std::nullopt;
  const double low = points.row(axis).minCoeff(), high = points.row(axis).maxCoeff(), least = rounding * (high - low);
  if (low >= -least || high <= least) return std::nullopt;
  const std::string letter(1, "xyz"[axis]);
  constexpr double noteworthy = 0.01;
  if (std::min(-low, high) > noteworthy * (high - low))
    warn("view.mirror.across", {{"axis", letter}, {"low", low}, {"high", high}});
  return CutPlane{Vec<3>::Zero(), (high + low >= -least ? -1 : 1) * Vec<3>::Unit(axis)};
}

Body cut(const Body& body, const CutPlane& plane) {
  const double tolerance = cut_tolerance * bounds(body).size();
  const Vec<3> normal = plane.normal.normalized();
  Body left;
  left.mesh = body.mesh;
  left.open = body.open;
  const VectorX distance = distances(body.skin.points, plane, tolerance);
  if (distance.size() > 0 && distance.minCoeff() < 0) {
    Builder face;
    for (const Lattice& lattice : body.inside) {
      const VectorX inside = distances(lattice.points, plane, tolerance);
      if (inside.minCoeff() >= 0 || inside.maxCoeff() < 0) continue;
      add_section(face, lattice, inside, normal);
      add_borders(left.mesh_lines, lattice, inside, normal);
    }
    left.skin = cut(body.skin, plane, tolerance);
    if (!face.points.empty()) left.skin = joined(left.skin, face.surface());
    left.rim = traces(body.skin, plane, tolerance);
    for (SurfaceLine& line : left.rim) line.normals.colwise() = normal;
    for (SurfaceLine& line : cut(body.mesh_lines, plane, tolerance)) left.mesh_lines.push_back(std::move(line));
    for (SurfaceLine& line : cut(body.rim, plane, tolerance)) left.rim.push_back(std::move(line));
  }
  left.undeformed = cut(body.undeformed, plane, tolerance);
  left.undeformed_rim = cut(body.undeformed_rim, plane, tolerance);
  keep_control_points(left, body, distances(body.control_points, plane, tolerance));
  return left;
}

} // namespace signorini::view
