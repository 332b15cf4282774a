#include "nurbs/basis_grid.hpp"

#include "nurbs/basis.hpp"

#include <algorithm>

namespace signorini::nurbs {

BasisGrid::BasisGrid(const Discretization& space)
    : space_(space), stack_direction_(space_number(space.through(), space.stack())) {
  for (const Row& row : space_.rows()) {
    std::array<int, 3>& numbers = row_directions_.emplace_back(std::array<int, 3>{});
    for (int d = 0; d < space_.parametric_dimension(); ++d)
      if (d != space_.through()) numbers[d] = space_number(d, row.direction(space_.in_row(d)));
  }
}

int BasisGrid::space_number(int direction, const Space1D& space) {
  const auto same = std::find_if(directions_.begin(), directions_.end(), [&](const Direction& known) {
    return known.direction == direction && *known.space == space;
  });
  const auto number = static_cast<int>(same - directions_.begin());
  if (same == directions_.end()) directions_.push_back({direction, &space, std::vector<Table>(space.elements())});
  return number;
}

const double* BasisGrid::table(int number, int element, const std::vector<double>& points) {
  Direction& direction = directions_[number];
  Table& table = direction.tables[element];
  if (table.points != std::ssize(points)) {
    const std::size_t size = 2 * direction.space->functions_on(element).size();
    table.points = std::ssize(points);
    table.values.resize(size * points.size());
    for (std::size_t q = 0; q < points.size(); ++q)
      basis_derivatives(*direction.space, element, points[q], 1, table.values.data() + size * q);
  }
  return table.values.data();
}

void BasisGrid::choose(int e, const std::vector<std::vector<double>>& points) {
  const int dimensions = space_.parametric_dimension(), through = space_.through();
  const int layer = space_.element_index(e, through);
  through_ = table(stack_direction_, layer, points[through]);
  functions_.clear();
  weights_.clear();
  parts_.clear();
  for (const int j : space_.stack().functions_on(layer)) {
    const ElementFunctions functions = space_.row_functions(e, j);
    functions.each([&](int function, const std::array<int, 3>&) {
      functions_.push_back(function);
      weights_.push_back(space_.homogeneous()(dimensions, function));
    });
    RowPart& part = parts_.emplace_back(RowPart{{1, 1, 1}, {}});
    for (int d = 0; d < dimensions; ++d) {
      if (d == through) continue;
      part.count[d] = functions.count(d);
      part.values[d] = table(row_directions_[j][d], space_.element_index(e, d), points[d]);
    }
  }
}

void BasisGrid::evaluate(const std::array<int, 3>& point, ElementBasis& result) {
  const int dimensions = space_.parametric_dimension();
  const std::size_t t = space_.through(), u = t == 0 ? 1 : 0, v = t == 2 ? 1 : 2;
  const std::size_t size = functions_.size(), layer_rows = parts_.size();
  result.functions = functions_;
  result.values.resize(static_cast<Eigen::Index>(size)); // w_A N_A(ξ), later R_A(ξ)
  result.gradients.resize(dimensions, static_cast<Eigen::Index>(size));
  rates_.resize(dimensions * size);

  static constexpr double one[2] = {1, 0};
  const double* through = through_ + 2 * layer_rows * point[t];
  std::size_t a = 0;
  for (std::size_t k = 0; k < layer_rows; ++k) {
    const RowPart& part = parts_[k];
    const double value = through[k], slope = through[layer_rows + k]; // in the thickness direction
    const auto at_point = [&](std::size_t d) {
      return part.values[d] ? part.values[d] + 2 * part.count[d] * point[d] : one;
    };
    const double *nu = at_point(u), *nv = at_point(v);
    const int count_u = part.count[u], count_v = part.count[v];
    // The lower of both directions runs fastest.
    for (int j = 0; j < count_v; ++j)
      for (int i = 0; i < count_u; ++i, ++a) {
        const double w = weights_[a];
        result.values(static_cast<Eigen::Index>(a)) = w * value * nu[i] * nv[j];
        rates_[t * size + a] = w * slope * nu[i] * nv[j];
        rates_[u * size + a] = w * value * nu[count_u + i] * nv[j];
        if (dimensions == 3) rates_[v * size + a] = w * value * nu[i] * nv[count_v + j];
      }
  }

  // R_A = w_A N_A / W,  ∂R_A = (∂(w_A N_A) − R_A ∂W) / W
  const double weight = result.values.sum();
  result.values /= weight;
  for (int d = 0; d < dimensions; ++d) {
    const Eigen::Map<const VectorX> rates(rates_.data() + d * size, static_cast<Eigen::Index>(size));
    result.gradients.row(d) = (rates - result.values * rates.sum()).transpose() / weight;
  }
}

} // namespace signorini::nurbs
