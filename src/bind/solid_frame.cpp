#include "bind/frame.hpp"
#include "tessellation/tessellate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::bind {

namespace {

std::vector<view::SurfaceLine> lines_of(std::vector<tessellation::SkinLine> lines, bool spaced) {
  std::vector<view::SurfaceLine> result;
  for (tessellation::SkinLine& line : lines)
    result.push_back({std::move(line.points), std::move(line.normals), spaced ? line.spacing : 0});
  return result;
}

/// A body's surface, without its inside.
view::Solid skin_of(const model::Model<3>& model, int b, const Showing& showing, const model::Field<3>* field,
                    int divisions) {
  const auto sampling = tessellation::sampling(model, b, divisions, showing.deformed, showing.windows);
  tessellation::Skin skin = tessellation::tessellate(model, b, field, sampling, showing.deformed);
  if (showing.field == pressure_name) skin.values = tessellation::contact_pressure(model, b, sampling);
  view::Solid solid = solid_body(std::move(skin), showing);
  if (showing.vectors == "displacement") {
    const view::Points other = tessellation::tessellate(model, b, nullptr, sampling, !showing.deformed).points;
    solid.skin.vectors = showing.deformed ? solid.skin.points - other : other - solid.skin.points;
  }
  if (showing.undeformed) {
    const auto at_rest = tessellation::sampling(model, b, divisions, false, showing.windows);
    view::Solid reference = solid_body(tessellation::tessellate(model, b, nullptr, at_rest, false), {});
    solid.undeformed = std::move(reference.skin);
    solid.undeformed_rim = std::move(reference.rim);
  }
  return solid;
}

/// The lattices of the elements that one of the planes crosses. No pressure acts between contacts.
std::vector<view::Lattice> inside_of(const model::Model<3>& model, int b, const Showing& showing,
                                     const model::Field<3>* field, int divisions, bool valued,
                                     const std::vector<tessellation::Plane>& planes) {
  std::vector<view::Lattice> result;
  for (tessellation::Inside& inside :
       tessellation::crossed_elements(model, b, field, divisions, showing.deformed, planes)) {
    view::Lattice lattice{inside.divisions, std::move(inside.points), showing.factor * inside.values};
    if (valued && !field) lattice.values.setZero(lattice.points.cols());
    result.push_back(std::move(lattice));
  }
  return result;
}

view::RigidSurface shifted(const nurbs::Patch& patch, const Vec<3>& shift, std::vector<Window> windows) {
  for (Window& window : windows) {
    window.low -= window.axes * shift;
    window.high -= window.axes * shift;
  }
  tessellation::Skin skin = tessellation::tessellate(patch, 1, windows);
  skin.points.colwise() += shift;
  for (tessellation::SkinLine& line : skin.rim) line.points.colwise() += shift;
  view::Solid solid = solid_body(std::move(skin), {});
  return {std::move(solid.skin), std::move(solid.rim)};
}

/// A model's rigid obstacle where it stands now, or stood at the start.
view::Rigid obstacle(const model::Model<3>& model, int index, bool deformed, const std::vector<Window>& windows) {
  const int first = model.system.unknowns.obstacle_offset(index);
  const Vec<3> shift = deformed ? Vec<3>(model.present.displacement.segment<3>(first)) : Vec<3>::Zero();
  const contact::Obstacle<3>& shape = model.system.scene.obstacles[static_cast<std::size_t>(index)];
  if (const auto* plane = std::get_if<contact::Plane<3>>(&shape))
    return view::RigidPlane{plane->point + shift, plane->normal};
  if (const auto* ball = std::get_if<contact::Ball<3>>(&shape))
    return view::RigidBall{ball->centre + shift, ball->radius};
  if (const auto* cylinder = std::get_if<contact::Cylinder>(&shape))
    return view::RigidCylinder{cylinder->point + shift, cylinder->axis, cylinder->radius};
  return shifted(std::get<nurbs::Patch>(shape), shift, windows);
}

void add_mirror_image(view::SolidPanel& panel, int axis, double sign) {
  for (view::Solid& body : panel.bodies) view::join_at_mirror(body, axis);
  for (std::size_t i = 0, count = panel.bodies.size(); i < count; ++i)
    panel.bodies.push_back(view::mirrored(panel.bodies[i], axis, sign));
  for (std::size_t i = 0, count = panel.obstacles.size(); i < count; ++i)
    if (auto image = view::mirrored(panel.obstacles[i], axis)) panel.obstacles.push_back(std::move(*image));
  for (std::size_t i = 0, count = panel.vectors.size(); i < count; ++i)
    panel.vectors.push_back(view::mirrored(panel.vectors[i], axis));
}

/// A plane and what it is in the mirrors: where the model itself must be sampled.
std::vector<tessellation::Plane> images(const view::CutPlane& plane, const std::string& mirror) {
  std::vector<tessellation::Plane> all = {{plane.point, plane.normal}};
  for (char letter : mirror)
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
      tessellation::Plane image = all[i];
      image.point[letter - 'x'] *= -1;
      image.normal[letter - 'x'] *= -1;
      all.push_back(image);
    }
  return all;
}

/// The plane of a cut; one without a point halves the box of all bodies and their images.
view::CutPlane plane_of(const Cut& cut, const std::vector<view::Solid>& bodies, const std::string& mirror) {
  view::Bounds box;
  for (const view::Solid& body : bodies) box.take(body.skin.points);
  for (char letter : mirror) {
    const int axis = letter - 'x';
    const double far = std::max(std::abs(box.low[axis]), std::abs(box.high[axis]));
    box.low[axis] = -far;
    box.high[axis] = far;
  }
  return {cut.point.value_or(box.centre()), cut.normal};
}

} // namespace

view::Solid solid_body(tessellation::Skin skin, const Showing& showing) {
  view::Solid solid;
  solid.skin = {std::move(skin.points), std::move(skin.normals), std::move(skin.triangles),
                showing.factor * skin.values};
  solid.rim = lines_of(std::move(skin.rim), false);
  solid.mesh_lines = lines_of(std::move(skin.mesh_lines), true);
  solid.mesh = showing.mesh;
  if (showing.control_points) {
    solid.control_points = std::move(skin.control_points);
    solid.net_lines = std::move(skin.net_lines);
  }
  return solid;
}

view::SolidPanel show(const model::Model<3>& model, const Showing& showing, const std::optional<Cut>& cut) {
  const bool pressure = showing.field == pressure_name;
  require(!pressure || !model.system.contacts.empty(), "field '", pressure_name,
          "': the model has no contact, and so no pressure; name contacts in sg.model, or draw another field");
  const model::Field<3>* field = showing.field.empty() || pressure ? nullptr : &model::find_field<3>(showing.field);
  const auto divisions = [&](int b) {
    return divisions_for(
        tessellation::surface_elements(model.system.scene.bodies[static_cast<std::size_t>(b)].body->space()));
  };
  view::SolidPanel panel;
  panel.windows = showing.windows;
  Showing skins = showing;
  if (cut) skins.windows.clear(); // cut faces have even pieces, and skins end where they do
  for (int b : showing.bodies) panel.bodies.push_back(skin_of(model, b, skins, field, divisions(b)));
  if (cut) {
    panel.cut = plane_of(*cut, panel.bodies, showing.mirror);
    const std::vector<tessellation::Plane> planes = images(*panel.cut, showing.mirror);
    for (std::size_t i = 0; i < panel.bodies.size(); ++i) {
      view::Solid& body = panel.bodies[i];
      const int b = showing.bodies[i];
      body.inside = inside_of(model, b, showing, field, divisions(b), body.skin.values.size() > 0, planes);
    }
  }
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
