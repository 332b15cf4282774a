#include "base/words.hpp"
#include "bind/lua/wording/wording.hpp"
#include "bind/scene/scene_builder.hpp"
#include "model/scene/face_projection.hpp"
#include "solid/load.hpp"

#include <algorithm>
#include <utility>

namespace signorini::bind {

using model::Constraint;

namespace {

/// Reads components named by letters, such as "x" or "xy".
template <int D>
void read_components(const Arguments& a, const char* key, Constraint constraint, model::Support<D>& support) {
  if (!a.has(key)) return;
  const auto letters = a.get<std::string>(key);
  if (D == 2 && letters.find('z') != std::string::npos)
    a.refuse(key, "'x', 'y' or 'xy'", "the bodies are plane and have no component z");
  for (char letter : letters) {
    Constraint& component = support.constraint[letter - 'x'];
    if (component != Constraint::free && constraint == Constraint::free)
      a.fail("it frees ", letter, ", which it also ", component == Constraint::fixed ? "fixes" : "drives",
             ": free is for components that are in neither fix nor drive, remove it from one of the two");
    if (component != Constraint::free)
      a.fail("it both fixes and drives ", letter,
             ": a component is either fixed or driven, remove it from one of the two");
    component = constraint;
    support.freed[letter - 'x'] = constraint == Constraint::free;
  }
}

/// The unit vector of rotate = "z" or {ax, ay, az}.
Vec<3> read_axis(const Arguments& a, int index) {
  lua_State* L = a.state();
  const char* expected = "'x', 'y', 'z', or a vector {x, y, z}";
  if (lua_isboolean(L, index))
    a.refuse("rotate", expected, "in 3D a face or obstacle rotates about an axis, as in rotate = \"z\"");
  if (lua_isstring(L, index)) return Vec<3>::Unit(*lua_tostring(L, index) - 'x');
  const Vec<3> axis = to<VectorX>(L, index);
  if (!(axis.norm() > 0)) a.refuse("rotate", expected, "a zero vector has no direction");
  return axis.normalized();
}

template <int D> double face_area(const solid::Body<D>& body, nurbs::Side side) {
  return solid::traction_load(body, side, 0).sum(); // ∫ Σ_A R_A dA, Σ_A R_A = 1
}

/// Calls visit(place) for each face in `on`; other values are errors.
template <int D, class Visit> void each_face(const Arguments& a, const char* expected, const char* cure, Visit visit) {
  a.list("on", [&](int, int index, const std::string&) {
    const BoundaryPart<D>* place = test_object<BoundaryPart<D>>(a.state(), index);
    if (!place) reject(a.state(), index, {a.name("on")}, expected, cure);
    if (!place->side) reject_place(*place, a.name("on"), expected, cure);
    visit(*place);
  });
}

/// The point about which a support rotates obstacles: that given, or the center of the sphere or cylinder.
template <int D> Vec<D> read_center(const Arguments& a, const SceneBuilder<D>& builder, const std::vector<int>& on) {
  if (a.has("center")) {
    const auto center = a.get<VectorX>("center");
    if (center.size() != D) a.refuse("center", components_text<D>(' '));
    return center;
  }
  const contact::Obstacle<D>& shape = builder.scene.obstacles[on.front()];
  if (on.size() == 1) {
    if (const auto* ball = std::get_if<contact::Ball<D>>(&shape)) return ball->center;
    if constexpr (D == 3)
      if (const auto* cylinder = std::get_if<contact::Cylinder>(&shape)) return cylinder->point;
  }
  a.refuse("center", D == 2 ? "a point {x, y}" : "a point {x, y, z}",
           "the obstacle rotates about it; only one sphere or cylinder has a center of its own");
}

/// The obstacles that a support rotates, by a driven or a free angle.
template <int D> void read_turning(const Arguments& a, const SceneBuilder<D>& builder, model::Support<D>& support) {
  if (!support.on.empty())
    a.fail("it rotates obstacles and faces, which have centers of their own: use a support for each");
  if (builder.scene.kind == solid::Kind::axisymmetric)
    a.fail("it rotates an obstacle, which would no longer be axisymmetric: remove rotate, or use a model in 3D");
  support.center = read_center(a, builder, support.obstacles);
  support.free_angle = a.get("angle", std::string("driven")) == "free";
}

/// Throws if a support frees what cannot move.
template <int D>
void check_freed(const Arguments& a, const SceneBuilder<D>& builder, const model::Support<D>& support) {
  if (support.obstacles.empty()) return;
  const bool frees = support.free_angle || std::ranges::find(support.freed, true) != support.freed.end();
  if (frees && support.obstacles.size() > 1)
    a.fail("it frees several obstacles, which would move independently: use a support for each");
  if (builder.scene.kind == solid::Kind::axisymmetric && support.freed[0])
    a.fail("free names x, but in an axisymmetric model an obstacle moves along the axis only: write free = \"y\"");
}

/// The face, in space the faces, that a support rotates about their common centroid (in space: an axis through it), or
/// obstacles.
template <int D> void read_rotation(const Arguments& a, const SceneBuilder<D>& builder, model::Support<D>& support) {
  lua_State* L = a.state();
  const int given = a.push("rotate");
  support.rotates = lua_toboolean(L, given);
  const auto needs = [&](const char* key, const char* why, const char* cure) {
    if (a.has(key)) a.fail(key, " is for obstacles that rotate", why, ": ", cure);
  };
  if (!support.rotates) {
    needs("center", ", but rotate is missing", D == 2 ? "add rotate = true" : "add rotate = \"z\", the axis");
    needs("angle", ", but rotate is missing", D == 2 ? "add rotate = true" : "add rotate = \"z\", the axis");
    return;
  }
  if constexpr (D == 3)
    support.axis = read_axis(a, given);
  else if (!lua_isboolean(L, given))
    a.refuse("rotate", "true or false", "plane bodies and obstacles can only rotate in the plane: write rotate = true");
  if (!support.obstacles.empty()) return read_turning(a, builder, support);
  needs("center", "; faces rotate about their centroid", "remove it");
  needs("angle", "; those of faces are prescribed by stages", "remove it");
  const char* expected = D == 2 ? "one face" : "a face, or a list of faces";
  const char* cure = D == 2 ? "only one face of a body can rotate; use separate supports for other faces"
                            : "only faces of bodies can rotate; use separate supports for others";
  if (D == 2 && lua_rawlen(L, a.push("on")) > 1) a.refuse("on", expected, cure);
  double size = 0;
  each_face<D>(a, expected, cure, [&](const BoundaryPart<D>& face) {
    const double area = face_area(*face.body, *face.side);
    support.center += area * model::face_centroid(*face.body, *face.side);
    size += area;
  });
  support.center /= size;
}

/// Springs on faces.
template <int D> void read_spring(const Arguments& a, const SceneBuilder<D>& builder, model::Support<D>& support) {
  if (!a.has("spring")) return;
  const auto stiffness = a.get<std::vector<double>>("spring");
  if (stiffness.size() != D) a.refuse("spring", components_text<D>('k'));
  const auto reject_spring = [&](const auto&... words) { fail(a.name("spring"), " ", words...); };
  for (int c = 0; c < D; ++c) {
    support.spring(c) = stiffness[c];
    if (!(support.spring(c) >= 0))
      reject_spring("must not be negative, got ", number(support.spring(c)), " for ", model::component_name(c));
    if (support.spring(c) > 0 && support.constraint[c] != Constraint::free)
      reject_spring("acts on ", model::component_name(c), ", which the support also ",
                    support.constraint[c] == Constraint::fixed ? "fixes" : "drives",
                    ": a component is held by a spring or prescribed, use 0 for it");
  }
  if (support.spring.isZero(0)) reject_spring("has no stiffness: give a positive one for at least one component");
  if (!support.obstacles.empty()) {
    if (!support.on.empty()) reject_spring("holds obstacles and faces, per area: use a support for each");
    for (int c = 0; c < D; ++c)
      if (support.spring(c) > 0 && !support.freed[c])
        reject_spring("acts on ", model::component_name(c), ", in which the obstacle is fixed: add free = \"",
                      model::component_name(c), "\"");
    std::swap(support.obstacle_spring, support.spring);
    return;
  }
  if (support.rotates) reject_spring("cannot be combined with rotate: use separate supports");
  each_face<D>(a, "a face, or a list of faces", "springs are for faces of bodies; use separate supports for others",
               [&](const BoundaryPart<D>& face) {
                 support.spring_faces.push_back({builder.index_of(face, a.name("on")), *face.side});
               });
}

/// Throws if a shape has values in components that do not follow it.
template <int D>
void check_driven(const Arguments& a, const model::Support<D>& support, const MatrixX& positions,
                  const MatrixX& values) {
  constexpr double rounding = 1e-9; // relative to the largest value: of a function such as sin(pi)
  const double least = rounding * values.cwiseAbs().maxCoeff();
  for (int c = 0; c < D; ++c) {
    Eigen::Index k = 0;
    if (support.constraint[c] == Constraint::driven || !(values.row(c).cwiseAbs().maxCoeff(&k) > least)) continue;
    const std::string component = model::component_name(c);
    fail(a.name("shape"), " returns u", component, " = ", number(values(c, k)),
         " at X = ", position_text(positions.col(k)), ", but the support does not drive ", component, ": add ",
         component, " to drive, or return 0 for it");
  }
}

/// The shape of a displacement, projected onto the control points of the faces.
template <int D> void read_shape(const Arguments& a, const SceneBuilder<D>& builder, model::Support<D>& support) {
  if (!a.has("shape")) return;
  const auto reject_shape = [&](const auto&... words) { fail(a.name("shape"), " ", words...); };
  if (std::ranges::find(support.constraint, Constraint::driven) == support.constraint.end())
    reject_shape("needs driven components, which follow it: add drive = \"", D == 2 ? "xy" : "xyz", "\"");
  if (support.rotates) reject_shape("cannot be combined with rotate: remove one of the two");
  std::vector<model::FaceReference> faces;
  MatrixX positions(D, 0);
  each_face<D>(a, "a face, or a list of faces", "a shape is for faces of bodies; use separate supports for others",
               [&](const BoundaryPart<D>& face) {
                 faces.push_back({builder.index_of(face, a.name("on")), *face.side});
                 const MatrixX own = solid::load_points(*face.body, *face.side).positions;
                 positions.conservativeResize(D, positions.cols() + own.cols());
                 positions.rightCols(own.cols()) = own;
               });
  const MatrixX values = values_at<D>(a, "shape", positions, components_text<D>('u'));
  check_driven(a, support, positions, values);
  const model::Projection shape = model::project(builder.scene, faces, values);
  for (std::size_t i = 0; i < shape.displacements.size(); ++i)
    support.on[i].shape.assign(shape.displacements[i].data(),
                               shape.displacements[i].data() + shape.displacements[i].size());
  support.shape_error = shape.error;
}

/// x, y or z = place.
struct AxisPlane {
  int axis;
  double place;
  std::string words() const { return text(model::component_name(axis), " = ", number(place)); }
};

/// The coordinate plane that contains all control points of a face, to `tolerance`; empty if the face is curved,
/// inclined or collapsed.
template <int D> std::optional<AxisPlane> plane_of(const MatrixX& points, double tolerance) {
  const Vec<D> low = points.rowwise().minCoeff(), extent = points.rowwise().maxCoeff() - low;
  if ((extent.array() <= tolerance).count() != 1) return std::nullopt;
  int axis = 0;
  extent.minCoeff(&axis);
  return AxisPlane{axis, low(axis)};
}

/// Fixes the normal component on faces in a plane of symmetry.
template <int D> void read_symmetry(const Arguments& a, const SceneBuilder<D>& builder, model::Support<D>& support) {
  if (!a.get<bool>("symmetry")) return;
  constexpr double flat = 1e-9; // relative to the body's size: rounding error of a plane
  const auto reject_symmetry = [&](const auto&... words) { fail(a.name("symmetry"), " ", words...); };
  if (support.rotates) reject_symmetry("cannot be combined with rotate: remove one of the two");
  std::optional<AxisPlane> plane;
  const char* cure = "only faces of bodies can be in a plane of symmetry; use separate supports for others";
  each_face<D>(a, "a face, or a list of faces", cure, [&](const BoundaryPart<D>& face) {
    const std::string words =
        worded(model::face_message(builder.scene, {builder.index_of(face, a.name("on")), *face.side}));
    const MatrixX points = face.body->space().points();
    const double tolerance = flat * (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
    const std::optional<AxisPlane> found = plane_of<D>(points(Eigen::all, face.functions), tolerance);
    if (!found)
      reject_symmetry(
          "needs a flat face across ", D == 2 ? "x or y" : "x, y or z", ", but ", words,
          " is curved or inclined: rotate all bodies with patch:rotate so that the plane is normal to an axis");
    if (builder.scene.kind == solid::Kind::axisymmetric && found->axis == 0 && std::abs(found->place) > tolerance)
      reject_symmetry("needs the axis x = 0 or a face across y, but ", words, " is a cylinder of radius ",
                      number(found->place), ": use fix = \"x\" to fix its radius");
    if (plane && (plane->axis != found->axis || std::abs(plane->place - found->place) > tolerance))
      reject_symmetry("needs faces in one plane, but ", words, " lies in ", found->words(), ", another one in ",
                      plane->words(), ". Hint: use a separate support for each plane");
    plane = found;
  });
  const std::string normal = model::component_name(plane->axis);
  for (const char* key : {"drive", "free"})
    if (a.has(key) && a.get<std::string>(key).find(normal) != std::string::npos)
      reject_symmetry("holds ", normal, " on the plane ", plane->words(), ", but ", key, " names ", normal,
                      ", too: remove one of the two");
  support.constraint[plane->axis] = Constraint::fixed;
}

} // namespace

template <int D> model::Support<D> read_support(SceneBuilder<D>& builder, const Arguments& a) {
  model::Support<D> support;
  const std::string on = a.name("on");
  std::vector<BoundaryPart<D>> places;
  a.list("on", [&](int, int index, const std::string&) {
    if (has_type(a.state(), index, Type<Rigid<D>>::name)) {
      const int obstacle = builder.index_of(read_object<Rigid<D>>(a.state(), index, {on}), on);
      if (std::ranges::find(support.obstacles, obstacle) != support.obstacles.end()) reject_twice(a, "an obstacle");
      support.obstacles.push_back(obstacle);
      return;
    }
    const BoundaryPart<D>& place = read_object<BoundaryPart<D>>(a.state(), index, {on});
    list_once(a, places, place, part_text(builder, place, on));
    support.on.push_back({builder.index_of(place, on), place.functions});
  });
  read_components(a, "fix", Constraint::fixed, support);
  read_components(a, "drive", Constraint::driven, support);
  read_components(a, "free", Constraint::free, support);
  read_rotation(a, builder, support);
  check_freed(a, builder, support);
  read_symmetry(a, builder, support);
  read_spring(a, builder, support);
  read_shape(a, builder, support);
  const bool frees = !support.obstacles.empty() && std::ranges::find(support.freed, true) != support.freed.end();
  if (support.constraint == std::array<Constraint, D>{} && !support.rotates && support.spring_faces.empty() && !frees)
    a.fail("it must constrain at least one component: add fix = \"xy\", drive = \"xy\", ",
           D == 2 ? "rotate = true" : "rotate = \"z\"", " or symmetry = true, or a spring; for an obstacle also free");
  return support;
}

template model::Support<2> read_support(SceneBuilder<2>&, const Arguments&);
template model::Support<3> read_support(SceneBuilder<3>&, const Arguments&);

} // namespace signorini::bind
