#include "exchange/interfaces.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::exchange {

namespace {

using nurbs::Orientation;
using nurbs::Side;

/// Control points of an interface coincide within this fraction of the face's size, weights and knots within this
/// relative difference: files of other programs often have six or seven digits.
constexpr double matching_digits = 1e-6;

bool same_knots(const nurbs::KnotVector& a, const nurbs::KnotVector& b, bool reversed) {
  if (a.degree() != b.degree() || a.knots().size() != b.knots().size()) return false;
  const auto relative = [](const nurbs::KnotVector& of, std::size_t i) {
    const auto& knots = of.knots();
    return (knots[i] - knots.front()) / (knots.back() - knots.front());
  };
  for (std::size_t i = 0, last = a.knots().size() - 1; i <= last; ++i) {
    const double other = reversed ? 1 - relative(b, last - i) : relative(b, i);
    if (std::abs(relative(a, i) - other) > matching_digits) return false;
  }
  return true;
}

bool matches(const Patch& a, const Patch& b, const Orientation& way) {
  std::array<int, 2> count{1, 1};
  for (std::size_t k = 0; k < a.directions().size(); ++k) {
    if (!same_knots(a.directions()[k], b.directions()[way.to[k]], way.flip[k])) return false;
    count[k] = a.directions()[k].functions();
  }
  const MatrixX here = a.points(), there = b.points();
  const VectorX weights = a.weights(), others = b.weights();
  const double size = (here.rowwise().maxCoeff() - here.rowwise().minCoeff()).norm();
  double factor = 0;
  for (std::array<int, 2> index{0, 0}; index[1] < count[1]; ++index[1])
    for (index[0] = 0; index[0] < count[0]; ++index[0]) {
      const auto turned = way.turn(index, [&](std::size_t k, int i) { return count[k] - 1 - i; });
      const Eigen::Index i = index[0] + count[0] * index[1];
      const Eigen::Index j = turned[0] + b.directions().front().functions() * turned[1];
      const double ratio = weights(i) / others(j);
      if (factor == 0) factor = ratio;
      if (std::abs(ratio / factor - 1) > matching_digits) return false;
      if ((here.col(i) - there.col(j)).norm() > matching_digits * size) return false;
    }
  return true;
}

std::optional<Orientation> orientation_of(const Patch& first, const Patch& second) {
  if (first.dimension() != second.dimension() || first.parametric_dimension() != second.parametric_dimension())
    return std::nullopt;
  for (const Orientation& way : nurbs::orientations(first.parametric_dimension()))
    if (matches(first, second, way)) return way;
  return std::nullopt;
}

/// A face with the bounding box of its control points.
struct BoxedFace {
  PatchFace face;
  Patch surface;
  VectorX low, high;
};

std::vector<BoxedFace> faces_of(const Geometry& geometry) {
  std::vector<BoxedFace> faces;
  for (std::size_t i = 0; i < geometry.patches.size(); ++i) {
    const Patch& patch = geometry.patches[i];
    if (patch.parametric_dimension() < 2) continue; // ends of curves are not patches
    for (const Side side : nurbs::sides(patch.parametric_dimension())) {
      const Patch surface = nurbs::face(patch, side);
      const MatrixX points = surface.points();
      faces.push_back({{static_cast<int>(i), side}, surface, points.rowwise().minCoeff(), points.rowwise().maxCoeff()});
    }
  }
  return faces;
}

bool same_boxes(const BoxedFace& a, const BoxedFace& b) {
  if (a.low.size() != b.low.size()) return false;
  const double tolerance = matching_digits * (a.high - a.low).norm();
  return (a.low - b.low).norm() <= tolerance && (a.high - b.high).norm() <= tolerance;
}

std::vector<OrientedInterface> found_interfaces(const Geometry& geometry) {
  std::vector<OrientedInterface> found;
  const std::vector<BoxedFace> faces = faces_of(geometry);
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      // A closed patch coincides with itself at its seam, which the formats do not list.
      if (faces[i].face.patch == faces[j].face.patch || !same_boxes(faces[i], faces[j])) continue;
      if (const auto way = orientation_of(faces[i].surface, faces[j].surface))
        found.push_back({{faces[i].face, faces[j].face}, *way});
    }
  return found;
}

} // namespace

std::vector<OrientedInterface> interfaces_of(const Geometry& geometry) {
  if (!geometry.interfaces) return found_interfaces(geometry);
  std::vector<OrientedInterface> listed;
  for (const Interface& faces : *geometry.interfaces) {
    const auto surface = [&](const PatchFace& face) { return nurbs::face(geometry.patches[face.patch], face.side); };
    const auto way = orientation_of(surface(faces[0]), surface(faces[1]));
    require(way.has_value(), "exchange.write.interface",
            {{"number", listed.size()},
             {"first", faces[0].patch + 1},
             {"first_face", nurbs::name_of(faces[0].side)},
             {"second", faces[1].patch + 1},
             {"second_face", nurbs::name_of(faces[1].side)}});
    listed.push_back({faces, *way});
  }
  return listed;
}

std::vector<PatchFace> outer_faces(const Geometry& geometry, const std::vector<OrientedInterface>& interfaces) {
  std::vector<PatchFace> outer;
  for (std::size_t i = 0; i < geometry.patches.size(); ++i)
    for (const Side side : nurbs::sides(geometry.patches[i].parametric_dimension())) {
      const PatchFace face{static_cast<int>(i), side};
      const bool inner = std::any_of(interfaces.begin(), interfaces.end(), [&](const OrientedInterface& one) {
        return one.faces[0] == face || one.faces[1] == face;
      });
      if (!inner) outer.push_back(face);
    }
  return outer;
}

int number_of(Side side) {
  return 2 * side.direction + (side.at_end ? 2 : 1);
}

Side side_of_number(int number) {
  return {(number - 1) / 2, number % 2 == 0};
}

} // namespace signorini::exchange
