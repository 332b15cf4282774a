#pragma once
// Faces that match point by point, so that their patches can be joined without gap or overlap.

#include "nurbs/constants.hpp"
#include "nurbs/discretization.hpp"

#include <array>
#include <vector>

namespace signorini::nurbs {

/// What keeps two faces from matching: the first property, in this order, in which they differ.
enum class Mismatch { none, corners, elements, borders, functions, points };

struct FaceMatch {
  Mismatch mismatch = Mismatch::corners;
  /// If they match: functions of the first face, each with the function of the second one that is equal to it.
  std::vector<std::array<int, 2>> pairs = {};
  /// If they match: whether their outward normals are opposite, so that the patches do not overlap.
  bool facing = false;
  /// Mismatch::corners: the largest distance of corners in the orientation that brings them closest.
  double apart = 0;
};

/// Compares two faces in each of their relative orientations (2 for curves, 8 for surfaces). They match if they have
/// the same elements, with parameters that differ by a constant factor, and on each of them the same rational functions
/// and control points; weights may differ by a common factor. Faces that cross a layer are compared element by element,
/// like others. Points coincide within a tolerance relative to the first face's size.
FaceMatch match_faces(const Discretization& first, Side first_side, const Discretization& second, Side second_side,
                      double tolerance = joinable);

} // namespace signorini::nurbs
