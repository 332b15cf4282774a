#include "model/tessellate.hpp"

#include "base/index.hpp"

namespace signorini::model {

namespace {

/// Polyline through an element along direction d, the other parameter fixed.
Points border(const Model<2>& model, int body, int e, int d, double fixed, int divisions, bool deformed) {
  const nurbs::Discretisation& space = model.scene().bodies[at(body)].body->space();
  const auto [from, to] = space.interval(e, d);
  Points line = Points::Zero(3, divisions + 1);
  VectorX xi(2);
  xi(1 - d) = fixed;
  for (int k = 0; k <= divisions; ++k) {
    xi(d) = from + (to - from) * k / divisions;
    const BodyPoint<2> point = regular_point(model, body, e, xi);
    line.col(k).head<2>() = point.reference;
    if (deformed) line.col(k).head<2>() += point.state.displacement;
  }
  return line;
}

} // namespace

Tessellation tessellate(const Model<2>& model, int body, const Field<2>* field, int divisions, bool deformed) {
  const solid::Body<2>& solid = *model.scene().bodies[at(body)].body;
  const nurbs::Discretisation& space = solid.space();
  const int side = divisions + 1, per_element = side * side, elements = space.elements();
  Tessellation result;
  result.points.setZero(3, per_element * elements);
  result.triangles.resize(3, 2 * divisions * divisions * elements);
  if (field) result.values.resize(per_element * elements);

  VectorX xi(2);
  for (int e = 0, triangle = 0; e < elements; ++e) {
    const int first = per_element * e;
    const auto [a, b] = space.interval(e, 0);
    const auto [c, d] = space.interval(e, 1);
    for (int n = 0; n < per_element; ++n) {
      xi << a + (b - a) * (n % side) / divisions, c + (d - c) * (n / side) / divisions;
      const BodyPoint<2> point = regular_point(model, body, e, xi);
      result.points.col(first + n).head<2>() = point.reference;
      if (deformed) result.points.col(first + n).head<2>() += point.state.displacement;
      if (field) result.values(first + n) = field->value(solid.material(), point.state);
    }
    for (int j = 0; j < divisions; ++j)
      for (int i = 0; i < divisions; ++i) {
        const int corner = first + i + side * j;
        result.triangles.col(triangle++) << corner, corner + 1, corner + side + 1;
        result.triangles.col(triangle++) << corner, corner + side + 1, corner + side;
      }
    // The element's start in each direction; the last element also its end
    const bool last_0 = e % space.elements(0) == space.elements(0) - 1,
               last_1 = e / space.elements(0) == space.elements(1) - 1;
    result.mesh_lines.push_back(border(model, body, e, 1, a, divisions, deformed));
    result.mesh_lines.push_back(border(model, body, e, 0, c, divisions, deformed));
    if (last_0) result.mesh_lines.push_back(border(model, body, e, 1, b, divisions, deformed));
    if (last_1) result.mesh_lines.push_back(border(model, body, e, 0, d, divisions, deformed));
  }

  result.control_points.setZero(3, space.functions());
  result.control_points.topRows<2>() = space.points();
  if (deformed) result.control_points.topRows<2>() += model.body_displacement(body);
  for (std::size_t j = 0; j < space.rows().size(); ++j) {
    const int first = space.first_function(static_cast<int>(j));
    for (int i = 1; i < space.rows()[j].functions(); ++i) result.net_lines.push_back({first + i - 1, first + i});
  }
  return result;
}

} // namespace signorini::model
