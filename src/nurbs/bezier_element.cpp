#include "nurbs/bezier_element.hpp"

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

BezierElement bezier_element(const Discretization& space, int e) {
  const int dimensions = space.parametric_dimension(), through = space.through();
  BezierElement result;
  std::array<int, 3> index{}, count{1, 1, 1};
  for (int d = 0; d < dimensions; ++d) {
    index[d] = space.element_index(e, d);
    result.degrees.push_back(space.degree(e, d));
    count[d] = result.degrees.back() + 1;
  }

  const int layer = index[through];
  const std::span<const int> rows = space.stack().functions_on(layer);
  std::vector<VectorX> columns; // of the transposed extraction, one per function
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const int j = rows[k];
    // Bézier coefficients of the functions per direction; a row has one function in the thickness direction.
    std::array<MatrixX, 3> coefficients;
    for (MatrixX& one : coefficients) one.setConstant(1, 1, 1.0);
    for (int d = 0; d < dimensions; ++d) {
      if (d == through) {
        coefficients[d] = space.stack().extraction(layer).row(static_cast<Eigen::Index>(k));
        continue;
      }
      const Space1D& along = space.rows()[j].direction(space.in_row(d));
      coefficients[d] =
          along.extraction(index[d]).lazyProduct(bernstein_elevation(along.degree(index[d]), result.degrees[d]));
    }
    space.row_functions(e, j).each([&](int function, const std::array<int, 3>& i) {
      result.functions.push_back(function);
      const auto& c = coefficients;
      VectorX column(count[0] * count[1] * count[2]);
      for (int z = 0, point = 0; z < count[2]; ++z)
        for (int y = 0; y < count[1]; ++y)
          for (int x = 0; x < count[0]; ++x) column(point++) = c[0](i[0], x) * c[1](i[1], y) * c[2](i[2], z);
      columns.push_back(std::move(column));
    });
  }
  result.extraction.resize(static_cast<Eigen::Index>(columns.size()), columns.front().size());
  for (std::size_t a = 0; a < columns.size(); ++a) result.extraction.row(static_cast<Eigen::Index>(a)) = columns[a];
  return result;
}

} // namespace signorini::nurbs
