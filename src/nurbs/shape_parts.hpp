#pragma once
// Checks and maps that shapes have in common.

#include "nurbs/transform.hpp"

namespace signorini::nurbs {

/// Throws Error unless the argument `name` is a positive length.
void check_length(const char* name, double length);
/// Throws Error unless 0 < inner < outer.
void check_radii(double inner, double outer);
/// Throws Error unless the argument `name` is a positive length that does not vanish by rounding when it is added to
/// the coordinate `from`.
void check_edge(const char* name, double length, const char* from, double start);
/// Throws Error unless `center` has `dimension` coordinates, and if a radius vanishes by rounding when added to one.
void check_radius(const char* name, double radius, const Point& center, int dimension);

/// A plane patch in the x-z plane, (x, y) ↦ (x, 0, y), moved by `shift`.
Patch upright(const Patch& patch, const Point& shift);

} // namespace signorini::nurbs
