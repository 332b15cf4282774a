#include "model/thickness.hpp"

namespace signorini::model {

double thickness(const nurbs::Discretisation& space, nurbs::Side side) {
  const int dimension = space.parametric_dimension(), d = side.direction, last = space.elements(d) - 1;
  const MatrixX points = space.points();
  int stride = 1;
  for (int k = 0; k < d; ++k) stride *= space.elements(k);
  /// The point of element e in the middle of its face.
  const auto position = [&](int e, bool at_end) {
    VectorX xi(dimension);
    for (int k = 0; k < dimension; ++k) {
      const auto [from, to] = space.interval(e, k);
      xi(k) = k == d ? (at_end ? to : from) : 0.5 * (from + to);
    }
    const nurbs::ElementBasis basis = space.basis(e, xi);
    VectorX x = VectorX::Zero(points.rows());
    for (std::size_t a = 0; a < basis.functions.size(); ++a)
      x += basis.values(static_cast<Eigen::Index>(a)) * points.col(basis.functions[a]);
    return x;
  };
  double sum = 0;
  int count = 0;
  for (int e = 0; e < space.elements(); ++e)
    if (e / stride % space.elements(d) == 0) {
      sum += (position(e + last * stride, true) - position(e, false)).norm();
      ++count;
    }
  return sum / count;
}

} // namespace signorini::model
