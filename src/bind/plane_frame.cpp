#include "base/index.hpp"
#include "bind/frame.hpp"
#include "tessellation/tessellate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::bind {

namespace {

/// The points of a tessellation in their order: element by element, row by row.
struct PlaneGrid {
  PlaneGrid(const view::Points& of, const tessellation::Sampling<2>& at_places)
      : points(of),
        sampling(at_places), elements{static_cast<int>(sampling[0].size()), static_cast<int>(sampling[1].size())} {
    for (int e = 0, next = 0; e < elements[0] * elements[1]; ++e) {
      first.push_back(next);
      next += count(e, 0) * count(e, 1);
    }
  }

  const view::Points& points;
  const tessellation::Sampling<2>& sampling;
  std::array<int, 2> elements;
  std::vector<int> first; ///< point of each element

  /// Points of an element in a direction.
  int count(int element, int direction) const {
    const int number = direction == 0 ? element % elements[0] : element / elements[0];
    return static_cast<int>(sampling[at(direction)][at(number)].size());
  }

  int index(int element, int i, int j) const { return first[at(element)] + count(element, 0) * j + i; }

  /// An element's border along a direction, at the start or the end of the other one.
  view::Points border(int element, int along, int end) const {
    const int fixed = end * (count(element, 1 - along) - 1);
    view::Points line(3, count(element, along));
    for (int k = 0; k < line.cols(); ++k)
      line.col(k) = points.col(along == 0 ? index(element, k, fixed) : index(element, fixed, k));
    return line;
  }

  /// An element's size across a direction, through its middle.
  double across(int element, int along) const {
    const int middle = count(element, along) / 2, last = count(element, 1 - along) - 1;
    return along == 0 ? (points.col(index(element, middle, last)) - points.col(index(element, middle, 0))).norm()
                      : (points.col(index(element, last, middle)) - points.col(index(element, 0, middle))).norm();
  }

  /// Whether an element is the first or the last of those across a direction.
  bool is_last(int element, int along, int end) const {
    const int place = along == 0 ? element / elements[0] : element % elements[0];
    return place == (end == 0 ? 0 : elements[static_cast<std::size_t>(1 - along)] - 1);
  }
};

/// Borders between elements, each once.
std::vector<view::MeshLine> mesh_lines(const PlaneGrid& grid) {
  std::vector<view::MeshLine> lines;
  for (int e = 0; e < grid.elements[0] * grid.elements[1]; ++e)
    for (int along : {0, 1})
      if (!grid.is_last(e, along, 0)) lines.push_back({grid.border(e, along, 0), grid.across(e, along)});
  return lines;
}

/// The sides of the body, element by element.
std::vector<view::Points> rim(const PlaneGrid& grid) {
  std::vector<view::Points> lines;
  for (int along : {0, 1})
    for (int end : {0, 1}) {
      view::Points line(3, 0);
      for (int e = 0; e < grid.elements[0] * grid.elements[1]; ++e)
        if (grid.is_last(e, along, end)) {
          const view::Points piece = grid.border(e, along, end);
          const Eigen::Index kept = std::max<Eigen::Index>(line.cols() - 1, 0); // neighbours share a point
          line.conservativeResize(3, kept + piece.cols());
          line.rightCols(piece.cols()) = piece;
        }
      lines.push_back(std::move(line));
    }
  return lines;
}

/// The lines of rim() without pairs of opposite sides that are one: where a body is closed it has no border.
std::vector<view::Points> without_seams(std::vector<view::Points> lines) {
  for (std::size_t pair = lines.size(); pair >= 2; pair -= 2)
    if (const auto first = lines.begin() + static_cast<std::ptrdiff_t>(pair) - 2; first[0].isApprox(first[1], 1e-9))
      lines.erase(first, first + 2);
  return lines;
}

void add_mirror_image(view::Panel& panel, int axis, double sign) {
  for (std::size_t i = 0, count = panel.bodies.size(); i < count; ++i)
    panel.bodies.push_back(view::mirrored(panel.bodies[i], axis, sign));
  for (std::size_t i = 0, count = panel.obstacles.size(); i < count; ++i)
    panel.obstacles.push_back(view::mirrored(panel.obstacles[i], axis));
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

template <> std::string field_label<2>(const std::string& field) {
  return field == pressure_name ? "contact pressure" : model::find_field<2>(field).label;
}

view::Panel show(const model::Model<2>& model, const Showing& showing) {
  const bool pressure = showing.field == pressure_name;
  const model::Field<2>* field = showing.field.empty() || pressure ? nullptr : &model::find_field<2>(showing.field);
  view::Panel panel;
  for (int b : showing.bodies) {
    const nurbs::Discretisation& space = model.system.scene.bodies[static_cast<std::size_t>(b)].body->space();
    const int divisions = divisions_for(space.elements());
    const auto sampling = tessellation::sampling(model, b, divisions, showing.deformed, showing.windows);
    tessellation::Tessellation sampled = tessellation::tessellate(model, b, field, sampling, showing.deformed);
    view::Body body;
    body.points = std::move(sampled.points);
    body.triangles = std::move(sampled.triangles);
    body.values = showing.factor * sampled.values;
    const PlaneGrid grid(body.points, sampling);
    body.rim = rim(grid);
    if (showing.mesh) body.mesh_lines = mesh_lines(grid);
    if (showing.control_points) {
      body.control_points = std::move(sampled.control_points);
      body.net_lines = std::move(sampled.net_lines);
    }
    if (showing.undeformed) {
      const auto at_rest = tessellation::sampling(model, b, divisions, false, showing.windows);
      const view::Points reference = tessellation::tessellate(model, b, nullptr, at_rest, false).points;
      body.undeformed = without_seams(rim({reference, at_rest}));
    }
    panel.bodies.push_back(std::move(body));
  }
  if (pressure) add_pressure(panel, model, showing);
  for (int k = 0; showing.obstacles && k < static_cast<int>(model.system.scene.obstacles.size()); ++k)
    panel.obstacles.push_back(obstacle(model, k, showing.deformed, showing.windows));
  for (char letter : showing.mirror) {
    const int axis = letter - 'x';
    add_mirror_image(panel, axis, mirror_sign(showing.field, axis));
  }
  return panel;
}

} // namespace signorini::bind
