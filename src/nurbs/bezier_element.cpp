#include "nurbs/bezier_element.hpp"

#include "nurbs/bezier.hpp"

namespace signorini::nurbs {

MatrixX bernstein_elevation(int from, int to) {
  MatrixX result = MatrixX::Identity(from + 1, from + 1);
  for (int p = from; p < to; ++p) {
    // B^p_k = (1 − k/(p+1)) B^{p+1}_k + (k+1)/(p+1) B^{p+1}_{k+1}
    MatrixX step = MatrixX::Zero(p + 1, p + 2);
    for (int k = 0; k <= p; ++k) {
      step(k, k) = (p + 1.0 - k) / (p + 1);
      step(k, k + 1) = (k + 1.0) / (p + 1);
    }
    result = result.lazyProduct(step).eval();
  }
  return result;
}

BezierElement bezier_element(const Discretisation& space, int e) {
  const int dimensions = space.parametric_dimension(), through = space.through();
  BezierElement result;
  std::array<int, 3> index{}, count{1, 1, 1};
  for (int d = 0, rest = e; d < dimensions; ++d) {
    const auto i = static_cast<std::size_t>(d);
    index[i] = rest % space.elements(d);
    rest /= space.elements(d);
    result.degrees.push_back(space.degree(e, d));
    count[i] = result.degrees.back() + 1;
  }

  const KnotVector& stack = space.through_knots();
  const int layer = index[static_cast<std::size_t>(through)];
  const MatrixX stacked = bezier_extraction(stack, layer);
  std::vector<VectorX> columns; // of the transposed extraction, function by function
  for (int k = 0; k <= stack.degree(); ++k) {
    const int j = stack.first_function(layer) + k;
    const Patch& row = space.rows()[static_cast<std::size_t>(j)];
    // Per direction of the patch the functions' Bézier coefficients; through the body there is one function in a row.
    std::array<MatrixX, 3> coefficients;
    for (MatrixX& one : coefficients) one.setConstant(1, 1, 1.0);
    std::array<int, 3> first{}, stride{};
    for (int d = 0, a = 0, size = 1; d < dimensions; ++d) {
      const auto i = static_cast<std::size_t>(d);
      if (d == through) {
        coefficients[i] = stacked.row(k);
        continue;
      }
      const KnotVector& knots = row.direction(a++);
      coefficients[i] =
          bezier_extraction(knots, index[i]).lazyProduct(bernstein_elevation(knots.degree(), result.degrees[i]));
      first[i] = knots.first_function(index[i]);
      stride[i] = size;
      size *= knots.functions();
    }
    const auto& [c0, c1, c2] = coefficients;
    for (int n = 0; n < c2.rows(); ++n)
      for (int m = 0; m < c1.rows(); ++m)
        for (int l = 0; l < c0.rows(); ++l) {
          result.functions.push_back(space.first_function(j) + (first[0] + l) * stride[0] + (first[1] + m) * stride[1] +
                                     (first[2] + n) * stride[2]);
          VectorX column(count[0] * count[1] * count[2]);
          for (int z = 0, point = 0; z < count[2]; ++z)
            for (int y = 0; y < count[1]; ++y)
              for (int x = 0; x < count[0]; ++x) column(point++) = c0(l, x) * c1(m, y) * c2(n, z);
          columns.push_back(std::move(column));
        }
  }
  result.extraction.resize(static_cast<Eigen::Index>(columns.size()), columns.front().size());
  for (std::size_t a = 0; a < columns.size(); ++a) result.extraction.row(static_cast<Eigen::Index>(a)) = columns[a];
  return result;
}

} // namespace signorini::nurbs
