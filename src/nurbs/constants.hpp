#pragma once
// Tolerances of geometry. All are relative to the size named with each.

namespace signorini::nurbs {

/// Rounding error of a few operations on values of size 1: parameters relative to their range, functions at its ends,
/// multiples of a quarter turn, coordinates of a flat patch relative to the largest one.
inline constexpr double rounding = 1e-12;
/// A parameter outside its range by less than this is probably a computed one: the message states the distance.
inline constexpr double just_outside = 1e-6;
/// Control points of a body coincide, and weights are equal, within this fraction of its size: more than the errors of
/// refinement and rotation, far less than any element.
inline constexpr double same_place = 1e-10;
/// Control points that users computed on two curves coincide within this fraction of the patch's size; also the
/// tolerance for integer shares of elements.
inline constexpr double computed = 1e-9;
/// Control points of two patches that are joined coincide within this fraction of the face's size: files of other
/// programs often have six or seven digits.
inline constexpr double joinable = 1e-6;
/// A Jacobian below this fraction of the product of its columns' lengths counts as zero (folded flat).
inline constexpr double folded_flat = 1e-13;

} // namespace signorini::nurbs
