#pragma once
// Largest pressures at sharp edges, where that of an elastic body has no limit as elements get smaller.

#include "model/steps/model.hpp"

namespace signorini::model {

/// True if the largest pressure of a contact is within an element of an open end of either face, which the contact
/// reaches, or at a kink of the master. An end whose control points cannot move along the face is no edge, as at a
/// plane of symmetry, nor is the axis of an axisymmetric model.
template <int D> bool is_peak_at_edge(const Model<D>& model, int contact);

} // namespace signorini::model
