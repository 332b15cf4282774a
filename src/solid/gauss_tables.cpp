#include "solid/gauss_tables.hpp"

#include "base/error.hpp"
#include "nurbs/basis_grid.hpp"
#include "nurbs/constants.hpp"
#include "os/interrupt.hpp"
#include "solid/projected.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::solid {

namespace {

QuadratureRule element_rule(const nurbs::Discretization& space, int e, int d, int times = 1) {
  const auto [a, b] = space.interval(e, d);
  return gauss_legendre(times * (space.degree(e, d) + 1), a, b);
}

void require_radius(double least, const Vec<2>& point) {
  require(point(0) > least, "solid.body.beyond_axis", {{"point", point}});
}

/// Throws Error if the map is degenerate within rounding error (folded flat) or left-handed.
template <int D> void check_jacobian(const Mat<D>& jacobian, double determinant, const Vec<D>& place) {
  require(std::abs(determinant) > nurbs::folded_flat * jacobian.colwise().norm().prod(),
          D == 2 ? "solid.body.no_area" : "solid.body.no_volume", {{"jacobian", determinant}, {"place", place}});
  require(determinant > 0, "solid.body.left_handed", {{"jacobian", determinant}, {"place", place}});
}

/// Throws Error if a corner of an element is beyond the axis; Gauss points are checked as they are created.
void check_radii(const nurbs::Discretization& space) {
  const MatrixX points = space.points();
  const double tolerance = nurbs::rounding * points.cwiseAbs().maxCoeff();
  VectorX xi(2);
  for (int e = 0; e < space.elements(); ++e)
    for (int corner = 0; corner < 4; ++corner) {
      xi << space.interval(e, 0)[corner % 2], space.interval(e, 1)[corner / 2];
      require_radius(-tolerance, space.basis(e, xi).combine(points));
    }
}

} // namespace

ElementQuadrature element_quadrature(const nurbs::Discretization& space, int e, int times) {
  std::vector<QuadratureRule> rules;
  for (int d = 0; d < space.parametric_dimension(); ++d) rules.push_back(element_rule(space, e, d, times));
  return tensor_product(rules);
}

/// What the tables are built from, one element after the other.
template <int D> struct GaussTables<D>::Construction {
  const nurbs::Discretization& space;
  const Material& material;
  Kind kind;
  Volumetric volumetric;
  const MatrixX points = space.points();
  nurbs::BasisGrid grid = nurbs::BasisGrid(space);
  std::array<std::vector<QuadratureRule>, D> rules = {}; ///< by interval of each direction, of the last element there
  nurbs::ElementBasis basis = {};
  std::vector<std::vector<double>> places = std::vector<std::vector<double>>(D); ///< of an element's points
};

template <int D>
GaussTables<D>::GaussTables(const nurbs::Discretization& space, const Material& material, Kind kind,
                            Volumetric volumetric) {
  require(space.dimension() == D, "solid.body.dimension", {{"expected", D}, {"dimension", space.dimension()}});
  require(D == 2 || kind == Kind::plane_strain, "solid.body.axisymmetric", {{"dimension", D}});
  require(kind != Kind::plane_stress || volumetric == Volumetric::pointwise, "solid.body.projected_plane_stress");
  if (kind == Kind::axisymmetric) check_radii(space);
  volumes_ = VectorX::Zero(space.functions());
  Construction construction{space, material, kind, volumetric};
  for (int d = 0; d < D; ++d) construction.rules[d].resize(space.elements(d));
  for (int e = 0; e < space.elements(); ++e) {
    require(!interrupted(), "solid.body.interrupted");
    add_element(e, construction);
    if (e > 0) continue;
    // Most bodies have the same number of values in every element.
    for (auto* table : {&weights_, &gradients_, &hoops_, &constants_})
      table->reserve(table->size() * space.elements() + vector_padding);
    functions_.reserve(functions_.size() * space.elements());
  }
  // Kernels read whole vectors.
  gradients_.resize(gradients_.size() + vector_padding);
  constants_.resize(constants_.size() + vector_padding);
  add_constants(material);
  for (auto* table : {&weights_, &gradients_, &hoops_, &constants_}) table->shrink_to_fit();
}

template <int D> std::size_t GaussTables<D>::memory() const {
  return sizeof(double) * (weights_.size() + gradients_.size() + hoops_.size() + constants_.size()) +
         sizeof(double) * volumes_.size() + sizeof(int) * functions_.size() + sizeof(ElementTable) * elements_.size();
}

template <int D> KernelArguments GaussTables<D>::arguments(int e, const Material& material) const {
  const ElementTable& table = element(e);
  const ElasticConstants& constants = material.constants();
  KernelArguments arguments{table.functions, table.points, constants.lambda, constants.mu};
  arguments.gradients = gradients_of(e);
  arguments.weights = weights_of(e);
  arguments.hoop = hoops_of(e);
  arguments.constant = constants_.data() + table.constant;
  arguments.law = material.law();
  arguments.respond = table.kernels.respond;
  arguments.small_strains = material.small_strains();
  return arguments;
}

template <int D> void GaussTables<D>::add_element(int e, Construction& construction) {
  const nurbs::Discretization& space = construction.space;
  const MatrixX& points = construction.points;
  nurbs::ElementBasis& basis = construction.basis;
  std::array<const double*, D> weights;
  std::array<int, D> counts;
  int count = 1;
  for (int d = 0; d < D; ++d) {
    QuadratureRule& rule = construction.rules[d][space.element_index(e, d)];
    if (std::ssize(rule.points) != space.degree(e, d) + 1) rule = element_rule(space, e, d);
    construction.places[d] = rule.points;
    weights[d] = rule.weights.data();
    counts[d] = std::ssize(rule.points);
    count *= counts[d];
  }
  construction.grid.choose(e, construction.places);
  ElementTable table{0, count, functions_.size(), weights_.size(), gradients_.size(), constants_.size(), {}};
  for (int q = 0; q < table.points; ++q) {
    std::array<int, 3> point{};
    double weight = 1;
    for (int d = 0, rest = q; d < D; ++d) {
      point[d] = rest % counts[d];
      weight *= weights[d][point[d]];
      rest /= counts[d];
    }
    construction.grid.evaluate(point, basis);
    if (q == 0) {
      table.functions = std::ssize(basis.functions);
      functions_.insert(functions_.end(), basis.functions.begin(), basis.functions.end());
      table.kernels = construction.volumetric == Volumetric::projected
                          ? projected_kernels<D>()
                          : construction.material.template kernels<D>(construction.kind, table.functions);
    }
    // ∂X/∂ξ = Σ_A X_A ⊗ ∂R_A/∂ξ,  ∂R/∂X = ∂R/∂ξ (∂X/∂ξ)⁻¹
    Vec<D> place = Vec<D>::Zero();
    Mat<D> jacobian = Mat<D>::Zero();
    for (int a = 0; a < table.functions; ++a) {
      const auto point = points.template block<D, 1>(0, basis.functions[a]);
      place += basis.values(a) * point;
      jacobian += point * basis.gradients.template block<D, 1>(0, a).transpose();
    }
    const double determinant = jacobian.determinant();
    check_jacobian(jacobian, determinant, place);
    weight *= determinant;
    const Mat<D> inverse = jacobian.inverse();
    const std::size_t first = gradients_.size();
    gradients_.resize(first + D * table.functions);
    for (int a = 0; a < table.functions; ++a) {
      const Vec<D> gradient = inverse.transpose() * basis.gradients.template block<D, 1>(0, a);
      for (int k = 0; k < D; ++k) gradients_[first + k * table.functions + a] = gradient(k);
    }
    if (construction.kind == Kind::axisymmetric) {
      require_radius(0, place.template head<2>());
      weight *= 2 * std::numbers::pi * place(0);
      for (int a = 0; a < table.functions; ++a) hoops_.push_back(basis.values(a) / place(0));
    }
    weights_.push_back(weight);
    for (int a = 0; a < table.functions; ++a) volumes_(basis.functions[a]) += weight * basis.values(a);
  }
  constants_.resize(constants_.size() + table.kernels.constant_blocks * table.functions * table.functions);
  most_functions_ = std::max(most_functions_, table.functions);
  most_points_ = std::max(most_points_, table.points);
  elements_.push_back(table);
}

/// Computes the constant parts of the elements' tangents; their table is already allocated.
template <int D> void GaussTables<D>::add_constants(const Material& material) {
  const std::vector<double> rest(D * most_functions_, 0.0);
  std::vector<double> force(rest.size());
  for (int e = 0; e < elements(); ++e) {
    const ElementTable& table = element(e);
    if (!table.kernels.constant) continue;
    KernelArguments given = arguments(e, material);
    given.local = rest.data();
    given.force = force.data();
    given.blocks = constants_.data() + table.constant;
    table.kernels.constant(given);
  }
}

template class GaussTables<2>;
template class GaussTables<3>;

} // namespace signorini::solid
