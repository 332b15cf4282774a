#pragma once
// The joins of a scene: faces that match share unknowns, others are tied.

#include "base/groups.hpp"
#include "model/scene/scene.hpp"

namespace signorini::model {

/// Finds the pairs of control points of joins whose faces match, and turns all other joins into ties, with the face
/// with more elements as slave. Throws Error if a face is joined with itself, if matching faces overlap, or if others
/// cross a layer.
template <int D> void resolve_joins(Scene<D>& scene);

/// Warns of joined faces that are apart or overlap.
template <int D> void warn_of_joins(const Scene<D>& scene, std::vector<Message>& warnings);

/// Bodies that joins connect; `tied`: also those that are tied otherwise.
template <int D> Groups connected_bodies(const Scene<D>& scene, bool tied);

/// In what two faces of a scene differ that do not match.
template <int D> Message difference(const Scene<D>& scene, const FaceReference& first, const FaceReference& second);

} // namespace signorini::model
