#include "model/checks/outline.hpp"

#include "model/checks/constants.hpp"
#include "nurbs/basis_grid.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace signorini::model {

namespace {

/// Pieces of an element's border per direction. On an arc of 90° the sagitta of a chord is 0.5 % (2D) or 2 % (3D) of
/// the radius.
template <int D> constexpr int pieces = D == 2 ? 8 : 4;

/// Angle of a segment at the origin, positive counter-clockwise.
double angle_of(const Vec<2>& a, const Vec<2>& b) {
  return std::atan2(a(0) * b(1) - a(1) * b(0), a.dot(b));
}

/// Solid angle of a triangle at the origin (A. van Oosterom and J. Strackee, IEEE Trans. Biomed. Eng. 30, 1983).
double angle_of(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

/// Axes of a ray in general position: meshes along the coordinate axes have no facets parallel to it.
template <int D> Mat<D> ray_frame() {
  if constexpr (D == 2)
    return Eigen::Rotation2Dd(1).toRotationMatrix();
  else
    return Eigen::AngleAxisd(1, Vec<3>(1, 2, 3).normalized()).toRotationMatrix();
}

/// Twice the area of a triangle in the plane across the ray, positive counter-clockwise.
double across(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
  return (b(1) - a(1)) * (c(2) - a(2)) - (b(2) - a(2)) * (c(1) - a(1));
}

/// +1 where a ray from x along the first axis leaves through a facet, −1 where it enters, 0 where they do not meet.
int passed(const std::array<Vec<2>, 2>& facet, const Vec<2>& x) {
  const auto& [a, b] = facet;
  if ((a(1) <= x(1)) == (b(1) <= x(1))) return 0;
  const double fraction = (x(1) - a(1)) / (b(1) - a(1));
  if (a(0) + fraction * (b(0) - a(0)) <= x(0)) return 0;
  return b(1) > a(1) ? 1 : -1;
}
int passed(const std::array<Vec<3>, 3>& facet, const Vec<3>& x) {
  const auto& [a, b, c] = facet;
  const double at_a = across(x, b, c), at_b = across(x, c, a), at_c = across(x, a, b);
  const bool out = at_a > 0 && at_b > 0 && at_c > 0, in = at_a < 0 && at_b < 0 && at_c < 0;
  if (!out && !in) return 0;
  if ((at_a * a(0) + at_b * b(0) + at_c * c(0)) / (at_a + at_b + at_c) <= x(0)) return 0;
  return out ? 1 : -1;
}

template <int D> double to_segment(const Vec<D>& a, const Vec<D>& b, const Vec<D>& x) {
  const Vec<D> along = b - a;
  const double fraction = std::clamp((x - a).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
  return (x - a - fraction * along).norm();
}

template <int D> Facet<D> facet_of(const std::array<Vec<D>, D>& corners, double sagitta, nurbs::Side side) {
  const Vec<D> middle = std::accumulate(corners.begin(), corners.end(), Vec<D>(Vec<D>::Zero())) / D;
  double radius = 0;
  for (const Vec<D>& corner : corners) radius = std::max(radius, (corner - middle).norm());
  const Vec<D> along = corners[1] - corners[0];
  Vec<D> normal = Vec<D>::Zero();
  if constexpr (D == 2)
    normal = Vec<2>(along(1), -along(0));
  else
    normal = along.cross(corners[2] - corners[0]);
  const double size = normal.norm(), rounding = outline_rounding * (middle.cwiseAbs().maxCoeff() + radius);
  normal *= size > rounding * (D == 2 ? 1 : radius) ? 1 / size : 0;
  return {corners, middle, normal, size / (D - 1), radius, sagitta, side};
}

} // namespace

template <int D> double distance(const Facet<D>& facet, const Vec<D>& x) {
  const auto& corners = facet.corners;
  if constexpr (D == 2) {
    return to_segment<2>(corners[0], corners[1], x);
  } else {
    double least = std::numeric_limits<double>::infinity();
    bool above = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec<3>&a = corners[i], &b = corners[(i + 1) % 3];
      above = above && facet.normal.dot((b - a).cross(x - a)) >= 0;
      least = std::min(least, to_segment<3>(a, b, x));
    }
    return above ? std::abs(facet.normal.dot(x - corners[0])) : least;
  }
}

template <int D> Outline<D>::Outline(const nurbs::Discretization& space, const MatrixX& points) {
  for (const nurbs::Side side : nurbs::sides(D)) add_face(space, points, side);
  lower_ = upper_ = facets_.front().middle;
  double volume = 0, area = 0; // ∫ x·n da = D V
  const Vec<D> origin = lower_;
  for (const Facet<D>& facet : facets_) {
    for (const Vec<D>& corner : facet.corners) {
      lower_ = lower_.cwiseMin(corner);
      upper_ = upper_.cwiseMax(corner);
    }
    volume += facet.area * facet.normal.dot(facet.middle - origin) / D;
    area += facet.area;
  }
  thickness_ = 2 * volume / area;
  sort();
}

template <int D>
void Outline<D>::add_face(const nurbs::Discretization& space, const MatrixX& points, nurbs::Side side) {
  constexpr int n = pieces<D>, rows = D == 2 ? 1 : n + 1;
  const bool reversed = nurbs::outward_sign(side) < 0;
  nurbs::BasisGrid grid(space);
  nurbs::ElementBasis basis;
  std::vector<std::vector<double>> parameters(D);
  std::array<Vec<D>, static_cast<std::size_t>(rows * (n + 1))> places;
  const auto place = [&](int i, int j) -> const Vec<D>& { return places[j * (n + 1) + i]; };
  for (int f = 0; f < space.elements_on(side); ++f) {
    const int e = space.element_behind(side, f);
    for (int d = 0; d < D; ++d) {
      const auto [from, to] = space.interval(e, d);
      parameters[d] = {side.at_end ? to : from};
      if (d == side.direction) continue;
      parameters[d].clear();
      for (int k = 0; k <= n; ++k) parameters[d].push_back(from + (to - from) * k / n);
    }
    grid.choose(e, parameters);
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i <= n; ++i) {
        std::array<int, 3> point{};
        for (int d = 0, along = 0; d < D; ++d)
          if (d != side.direction) point[d] = along++ == 0 ? i : j;
        grid.evaluate(point, basis);
        Vec<D>& x = places[j * (n + 1) + i];
        x.setZero();
        for (std::size_t a = 0; a < basis.functions.size(); ++a)
          x += basis.values(static_cast<Eigen::Index>(a)) * points.col(basis.functions[a]);
      }
    // An arc has the height |x₀ − 2 x₁ + x₂|/8 above its chords, a twisted square |x₀₀ − x₁₀ + x₁₁ − x₀₁|/4.
    double first = 0, second = 0, twist = 0;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i <= n; ++i) {
        if (i > 0 && i < n) first = std::max(first, (place(i - 1, j) - 2 * place(i, j) + place(i + 1, j)).norm() / 8);
        if (j == 0 || rows == 1) continue;
        if (j < n) second = std::max(second, (place(i, j - 1) - 2 * place(i, j) + place(i, j + 1)).norm() / 8);
        if (i > 0)
          twist = std::max(twist, (place(i, j) - place(i - 1, j) + place(i - 1, j - 1) - place(i, j - 1)).norm() / 4);
      }
    const auto add = [&](std::array<Vec<D>, D> corners) {
      if (reversed) std::swap(corners[0], corners[1]);
      facets_.push_back(facet_of<D>(corners, first + second + twist, side));
    };
    for (int i = 0; i < n; ++i)
      if constexpr (D == 2) {
        add({place(i, 0), place(i + 1, 0)});
      } else {
        for (int j = 0; j < n; ++j) {
          add({place(i, j), place(i + 1, j), place(i + 1, j + 1)});
          add({place(i, j), place(i + 1, j + 1), place(i, j + 1)});
        }
      }
  }
}

template <int D> int Outline<D>::cell(double place, int direction) const {
  const double number = std::floor((place - start_(direction)) / width_(direction));
  return static_cast<int>(std::clamp(number, 0.0, cells_ - 1.0));
}

/// Lists the facets by cell.
template <int D> void Outline<D>::sort() {
  const Mat<D> frame = ray_frame<D>();
  Vec<D> high = frame * lower_;
  start_ = high;
  for (const Facet<D>& facet : facets_) {
    auto& corners = turned_.emplace_back(facet.corners);
    for (Vec<D>& corner : corners) {
      corner = (frame * corner).eval();
      start_ = start_.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
  cells_ = D == 2 ? static_cast<int>(facets_.size()) : static_cast<int>(std::sqrt(facets_.size()));
  width_ = (high - start_).cwiseMax(std::numeric_limits<double>::min()) / cells_;
  const auto visit = [&](std::size_t i, const auto& what) {
    std::array<int, 2> from{}, to{}; // 2D: one row of cells
    for (int d = 1; d < D; ++d) {
      const auto [low, top] = std::minmax_element(turned_[i].begin(), turned_[i].end(),
                                                  [d](const Vec<D>& a, const Vec<D>& b) { return a(d) < b(d); });
      from[d - 1] = cell((*low)(d), d);
      to[d - 1] = cell((*top)(d), d);
    }
    for (int k = from[1]; k <= to[1]; ++k)
      for (int j = from[0]; j <= to[0]; ++j) what(k * cells_ + j);
  };
  first_.assign((D == 2 ? cells_ : cells_ * cells_) + 1, 0);
  for (std::size_t i = 0; i < turned_.size(); ++i) visit(i, [&](std::size_t c) { ++first_[c + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  listed_.resize(first_.back());
  std::vector<int> next = first_;
  for (std::size_t i = 0; i < turned_.size(); ++i)
    visit(i, [&](std::size_t c) { listed_[next[c]++] = static_cast<int>(i); });
}

template <int D> double Outline<D>::winding(const Vec<D>& x) const {
  double angle = 0;
  for (const Facet<D>& facet : facets_)
    if constexpr (D == 2)
      angle += angle_of(facet.corners[0] - x, facet.corners[1] - x);
    else
      angle += angle_of(facet.corners[0] - x, facet.corners[1] - x, facet.corners[2] - x);
  return angle / (2 * (D - 1) * std::numbers::pi);
}

template <int D> int Outline<D>::layers(const Vec<D>& x) const {
  const Vec<D> turned = ray_frame<D>() * x;
  const std::size_t here = (D == 2 ? 0 : cells_ * cell(turned(D - 1), D - 1)) + cell(turned(1), 1);
  int sum = 0;
  for (int i = first_[here]; i < first_[here + 1]; ++i) sum += passed(turned_[listed_[i]], turned);
  return sum;
}

template double distance<2>(const Facet<2>&, const Vec<2>&);
template double distance<3>(const Facet<3>&, const Vec<3>&);
template class Outline<2>;
template class Outline<3>;

} // namespace signorini::model
