#pragma once
// Faces of several bodies that lie on each other.

#include "model/scene.hpp"

namespace signorini::model {

/// Two faces; `body` counts the bodies of the list.
using FacePair = std::array<FaceReference, 2>;

/// Pairs of faces of different bodies that match, then pairs of other faces that coincide at least in part.
template <int D>
std::vector<FacePair> coincident_faces(const std::vector<std::shared_ptr<const solid::Body<D>>>& bodies);

} // namespace signorini::model
