#pragma once
// The functions of a discretization at tensor-product points of its elements, such as Gauss points.

#include "nurbs/discretization.hpp"

#include <array>
#include <vector>

namespace signorini::nurbs {

/// Evaluates what Discretization::basis() returns, bit by bit, at a grid of points of one element after the other.
/// Functions of one direction are evaluated once per element of that direction, not once per point: points of an
/// element must depend only on its interval and their number.
class BasisGrid {
public:
  explicit BasisGrid(const Discretization& space);

  /// Chooses element e, with these parameters of points per direction of the body.
  void choose(int e, const std::vector<std::vector<double>>& points);
  /// The functions at the point with these indices per direction.
  void evaluate(const std::array<int, 3>& point, ElementBasis& result);

private:
  /// Per point the values of the functions on one element of a direction, then their derivatives.
  struct Table {
    int points = 0;
    std::vector<double> values;
  };
  /// A function space of a direction of the body, and its tables per element.
  struct Direction {
    int direction;
    const Space1D* space;
    std::vector<Table> tables;
  };
  /// A row on the chosen element: the numbers of functions, and the tables, per direction of the body.
  struct RowPart {
    std::array<int, 3> count;
    std::array<const double*, 3> values;
  };

  int space_number(int direction, const Space1D& space);
  const double* table(int number, int element, const std::vector<double>& points);

  const Discretization& space_;
  std::vector<Direction> directions_;              ///< different ones only
  std::vector<std::array<int, 3>> row_directions_; ///< per row: numbers of its spaces in directions_
  int stack_direction_;
  std::vector<int> functions_;  ///< on the chosen element
  std::vector<double> weights_; ///< w_A
  std::vector<RowPart> parts_;
  const double* through_ = nullptr;
  std::vector<double> rates_; ///< ∂(w_A N_A)/∂ξ^d, one direction after the other
};

} // namespace signorini::nurbs
