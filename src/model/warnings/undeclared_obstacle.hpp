#pragma once
// Bodies that pass through obstacles where no contact acts, and obstacles that pass between contact points.

#include "model/warnings/undeclared_overlap.hpp"

namespace signorini::model {

/// Appends a warning for each body and obstacle
///  - if a face that is not the slave of a contact with this obstacle lies behind it, deeper than
///    PresentOutlines::allowed() and farther than before the first step. A plane, or the full side of a hollow shape,
///    is infinite, so that a place that has always been behind it belongs to another part of the scene. Behind an open
///    curve or surface are only the places of a face that crosses it, with a regular foot point between its ends;
///  - otherwise if the middle of a ball, cylinder or torus lies inside the body, or any place of an obstacle that does
///    not touch the body: it has passed between contact points.
/// Obstacles without any contact are not part of the mechanics and are not examined.
template <int D>
void warn_of_obstacles(const Model<D>& model, const PresentOutlines<D>& outlines, std::vector<Message>& warnings);

} // namespace signorini::model
