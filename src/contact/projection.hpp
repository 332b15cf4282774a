#pragma once
// Closest-point projection of a slave point onto a master curve: the global minimum of the distance.

#include "contact/surface.hpp"

#include <vector>

namespace signorini::contact {

/// What kind of point of the master is the closest.
enum class Foot {
  none,    ///< an open end of the master: no contact there (its normal would be arbitrary)
  regular, ///< the connecting line is normal to the master
  corner   ///< a kink between two elements (C⁰ knot): the normal is the connecting line itself
};

template <int D> struct Projection {
  Foot foot = Foot::none;
  int element = -1; ///< of the master; −1 before the first projection
  FaceCoordinates<D> xi = FaceCoordinates<D>::Zero();
  /// Normal gap (xˢ − x̄ᵐ)·n̄, negative when penetrating.
  double gap = 0;
};

/// Bounding boxes of a face's elements, for a lower bound of the distance to each.
template <int D> class ElementBoxes {
public:
  void update(const Surface<D>& surface);
  /// Square of a lower bound of the distance from x to the element.
  double distance2(int element, const Vec<D>& x) const {
    const Vec<D> outside = (lower_.col(element) - x).cwiseMax(x - upper_.col(element)).cwiseMax(0.0);
    return outside.squaredNorm();
  }
  double diagonal2(int element) const { return (upper_.col(element) - lower_.col(element)).squaredNorm(); }

private:
  Eigen::Matrix<double, D, Eigen::Dynamic> lower_, upper_;
};

/// The closest point of `surface` to x. Starts from the element and parameter of `seed` (when it has any), follows the
/// curve across element borders, then looks into every element whose box is nearer than what was found. `point` holds
/// the face's geometry at the closest point, order 2; its functions are left alone.
///
/// Rules where the connecting line is not normal to the curve: an open end of the master is no contact (Foot::none); at
/// a kink the vertex itself is the master point, with gap −distance when x lies on the inside (Foot::corner).
Projection<2> project(const Surface<2>& surface, const ElementBoxes<2>& boxes, const Vec<2>& x,
                      const Projection<2>& seed, FacePoint<2>& point);

} // namespace signorini::contact
