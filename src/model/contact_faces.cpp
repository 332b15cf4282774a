#include "model/contact_faces.hpp"

#include "nurbs/coincident.hpp"

namespace signorini::model {

template <int D> int first_control_point(const Scene<D>& scene, int body) {
  int first = 0;
  for (int b = 0; b < body; ++b) first += scene.bodies[at(b)].body->functions();
  return first;
}

template <int D> Groups coincident_points(const Scene<D>& scene) {
  const auto count = static_cast<int>(scene.bodies.size());
  Groups groups(first_control_point(scene, count));
  for (int b = 0, first = 0; b < count; first += scene.bodies[at(b)].body->functions(), ++b)
    for (const std::vector<int>& group : nurbs::coincident_functions(scene.bodies[at(b)].body->space()))
      for (int function : group) groups.unite(first + group.front(), first + function);
  for (const Join& join : scene.joins) {
    const int first = first_control_point(scene, join.first.body),
              second = first_control_point(scene, join.second.body);
    for (const auto& [a, b] : join.pairs) groups.unite(first + a, second + b);
  }
  return groups;
}

namespace {

template <int D> contact::FaceGrid grid_of(const Scene<D>& scene, const Faces& faces, const Message& list) {
  const Groups shared = coincident_points(scene);
  std::vector<contact::FacePart> parts;
  for (const FaceReference& face : faces) {
    const nurbs::Discretization& space = scene.bodies[at(face.body)].body->space();
    const int first = first_control_point(scene, face.body);
    std::vector<int> nodes = space.face_functions(face.side);
    for (int& node : nodes) node = shared.leader(first + node);
    parts.push_back(
        {space.face(face.side), std::move(nodes), nurbs::outward_sign(face.side), face_message(scene, face)});
  }
  return contact::arrange(parts, list);
}

} // namespace

template <int D> contact::Surface<D> surface_of(const Scene<D>& scene, const Faces& faces, const Message& list) {
  if (faces.size() > 1) return contact::Surface<D>(grid_of(scene, faces, list));
  const FaceReference& face = faces.front();
  return {scene.bodies[at(face.body)].body->space(), face.side, first_control_point(scene, face.body)};
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template int first_control_point(const Scene<D>&, int);                                                              \
  template Groups coincident_points(const Scene<D>&);                                                                  \
  template contact::Surface<D> surface_of(const Scene<D>&, const Faces&, const Message&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
