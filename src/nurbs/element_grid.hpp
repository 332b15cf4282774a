#pragma once
// A grid of elements: the boxes between the breakpoints of all parametric directions.

#include "nurbs/patch.hpp"

#include <array>
#include <vector>

namespace signorini::nurbs {

/// Elements are numbered with ξ¹ fastest.
class ElementGrid {
public:
  /// `breaks`: increasing, per direction.
  explicit ElementGrid(std::vector<std::vector<double>> breaks) : breaks_(std::move(breaks)) {}

  int parametric_dimension() const { return std::ssize(breaks_); }
  int elements(int d) const { return static_cast<int>(std::ssize(breaks_[d])) - 1; }
  int elements() const;
  /// Index of element e in direction d.
  int element_index(int e, int d) const;
  /// True if element e has a face on a side.
  bool touches(int e, Side side) const {
    return element_index(e, side.direction) == (side.at_end ? elements(side.direction) - 1 : 0);
  }
  /// Number of elements at a side, and the f-th of them, the side's lower direction counting fastest.
  int elements_on(Side side) const { return elements() / elements(side.direction); }
  int element_behind(Side side, int f) const;
  /// Parameter interval of element e in direction d.
  std::array<double, 2> interval(int e, int d) const {
    const int i = element_index(e, d);
    return {breaks_[d][i], breaks_[d][i + 1]};
  }
  /// Parameters of the point of element e at these fractions (0 … 1 per direction).
  VectorX parameter(int e, const VectorX& fractions) const;
  /// The element that contains xi. Throws Error if xi is outside the grid.
  int find_element(const VectorX& xi) const;

private:
  std::vector<std::vector<double>> breaks_;
};

} // namespace signorini::nurbs
