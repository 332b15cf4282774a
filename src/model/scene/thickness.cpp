#include "model/scene/thickness.hpp"

namespace signorini::model {

double thickness(const nurbs::Discretization& space, nurbs::Side side) {
  const MatrixX points = space.points();
  /// The middle of the border of element f of a face.
  const auto position = [&](nurbs::Side face, int f) {
    const int e = space.element_behind(face, f);
    VectorX xi(space.parametric_dimension());
    for (int d = 0; d < xi.size(); ++d) {
      const auto [from, to] = space.interval(e, d);
      xi(d) = d == face.direction ? (face.at_end ? to : from) : 0.5 * (from + to);
    }
    return space.basis(e, xi).combine(points);
  };
  double sum = 0;
  const int count = space.elements_on(side);
  for (int f = 0; f < count; ++f)
    sum += (position({side.direction, true}, f) - position({side.direction, false}, f)).norm();
  return sum / count;
}

} // namespace signorini::model
