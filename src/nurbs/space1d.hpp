#pragma once
// The function space of one parametric direction as a table: what rows, faces, projection, pictures and files read.

#include "base/eigen.hpp"
#include "base/index.hpp"
#include "nurbs/knots.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace signorini::nurbs {

/// What lives on one element: N_a(ξ) = Σ_k extraction(a, k) B_k(t), t = (ξ − start)/(end − start), with the Bernstein
/// polynomials B_k of `degree`, so that the element's Bézier points are Q_k = Σ_a extraction(a, k) P_a.
struct Element1D {
  int degree;
  std::vector<int> functions; ///< numbers a, rising
  MatrixX extraction;         ///< functions × (degree+1)
};

/// Piecewise polynomials that sum to 1, numbered from 0 along the direction. Elements may differ in degree and in
/// number of functions, breakpoints in smoothness: B-splines, Lagrange elements, joins of several degrees, spaces that
/// are refined in places. A value: checked when made, never changed.
class Space1D {
public:
  using Extraction = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

  /// `breaks`: elements+1 parameters; `smoothness`: k where all functions are C^k at a breakpoint, −1 at both ends.
  /// `knots` where these are their B-splines: then basis_derivatives() takes the stable recursion, and refinement can
  /// go on. Throws Error when the parts do not fit together.
  Space1D(std::vector<double> breaks, std::vector<int> smoothness, const std::vector<Element1D>& elements,
          std::optional<KnotVector> knots = {});

  int elements() const { return static_cast<int>(tables_.size()); }
  int functions() const { return functions_; }
  const std::vector<double>& breaks() const { return breaks_; }
  double first() const { return breaks_.front(); }
  double last() const { return breaks_.back(); }
  std::array<double, 2> interval(int element) const { return {breaks_[at(element)], breaks_[at(element) + 1]}; }
  /// Per breakpoint: C^k there; −1 at both ends.
  const std::vector<int>& smoothness() const { return smoothness_; }

  /// Highest degree of all elements.
  int degree() const { return degree_; }
  int degree(int element) const { return tables_[at(element)].degree; }
  /// Numbers of the functions that do not vanish on an element.
  std::span<const int> functions_on(int element) const {
    const Table& table = tables_[at(element)];
    return {numbers_.data() + table.numbers, table.count};
  }
  /// functions_on(element) × (degree(element)+1), see Element1D.
  Extraction extraction(int element) const {
    const Table& table = tables_[at(element)];
    return {extraction_.data() + table.extraction, static_cast<Eigen::Index>(table.count), table.degree + 1};
  }
  Element1D element(int e) const;
  /// The element that holds xi; the last one at the right end. Throws Error when xi is outside [first, last] or NaN.
  int find_element(double xi) const { return nurbs::find_element(breaks_, xi); }

  const std::optional<KnotVector>& knots() const { return knots_; }
  bool operator==(const Space1D&) const = default;

private:
  /// Where an element's parts begin.
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

/// Parameters that tell a space's continuous functions apart: degree+1 at equal distances per element, ends shared.
std::vector<double> sites(const Space1D& space);

/// The B-splines of a knot vector; Lagrange elements where interior knots are repeated degree times.
Space1D spline_space(const KnotVector& knots);

} // namespace signorini::nurbs
