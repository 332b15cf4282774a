#pragma once
// What geometry counts as equal. All are relative, to the size named with each.

namespace signorini::nurbs {

/// What comes out of a few operations on values of size 1: parameters of a direction's range, functions at its ends,
/// whole quarters of a turn, coordinates of a flat patch by the largest one.
inline constexpr double rounding = 1e-12;
/// A parameter that is outside its range by less is probably a computed one: the message says by how much.
inline constexpr double just_outside = 1e-6;
/// Control points of one body are one place, and weights one weight, to this part of its size: after refinement and
/// rotation, far below any element.
inline constexpr double same_place = 1e-10;
/// Control points that users computed on two curves meet to this part of the patch's size; shares of elements are
/// whole numbers.
inline constexpr double computed = 1e-9;
/// A Jacobian below this part of the product of its columns' lengths is folded flat: what rounding leaves of zero.
inline constexpr double folded_flat = 1e-13;

} // namespace signorini::nurbs
