#include "model/scene/region.hpp"

#include <algorithm>

namespace signorini::model {

template <int D> RegionPoints<D> points_of_region(const contact::Formulation<D>& formulation) {
  const auto& positions = formulation.points().reference;
  RegionPoints<D> points(D, formulation.points().whole ? 0 : static_cast<Eigen::Index>(positions.size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = positions[i];
  return points;
}

template <int D> RegionPoints<D> bonded_points(const contact::Formulation<D>& formulation) {
  std::vector<Vec<D>> bonded;
  const auto& positions = formulation.points().reference;
  for (std::size_t i = 0; i < positions.size() && formulation.bonds(); ++i)
    if (formulation.bonds()->bonded(i)) bonded.push_back(positions[i]);
  RegionPoints<D> points(D, bonded.size() == positions.size() ? 0 : static_cast<Eigen::Index>(bonded.size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = bonded[i];
  return points;
}

template <int D> contact::Region<D> region_of(const RegionPoints<D>& points, double tolerance) {
  if (points.cols() == 0) return {};
  std::vector<Vec<D>> sorted;
  for (Eigen::Index i = 0; i < points.cols(); ++i) sorted.push_back(points.col(i));
  std::ranges::sort(sorted, {}, [](const Vec<D>& x) { return x(0); });
  return [sorted, tolerance](const Vec<D>& x) {
    auto place = std::ranges::lower_bound(sorted, x(0) - tolerance, {}, [](const Vec<D>& y) { return y(0); });
    for (; place != sorted.end() && (*place)(0) <= x(0) + tolerance; ++place)
      if ((*place - x).cwiseAbs().maxCoeff() <= tolerance) return true;
    return false;
  };
}

template <int D> Contact<D> with_regions(Contact<D> contact, const contact::Formulation<D>& formulation, double size) {
  constexpr double rounding = 1e-10; // relative to the coordinates; points of a rule are much farther apart
  contact.where = region_of<D>(points_of_region(formulation), rounding * size);
  contact.bonded = region_of<D>(bonded_points(formulation), rounding * size);
  return contact;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template RegionPoints<D> points_of_region(const contact::Formulation<D>&);                                           \
  template RegionPoints<D> bonded_points(const contact::Formulation<D>&);                                              \
  template contact::Region<D> region_of(const RegionPoints<D>&, double);                                               \
  template Contact<D> with_regions(Contact<D>, const contact::Formulation<D>&, double);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
