#pragma once
// Exact refinement: knot insertion, degree elevation, k-refinement. Each returns a new patch of the same map.

#include "nurbs/patch.hpp"

#include <optional>

namespace signorini::nurbs {

/// Inserts knots (any order, repetitions count) in direction d. Throws Error when one lies outside the open interval of
/// the direction, or would be repeated more than degree times.
Patch insert_knots(const Patch& patch, int d, std::vector<double> knots);

/// Raises the degree of direction d by `times`; every interior knot's multiplicity grows by `times` (continuity kept).
Patch elevate(const Patch& patch, int d, int times);

/// Where elements crowd: a share of the elements of a direction lies within a share of the knot length at one end
/// (the knots are the image of uniform ones under a piecewise linear map).
struct Grading {
  double elements; ///< share of the elements, in (0, 1)
  double length;   ///< share of the knot interval they fill, in (0, 1)
  bool at_end;     ///< crowd at the last knot instead of the first
};

/// Knots to insert so that a direction has `elements` spans: the patch's own knots stay, the new ones are shared out to
/// its spans by length (largest remainder, at least one span each) and are uniform within each, or the image of uniform
/// ones under the grading. Throws Error when `elements` is below the spans that exist.
std::vector<double> element_knots(const KnotVector& knots, int elements, const std::optional<Grading>& grading = {});

/// k-refinement of direction d: elevate to `degree` first (≥ the present one), then insert each of `knots` once.
Patch k_refine(const Patch& patch, int d, int degree, const std::vector<double>& knots);

} // namespace signorini::nurbs
