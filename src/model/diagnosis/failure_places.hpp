#pragma once
// Places in a model that a diagnosis names.

#include "model/diagnosis/diagnosis.hpp"

#include <functional>

namespace signorini::model {

/// The control points with the largest shares of a vector of unknowns, at most three, and these shares. Where an
/// obstacle's motion or a multiplier has nearly all of it, what is left are rounding errors.
/// `what`: the message about a share.
template <int D>
std::vector<FailurePlace> largest_shares(const Model<D>& model, const VectorX& values,
                                         const std::function<Message(double)>& what);

template <int D>
FailurePlace contact_point(const Model<D>& model, std::size_t contact, std::size_t i, double gap, Message what);

/// The inverted Gauss point of an element.
template <int D> FailurePlace inverted_element(const Model<D>& model);

/// Message about the obstacle that a direction, by degree of freedom, moves; empty if there is none.
template <int D> Message obstacle_part(const Model<D>& model, const VectorX& all);

/// Message about the body or obstacle that a direction, by unknown, moves as a rigid body; empty if there is none.
template <int D> Message rigid_part(const Model<D>& model, const VectorX& direction);

} // namespace signorini::model
