#include "base/index.hpp"
#include "bind/frame.hpp"
#include "tessellation/tessellate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::bind {

namespace {

/// The four sides of a body without pairs of opposite ones that are one: where a body is closed it has no border.
std::vector<view::Points> without_seams(std::vector<view::Points> lines) {
  for (std::size_t pair = lines.size(); pair >= 2; pair -= 2)
    if (const auto first = lines.begin() + static_cast<std::ptrdiff_t>(pair) - 2; first[0].isApprox(first[1], 1e-9))
      lines.erase(first, first + 2);
  return lines;
}

void add_mirror_image(view::Panel& panel, int axis, double sign) {
  for (view::Body& body : panel.bodies) view::join_at_mirror(body, axis);
  for (std::size_t i = 0, count = panel.bodies.size(); i < count; ++i)
    panel.bodies.push_back(view::mirrored(panel.bodies[i], axis, sign));
  for (std::size_t i = 0, count = panel.obstacles.size(); i < count; ++i)
    panel.obstacles.push_back(view::mirrored(panel.obstacles[i], axis));
  for (std::size_t i = 0, count = panel.vectors.size(); i < count; ++i)
    panel.vectors.push_back(view::mirrored(panel.vectors[i], axis));
}

/// The rim of a model's rigid obstacle where it stands now, or stood at the start.
view::Outline obstacle(const model::Model<2>& model, int index, bool deformed, const std::vector<Window>& windows) {
  const int first = model.system.unknowns.obstacle_offset(index);
  const Vec<2> shift = deformed ? Vec<2>(model.present.displacement.segment<2>(first)) : Vec<2>::Zero();
  const contact::Obstacle<2>& shape = model.system.scene.obstacles[static_cast<std::size_t>(index)];
  if (const auto* plane = std::get_if<contact::Plane<2>>(&shape))
    return view::half_plane(plane->point + shift, plane->normal);
  if (const auto* ball = std::get_if<contact::Ball<2>>(&shape))
    return view::circle(ball->centre + shift, ball->radius, windows);
  const auto& curve = std::get<nurbs::Patch>(shape);
  const nurbs::KnotVector& knots = curve.directions().front();
  const auto place = [&](double fraction) {
    const double xi = knots.first() + (knots.last() - knots.first()) * fraction;
    Vec<3> point = Vec<3>::Zero();
    point.head<2>() = nurbs::evaluate(curve, VectorX::Constant(1, xi)) + shift;
    return point;
  };
  return view::outline(place, 400, windows);
}

/// Bands of pressure on the slave faces of the bodies that are drawn, in front of these: what is drawn first covers
/// what comes behind it.
void add_pressure(view::Panel& panel, const model::Model<2>& model, const Showing& showing) {
  Vec<3> low = Vec<3>::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const view::Body& body : panel.bodies) {
    low = low.cwiseMin(body.points.rowwise().minCoeff());
    high = high.cwiseMax(body.points.rowwise().maxCoeff());
  }
  std::vector<view::Body> bands;
  const auto& contacts = model.system.scene.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (std::count(showing.bodies.begin(), showing.bodies.end(), contacts[c].slave.body) > 0)
      bands.push_back(pressure_band(model, static_cast<int>(c), showing, (high - low).maxCoeff()));
  panel.bodies.insert(panel.bodies.begin(), bands.begin(), bands.end());
}

} // namespace

view::Body plane_body(tessellation::Skin skin, const Showing& showing) {
  view::Body body;
  body.points = std::move(skin.points);
  body.triangles = std::move(skin.triangles);
  body.values = showing.factor * skin.values;
  for (tessellation::SkinLine& line : skin.rim) body.rim.push_back(std::move(line.points));
  if (showing.mesh)
    for (tessellation::SkinLine& line : skin.mesh_lines)
      body.mesh_lines.push_back({std::move(line.points), line.spacing});
  if (showing.control_points) {
    body.control_points = std::move(skin.control_points);
    body.net_lines = std::move(skin.net_lines);
  }
  return body;
}

double mirror_sign(const std::string& field, int axis) {
  const bool component = field.size() > 1 && (field[0] == 'u' || field[0] == 's' || field[0] == 'F');
  if (!component) return 1;
  const auto along = std::count_if(field.begin() + 1, field.end(),
                                   [&](char index) { return index == "xyz"[axis] || index == "123"[axis]; });
  return along % 2 == 0 ? 1 : -1;
}

int divisions_for(int elements) {
  return std::clamp(static_cast<int>(std::sqrt(40000.0 / elements)), 4, 12);
}

view::Panel show(const model::Model<2>& model, const Showing& showing) {
  const bool pressure = showing.field == pressure_name;
  const model::Field<2>* field = showing.field.empty() || pressure ? nullptr : &model::find_field<2>(showing.field);
  view::Panel panel;
  for (int b : showing.bodies) {
    const nurbs::Discretisation& space = model.system.scene.bodies[static_cast<std::size_t>(b)].body->space();
    const int divisions = divisions_for(space.elements());
    const auto sampling = tessellation::sampling(model, b, divisions, showing.deformed, showing.windows);
    view::Body body = plane_body(tessellation::tessellate(model, b, field, sampling, showing.deformed), showing);
    if (showing.vectors == "displacement") {
      const view::Points other = tessellation::tessellate(model, b, nullptr, sampling, !showing.deformed).points;
      body.vectors = showing.deformed ? body.points - other : other - body.points;
    }
    if (showing.undeformed) {
      const auto at_rest = tessellation::sampling(model, b, divisions, false, showing.windows);
      const tessellation::Skin reference = tessellation::tessellate(model, b, nullptr, at_rest, false);
      body.undeformed = without_seams(plane_body(reference, showing).rim);
    }
    panel.bodies.push_back(std::move(body));
  }
  if (pressure) add_pressure(panel, model, showing);
  if (showing.vectors == "traction") panel.vectors = tractions(model, showing.bodies);
  for (int k = 0; showing.obstacles && k < static_cast<int>(model.system.scene.obstacles.size()); ++k)
    panel.obstacles.push_back(obstacle(model, k, showing.deformed, showing.windows));
  for (char letter : showing.mirror) {
    const int axis = letter - 'x';
    add_mirror_image(panel, axis, mirror_sign(showing.field, axis));
  }
  return panel;
}

} // namespace signorini::bind
