#pragma once
// Order labels: the short names N2, N2.1, L2, N2-N4, N2-N2.2x2 of discretizations.

#include <optional>
#include <string>
#include <vector>

namespace signorini::nurbs {

/// The space Np.s along a contact face: k-refined to degree p (C^{p−1}), then elevated s times (degree p+s, still
/// C^{p−1}).
struct Space {
  int degree;
  int elevations = 0;
  /// Polynomial degree after elevation, p+s.
  int full_degree() const { return degree + elevations; }
  bool operator==(const Space&) const = default;
};

/// What a label defines for one parametric direction along the contact face.
struct Label {
  std::string text;
  bool lagrange = false;      ///< Lp: C⁰ elements that interpolate the geometry
  Space bulk{};               ///< all rows, or all but the layer's
  std::optional<Space> layer; ///< the layer rows next to each contact face, if they differ
  int rows = 1;               ///< layer depth in rows of control points
};

/// The bulk space of several directions: that of the highest degree.
Space bulk_space(const std::vector<Label>& labels);

/// Parses a label (grammar: `Np`, `Np.s`, `Lp`, `Nb-Nc`, `Nb-Nc.s`, each layer with an optional `xr`). Throws Error
/// that shows the grammar.
Label parse_label(const std::string& text);

} // namespace signorini::nurbs
