#pragma once
// Exact refinement: knot insertion, degree elevation, k-refinement. Each returns a new patch with the same map.

#include "nurbs/patch.hpp"

#include <optional>

namespace signorini::nurbs {

/// Inserts knots (in any order, repetitions count) in direction d. Throws Error if one lies outside the open interval
/// of the direction, or would have a multiplicity above the degree.
Patch insert_knots(const Patch& patch, int d, std::vector<double> knots);

/// Raises the degree of direction d by `times`; every interior knot's multiplicity grows by `times` (continuity kept).
Patch elevate(const Patch& patch, int d, int times);

/// Grading of elements: a fraction of the elements of a direction lies within a fraction of the knot interval at one
/// end (the knots are the image of uniform ones under a piecewise linear map).
struct Grading {
  double elements; ///< fraction of the elements, in (0, 1)
  double length;   ///< fraction of the knot interval that they occupy, in (0, 1)
  bool at_end;     ///< graded towards the last knot instead of the first
};

/// Knots to insert so that a direction has `elements` spans: the patch's knots stay, new ones are distributed to its
/// spans by length (largest remainder, at least one element per span) and are uniform within each, or the image of
/// uniform ones under the grading. Throws Error if `elements` is less than the number of existing spans.
std::vector<double> element_knots(const KnotVector& knots, int elements, const std::optional<Grading>& grading = {});

/// k-refinement of direction d: elevates to `degree` (≥ the present one), then inserts each of `knots` once.
Patch k_refine(const Patch& patch, int d, int degree, const std::vector<double>& knots);

} // namespace signorini::nurbs
