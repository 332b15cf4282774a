#include "solid/projection.hpp"

#include "base/dense.hpp"

#include <algorithm>

namespace signorini::solid {

namespace {

/// The lowest degree of the elements per direction: constraints must be few for the poorest of them.
std::vector<int> lowest_degrees(const nurbs::Discretization& space) {
  std::vector<int> lowest(space.parametric_dimension(), space.degree(0, 0));
  for (int d = 0; d < space.parametric_dimension(); ++d) {
    lowest[d] = space.degree(0, d);
    for (int e = 1; e < space.elements(); ++e) lowest[d] = std::min(lowest[d], space.degree(e, d));
  }
  return lowest;
}

/// Number of macro-elements along a direction.
int macro_count(int elements, int degree) {
  const int count = std::max(1, elements / degree);
  if (count % 2 == 1 || elements % 2 == 0) return count;
  return count == 2 ? 3 : count - 1;
}

/// The macro-element of the i-th of n elements, of count along this direction: boundary k is that of elements nearest
/// to k n/count, and that of count − k its mirror image.
int macro_along(int i, int n, int count) {
  if (2 * i + 1 > n) return count - 1 - macro_along(n - 1 - i, n, count);
  return ((2 * i + 1) * count - 1) / (2 * n); // the largest k with k n/count < i + 1/2
}

/// P_0 … P_degree at x.
std::vector<double> legendre(int degree, double x) {
  std::vector<double> values{1};
  if (degree > 0) values.push_back(x);
  for (int k = 2; k <= degree; ++k) values.push_back(((2 * k - 1) * x * values[k - 1] - (k - 1) * values[k - 2]) / k);
  return values;
}

/// Products of Legendre polynomials up to its degrees at a parametric point, on the macro-element's box.
VectorX legendre_products(const MacroElement& macro, const VectorX& xi) {
  VectorX products = VectorX::Ones(1);
  for (int d = 0; d < std::ssize(macro.degrees); ++d) {
    const double from = macro.box(0, d), to = macro.box(1, d);
    const std::vector<double> values = legendre(macro.degrees[d], (2 * xi(d) - from - to) / (to - from));
    VectorX next(products.size() * static_cast<Eigen::Index>(values.size()));
    for (std::size_t k = 0; k < values.size(); ++k)
      next.segment(static_cast<Eigen::Index>(k) * products.size(), products.size()) = values[k] * products;
    products = std::move(next);
  }
  return products;
}

/// Macro-elements without functions and modes.
MacroElements divided(const nurbs::Discretization& space) {
  const int dimensions = space.parametric_dimension();
  MacroElements result;
  const std::vector<int> lowest = lowest_degrees(space);
  int size = 1;
  for (int d = 0; d < dimensions; ++d) {
    result.counts.push_back(macro_count(space.elements(d), lowest[d]));
    size *= result.counts.back();
  }
  result.list.resize(size);
  for (int e = 0; e < space.elements(); ++e) {
    MacroElement& macro = result.list[result.containing(space, e)];
    if (macro.elements.empty()) macro.box = MatrixX::Constant(2, dimensions, space.interval(e, 0)[0]);
    for (int d = 0; d < dimensions; ++d) {
      const auto [from, to] = space.interval(e, d);
      macro.box(0, d) = macro.elements.empty() ? from : std::min(macro.box(0, d), from);
      macro.box(1, d) = macro.elements.empty() ? to : std::max(macro.box(1, d), to);
    }
    macro.elements.push_back(e);
  }
  int index = 0;
  for (MacroElement& macro : result.list) {
    for (int d = 0, along = index; d < dimensions; along /= result.counts[d++]) {
      const int own = along % result.counts[d], n = space.elements(d);
      int elements = 0;
      for (int i = 0; i < n; ++i) elements += macro_along(i, n, result.counts[d]) == own;
      const int degree = lowest[d] - 1;
      macro.degrees.push_back(result.counts[d] == 1 ? degree : std::min(elements - 1, degree));
    }
    ++index;
  }
  return result;
}

/// Adds the functions, and the modes at the Gauss points.
template <int D> void complete(MacroElement& macro, const nurbs::Discretization& space, const GaussTables<D>& tables) {
  std::vector<double> weights;
  for (int e : macro.elements) {
    const auto functions = tables.functions_of(e);
    macro.functions.insert(macro.functions.end(), functions.begin(), functions.end());
    weights.insert(weights.end(), tables.weights_of(e), tables.weights_of(e) + tables.element(e).points);
  }
  std::sort(macro.functions.begin(), macro.functions.end());
  macro.functions.erase(std::unique(macro.functions.begin(), macro.functions.end()), macro.functions.end());
  macro.weights = Eigen::Map<const VectorX>(weights.data(), std::ssize(weights));
  int modes = 1;
  for (int degree : macro.degrees) modes *= degree + 1;
  MatrixX polynomials(std::ssize(weights), modes);
  Eigen::Index row = 0;
  for (int e : macro.elements) {
    std::vector<int>& places = macro.places.emplace_back();
    for (int function : tables.functions_of(e))
      places.push_back(static_cast<int>(std::lower_bound(macro.functions.begin(), macro.functions.end(), function) -
                                        macro.functions.begin()));
    const ElementQuadrature rule = element_quadrature(space, e);
    for (Eigen::Index q = 0; q < rule.points.cols(); ++q)
      polynomials.row(row++) = legendre_products(macro, rule.points.col(q));
  }
  // Φ = Π L⁻ᵀ with L Lᵀ = Πᵀ W Π
  const MatrixX gram = polynomials.transpose() * macro.weights.asDiagonal() * polynomials;
  macro.combine = dense::solve(dense::cholesky(gram).transpose(), MatrixX::Identity(gram.rows(), gram.cols()));
  macro.modes = polynomials * macro.combine;
}

} // namespace

VectorX MacroElement::modes_at(const VectorX& xi) const {
  return combine.transpose() * legendre_products(*this, xi);
}

int MacroElements::containing(const nurbs::Discretization& space, int e) const {
  int index = 0, stride = 1;
  for (int d = 0; d < space.parametric_dimension(); ++d) {
    index += stride * macro_along(space.element_index(e, d), space.elements(d), counts[d]);
    stride *= counts[d];
  }
  return index;
}

int MacroElements::most_functions() const {
  std::size_t most = 0;
  for (const MacroElement& macro : list) most = std::max(most, macro.functions.size());
  return static_cast<int>(most);
}

std::size_t MacroElements::memory() const {
  std::size_t numbers = 0, indices = 0;
  for (const MacroElement& macro : list) {
    numbers +=
        static_cast<std::size_t>(macro.modes.size() + macro.weights.size() + macro.combine.size() + macro.box.size());
    indices += macro.elements.size() + macro.functions.size() + macro.degrees.size();
    for (const auto& places : macro.places) indices += places.size();
  }
  return sizeof(double) * numbers + sizeof(int) * indices;
}

template <int D> MacroElements macro_elements(const nurbs::Discretization& space, const GaussTables<D>& tables) {
  MacroElements result = divided(space);
  for (MacroElement& macro : result.list) complete(macro, space, tables);
  return result;
}

template MacroElements macro_elements(const nurbs::Discretization&, const GaussTables<2>&);
template MacroElements macro_elements(const nurbs::Discretization&, const GaussTables<3>&);

} // namespace signorini::solid
