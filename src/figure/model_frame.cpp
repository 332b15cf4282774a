#include "figure/frame.hpp"
#include "figure/obstacle_frame.hpp"
#include "model/scene/turning.hpp"
#include "view/obstacle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::figure {

namespace {

std::vector<view::SurfaceLine> lines_of(std::vector<tessellation::SkinLine> lines, bool spaced) {
  std::vector<view::SurfaceLine> result;
  for (tessellation::SkinLine& line : lines)
    result.push_back({std::move(line.points), std::move(line.normals), spaced ? line.spacing : 0});
  return result;
}

/// Removes pairs of opposite sides that coincide: a closed body has no border there.
std::vector<view::SurfaceLine> without_seams(std::vector<view::SurfaceLine> lines) {
  for (std::size_t pair = lines.size(); pair >= 2; pair -= 2)
    if (const auto first = lines.begin() + static_cast<std::ptrdiff_t>(pair) - 2;
        first[0].points.isApprox(first[1].points, 1e-9))
      lines.erase(first, first + 2);
  return lines;
}

/// Pieces per element and direction: enough for a quadratic arc over an eighth of a circle to look round at any size;
/// fewer for many small elements.
template <int D> int divisions_for(const model::Model<D>& model, int b) {
  const nurbs::Discretization& space = model.system.scene.bodies[b].body->space();
  const int elements = D == 2 ? space.elements() : tessellation::surface_elements(space);
  return std::clamp(static_cast<int>(std::sqrt(40000.0 / elements)), 4, 12);
}

void check_finite(const VectorX& values, const Showing& showing) {
  require(values.allFinite(), "figure.field.finite", {{"field", showing.field}});
}

/// A plane body, or the surface of a solid.
template <int D>
view::Body skin_of(const model::Model<D>& model, int b, const Showing& showing, const model::Field<D>* field) {
  const int divisions = divisions_for(model, b);
  const auto sampling = tessellation::sampling(model, b, divisions, showing.deformed, showing.windows);
  tessellation::Skin skin = tessellation::tessellate(model, b, field, sampling, showing.deformed);
  check_finite(skin.values, showing);
  if constexpr (D == 3)
    if (const auto on_faces = model::face_field(showing.field))
      skin.values = tessellation::face_values(model, *on_faces, b, sampling);
  view::Body body = picture_body(std::move(skin), showing);
  if (showing.vectors == "displacement") {
    const view::Points other = tessellation::tessellate(model, b, nullptr, sampling, !showing.deformed).points;
    body.skin.vectors = showing.deformed ? body.skin.points - other : other - body.skin.points;
  }
  if (showing.undeformed) {
    const auto at_rest = tessellation::sampling(model, b, divisions, false, showing.windows);
    view::Body reference = picture_body(tessellation::tessellate(model, b, nullptr, at_rest, false), {});
    if (D == 3) body.undeformed = std::move(reference.skin);
    body.undeformed_rim = D == 3 ? std::move(reference.rim) : without_seams(std::move(reference.rim));
  }
  return body;
}

/// Inserts bands on the slave faces of the drawn bodies before these, because bodies drawn first cover later
/// ones.
void add_bands(view::Panel& panel, const model::Model<2>& model, model::FaceField field, const Showing& showing) {
  view::Bounds box;
  for (const view::Body& body : panel.bodies) box.take(body.skin.points);
  std::vector<view::Body> bands;
  model::Faces drawn;
  for (const auto& contact : model.system.scene.contacts) {
    if (!has(contact, field)) continue;
    for (const model::FaceReference& face : contact.slave) {
      if (drawn.contains(face) || std::count(showing.bodies.begin(), showing.bodies.end(), face.body) == 0) continue;
      drawn.push_back(face);
      bands.push_back(face_band(model, field, face, showing, box.size()));
    }
  }
  panel.bodies.insert(panel.bodies.begin(), bands.begin(), bands.end());
}

// ── Obstacles, in the present or initial position ────────────────────────────────────────────────────────────────────

void add_obstacle(view::Panel& panel, const contact::Obstacle<2>& shape, const Motion<2>& motion) {
  const auto add = [&](view::Outline outline) { panel.outlines.push_back(std::move(outline)); };
  if (const auto* plane = std::get_if<contact::Plane<2>>(&shape))
    return add(view::half_plane(plane->point, plane->normal));
  if (const auto* ball = std::get_if<contact::Ball<2>>(&shape)) return add(circle_of(*ball, panel.windows));
  if (const auto* level_set = std::get_if<contact::LevelSet<2>>(&shape)) {
    for (view::Outline& outline : outlines(*level_set, motion)) add(std::move(outline));
    return;
  }
  const auto& curve = std::get<nurbs::Patch>(shape);
  const nurbs::KnotVector& knots = curve.directions().front();
  const auto place = [&](double fraction) {
    const double xi = knots.first() + (knots.last() - knots.first()) * fraction;
    Vec<3> point = Vec<3>::Zero();
    point.head<2>() = nurbs::evaluate(curve, VectorX::Constant(1, xi));
    return point;
  };
  add(view::outline(place, 400, panel.windows));
}

view::RigidSurface rigid_patch(const nurbs::Patch& patch, const std::vector<Window>& windows) {
  view::Body body = picture_body(tessellation::tessellate(patch, 1, windows), {});
  return {std::move(body.skin), std::move(body.rim)};
}

void add_obstacle(view::Panel& panel, const contact::Obstacle<3>& shape, const Motion<3>& motion) {
  const auto add = [&](view::Rigid rigid) { panel.obstacles.push_back(std::move(rigid)); };
  if (const auto* plane = std::get_if<contact::Plane<3>>(&shape))
    return add(view::RigidPlane{plane->point, plane->normal});
  if (const auto* ball = std::get_if<contact::Ball<3>>(&shape)) return add(view::RigidBall{ball->center, ball->radius});
  if (const auto* cylinder = std::get_if<contact::Cylinder>(&shape))
    return add(view::RigidCylinder{cylinder->point, cylinder->axis, cylinder->radius});
  if (const auto* torus = std::get_if<contact::Torus>(&shape)) return add(surface_of(*torus));
  if (const auto* level_set = std::get_if<contact::LevelSet<3>>(&shape)) return add(surface_of(*level_set, motion));
  add(rigid_patch(std::get<nurbs::Patch>(shape), panel.windows));
}

/// A radius of a disc, which shows its rotation.
void add_spoke(view::Panel& panel, const contact::Obstacle<2>& shape, const Mat<2>& rotation) {
  const auto* ball = std::get_if<contact::Ball<2>>(&shape);
  if (!ball) return;
  view::Points& spoke = panel.outlines.back().spoke;
  spoke.setZero(3, 2);
  spoke.topRows<2>().colwise() = ball->center;
  spoke.col(1).head<2>() += ball->radius * rotation.col(0);
}

template <int D> void add_obstacles(view::Panel& panel, const model::Model<D>& model, bool deformed) {
  for (int k = 0; k < std::ssize(model.system.scene.obstacles); ++k) {
    const int first = model.system.unknowns.obstacle_offset(k);
    const VectorX& u = model.present.displacement;
    const Vec<D> shift = deformed ? Vec<D>(u.template segment<D>(first)) : Vec<D>(Vec<D>::Zero());
    const auto turn = model::turn_of(model.system.scene, k);
    Mat<D> rotation = Mat<D>::Identity();
    if (turn && deformed) rotation += Eigen::Map<const Mat<D>>(u.data() + first + D) / turn->turning.arm;
    const Motion<D> motion = motion_about<D>(turn ? turn->turning.center : Vec<D>(Vec<D>::Zero()), rotation, shift);
    const contact::Obstacle<D> shape = moved<D>(model.system.scene.obstacles[k], motion);
    add_obstacle(panel, shape, motion);
    if constexpr (D == 2)
      if (turn) add_spoke(panel, shape, rotation);
  }
}

// ── Mirrors ──────────────────────────────────────────────────────────────────────────────────────────────────────────

/// The sign of a field's values in the mirror of an axis (0, 1, 2): components with an odd number of indices along it
/// change sign.
double mirror_sign(const std::string& field, int axis) {
  const bool component = field.size() > 1 && (field[0] == 'u' || field[0] == 's' || field[0] == 'F');
  if (!component) return 1;
  const auto along = std::count_if(field.begin() + 1, field.end(),
                                   [&](char index) { return index == "xyz"[axis] || index == "123"[axis]; });
  return along % 2 == 0 ? 1 : -1;
}

/// Appends the images of a list's items; image(item) may be empty.
template <class T, class Image> void add_images(std::vector<T>& list, Image image) {
  for (std::size_t i = 0, count = list.size(); i < count; ++i)
    if (std::optional<T> one = image(list[i])) list.push_back(std::move(*one));
}

void add_mirror_image(view::Panel& panel, int axis, double sign) {
  const auto image = [&](const auto& one) { return view::mirrored(one, axis); };
  for (view::Body& body : panel.bodies) view::join_at_mirror(body, axis);
  add_images(panel.bodies, [&](const view::Body& body) { return view::mirrored(body, axis, sign); });
  add_images(panel.outlines, image);
  add_images(panel.obstacles, image);
  add_images(panel.vectors, image);
}

// ── Cuts ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

/// The lattices of the elements that one of the planes intersects.
std::vector<view::Lattice> inside_of(const model::Model<3>& model, int b, const Showing& showing,
                                     const model::Field<3>* field, bool valued,
                                     const std::vector<tessellation::CutPlane>& planes) {
  std::vector<view::Lattice> result;
  for (tessellation::Inside& inside :
       tessellation::crossed_elements(model, b, field, divisions_for(model, b), showing.deformed, planes)) {
    check_finite(inside.values, showing);
    view::Lattice lattice{inside.divisions, std::move(inside.points), showing.factor * inside.values};
    if (valued && !field)
      lattice.values.setConstant(lattice.points.cols(), elsewhere(*model::face_field(showing.field)));
    result.push_back(std::move(lattice));
  }
  return result;
}

/// The plane of a cut; by default through the center of the bounding box of all bodies and their images.
view::CutPlane plane_of(const Cut& cut, const std::vector<view::Body>& bodies, const std::string& mirror) {
  view::Bounds box;
  for (const view::Body& body : bodies) box.take(body.skin.points);
  for (char letter : mirror) {
    const int axis = letter - 'x';
    const double far = std::max(std::abs(box.low[axis]), std::abs(box.high[axis]));
    box.low[axis] = -far;
    box.high[axis] = far;
  }
  return {cut.point.value_or(box.center()), cut.normal};
}

/// Sets the cut; the model itself is sampled in the plane and in its mirror images.
void cut_open(view::Panel& panel, const model::Model<3>& model, const Cut& cut, const Showing& showing,
              const model::Field<3>* field) {
  panel.cut = plane_of(cut, panel.bodies, showing.mirror);
  std::vector<tessellation::CutPlane> planes = {{panel.cut->point, panel.cut->normal}};
  for (char letter : showing.mirror)
    add_images(planes, [&](tessellation::CutPlane image) {
      image.point[letter - 'x'] *= -1;
      image.normal[letter - 'x'] *= -1;
      return image;
    });
  for (std::size_t i = 0; i < panel.bodies.size(); ++i) {
    view::Body& body = panel.bodies[i];
    const bool valued = body.skin.values.size() > 0;
    body.inside = inside_of(model, showing.bodies[i], showing, valued ? field : nullptr, valued, planes);
  }
}

} // namespace

view::Body picture_body(tessellation::Skin skin, const Showing& showing) {
  view::Body body;
  body.skin = {std::move(skin.points), std::move(skin.normals), std::move(skin.triangles),
               showing.factor * skin.values};
  body.rim = lines_of(std::move(skin.rim), false);
  body.mesh_lines = lines_of(std::move(skin.mesh_lines), true);
  body.mesh = showing.mesh;
  if (showing.control_points) {
    body.control_points = std::move(skin.control_points);
    body.net_lines = std::move(skin.net_lines);
  }
  return body;
}

template <int D> view::Panel show(const model::Model<D>& model, const Showing& showing, const std::optional<Cut>& cut) {
  const auto on_faces = model::face_field(showing.field);
  const auto& contacts = model.system.scene.contacts;
  const bool found =
      !on_faces || std::ranges::any_of(contacts, [&](const auto& contact) { return has(contact, *on_faces); });
  const auto misses = [&](model::FaceField field) { return !found && on_faces == field; };
  using model::FaceField;
  require(D == 2 || !misses(FaceField::pressure), "figure.field.contact", {{"field", showing.field}});
  require(!misses(FaceField::damage), "figure.field.cohesive", {{"field", showing.field}});
  require(!misses(FaceField::worn), "figure.field.wear", {{"field", showing.field}});
  require(!misses(FaceField::mu) && !misses(FaceField::slip), "figure.field.friction", {{"field", showing.field}});
  const model::Field<D>* field = showing.field.empty() || on_faces ? nullptr : &model::find_field<D>(showing.field);
  view::Panel panel;
  panel.windows = showing.windows;
  Showing skins = showing;
  if (cut) skins.windows.clear(); // cut faces have even pieces, and the skin must end where they do
  Showing plain = skins;
  plain.field.clear();
  for (int b : showing.bodies) {
    const bool gray = std::find(showing.gray.begin(), showing.gray.end(), b) != showing.gray.end();
    panel.bodies.push_back(skin_of(model, b, gray ? plain : skins, gray ? nullptr : field));
  }
  if constexpr (D == 3) {
    if (cut) cut_open(panel, model, *cut, showing, field);
  } else if (on_faces) {
    add_bands(panel, model, *on_faces, showing);
  }
  if (showing.vectors == "traction") panel.vectors = tractions(model, showing.bodies);
  if (showing.obstacles) add_obstacles(panel, model, showing.deformed);
  for (char letter : showing.mirror) add_mirror_image(panel, letter - 'x', mirror_sign(showing.field, letter - 'x'));
  return panel;
}
template view::Panel show<2>(const model::Model<2>&, const Showing&, const std::optional<Cut>&);
template view::Panel show<3>(const model::Model<3>&, const Showing&, const std::optional<Cut>&);

} // namespace signorini::figure
