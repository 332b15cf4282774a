#pragma once
// Faces of several bodies that lie on each other.

#include "model/scene.hpp"

namespace signorini::model {

/// Two faces; `body` counts the bodies of the list.
using FacePair = std::array<FaceReference, 2>;

/// Pairs of faces of different bodies that match, or that coincide at least in part and face each other. They are
/// sorted by the first face.
template <int D>
std::vector<FacePair> coincident_faces(const std::vector<std::shared_ptr<const solid::Body<D>>>& bodies);

/// Whether the rows of a layer have different functions on a side, so that it is not a single NURBS and cannot be tied.
bool crosses_layer(const nurbs::Discretization& space, nurbs::Side side);

} // namespace signorini::model
