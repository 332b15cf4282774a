#include "nurbs/directions.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>

namespace signorini::nurbs {

void check_direction(const Patch& patch, int d) {
  require(d >= 0 && d < patch.parametric_dimension(), "nurbs.patch.direction",
          {{"direction", d}, {"count", patch.parametric_dimension()}});
}

namespace {

/// The reversed knots; both end knots keep all bits.
KnotVector reversed(const KnotVector& knots) {
  std::vector<double> mirrored = knots.knots();
  std::reverse(mirrored.begin(), mirrored.end());
  for (double& knot : mirrored)
    knot = knot == knots.last()    ? knots.first()
           : knot == knots.first() ? knots.last()
                                   : knots.first() + (knots.last() - knot);
  return {knots.degree(), std::move(mirrored)};
}

} // namespace

Patch reverse(const Patch& patch, int d) {
  check_direction(patch, d);
  std::vector<KnotVector> directions = patch.directions();
  directions[d] = reversed(patch.direction(d));
  const int stride = patch.stride(d), count = patch.direction(d).functions();
  // Index = inner + stride·(i_d + count·outer)
  MatrixX homogeneous(patch.dimension() + 1, patch.functions());
  for (int n = 0; n < patch.functions(); ++n) {
    const int i = n / stride % count;
    homogeneous.col(n + stride * (count - 1 - 2 * i)) = patch.homogeneous().col(n);
  }
  return {std::move(directions), std::move(homogeneous)};
}

Patch swap_directions(const Patch& patch, int i, int j) {
  check_direction(patch, i);
  check_direction(patch, j);
  std::vector<KnotVector> directions = patch.directions();
  std::swap(directions[i], directions[j]);
  MatrixX homogeneous(patch.dimension() + 1, patch.functions());
  for (int n = 0; n < patch.functions(); ++n) {
    std::array<int, 3> place{};
    for (int d = 0; d < patch.parametric_dimension(); ++d)
      place[d] = n / patch.stride(d) % patch.direction(d).functions();
    std::swap(place[i], place[j]);
    int to = 0;
    for (int d = patch.parametric_dimension() - 1; d >= 0; --d) to = to * directions[d].functions() + place[d];
    homogeneous.col(to) = patch.homogeneous().col(n);
  }
  return {std::move(directions), std::move(homogeneous)};
}

} // namespace signorini::nurbs
