#pragma once
// Discretization labels: the short names N2, N2.1, L2, N2-N4, N2-N2.2x2 that researchers give function spaces.

#include <optional>
#include <string>
#include <vector>

namespace signorini::nurbs {

/// The space Np.s along a contact face: k-refined to degree p (C^{p−1}), then elevated s times (degree p+s, still
/// C^{p−1}).
struct Space {
  int degree;
  int elevations = 0;
  /// Polynomial degree in the end, p+s.
  int full_degree() const { return degree + elevations; }
  bool operator==(const Space&) const = default;
};

/// What a label says about one parametric direction along the contact face.
struct Label {
  std::string text;
  bool lagrange = false;      ///< Lp: C⁰ elements that interpolate the geometry
  Space bulk{};               ///< all rows, or all but the layer's
  std::optional<Space> layer; ///< the rows next to each contact face, when they differ
  int rows = 1;               ///< depth of the layer in rows of control points
};

/// The bulk of several directions: the space of the highest degree.
Space bulk_space(const std::vector<Label>& labels);

/// Reads a label (grammar: `Np`, `Np.s`, `Lp`, `Nb-Nc`, `Nb-Nc.s`, each layer with an optional `xr`).
/// Throws Error that shows the grammar.
Label parse_label(const std::string& text);

} // namespace signorini::nurbs
