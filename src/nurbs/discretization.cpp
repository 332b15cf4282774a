#include "nurbs/discretization.hpp"

#include "base/error.hpp"
#include "nurbs/basis.hpp"
#include "nurbs/constants.hpp"

#include <algorithm>

namespace signorini::nurbs {

namespace {

/// Throws Error unless the space is interpolatory: only the first function is nonzero at the start, only the last at
/// the end.
void check_ends(const Space1D& space) {
  const int last = space.elements() - 1;
  const VectorX start = space.extraction(0).col(0), end = space.extraction(last).rightCols(1);
  const auto others = [](const VectorX& column, Eigen::Index own) {
    return (column - VectorX::Unit(column.size(), own)).norm();
  };
  require(space.functions_on(0).front() == 0 && others(start, 0) <= rounding &&
              space.functions_on(last).back() == space.functions() - 1 && others(end, end.size() - 1) <= rounding,
          "nurbs.space.ends");
}

/// The common elements of the parts. Throws Error if these are inconsistent.
ElementGrid grid_of(int through, const Space1D& stack, const std::vector<Row>& rows) {
  require(static_cast<int>(rows.size()) == stack.functions(), "nurbs.body.rows",
          {{"expected", stack.functions()}, {"count", rows.size()}});
  const Row& first = rows.front();
  require(first.parametric_dimension() + 1 == first.dimension() && through >= 0 && through < first.dimension(),
          "nurbs.body.row_dimension");
  check_ends(stack);
  for (const Row& row : rows) {
    bool fits = row.dimension() == first.dimension() && row.parametric_dimension() == first.parametric_dimension();
    for (int a = 0; fits && a < row.parametric_dimension(); ++a) {
      fits = row.direction(a).breaks() == first.direction(a).breaks();
      check_ends(row.direction(a));
    }
    require(fits, "nurbs.body.row_elements");
  }
  std::vector<std::vector<double>> breaks;
  for (const Space1D& space : first.directions()) breaks.push_back(space.breaks());
  breaks.insert(breaks.begin() + through, stack.breaks());
  return ElementGrid(std::move(breaks));
}

} // namespace

VectorX ElementBasis::combine(const MatrixX& at_points) const {
  VectorX sum = VectorX::Zero(at_points.rows());
  for (std::size_t a = 0; a < functions.size(); ++a)
    sum += values(static_cast<Eigen::Index>(a)) * at_points.col(functions[a]);
  return sum;
}

Discretization::Discretization(int through, Space1D stack, std::vector<Row> rows, std::vector<Side> contact)
    : ElementGrid(grid_of(through, stack, rows)), through_(through), stack_(std::move(stack)), rows_(std::move(rows)),
      contact_(std::move(contact)) {
  int count = 0; // functions are numbered row by row
  for (const Row& row : rows_) {
    first_.push_back(count);
    count += row.functions();
  }
  homogeneous_.resize(rows_.front().dimension() + 1, count);
  for (std::size_t j = 0; j < rows_.size(); ++j)
    homogeneous_.middleCols(first_[j], rows_[j].functions()) = rows_[j].homogeneous();
}

MatrixX Discretization::points() const {
  return homogeneous_.topRows(dimension()).array().rowwise() / homogeneous_.bottomRows(1).row(0).array();
}

int Discretization::degree(int e, int d) const {
  if (d == through_) return stack_.degree(element_index(e, d));
  int highest = 0;
  for (int j : stack_.functions_on(element_index(e, through_)))
    highest = std::max(highest, rows_[j].direction(in_row(d)).degree(element_index(e, d)));
  return highest;
}

ElementFunctions Discretization::row_functions(int e, int j) const {
  const Row& row = rows_[j];
  ElementFunctions functions;
  functions.first = first_[j];
  for (int d = 0; d < parametric_dimension(); ++d) {
    if (d == through_) continue;
    functions.along[d] = row.direction(in_row(d)).functions_on(element_index(e, d));
    functions.stride[d] = row.stride(in_row(d));
  }
  return functions;
}

ElementBasis Discretization::basis(int e, const VectorX& xi) const {
  ElementBasis result;
  const int dimensions = parametric_dimension();
  const int layer = element_index(e, through_);
  const std::span<const int> layer_rows = stack_.functions_on(layer);
  double through[2 * (max_degree + 1)];
  basis_derivatives(stack_, layer, xi(through_), 1, through);
  // Factors of a product: first in the thickness direction, then along the row.
  const std::size_t t = through_, u = t == 0 ? 1 : 0, v = t == 2 ? 1 : 2;

  std::array<ElementFunctions, max_degree + 1> rows;
  int size = 0;
  for (std::size_t k = 0; k < layer_rows.size(); ++k) {
    rows[k] = row_functions(e, layer_rows[k]);
    size += rows[k].count(0) * rows[k].count(1) * rows[k].count(2);
  }
  result.functions.resize(size);
  result.values.resize(size);      // w_A N_A(ξ), later R_A(ξ)
  MatrixX rates(size, dimensions); // ∂(w_A N_A)/∂ξ^d
  result.gradients.resize(dimensions, size);
  int a = 0;
  for (std::size_t k = 0; k < layer_rows.size(); ++k) {
    const Row& row = rows_[layer_rows[k]];
    double n[3][2 * (max_degree + 1)] = {{1}, {1}, {1}}; // values along each direction, then derivatives
    for (int d = 0; d < dimensions; ++d)
      if (d != through_) basis_derivatives(row.direction(in_row(d)), element_index(e, d), xi(d), 1, n[d]);
    n[t][0] = through[k];
    n[t][1] = through[layer_rows.size() + k];
    rows[k].each([&](int function, const std::array<int, 3>& i) {
      const double w = homogeneous_(dimensions, function);
      result.functions[a] = function;
      result.values(a) = w * n[t][i[t]] * n[u][i[u]] * n[v][i[v]];
      for (int d = 0; d < dimensions; ++d) {
        std::array<int, 3> rate = i;
        rate[d] += rows[k].count(d);
        rates(a, d) = w * n[t][rate[t]] * n[u][rate[u]] * n[v][rate[v]];
      }
      ++a;
    });
  }

  // R_A = w_A N_A / W,  ∂R_A = (∂(w_A N_A) − R_A ∂W) / W [theory 4.1]
  const double weight = result.values.sum();
  result.values /= weight;
  for (int d = 0; d < dimensions; ++d)
    result.gradients.row(d) = (rates.col(d) - result.values * rates.col(d).sum()).transpose() / weight;
  return result;
}

std::vector<int> row_end(const Discretization& space, int j, int a, bool at_end) {
  const Row& row = space.rows()[j];
  const int n0 = row.direction(0).functions(), end = at_end ? row.direction(a).functions() - 1 : 0;
  std::vector<int> result;
  for (int i = 0; i < row.functions(); ++i)
    if ((a == 0 ? i % n0 : i / n0) == end) result.push_back(space.first_function(j) + i);
  return result;
}

std::vector<int> Discretization::face_functions(Side side) const {
  std::vector<int> result;
  if (side.direction == through_) {
    const int row = side.at_end ? stack_.functions() - 1 : 0;
    for (int i = 0; i < rows_[row].functions(); ++i) result.push_back(first_[row] + i);
    return result;
  }
  // A side along the thickness direction intersects every row at one end of the row's direction a.
  std::vector<std::vector<int>> cuts;
  for (std::size_t j = 0; j < rows_.size(); ++j)
    cuts.push_back(row_end(*this, static_cast<int>(j), in_row(side.direction), side.at_end));
  // Parametric order: the lower of the two remaining directions runs fastest.
  const bool through_first = parametric_dimension() == 3 && through_ < 3 - through_ - side.direction;
  const bool tensor = std::all_of(cuts.begin(), cuts.end(), [&](auto& cut) { return cut.size() == cuts[0].size(); });
  if (through_first && tensor) {
    for (std::size_t i = 0; i < cuts[0].size(); ++i)
      for (const auto& cut : cuts) result.push_back(cut[i]);
  } else {
    for (const auto& cut : cuts) result.insert(result.end(), cut.begin(), cut.end());
  }
  return result;
}

bool crosses_layer(const Discretization& space, Side side) {
  if (space.parametric_dimension() == 2 || side.direction == space.through()) return false;
  const int along = 1 - space.in_row(side.direction); // of a row, on the side
  const std::vector<Row>& rows = space.rows();
  return std::any_of(rows.begin(), rows.end(),
                     [&](const Row& row) { return row.direction(along) != rows.front().direction(along); });
}

Row Discretization::face(Side side) const {
  if (side.direction == through_) return rows_[side.at_end ? stack_.functions() - 1 : 0];
  if (crosses_layer(*this, side))
    fail("nurbs.body.face_across_layer", {{"face", name_of(side)}, {"contact", name_of(contact_.front())}});
  const std::vector<int> functions = face_functions(side);
  std::vector<Space1D> directions;
  for (int d = 0; d < parametric_dimension(); ++d)
    if (d != side.direction) directions.push_back(d == through_ ? stack_ : rows_.front().direction(in_row(d)));
  return {std::move(directions), homogeneous_(Eigen::all, functions)};
}

} // namespace signorini::nurbs
