#pragma once
// Scene of a model: named bodies, supports, loads, obstacles, contacts, ties and joins, as plain values.

#include "base/message.hpp"
#include "contact/method/method.hpp"
#include "contact/tie/tie.hpp"
#include "solid/body.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace signorini::model {

template <int D> struct NamedBody {
  std::string name;
  std::shared_ptr<const solid::Body<D>> body;
};

/// A face of a body of the scene.
struct FaceReference {
  int body; ///< index into Scene::bodies
  nurbs::Side side;
  bool operator==(const FaceReference&) const = default;
};

/// One face, or a list of faces with common borders that act as one (contact/face/face_grid.hpp).
struct Faces : std::vector<FaceReference> {
  using std::vector<FaceReference>::vector;
  Faces(int body, nurbs::Side side) : Faces(FaceReference{body, side}) {}
  Faces(const FaceReference& face) : std::vector<FaceReference>{face} {}

  bool contains(const FaceReference& face) const { return std::find(begin(), end(), face) != end(); }
  bool meets(const Faces& other) const {
    return std::any_of(begin(), end(), [&](const FaceReference& face) { return other.contains(face); });
  }
  /// True if one of the faces belongs to a body.
  bool on(int body) const {
    return std::any_of(begin(), end(), [&](const FaceReference& face) { return face.body == body; });
  }
};

/// A rigid obstacle of the scene.
struct ObstacleReference {
  int obstacle; ///< index into Scene::obstacles
  bool operator==(const ObstacleReference&) const = default;
};

/// Constraint of one displacement component by a support.
enum class Constraint { free, fixed, driven };

/// Control points of one body on which a support acts.
struct SupportedControlPoints {
  int body;
  std::vector<int> functions;
  /// Displacement of each control point for a factor of 1, D numbers each; empty unless the support has a shape.
  std::vector<double> shape = {};
};

/// Constrains control points and obstacles component by component. A rotating support moves its control points as a
/// rigid body,
///   x = X_c + c + R(θ)(X − X_c),
/// with a prescribed angle θ, in 3D about `axis`; `constraint` then refers to the translation c, whose free components
/// are unknowns. Components of an obstacle's translation are unknowns only if `freed`, and its angle may be free.
template <int D> struct Support {
  std::string name;
  std::vector<SupportedControlPoints> on;
  std::array<Constraint, D> constraint{};
  std::vector<int> obstacles = {};
  bool rotates = false;
  Vec<D> center = Vec<D>::Zero(); ///< X_c, if it rotates
  Vec<D> axis = Vec<D>::Zero();   ///< unit vector (3D); unused in 2D
  Vec<D> spring = Vec<D>::Zero(); ///< stiffness per reference area, by component
  std::vector<FaceReference> spring_faces = {};
  double shape_error = 0; ///< of the projection of its shape, see face_projection.hpp
  std::array<bool, D> freed{};
  bool free_angle = false;                 ///< of an obstacle that it rotates
  Vec<D> obstacle_spring = Vec<D>::Zero(); ///< stiffness by component, of springs that hold obstacles

  /// True if it rotates by a prescribed angle.
  bool turns() const { return rotates && !free_angle; }
  bool acts_on(int obstacle) const { return std::ranges::find(obstacles, obstacle) != obstacles.end(); }
  /// True if its driven components follow a shape times one factor, in place of a displacement for each component.
  bool shaped() const { return !on.empty() && !on.front().shape.empty(); }
};

/// Dead loads: per reference area or volume, or on edges and corners, of D components, or one value against the outward
/// reference normal; and a pressure against the current normal per current area, which follows the deformation. On
/// obstacles a force, or a moment about the center or axis of the support that rotates it.
enum class LoadKind { traction, pressure, body_force, follower_pressure, point_force, moment };

/// The share of a control point in a force on corners and edges: 1 at a corner, on an edge a length.
struct PointShare {
  int body, function;
  double share;
};

/// An external force on faces, on the volume of bodies, on corners and edges, or on obstacles.
struct Load {
  std::string name;
  std::vector<FaceReference> on;
  LoadKind kind;
  std::vector<double> start;    ///< initial value
  std::vector<int> bodies = {}; ///< of a body force, in place of faces
  /// Values of a function of X at the Gauss points of the faces or bodies, with all components of a point; empty for a
  /// uniform load. `start` is then a factor.
  std::vector<double> values = {};
  std::vector<PointShare> points = {}; ///< of a force on corners and edges
  std::vector<int> obstacles = {};     ///< of a force or moment on obstacles, each of which receives all of it

  bool pressure() const { return kind == LoadKind::pressure || kind == LoadKind::follower_pressure; }
};

template <int D> struct Contact {
  std::string name;
  Faces slave;
  std::variant<Faces, ObstacleReference> master; ///< equal to the slave: a set of faces in contact with each other
  contact::Method method;
  int points; ///< Gauss points per slave element and direction
  contact::Region<D> where = {};
  contact::Start start = {};
  contact::Region<D> bonded = {}; ///< of a cohesive contact
  int other_pass = -1;            ///< of a half pass: index of the contact with slave and master swapped
  bool default_penalty = false;   ///< its penalty is from material and mesh
  bool adaptive_points = false;   ///< see contact::ContactSetting::adaptive
  /// Of a set, pairs of faces that do not touch each other, by place in the list, the lower one first
  std::vector<std::array<int, 2>> apart = {};
  contact::FormulationFactory<D> own = {}; ///< a user-defined formulation, in place of the method
};

/// Two faces that move as one, see contact/tie/tie.hpp.
struct Tie {
  std::string name;
  Faces slave, master;
  contact::MultiplierSpace multipliers;
  bool from_join = false; ///< of the joins, between faces that do not match
};

/// Faces of slave and master.
inline Faces faces_of(const Tie& tie) {
  Faces all = tie.slave;
  all.insert(all.end(), tie.master.begin(), tie.master.end());
  return all;
}

/// Two faces that match point by point and share their unknowns, see nurbs/matching.hpp.
struct Join {
  std::string name;
  FaceReference first, second;
  std::vector<std::array<int, 2>> pairs = {}; ///< functions of the two bodies; found by resolve_joins()
};

template <int D> struct Scene {
  std::vector<NamedBody<D>> bodies;
  std::vector<contact::Obstacle<D>> obstacles = {}; ///< fixed unless a support drives or frees them
  std::vector<Support<D>> supports;
  std::vector<Load> loads = {};
  std::vector<Contact<D>> contacts;
  std::vector<Tie> ties = {};
  std::vector<Join> joins = {};
  solid::Kind kind = solid::Kind::plane_strain; ///< of all bodies
};

/// A part of a scene: its name for users ("body 'slab'", "the kind of scene") and its bytes.
struct ScenePart {
  std::string name, bytes;
};

template <int D> bool is_set(const Contact<D>& contact) {
  const auto* master = std::get_if<Faces>(&contact.master);
  return master && *master == contact.slave;
}

/// True if two faces of bodies touch each other in a contact.
template <int D> bool may_touch(const Contact<D>& contact, const FaceReference& one, const FaceReference& other) {
  const auto* master = std::get_if<Faces>(&contact.master);
  if (!master) return false;
  if (!is_set(contact))
    return (contact.slave.contains(one) && master->contains(other)) ||
           (contact.slave.contains(other) && master->contains(one));
  const auto place = [&](const FaceReference& face) {
    return static_cast<int>(std::ranges::find(contact.slave, face) - contact.slave.begin());
  };
  const int a = place(one), b = place(other), count = static_cast<int>(contact.slave.size());
  return a < count && b < count &&
         std::ranges::find(contact.apart, std::array{std::min(a, b), std::max(a, b)}) == contact.apart.end();
}

/// True for contact at points with an obstacle, whose slave may be any list of faces.
template <int D> bool is_loose(const Contact<D>& contact) {
  return std::holds_alternative<ObstacleReference>(contact.master) && !contact.method.multipliers && !contact.own;
}

/// True if a face of a body acts in a contact, as slave or master.
template <int D> bool acts_on(const Contact<D>& contact, int body) {
  const auto* master = std::get_if<Faces>(&contact.master);
  return contact.slave.on(body) || (master && master->on(body));
}

/// The law of a contact with a penalty, with the constness of its argument; nullptr for adhesion, pressures by formula
/// and user-defined formulations.
template <class AnyContact> auto* penalty_law(AnyContact& contact) {
  auto* law = &contact.method.law;
  return has_penalty(*law) && !contact.own ? law : nullptr;
}

/// Radius of a ball, a cylinder or a torus; 0 if it is hollow, and of other shapes.
template <int D> double full_radius(const contact::Obstacle<D>& obstacle) {
  return std::visit(
      [](const auto& shape) {
        if constexpr (requires { shape.hollow; }) return shape.hollow ? 0 : shape.radius;
        return 0.0;
      },
      obstacle);
}

/// A face and its body, for messages.
template <int D> Message face_message(const Scene<D>& scene, const FaceReference& face) {
  return Message("model.face.of_body", {{"face", nurbs::name_of(face.side)}, {"body", scene.bodies[face.body].name}});
}

/// The faces of a list, for messages.
template <int D> Message faces_message(const Scene<D>& scene, const Faces& faces) {
  if (faces.size() == 1) return face_message(scene, faces.front());
  std::vector<Message> all;
  for (const FaceReference& face : faces) all.push_back(face_message(scene, face));
  return Message("model.face.list", {{"faces", all}});
}

/// A tie, by the key under which the user has given it, for messages.
Message tie_message(const Tie& tie);

/// "x", "y", "z".
inline std::string component_name(int component) {
  return std::string(1, static_cast<char>('x' + component));
}

} // namespace signorini::model
