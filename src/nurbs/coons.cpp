// Transfinite interpolation of a closed boundary of curves or surfaces.
#include "nurbs/constructions.hpp"

#include "base/error.hpp"
#include "nurbs/constants.hpp"

#include <algorithm>
#include <array>

namespace signorini::nurbs {

namespace {

/// The boundary as faces of one lattice of control points.
struct Lattice {
  std::vector<Patch> faces; ///< west, east, south, …
  std::array<int, 3> count{1, 1, 1};

  int dimensions() const { return std::ssize(faces) / 2; }

  /// Homogeneous coordinates of lattice point `index`, which is at an end in direction d, on the face normal to d.
  VectorX value(const std::array<int, 3>& index, int d) const {
    const Patch& face = faces[2 * d + (index[d] > 0 ? 1 : 0)];
    int function = 0;
    for (int k = dimensions() - 1; k >= 0; --k)
      if (k != d) function = function * count[k] + index[k];
    return face.homogeneous().col(function);
  }
};

/// Calls visit(index) for every point of the lattice.
template <class Visit> void each_point(const Lattice& lattice, Visit visit) {
  std::array<int, 3> index;
  for (index[2] = 0; index[2] < lattice.count[2]; ++index[2])
    for (index[1] = 0; index[1] < lattice.count[1]; ++index[1])
      for (index[0] = 0; index[0] < lattice.count[0]; ++index[0]) visit(index);
}

/// Throws Error unless points shared by two or three faces coincide.
void check_meeting(const Lattice& lattice, double size) {
  const int space = lattice.faces.front().dimension();
  each_point(lattice, [&](const std::array<int, 3>& index) {
    int known = -1;
    for (int d = 0; d < lattice.dimensions(); ++d) {
      if (index[d] > 0 && index[d] < lattice.count[d] - 1) continue;
      if (known >= 0) {
        const VectorX a = lattice.value(index, known), b = lattice.value(index, d);
        const VectorX x = a.head(space) / a(space), y = b.head(space) / b(space);
        const std::string first = name_of({known, index[known] > 0}), second = name_of({d, index[d] > 0});
        require((x - y).norm() <= computed * size, "nurbs.coons.apart",
                {{"first", first}, {"second", second}, {"at", x}, {"other", y}});
        require(std::abs(a(space) - b(space)) <= computed * std::abs(a(space)), "nurbs.coons.weights",
                {{"first", first}, {"second", second}, {"at", x}, {"one", a(space)}, {"other", b(space)}});
      }
      known = d;
    }
  });
}

void check_boundary(const std::vector<Patch>& boundary) {
  require(boundary.size() == 4 || boundary.size() == 6, "nurbs.coons.count", {{"count", boundary.size()}});
  const int parametric = std::ssize(boundary) / 2 - 1;
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const std::string name = name_of({static_cast<int>(i) / 2, i % 2 == 1});
    require(boundary[i].parametric_dimension() == parametric, "nurbs.coons.directions",
            {{"face", name},
             {"directions", boundary[i].parametric_dimension()},
             {"expected", parametric},
             {"count", boundary.size()}});
    require(boundary[i].dimension() == boundary[0].dimension(), "nurbs.coons.dimension",
            {{"face", name}, {"dimension", boundary[i].dimension()}, {"expected", boundary[0].dimension()}});
  }
}

} // namespace

Patch coons(const std::vector<Patch>& boundary) {
  check_boundary(boundary);
  Lattice lattice{boundary, {1, 1, 1}};
  const int dimensions = lattice.dimensions(), space = boundary.front().dimension();
  std::vector<KnotVector> directions;
  std::vector<std::vector<double>> blends; // per direction and function: weight of the end
  for (int d = 0; d < dimensions; ++d) {
    std::vector<Along> along;
    for (int f = 0; f < 2 * dimensions; ++f)
      if (f / 2 != d) along.push_back({&lattice.faces[f], d < f / 2 ? d : d - 1});
    unify(along);
    directions.push_back(along.front().patch->direction(along.front().direction));
    lattice.count[d] = directions.back().functions();
    blends.push_back(directions.back().greville());
    for (double& blend : blends.back())
      blend = (blend - directions.back().first()) / (directions.back().last() - directions.back().first());
  }
  double size = 0;
  for (const Patch& face : boundary)
    size = std::max(size, (face.points().colwise() - boundary.front().points().col(0)).cwiseAbs().maxCoeff());
  check_meeting(lattice, size);

  // Boolean sum of the linear blends (Gordon & Hall 1973), over all sets D of directions:
  //   Q = Σ_{D≠∅} (−1)^{|D|+1} Σ_{ends of D} Π_{d∈D} blend_d(end) · Q(at those ends)
  // The control values of a linear function are the Greville abscissae, so the sum is taken control point by control
  // point.
  MatrixX homogeneous(space + 1, lattice.count[0] * lattice.count[1] * lattice.count[2]);
  int column = 0;
  each_point(lattice, [&](const std::array<int, 3>& index) {
    VectorX sum = VectorX::Zero(space + 1);
    for (int set = 1; set < 1 << dimensions; ++set)
      for (int ends = set;; ends = (ends - 1) & set) { // all subsets of `set`: the directions taken at their end
        std::array<int, 3> clamped = index;
        double factor = -1;
        int last = 0;
        for (int d = 0; d < dimensions; ++d) {
          if (!(set >> d & 1)) continue;
          const bool at_end = ends >> d & 1;
          const double blend = blends[d][index[d]];
          factor *= at_end ? -blend : blend - 1;
          clamped[d] = at_end ? lattice.count[d] - 1 : 0;
          last = d;
        }
        sum += factor * lattice.value(clamped, last);
        if (ends == 0) break;
      }
    require(sum(space) > 0, "nurbs.coons.blend", {{"weight", sum(space)}});
    homogeneous.col(column++) = sum;
  });
  return {std::move(directions), std::move(homogeneous)};
}

} // namespace signorini::nurbs
