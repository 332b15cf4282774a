#pragma once
// The open (clamped) knot vector of one parametric direction together with its degree.

#include <vector>

namespace signorini::nurbs {

/// Highest degree supported; it sizes small buffers on the stack.
inline constexpr int max_degree = 15;

/// The element between two of `breaks` that contains xi; the last one at the right end. Throws Error if xi is outside
/// or NaN.
int find_element(const std::vector<double>& breaks, double xi);

/// An open knot vector of a given degree. An immutable value, checked by its constructor.
///
/// Throws Error unless the knots are finite and sorted, both ends are repeated exactly degree+1 times, and no interior
/// knot is repeated more than degree times (so every function is at least C⁰).
class KnotVector {
public:
  KnotVector(int degree, std::vector<double> knots);

  /// The open knot vector of one element on [0, 1].
  static KnotVector single(int degree);

  int degree() const { return degree_; }
  const std::vector<double>& knots() const { return knots_; }
  /// The elements()+1 distinct knots.
  const std::vector<double>& breaks() const { return breaks_; }
  double first() const { return breaks_.front(); }
  double last() const { return breaks_.back(); }

  /// Number of B-spline functions, knots − degree − 1.
  int functions() const { return std::ssize(knots_) - degree_ - 1; }
  /// Number of non-empty knot spans.
  int elements() const { return std::ssize(breaks_) - 1; }

  /// Index i of the span [knots[i], knots[i+1]) that is element e (from 0). Functions i − degree … i do not vanish on
  /// it.
  int span(int element) const { return spans_[element]; }
  /// First function that does not vanish on element e.
  int first_function(int element) const { return span(element) - degree_; }
  std::vector<int> functions_on(int element) const;
  /// The element that contains xi; the last one at the right end. Throws Error if xi is outside [first, last] or NaN.
  int find_element(double xi) const { return nurbs::find_element(breaks_, xi); }

  /// Multiplicity of `knot` (exact comparison).
  int multiplicity(double knot) const;
  /// Greville abscissae, one per function: (ξ_{i+1} + … + ξ_{i+p})/p; for degree 0 the midpoint of the span.
  std::vector<double> greville() const;

  bool operator==(const KnotVector& other) const { return degree_ == other.degree_ && knots_ == other.knots_; }

private:
  int degree_;
  std::vector<double> knots_, breaks_;
  std::vector<int> spans_;
};

} // namespace signorini::nurbs
