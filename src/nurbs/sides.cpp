// Names of a patch's sides, and the patches on them.
#include "nurbs/patch.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace signorini::nurbs {

namespace {

const char* const names[] = {"west", "east", "south", "north", "front", "back"};

/// Levenshtein distance: the least number of letters inserted, removed or replaced.
int edits(const std::string& a, const std::string& b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = std::exchange(row[0], static_cast<int>(i));
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

/// Everyday names that fit a rectangle or a block along the axes.
struct Nickname {
  const char *name, *plane, *space;
};
const Nickname nicknames[] = {
    {"left", "west", "west"}, {"right", "east", "east"},   {"bottom", "south", "front"},
    {"top", "north", "back"}, {"lower", "south", "front"}, {"upper", "north", "back"},
};

} // namespace

std::string meant_side(const std::string& name, int parametric_dimension) {
  for (const auto& [nickname, plane, space] : nicknames)
    if (name == nickname) return parametric_dimension == 2 ? plane : space;
  const auto end = names + 2 * parametric_dimension;
  const auto nearest = std::min_element(names, end, [&](auto a, auto b) { return edits(name, a) < edits(name, b); });
  return edits(name, *nearest) <= 2 ? *nearest : "";
}

Side side_of(const std::string& name, int parametric_dimension) {
  require(parametric_dimension >= 1 && parametric_dimension <= 3, "nurbs.patch.directions",
          {{"count", parametric_dimension}});
  const auto end = names + 2 * parametric_dimension;
  const auto found = std::find(names, end, name);
  if (found == end) {
    const std::vector<std::string> known(names, end), ends = {"xi1", "xi2", "xi3"};
    const std::string meant = meant_side(name, parametric_dimension);
    fail("nurbs.face.unknown",
         {{"face", name},
          {"suggestion", meant.empty() ? Message() : Message("nurbs.face.did_you_mean", {{"face", meant}})},
          {"known", known},
          {"ends", std::vector<std::string>(ends.begin(), ends.begin() + parametric_dimension)}});
  }
  const int i = static_cast<int>(found - names);
  return {i / 2, i % 2 == 1};
}

std::vector<Side> sides(int parametric_dimension) {
  std::vector<Side> all;
  for (int d = 0; d < parametric_dimension; ++d)
    for (const bool at_end : {false, true}) all.push_back({d, at_end});
  return all;
}

std::string name_of(Side side) {
  return names[2 * side.direction + (side.at_end ? 1 : 0)];
}

double outward_sign(Side side) {
  // Natural normals. 2D: that of south (ξ² = 0, tangent +ξ¹) rotated by −90° points outwards, that of west (ξ¹ = 0,
  // tangent +ξ²) inwards. 3D: ξ²×ξ³ is +ξ¹, ξ¹×ξ³ is −ξ², ξ¹×ξ² is +ξ³.
  return side.at_end == (side.direction == 1) ? -1 : 1;
}

template <class Direction> TensorProduct<Direction> face(const TensorProduct<Direction>& patch, Side side) {
  require(side.direction >= 0 && side.direction < patch.parametric_dimension(), "nurbs.face.direction",
          {{"direction", side.direction}, {"count", patch.parametric_dimension()}});
  return control_row(patch, side.direction, side.at_end ? patch.direction(side.direction).functions() - 1 : 0);
}

template <class Direction>
TensorProduct<Direction> control_row(const TensorProduct<Direction>& patch, int through, int j) {
  require(patch.parametric_dimension() >= 2, "nurbs.face.curve");
  require(through >= 0 && through < patch.parametric_dimension(), "nurbs.row.direction",
          {{"direction", through}, {"count", patch.parametric_dimension()}});
  const int count = patch.direction(through).functions();
  require(j >= 0 && j < count, "nurbs.row.number", {{"row", j}, {"count", count}});
  const int stride = patch.stride(through);
  std::vector<Direction> directions = patch.directions();
  directions.erase(directions.begin() + through);
  // Index = inner + stride·(i_through + count·outer)
  MatrixX homogeneous(patch.dimension() + 1, patch.functions() / count);
  for (int n = 0; n < homogeneous.cols(); ++n)
    homogeneous.col(n) = patch.homogeneous().col(n % stride + stride * (j + count * (n / stride)));
  return {std::move(directions), std::move(homogeneous)};
}

template Patch face(const Patch&, Side);
template Row face(const Row&, Side);
template Patch control_row(const Patch&, int, int);
template Row control_row(const Row&, int, int);

} // namespace signorini::nurbs
