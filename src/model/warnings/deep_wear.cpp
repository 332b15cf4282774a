#include "model/warnings/deep_wear.hpp"

#include "model/constants.hpp"
#include "model/scene/thickness.hpp"

#include <cmath>

namespace signorini::model {

namespace {

/// The largest curvature of a face, |n̄·x_,αβ| in unit directions.
template <int D> double curvature(const contact::FaceGeometry<D>& point, const Vec<D>& normal) {
  Mat<D - 1> metric, second;
  for (int a = 0; a < D - 1; ++a)
    for (int b = 0; b < D - 1; ++b) {
      metric(a, b) = point.tangent[a].dot(point.tangent[b]);
      second(a, b) = normal.dot(point.second[a + b]);
    }
  const Mat<D - 1> shape = metric.inverse() * second;
  if constexpr (D == 2) return std::abs(shape(0));
  const double half = 0.5 * shape.trace();
  return std::abs(half) + std::sqrt(std::max(0.0, half * half - shape.determinant()));
}

struct Depth {
  double part = 0; ///< depth relative to the master's radius of curvature
  std::size_t point = 0;
};

/// The point that touches and has worn most relative to the radius of the master there.
template <int D> Depth deepest(const contact::Formulation<D>& contact, const contact::History<D>& history) {
  Depth deepest;
  contact::FaceGeometry<D> foot;
  for (std::size_t i = 0; i < history.points.size(); ++i) {
    const contact::PointHistory<D>& point = history.points[i];
    if (point.worn == 0 || !touches(history.results[i].state) || point.projection.foot != contact::Foot::regular)
      continue;
    contact.master().locate(point.projection, foot);
    const double part = point.worn * curvature<D>(foot, contact.master().normal(foot));
    if (part > deepest.part) deepest = {part, i};
  }
  return deepest;
}

} // namespace

template <int D> void warn_of_deep_wear(const Model<D>& model, std::vector<Message>& warnings) {
  const Scene<D>& scene = model.system.scene;
  for (std::size_t k = 0; k < scene.contacts.size(); ++k) {
    const contact::History<D>& history = model.present.contacts[k];
    const double depth = contact::resultant(history).max_wear;
    if (depth == 0) continue;
    const double part = depth / thickness(scene, scene.contacts[k].slave);
    if (part > much_wear)
      warnings.push_back(
          Message("model.warning.deep_wear",
                  {{"contact", scene.contacts[k].name}, {"depth", depth}, {"percent", std::round(100 * part)}}));
    const Depth found = deepest(*model.system.contacts[k], history);
    if (found.part > much_curved_wear)
      warnings.push_back(Message("model.warning.wear_on_curve",
                                 {{"contact", scene.contacts[k].name},
                                  {"depth", history.points[found.point].worn},
                                  {"percent", std::round(100 * found.part)},
                                  {"place", VectorX(model.system.contacts[k]->points().reference[found.point])}}));
  }
}

template void warn_of_deep_wear(const Model<2>&, std::vector<Message>&);
template void warn_of_deep_wear(const Model<3>&, std::vector<Message>&);

} // namespace signorini::model
