#pragma once
// The function space of one parametric direction as a table, as used by rows, faces, projection, pictures and files.

#include "base/eigen.hpp"
#include "nurbs/knots.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace signorini::nurbs {

/// The functions on one element: N_a(ξ) = Σ_k extraction(a, k) B_k(t), t = (ξ − start)/(end − start), with the
/// Bernstein polynomials B_k of `degree`; the element's Bézier points are Q_k = Σ_a extraction(a, k) P_a.
struct Element1D {
  int degree;
  std::vector<int> functions; ///< indices a, increasing
  MatrixX extraction;         ///< functions × (degree+1)
};

/// Piecewise polynomials that sum to 1, numbered from 0 along the direction. Elements may differ in degree and number
/// of functions, breakpoints in continuity: B-splines, Lagrange elements, joins of several degrees, locally refined
/// spaces. An immutable value, checked by its constructor.
class Space1D {
public:
  using Extraction = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

  /// `breaks`: elements+1 parameters; `smoothness`: k where all functions are C^k at a breakpoint, −1 at both ends.
  /// `knots`, if the functions are their B-splines: basis_derivatives() then uses the stable recursion, and the space
  /// can be refined. Throws Error if the parts are inconsistent.
  Space1D(std::vector<double> breaks, std::vector<int> smoothness, const std::vector<Element1D>& elements,
          std::optional<KnotVector> knots = {});

  int elements() const { return std::ssize(tables_); }
  int functions() const { return functions_; }
  const std::vector<double>& breaks() const { return breaks_; }
  double first() const { return breaks_.front(); }
  double last() const { return breaks_.back(); }
  std::array<double, 2> interval(int element) const { return {breaks_[element], breaks_[element + 1]}; }
  /// C^k per breakpoint; −1 at both ends.
  const std::vector<int>& smoothness() const { return smoothness_; }

  /// Highest degree of all elements.
  int degree() const { return degree_; }
  int degree(int element) const { return tables_[element].degree; }
  /// Indices of the functions that do not vanish on an element.
  std::span<const int> functions_on(int element) const {
    const Table& table = tables_[element];
    return {numbers_.data() + table.numbers, table.count};
  }
  /// Matrix functions_on(element) × (degree(element)+1), see Element1D.
  Extraction extraction(int element) const {
    const Table& table = tables_[element];
    return {extraction_.data() + table.extraction, static_cast<Eigen::Index>(table.count), table.degree + 1};
  }
  Element1D element(int e) const;
  /// The element that contains xi; the last one at the right end. Throws Error if xi is outside [first, last] or NaN.
  int find_element(double xi) const { return nurbs::find_element(breaks_, xi); }

  const std::optional<KnotVector>& knots() const { return knots_; }
  bool operator==(const Space1D&) const = default;

private:
  /// Offsets of an element's data.
  struct Table {
    int degree;
    std::size_t count, numbers, extraction;
    bool operator==(const Table&) const = default;
  };

  std::vector<double> breaks_;
  std::vector<int> smoothness_;
  std::optional<KnotVector> knots_;
  std::vector<Table> tables_;
  std::vector<int> numbers_;
  std::vector<double> extraction_;
  int functions_ = 0, degree_ = 0;
};

/// Parameters at which values determine a continuous function: degree+1 equidistant ones per element, ends shared.
std::vector<double> sites(const Space1D& space);

/// The B-splines of a knot vector; Lagrange elements if interior knots are repeated degree times.
Space1D spline_space(const KnotVector& knots);

} // namespace signorini::nurbs
