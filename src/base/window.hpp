#pragma once
// The part of a scene that a picture shows at a larger scale, and how finely what lies in it must be cut to look
// curved.

#include "base/eigen.hpp"

#include <array>
#include <functional>
#include <vector>

namespace signorini {

/// What lies between `low` and `high` on paper, a picture's plane in model units.
struct Window {
  Eigen::Matrix<double, 2, 3> axes; ///< of the paper, to the right and upwards
  Vec<2> low, high;
  double pixel; ///< size of one in model units
};

/// What shows the whole of a box in space, for a picture of at most width × height pixels.
Window box_window(const Eigen::Matrix<double, 2, 3>& axes, const Vec<3>& low, const Vec<3>& high,
                  const std::array<int, 2>& size);

/// Where the mirror of axis = 0 must be looked through to see the same.
Window mirrored(Window window, int axis);

/// A point at fractions 0 … 1 of a surface's two directions; of a curve the second one means nothing.
using PlaceAt = std::function<Vec<3>(double, double)>;

/// Where a surface must be cut besides at its ends, as rising fractions of each direction: what windows show of it then
/// departs from the true surface by a quarter of a pixel at most. Where colors vary over it no piece spans more than
/// 1/16 of a window. What no window shows is cut only where that follows: cuts go through from end to end.
std::array<std::vector<double>, 2> window_cuts(const PlaceAt& place, const std::vector<Window>& windows, bool colored);

/// Adds cuts to rising fractions, each once.
void add_cuts(std::vector<double>& fractions, const std::vector<double>& cuts);

/// 0, 1/pieces … 1.
std::vector<double> even_cuts(int pieces);

} // namespace signorini
