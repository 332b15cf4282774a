#pragma once
// The faces of a contact as one surface, and the numbering of control points that it uses.

#include "base/groups.hpp"
#include "model/scene/scene.hpp"

namespace signorini::model {

/// Number of a body's first control point, counted through all bodies.
template <int D> int first_control_point(const Scene<D>& scene, int body);

/// Control points of the scene, counted through all bodies, that share unknowns: those that coincide within a body, and
/// those of joined faces.
template <int D> Groups coincident_points(const Scene<D>& scene);

/// The surface of one face or of several with common borders, with control points counted through all bodies. Throws
/// Error, with `list` as the name of the list, if the faces do not form one surface.
template <int D> contact::Surface<D> surface_of(const Scene<D>& scene, const Faces& faces, const Message& list = {});
/// A set of faces as the sheets of one surface.
template <int D> contact::Surface<D> set_of(const Scene<D>& scene, const Faces& faces);
/// The slave face of a contact; of a set, and of a loose list of faces that are not one surface, a set.
template <int D> contact::Surface<D> slave_of(const Scene<D>& scene, const Contact<D>& contact);

} // namespace signorini::model
