#include "model/tessellate.hpp"

#include "base/index.hpp"
#include "model/results.hpp"

namespace signorini::model {

Tessellation tessellate(const Model<2>& model, int body, const Field<2>* field, const Sampling<2>& sampling,
                        bool deformed) {
  const solid::Body<2>& solid = *model.system.scene.bodies[at(body)].body;
  const nurbs::Discretisation& space = solid.space();
  Eigen::Index points = 0, triangles = 0;
  for (const auto& across : sampling[1])
    for (const auto& along : sampling[0]) {
      points += static_cast<Eigen::Index>(along.size() * across.size());
      triangles += static_cast<Eigen::Index>(2 * (along.size() - 1) * (across.size() - 1));
    }
  Tessellation result;
  result.points.setZero(3, points);
  result.triangles.resize(3, triangles);
  if (field) result.values.resize(points);

  int here = 0, triangle = 0;
  for (int e = 0; e < space.elements(); ++e) {
    const auto &along = sampling[0][at(e % space.elements(0))], &across = sampling[1][at(e / space.elements(0))];
    const int side = static_cast<int>(along.size());
    for (double t : across)
      for (double s : along) {
        const BodyPoint<2> point = regular_point(model, body, e, space.parameter(e, Vec<2>(s, t)));
        result.points.col(here).head<2>() = point.reference;
        if (deformed) result.points.col(here).head<2>() += point.state.displacement;
        if (field) result.values(here) = field->value(solid.material(), point.state);
        if (s < 1 && t < 1) {
          result.triangles.col(triangle++) << here, here + 1, here + side + 1;
          result.triangles.col(triangle++) << here, here + side + 1, here + side;
        }
        ++here;
      }
  }

  result.control_points.setZero(3, space.functions());
  result.control_points.topRows<2>() = space.points();
  if (deformed) result.control_points.topRows<2>() += body_displacement(model, body);
  result.net_lines = net_lines(space);
  return result;
}

std::vector<std::array<int, 2>> net_lines(const nurbs::Discretisation& space) {
  std::vector<std::array<int, 2>> lines;
  for (std::size_t j = 0; j < space.rows().size(); ++j) {
    const int first = space.first_function(static_cast<int>(j)), n = space.rows()[j].direction(0).functions();
    for (int f = 0; f < space.rows()[j].functions(); ++f) {
      if (f % n > 0) lines.push_back({first + f - 1, first + f});
      if (f >= n) lines.push_back({first + f - n, first + f});
    }
  }
  return lines;
}

} // namespace signorini::model
