#pragma once
// The part of a scene that a picture magnifies, and how finely its surfaces must be divided to look smooth.

#include "base/eigen.hpp"

#include <array>
#include <functional>
#include <vector>

namespace signorini {

/// A rectangle from `low` to `high` in the plane of a picture, in model units.
struct Window {
  Eigen::Matrix<double, 2, 3> axes; ///< of the picture, to the right and upwards
  Vec<2> low, high;
  double pixel; ///< size of a pixel in model units
};

/// The window that shows a whole box in space, for a picture of at most width × height pixels.
Window box_window(const Eigen::Matrix<double, 2, 3>& axes, const Vec<3>& low, const Vec<3>& high,
                  const std::array<int, 2>& size);

/// The window that shows the same after reflection in axis = 0.
Window mirrored(Window window, int axis);

/// A point at fractions 0 … 1 of a surface's two directions; the second is ignored for curves.
using PointAt = std::function<Vec<3>(double, double)>;

/// Inner division points of a surface, as increasing fractions of each direction, such that what the windows show of it
/// deviates from the exact surface by at most a quarter of a pixel. If colors vary over it, no piece spans more than
/// 1/16 of a window. Divisions run through the whole surface, so parts outside the windows are divided only by those.
std::array<std::vector<double>, 2> window_divisions(const PointAt& place, const std::vector<Window>& windows,
                                                    bool colored);

/// Adds division points to increasing fractions, without duplicates.
void add_divisions(std::vector<double>& fractions, const std::vector<double>& cuts);

/// 0, 1/pieces … 1.
std::vector<double> even_cuts(int pieces);

} // namespace signorini
