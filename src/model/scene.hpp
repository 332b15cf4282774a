#pragma once
// What a model is made of: named bodies, supports and contacts, as plain values.

#include "contact/penalty.hpp"
#include "solid/body.hpp"

#include <array>
#include <memory>
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

/// What a support does to one displacement component of its control points.
enum class Hold { free, fixed, driven };

/// Control points of one body that a support holds.
struct Held {
  int body;
  std::vector<int> functions;
};

template <int D> struct Support {
  std::string name;
  std::vector<Held> on;
  std::array<Hold, D> hold{};
};

struct Contact {
  std::string name;
  FaceReference slave, master;
  contact::PenaltyLaw law;
  int points; ///< Gauss points per slave element and direction
};

template <int D> struct Scene {
  std::vector<NamedBody<D>> bodies;
  std::vector<Support<D>> supports;
  std::vector<Contact> contacts;
};

/// "x", "y", "z".
std::string component_name(int component);

} // namespace signorini::model
