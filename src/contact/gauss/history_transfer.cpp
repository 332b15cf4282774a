#include "contact/gauss/history_transfer.hpp"

#include "base/dense.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

namespace {

/// Memories between which a history is interpolated: a linear field has D coefficients on a face.
template <int D> constexpr std::size_t neighbors = D == 2 ? 3 : 8;
/// (h over the distance of the farthest memory)²: a memory at the place itself has a thousand times the farthest's
/// weight.
constexpr double nearness = 1e-3;
/// Weight of slopes that the memories do not determine, relative to that of the mean: across the face, and along it if
/// they are in one line.
constexpr double no_slope = 1e-10;

/// The nearest of the memories `among`, at most neighbors<D>, nearest first.
template <int D>
std::vector<std::size_t> nearest(const std::vector<PointMemory<D>>& memories, std::vector<std::size_t> among,
                                 const Vec<D>& place) {
  const auto middle = among.begin() + static_cast<std::ptrdiff_t>(std::min(among.size(), neighbors<D>));
  std::partial_sort(among.begin(), middle, among.end(), [&](std::size_t a, std::size_t b) {
    const double one = (memories[a].place - place).squaredNorm(), other = (memories[b].place - place).squaredNorm();
    return one < other || (one == other && a < b);
  });
  among.erase(middle, among.end());
  return among;
}

/// Weights w_i with f(place) ≈ Σ w_i f_i, Σ w_i = 1, exact for linear f if the points span the face: the constant term
/// of the least-squares fit of a + b·(X − place) with weights 1/(h² + |X_i − place|²).
template <int D>
std::vector<double> weights(const std::vector<PointMemory<D>>& memories, const std::vector<std::size_t>& points,
                            const Vec<D>& place) {
  double size2 = 0; // squared distance to the farthest
  for (const std::size_t i : points) size2 = std::max(size2, (memories[i].place - place).squaredNorm());
  std::vector<double> result(points.size(), 1.0 / static_cast<double>(points.size()));
  if (points.size() == 1 || size2 == 0) return result;
  using Basis = Eigen::Matrix<double, D + 1, 1>;
  const auto basis = [&](std::size_t i) {
    Basis b;
    b << 1, (memories[i].place - place) / std::sqrt(size2);
    return b;
  };
  const auto weight = [&](std::size_t i) { return 1 / (nearness + (memories[i].place - place).squaredNorm() / size2); };
  Eigen::Matrix<double, D + 1, D + 1> normal = Eigen::Matrix<double, D + 1, D + 1>::Zero();
  for (const std::size_t i : points) normal += weight(i) * basis(i) * basis(i).transpose();
  normal.template bottomRightCorner<D, D>() += no_slope * normal(0, 0) * Mat<D>::Identity();
  const Basis constant = dense::solve(normal, Basis::Unit(0));
  for (std::size_t k = 0; k < points.size(); ++k) result[k] = weight(points[k]) * constant.dot(basis(points[k]));
  return result;
}

} // namespace

template <int D>
std::vector<PointMemory<D>> memories(const Formulation<D>& contact, const History<D>& history,
                                     std::span<const std::size_t> numbers) {
  std::vector<PointMemory<D>> result;
  for (const std::size_t i : numbers) {
    const PointHistory<D>& point = history.points[i];
    PointMemory<D> memory{contact.points().reference[i],
                          touches(history.results[i].state),
                          point.slips,
                          Vec<D>::Zero(),
                          point.limit / reference_area(contact.points().list[i]),
                          point.slipped,
                          point.recent,
                          point.worn,
                          point.projection};
    if (point.slips) {
      FacePoint<D> slip, foot;
      contact.master().locate(point.slip, slip);
      contact.master().locate(point.projection.point(), foot);
      memory.stretch = slip.position - foot.position;
    }
    result.push_back(std::move(memory));
  }
  return result;
}

template <int D>
void recall(const std::vector<PointMemory<D>>& memories, const Formulation<D>& contact,
            std::span<const std::size_t> numbers, History<D>& history) {
  std::vector<std::size_t> all(memories.size()), touching;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  for (const std::size_t i : all)
    if (memories[i].touches) touching.push_back(i);
  for (const std::size_t number : numbers) {
    PointHistory<D>& point = history.points[number] = {};
    history.results[number] = {};
    const Vec<D> here = history.results[number].position = position(contact.points(), contact.slave(), number);
    if (memories.empty()) continue;
    const Vec<D>& place = contact.points().reference[number];
    const PointMemory<D>& closest = memories[nearest<D>(memories, all, place).front()];
    FaceGeometry<D> foot;
    point.projection = closest.projection;
    if (contact.parameters().wears()) {
      const std::vector<std::size_t> near = nearest<D>(memories, all, place);
      const std::vector<double> w = weights<D>(memories, near, place);
      for (std::size_t k = 0; k < near.size(); ++k) point.worn += w[k] * memories[near[k]].worn;
      point.worn = std::max(point.worn, 0.0);
    }
    if (!closest.touches) continue;
    const Lookout<D> from = lookout(contact.faces(), contact.points(), number);
    point.projection = contact.master().project(here, point.projection, foot, from);
    if (point.projection.foot == Foot::none) continue;

    const std::vector<std::size_t> some = nearest<D>(memories, touching, place);
    const std::vector<double> w = weights<D>(memories, some, place);
    Vec<D> stretch = Vec<D>::Zero();
    for (std::size_t k = 0; k < some.size(); ++k) {
      const PointMemory<D>& other = memories[some[k]];
      point.limit += w[k] * other.limit * reference_area(contact.points().list[number]);
      point.slipped += w[k] * other.slipped;
      point.recent += w[k] * other.recent;
      stretch += w[k] * other.stretch;
    }
    for (double* value : {&point.limit, &point.slipped, &point.recent}) *value = std::max(*value, 0.0);
    point.slips = closest.slips;
    if (!point.slips) continue;
    FaceGeometry<D> slip;
    const Projection<D> to = contact.master().project(foot.position + stretch, point.projection, slip, from);
    point.slip = to.foot == Foot::none ? point.projection.point() : to.point();
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::vector<PointMemory<D>> memories(const Formulation<D>&, const History<D>&,                              \
                                                std::span<const std::size_t>);                                         \
  template void recall(const std::vector<PointMemory<D>>&, const Formulation<D>&, std::span<const std::size_t>,        \
                       History<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
