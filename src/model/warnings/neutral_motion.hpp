#pragma once
// Rigid motions that contacts do not resist.

#include "model/steps/model.hpp"

namespace signorini::model {

/// True if a direction, by unknown, of negative `stiffness` is a rigid motion of a body that contacts alone hold, and
/// its stiffness an effect of the discretization. The forces F of the contacts change the stiffness of a body of extent
/// L by F/L; where the contact is one element wide or narrower, contact points that pass through it do so by as much.
/// Therefore it is one below constants.hpp's part of F/L, and where round faces (arcs, spheres, cylinders along the
/// axis of rotation) turn about their center, or roll on planes and flat faces. Bodies that joins or ties connect move
/// as one.
template <int D> bool is_neutral(Model<D>& model, const VectorX& direction, double stiffness);

} // namespace signorini::model
