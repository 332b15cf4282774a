#pragma once
// Faces of several bodies that lie on each other.

#include "model/scene/scene.hpp"

namespace signorini::model {

/// Two faces; `body` counts the bodies of the list.
using FacePair = std::array<FaceReference, 2>;

/// Pairs of faces of different bodies that match, then pairs of other faces that coincide at least in part: up to the
/// distance that a tie accepts, most_seam_distance, and without another face of the list between them.
template <int D>
std::vector<FacePair> coincident_faces(const std::vector<std::shared_ptr<const solid::Body<D>>>& bodies);

/// The smallest distance between faces of two lists of bodies, and the two faces; of faces that cross a layer that of
/// control points.
template <int D> struct FaceGap {
  FacePair faces;
  double distance;
};
template <int D>
FaceGap<D> smallest_gap(const std::vector<std::shared_ptr<const solid::Body<D>>>& first,
                        const std::vector<std::shared_ptr<const solid::Body<D>>>& second);

} // namespace signorini::model
