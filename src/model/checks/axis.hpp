#pragma once
// Prescribed motions that axisymmetric scenes cannot follow: off the axis x = 0, or of a rigid ring that would widen.

#include "model/system/system.hpp"

namespace signorini::model {

/// The radial displacements on the axis of an axisymmetric scene, which vanish, by degree of freedom.
template <int D> std::vector<char> radial_on_axis(const System<D>& system);

/// What is wrong with values of a drive's components in an axisymmetric scene: they move points of a body off the axis,
/// or an obstacle across it. An empty message if nothing is.
template <int D> Message off_axis(const System<D>& system, int drive, const std::vector<double>& values);

} // namespace signorini::model
