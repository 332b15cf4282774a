#include "solid/load.hpp"

#include "bind/lua/wording/wording.hpp"
#include "bind/scene/scene_builder.hpp"
#include "model/checks/scene_warnings.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

using model::LoadKind;

/// Components of a load of a kind, in the words of messages.
template <int D> std::string expected_of(LoadKind kind) {
  return components_text<D>(kind == LoadKind::traction ? 't' : kind == LoadKind::body_force ? 'b' : 'p');
}

/// The integral of a load's function over its faces or bodies, by component, and that of its size.
struct Resultant {
  VectorX sum;
  double size = 0;

  void add(const MatrixX& values, const VectorX& measures) {
    if (sum.size() == 0) sum = VectorX::Zero(values.rows());
    sum += values * measures;
    size += values.colwise().norm().dot(measures);
  }
};

/// Reads the values of a user's function at the points of the load, and compares its resultant with that of twice as
/// many points per direction.
template <int D> void read_function(SceneBuilder<D>& builder, const Arguments& a, const char* key, model::Load& load) {
  Resultant usual, finer;
  const auto read = [&](const solid::LoadPoints& points, Resultant& resultant) {
    const MatrixX values = values_at<D>(a, key, points.positions, load.pressure() ? "" : expected_of<D>(load.kind));
    // Bodies become bodies of revolution when the scene is complete.
    if (builder.scene.kind == solid::Kind::axisymmetric)
      resultant.add(values, points.measures.cwiseProduct(points.positions.row(0).transpose()));
    else
      resultant.add(values, points.measures);
    return values;
  };
  const auto add = [&](const solid::LoadPoints& points, const solid::LoadPoints& more) {
    const MatrixX values = read(points, usual);
    load.values.insert(load.values.end(), values.data(), values.data() + values.size());
    read(more, finer);
  };
  for (const model::FaceReference& face : load.on) {
    const solid::Body<D>& body = *builder.scene.bodies[face.body].body;
    add(solid::load_points(body, face.side), solid::load_points(body, face.side, 4));
  }
  for (const int index : load.bodies) {
    const solid::Body<D>& body = *builder.scene.bodies[index].body;
    add(solid::load_points(body), solid::load_points(body, 2));
  }
  if (usual.size == 0) return; // of which the model warns
  if (const Message warning = model::function_warning(a.name(key), (usual.sum - finer.sum).norm() / finer.size);
      !warning.code.empty())
    builder.warnings.push_back(warning);
}

/// Adds the control points of a corner or an edge.
template <int D>
void add_points(const SceneBuilder<D>& builder, const Arguments& a, const BoundaryPart<D>& place, model::Load& load) {
  const int body = builder.index_of(place, a.name("on"));
  if (place.functions.size() == 1 && std::string(place.kind) == "corner") {
    load.points.push_back({body, place.functions.front(), 1.0});
    return;
  }
  if constexpr (D == 3) {
    const auto dash = place.name.find('-');
    const VectorX lengths = solid::edge_lengths(*place.body, nurbs::side_of(place.name.substr(0, dash), 3),
                                                nurbs::side_of(place.name.substr(dash + 1), 3));
    for (const int function : place.functions) load.points.push_back({body, function, lengths(function)});
  }
}

/// Reads `on` of a force or moment on obstacles; false for others.
template <int D> bool read_obstacles(SceneBuilder<D>& builder, const Arguments& a, model::Load& load) {
  const bool moment = a.has("moment");
  int others = 0;
  a.list("on", [&](int, int index, const std::string&) {
    if (!has_type(a.state(), index, Type<Rigid<D>>::name)) {
      ++others;
      return;
    }
    const int obstacle = builder.index_of(read_object<Rigid<D>>(a.state(), index, {a.name("on")}), a.name("on"));
    if (std::ranges::find(load.obstacles, obstacle) != load.obstacles.end()) reject_twice(a, "an obstacle");
    load.obstacles.push_back(obstacle);
  });
  if (moment && others > 0)
    a.fail("it is a moment, which acts on obstacles that rotate, but on names another place: give force or traction");
  if (load.obstacles.empty()) return false;
  if (others > 0 || load.obstacles.size() > 1)
    a.fail("it is on an obstacle and another place, but a force on an obstacle is its total: use a load for each");
  load.kind = moment ? LoadKind::moment : LoadKind::point_force;
  return true;
}

/// Reads `on` of a force: bodies, corners, or edges.
template <int D> void read_places(const SceneBuilder<D>& builder, const Arguments& a, model::Load& load) {
  std::vector<std::string> kinds, listed;
  std::vector<BoundaryPart<D>> places;
  a.list("on", [&](int, int index, const std::string&) {
    std::string kind = "body", words;
    if (const Body<D>* body = test_object<Body<D>>(a.state(), index)) {
      load.bodies.push_back(builder.index_of(*body, a.name("on")));
      words = text("body '", builder.scene.bodies[load.bodies.back()].name, "'");
      if (std::ranges::find(listed, words) != listed.end()) reject_twice(a, words);
    } else {
      const BoundaryPart<D>& place = read_object<BoundaryPart<D>>(a.state(), index, {a.name("on")});
      kind = place.kind;
      words = part_text(builder, place, a.name("on"));
      if (place.side)
        a.fail("it is on the ", words,
               ", but force acts on bodies per volume, on edges per length, or on corners: name "
               "one of these, or give traction, a force per area");
      list_once(a, places, place, words);
      add_points(builder, a, place, load);
    }
    if (!kinds.empty() && kinds.front() != kind)
      a.fail("it is on the ", listed.front(), " and the ", words,
             ", but a force per volume, per length or on a corner has another unit: use a load for each");
    listed.push_back(words);
    kinds.push_back(kind);
  });
  load.kind = load.bodies.empty() ? LoadKind::point_force : LoadKind::body_force;
}

/// Reads `on` of a traction or a pressure: faces.
template <int D> void read_faces(const SceneBuilder<D>& builder, const Arguments& a, model::Load& load) {
  a.list("on", [&](int, int index, const std::string&) {
    if (const Body<D>* body = test_object<Body<D>>(a.state(), index))
      a.fail("it is on the body '", builder.scene.bodies[builder.index_of(*body, a.name("on"))].name,
             "', but traction and pressure act on faces: name a face, or give force");
    const model::FaceReference face = builder.face(a.state(), index, a.name("on"));
    if (std::ranges::find(load.on, face) != load.on.end())
      reject_twice(a, worded(model::face_message(builder.scene, face)));
    load.on.push_back(face);
  });
}

} // namespace

template <int D> model::Load read_load(SceneBuilder<D>& builder, const Arguments& a) {
  model::Load load;
  const char* key = a.has("pressure") ? "pressure" : a.has("force") ? "force" : a.has("moment") ? "moment" : "traction";
  if (a.has("force") || a.has("moment")) {
    if (!read_obstacles(builder, a, load)) read_places(builder, a, load);
  } else {
    read_faces(builder, a, load);
    load.kind = !a.has("pressure")        ? LoadKind::traction
                : a.get<bool>("follower") ? LoadKind::follower_pressure
                                          : LoadKind::pressure;
  }
  if (!a.is(key, LUA_TFUNCTION)) {
    const bool scalar = load.pressure() || load.kind == LoadKind::moment;
    load.start = scalar ? std::vector<double>{a.get<double>(key)} : a.get<std::vector<double>>(key);
    if (std::ssize(load.start) != (scalar ? 1 : D)) a.refuse(key, expected_of<D>(load.kind));
    return load;
  }
  if (load.kind == LoadKind::point_force)
    a.fail("force is a function, which is for faces and bodies, but it is on corners, edges or an obstacle: give ",
           expected_of<D>(load.kind));
  read_function(builder, a, key, load);
  load.start = {a.get<double>("factor")};
  return load;
}

template model::Load read_load(SceneBuilder<2>&, const Arguments&);
template model::Load read_load(SceneBuilder<3>&, const Arguments&);

} // namespace signorini::bind
