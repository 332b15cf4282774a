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
/// Likewise where faces cross a layer and cannot be tied: their difference is a strain of this size in one element.
inline constexpr double joinable_layers = 1e-3;
/// A Jacobian below this fraction of the product of its columns' lengths counts as zero (folded flat).
inline constexpr double folded_flat = 1e-13;
/// A Jacobian is negative below this fraction of the largest Bernstein coefficient of its numerator on a span: at poles
/// and collapsed corners, where it is zero, coordinates with six digits leave both signs.
inline constexpr double folded_digits = 1e-6;
/// Boxes of a span that are examined for a negative Jacobian: a zero at a corner takes 20 halvings per direction.
inline constexpr int most_boxes = 4096;
/// Bernstein coefficients of a patch that are examined: a second's work.
inline constexpr double examined_coefficients = 1e6;

} // namespace signorini::nurbs
