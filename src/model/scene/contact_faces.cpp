#include "model/scene/contact_faces.hpp"

#include "base/error.hpp"
#include "nurbs/coincident.hpp"

namespace signorini::model {

template <int D> int first_control_point(const Scene<D>& scene, int body) {
  int first = 0;
  for (int b = 0; b < body; ++b) first += scene.bodies[b].body->functions();
  return first;
}

namespace {

/// Unites the control points of a body that coincide.
template <int D> void unite_coincident(const Scene<D>& scene, int body, Groups& groups) {
  const int first = first_control_point(scene, body);
  for (const std::vector<int>& group : nurbs::coincident_functions(scene.bodies[body].body->space()))
    for (int function : group) groups.unite(first + group.front(), first + function);
}

} // namespace

template <int D> Groups coincident_points(const Scene<D>& scene) {
  const int count = std::ssize(scene.bodies);
  Groups groups(first_control_point(scene, count));
  for (int b = 0; b < count; ++b) unite_coincident(scene, b, groups);
  for (const Join& join : scene.joins) {
    const int first = first_control_point(scene, join.first.body),
              second = first_control_point(scene, join.second.body);
    for (const auto& [a, b] : join.pairs) groups.unite(first + a, second + b);
  }
  return groups;
}

namespace {

/// Numbers of a face's control points, equal for those that share unknowns.
template <int D>
std::vector<int> shared_numbers(const Scene<D>& scene, const FaceReference& face, const Groups& groups) {
  const int first = first_control_point(scene, face.body);
  std::vector<int> nodes = scene.bodies[face.body].body->space().face_functions(face.side);
  for (int& node : nodes) node = groups.leader(first + node);
  return nodes;
}

} // namespace

template <int D> contact::Surface<D> surface_of(const Scene<D>& scene, const Faces& faces, const Message& list) {
  const auto space = [&](const FaceReference& face) -> const nurbs::Discretization& {
    return scene.bodies[face.body].body->space();
  };
  if (const FaceReference& face = faces.front(); faces.size() == 1) {
    // Points of one face coincide only at seams and poles of its own body.
    Groups groups(first_control_point(scene, face.body + 1));
    unite_coincident(scene, face.body, groups);
    return {space(face), face.side, first_control_point(scene, face.body), shared_numbers(scene, face, groups)};
  }
  const Groups groups = coincident_points(scene);
  std::vector<contact::FacePart> parts;
  for (const FaceReference& face : faces)
    parts.push_back({space(face).face(face.side), shared_numbers(scene, face, groups), nurbs::outward_sign(face.side),
                     face_message(scene, face)});
  return contact::Surface<D>(contact::arrange(parts, list));
}

template <int D> contact::Surface<D> set_of(const Scene<D>& scene, const Faces& faces) {
  const Groups groups = coincident_points(scene);
  std::vector<contact::Surface<D>> sheets;
  for (const FaceReference& face : faces)
    sheets.emplace_back(scene.bodies[face.body].body->space(), face.side, first_control_point(scene, face.body),
                        shared_numbers(scene, face, groups));
  return contact::Surface<D>(sheets);
}

template <int D> contact::Surface<D> slave_of(const Scene<D>& scene, const Contact<D>& contact) {
  if (is_set(contact)) return set_of(scene, contact.slave);
  try {
    return surface_of(scene, contact.slave);
  } catch (const Error&) {
    if (!is_loose(contact)) throw;
    return set_of(scene, contact.slave);
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template int first_control_point(const Scene<D>&, int);                                                              \
  template Groups coincident_points(const Scene<D>&);                                                                  \
  template contact::Surface<D> surface_of(const Scene<D>&, const Faces&, const Message&);                              \
  template contact::Surface<D> set_of(const Scene<D>&, const Faces&);                                                  \
  template contact::Surface<D> slave_of(const Scene<D>&, const Contact<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
