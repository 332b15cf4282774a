#include "model/scene/joins.hpp"

#include "base/error.hpp"
#include "model/scene/coincident_faces.hpp"
#include "nurbs/matching.hpp"

namespace signorini::model {

namespace {

template <int D> const nurbs::Discretization& space_of(const Scene<D>& scene, const FaceReference& face) {
  return scene.bodies[face.body].body->space();
}

template <int D>
nurbs::FaceMatch match(const Scene<D>& scene, const FaceReference& first, const FaceReference& second) {
  const nurbs::Discretization &one = space_of(scene, first), &other = space_of(scene, second);
  nurbs::FaceMatch found = nurbs::match_faces(one, first.side, other, second.side);
  if (found.mismatch != nurbs::Mismatch::none && (crosses_layer(one, first.side) || crosses_layer(other, second.side)))
    if (nurbs::FaceMatch near = nurbs::match_faces(one, first.side, other, second.side, nurbs::joinable_layers);
        near.mismatch == nurbs::Mismatch::none)
      return near;
  return found;
}

Message message_of(const nurbs::FaceMatch& found) {
  switch (found.mismatch) {
  case nurbs::Mismatch::corners:
    return Message("model.join.corners", {{"apart", found.apart}});
  case nurbs::Mismatch::elements:
    return Message("model.join.elements");
  case nurbs::Mismatch::borders:
    return Message("model.join.borders");
  case nurbs::Mismatch::functions:
    return Message("model.join.functions");
  default:
    return Message("model.join.points");
  }
}

} // namespace

template <int D> Message difference(const Scene<D>& scene, const FaceReference& first, const FaceReference& second) {
  return message_of(match<D>(scene, first, second));
}

template <int D> void resolve_joins(Scene<D>& scene) {
  std::vector<Join> matching;
  for (Join& join : scene.joins) {
    require(!(join.first == join.second), "model.join.own_face",
            {{"join", join.name}, {"face", face_message(scene, join.first)}});
    nurbs::FaceMatch found = match(scene, join.first, join.second);
    if (found.mismatch == nurbs::Mismatch::none) {
      require(found.facing, "model.join.facing",
              {{"join", join.name},
               {"first", face_message(scene, join.first)},
               {"second", face_message(scene, join.second)}});
      join.pairs = std::move(found.pairs);
      matching.push_back(std::move(join));
      continue;
    }
    for (const FaceReference& face : {join.first, join.second})
      require(!crosses_layer(space_of(scene, face), face.side), "model.join.layers",
              {{"join", join.name},
               {"first", face_message(scene, join.first)},
               {"second", face_message(scene, join.second)},
               {"why", message_of(found)},
               {"face", face_message(scene, face)}});
    const auto elements = [&](const FaceReference& face) { return space_of(scene, face).elements_on(face.side); };
    const bool finer = elements(join.second) > elements(join.first);
    scene.ties.push_back({join.name, finer ? join.second : join.first, finer ? join.first : join.second,
                          contact::MultiplierSpace::equal, true});
  }
  scene.joins = std::move(matching);
}

template <int D> void warn_of_joins(const Scene<D>& scene, std::vector<Message>& warnings) {
  for (const Join& join : scene.joins) {
    const MatrixX first = space_of(scene, join.first).points(), second = space_of(scene, join.second).points();
    double apart = 0;
    Vec<D> place = Vec<D>::Zero();
    for (const auto& [a, b] : join.pairs)
      if (const double distance = (first.col(a) - second.col(b)).norm(); distance > apart) {
        apart = distance;
        place = first.col(a);
      }
    if (apart > nurbs::joinable * (first.rowwise().maxCoeff() - first.rowwise().minCoeff()).norm())
      warnings.push_back(Message("model.warning.joined_gap", {{"join", join.name},
                                                              {"first", face_message(scene, join.first)},
                                                              {"second", face_message(scene, join.second)},
                                                              {"distance", apart},
                                                              {"at", place}}));
  }
}

template <int D> Groups connected_bodies(const Scene<D>& scene, bool tied) {
  Groups connected(static_cast<int>(scene.bodies.size()));
  for (const Join& join : scene.joins) connected.unite(join.first.body, join.second.body);
  for (const Tie& tie : scene.ties)
    if (tied || tie.from_join)
      for (const FaceReference& face : faces_of(tie)) connected.unite(tie.slave.front().body, face.body);
  return connected;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template void resolve_joins(Scene<D>&);                                                                              \
  template void warn_of_joins(const Scene<D>&, std::vector<Message>&);                                                 \
  template Groups connected_bodies(const Scene<D>&, bool);                                                             \
  template Message difference(const Scene<D>&, const FaceReference&, const FaceReference&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
