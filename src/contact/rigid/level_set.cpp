#include "contact/rigid/level_set.hpp"

#include "base/error.hpp"
#include "contact/closest/chord.hpp"
#include "contact/rigid/near_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace signorini::contact {

namespace {

/// Rounding error of a coordinate, relative to the largest one.
constexpr double coordinate_rounding = 4 * std::numeric_limits<double>::epsilon();

template <int D> using TangentBasis = Eigen::Matrix<double, D, D - 1>;

template <int D> TangentBasis<D> tangents_of(const Vec<D>& normal) {
  TangentBasis<D> t;
  const auto directions = across(normal);
  for (int k = 0; k < D - 1; ++k) t.col(k) = directions[k];
  return t;
}

template <int D> Vec<D> place_of(const FaceCoordinates<D>& xi, double last) {
  Vec<D> place;
  place << xi, last;
  return place;
}

template <int D> void set_place(FaceGeometry<D>& point, const Vec<D>& place) {
  point.xi = place.template head<D - 1>();
  point.last = place(D - 1);
}

/// Moves a point near the level set onto it along gradients (Newton); false if that fails.
template <int D> bool drop(const CompiledLevelSet<D>& f, Vec<D>& p, LevelValue<D>& at) {
  double previous = std::numeric_limits<double>::infinity();
  const double rounding = coordinate_rounding * std::max(p.cwiseAbs().maxCoeff(), f.mesh.spacing);
  for (int iteration = 0; iteration < most_foot_iterations; ++iteration) {
    at = f(p);
    const double square = at.gradient.squaredNorm(), distance = std::abs(at.value) / std::sqrt(square);
    if (!std::isfinite(distance)) return false;
    // Rounding error of f may exceed that of the coordinates: then steps stop decreasing.
    if (distance <= rounding || (distance < short_step * f.mesh.spacing && distance >= previous)) return true;
    if (distance > f.mesh.spacing && distance >= previous) return false;
    p -= at.value / square * at.gradient;
    previous = distance;
  }
  return false;
}

/// The point of the mesh nearest to x: outwards from x in the order of their first coordinates.
template <int D> Vec<D> nearest_point(const CompiledLevelSet<D>& f, const Vec<D>& x) {
  const auto& points = f.mesh.points;
  const auto start = std::ranges::lower_bound(f.sorted, x(0), {}, [&](int i) { return points(0, i); });
  double best = std::numeric_limits<double>::infinity();
  int found = f.sorted.front();
  const auto look = [&](int i) { // returns false if all further points are farther away
    if (const double apart = points(0, i) - x(0); apart * apart > best) return false;
    if (const double square = (points.col(i) - x).squaredNorm(); square < best) best = square, found = i;
    return true;
  };
  auto up = start, down = start;
  for (bool rises = true, falls = true; rises || falls;) {
    if (rises) rises = up != f.sorted.end() && look(*up++);
    if (falls) falls = down != f.sorted.begin() && look(*--down);
  }
  return points.col(found);
}

} // namespace

template <> std::vector<std::string> level_set_variables<2>() {
  return {"x", "y"};
}
template <> std::vector<std::string> level_set_variables<3>() {
  return {"x", "y", "z"};
}

template <int D> LevelValue<D> CompiledLevelSet<D>::operator()(const Vec<D>& x) const {
  constexpr int most_on_stack = 256;
  std::array<double, most_on_stack> few;
  std::vector<double> many;
  double* registers = few.data();
  if (tape.registers > most_on_stack) many.resize(tape.registers), registers = many.data();
  std::copy_n(x.data(), D, registers);
  symbolic::evaluate(tape, registers, 1, 1, static_cast<int>(tape.outputs.size()));
  std::size_t next = 0;
  const auto take = [&] {
    const int output = tape.outputs[next++];
    return output < 0 ? 0 : registers[output];
  };
  LevelValue<D> result;
  result.value = take();
  for (int i = 0; i < D; ++i) result.gradient(i) = take();
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j) result.second(i, j) = result.second(j, i) = take();
  return result;
}

template <int D> LevelSet<D> make_level_set(symbolic::Formula given, const Vec<D>& low, const Vec<D>& high) {
  require(low.allFinite() && high.allFinite() && (low.array() < high.array()).all(), "contact.level_set.box",
          {{"low", low}, {"high", high}});
  auto [graph, node] = symbolic::reduced(given.graph, given.node);
  constexpr int most_nodes = 2000; // compilation is recursive
  require(graph.size() <= most_nodes, "contact.level_set.size", {{"count", graph.size()}, {"most", most_nodes}});
  const auto result = std::make_shared<CompiledLevelSet<D>>(CompiledLevelSet<D>{{graph, node}, low, high, {}, {}, {}});
  std::vector<int> all{node};
  for (int i = 0; i < D; ++i) all.push_back(symbolic::derivative(graph, node, i));
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j) all.push_back(symbolic::derivative(graph, all[i + 1], j));
  result->tape = symbolic::compile(graph, all, false);
  result->mesh = march(*result);
  const auto& points = result->mesh.points;
  result->sorted.resize(points.cols());
  std::iota(result->sorted.begin(), result->sorted.end(), 0);
  std::ranges::stable_sort(result->sorted, {}, [&](int i) { return points(0, i); });
  return {result};
}

/// Newton's method for the least |x − p|²/2 on the surface, with steps in the tangent plane that are dropped onto the
/// surface, and Armijo's rule.
template <int D> void find_closest(const LevelSet<D>& level_set, const Vec<D>& x, FaceGeometry<D>& point) {
  const CompiledLevelSet<D>& f = *level_set.compiled;
  const double spacing = f.mesh.spacing;
  Vec<D> p = nearest_point(f, x);
  LevelValue<D> at;
  double most = spacing; // length of a step; grows, for points far outside the box
  point.settled = false;
  if (!drop(f, p, at)) return set_place(point, p);
  for (int iteration = 0; iteration < most_foot_iterations; ++iteration) {
    const double slope = at.gradient.norm();
    const Vec<D> normal = at.gradient / slope, away = x - p;
    const TangentBasis<D> t = tangents_of<D>(normal);
    const FaceCoordinates<D> descent = t.transpose() * away;
    // The surface over its tangent plane is p + t ξ − ½ (ξ·tᵀHt ξ)/|∇f| n, with H the second derivatives of f.
    Mat<D - 1> hessian = Mat<D - 1>::Identity() + (away.dot(normal) / slope) * (t.transpose() * at.second * t);
    FaceCoordinates<D> step = hessian.inverse() * descent;
    if (!(step.dot(descent) >= trusted_curvature * step.norm() * descent.norm())) step = descent;
    if (step.norm() > most) step *= most / step.norm();
    const double size = step.norm();
    const bool is_short = size <= short_step * spacing;
    const double before = away.squaredNorm(), gain = 2 * sufficient_decrease * step.dot(descent);
    Vec<D> next = p;
    LevelValue<D> there = at;
    bool moved = false;
    int tries = 0;
    for (double share = 1; tries < most_halvings && !moved; ++tries, share /= 2) {
      next = p + share * (t * step);
      moved = drop(f, next, there) && (is_short || (x - next).squaredNorm() <= before - share * gain);
    }
    if (!moved) break;
    most = tries == 1 ? 2 * most : spacing;
    p = next;
    at = there;
    point.settled = size <= foot_tolerance * spacing;
    if (size <= last_step * spacing) break;
  }
  set_place(point, p);
}

template <int D> void locate(const LevelSet<D>& level_set, FaceGeometry<D>& point) {
  point.position = place_of<D>(point.xi, point.last);
  const LevelValue<D> at = (*level_set.compiled)(point.position);
  const double slope = at.gradient.norm();
  const Vec<D> normal = at.gradient / slope;
  const TangentBasis<D> t = tangents_of<D>(normal);
  const Mat<D - 1> bend = t.transpose() * at.second * t / -slope;
  std::size_t next = 0;
  for (int a = 0; a < D - 1; ++a) {
    point.tangent[a] = t.col(a);
    for (int b = a; b < D - 1; ++b) point.second[next++] = bend(a, b) * normal;
  }
}

template <int D>
MasterPoint<D> advance_slip(const LevelSet<D>& level_set, const MasterPoint<D>& slip, const FaceGeometry<D>& foot,
                            double length) {
  const Vec<D> from = place_of<D>(foot.xi, foot.last), chord = place_of<D>(slip.xi, slip.last) - from;
  if (!(chord.norm() > length)) return slip;
  // Where the chord leads too far from the surface the slip point stays, which counts as unsettled.
  return point_on_chord(level_set, from, Vec<D>(from + chord), length).value_or(slip);
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template struct CompiledLevelSet<D>;                                                                                 \
  template LevelSet<D> make_level_set(symbolic::Formula, const Vec<D>&, const Vec<D>&);                                \
  template void find_closest(const LevelSet<D>&, const Vec<D>&, FaceGeometry<D>&);                                     \
  template void locate(const LevelSet<D>&, FaceGeometry<D>&);                                                          \
  template MasterPoint<D> advance_slip(const LevelSet<D>&, const MasterPoint<D>&, const FaceGeometry<D>&, double);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
