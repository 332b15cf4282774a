#include "model/scene/supports.hpp"

#include "model/scene/contact_faces.hpp"

#include <algorithm>

namespace signorini::model {

template <int D> std::vector<std::vector<int>> supported_points(const Scene<D>& scene, const Groups& shared) {
  const int control_points = first_control_point(scene, static_cast<int>(scene.bodies.size()));
  const std::vector<std::vector<int>> groups = shared.all();
  std::vector<std::vector<int>> result;
  for (const Support<D>& support : scene.supports) {
    std::vector<int>& list = result.emplace_back();
    std::vector<char> leads(control_points, false);
    for (const SupportedControlPoints& points : support.on)
      for (const int function : points.functions) {
        list.push_back(first_control_point(scene, points.body) + function);
        leads[shared.leader(list.back())] = true;
      }
    for (const std::vector<int>& group : groups)
      if (leads[group.front()]) list.insert(list.end(), group.begin(), group.end());
    for (const int obstacle : support.obstacles) list.push_back(control_points + obstacle);
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return result;
}

template <int D> bool constrains(const Support<D>& support, int component, bool obstacle) {
  return support.constraint[component] != Constraint::free || (obstacle ? support.freed[component] : support.rotates);
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::vector<std::vector<int>> supported_points(const Scene<D>&, const Groups&);                             \
  template bool constrains(const Support<D>&, int, bool);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
