#include "solid/body.hpp"

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

/// What the elements of a body are built from, one after the other.
template <int D> struct Body<D>::Construction {
  const MatrixX points;
  nurbs::BasisGrid grid;
  std::array<std::vector<QuadratureRule>, D> rules; ///< by interval of each direction, of the last element there
  nurbs::ElementBasis basis = {};
  std::vector<std::vector<double>> places = std::vector<std::vector<double>>(D); ///< of an element's points
};

template <int D>
Body<D>::Body(std::shared_ptr<const nurbs::Discretization> space, Material material, Kind kind, Volumetric volumetric)
    : space_(std::move(space)), material_(std::move(material)), kind_(kind), volumetric_(volumetric),
      internal_variables_(static_cast<int>(material_.initial_values().size())) {
  require(space_->dimension() == D, "solid.body.dimension", {{"expected", D}, {"dimension", space_->dimension()}});
  require(D == 2 || kind_ == Kind::plane_strain, "solid.body.axisymmetric", {{"dimension", D}});
  require(kind_ != Kind::plane_stress || volumetric_ == Volumetric::pointwise, "solid.body.projected_plane_stress");
  if (kind_ == Kind::axisymmetric) check_radii(*space_);
  volumes_ = VectorX::Zero(functions());
  Construction construction{space_->points(), nurbs::BasisGrid(*space_), {}};
  for (int d = 0; d < D; ++d) construction.rules[d].resize(space_->elements(d));
  for (int e = 0; e < space_->elements(); ++e) {
    require(!interrupted(), "solid.body.interrupted");
    add_element(e, construction);
    if (e > 0) continue;
    // Most bodies have the same number of values in every element.
    for (auto* table : {&weights_, &gradients_, &hoops_, &constants_})
      table->reserve(table->size() * space_->elements() + vector_padding);
    functions_.reserve(functions_.size() * space_->elements());
  }
  // Kernels read whole vectors.
  gradients_.resize(gradients_.size() + vector_padding);
  constants_.resize(constants_.size() + vector_padding);
  add_constants();
  for (auto* table : {&weights_, &gradients_, &hoops_, &constants_}) table->shrink_to_fit();
  if (volumetric_ == Volumetric::projected) add_macro_elements();
}

template <int D> void Body<D>::add_macro_elements() {
  macros_ = solid::macro_elements(*space_);
  for (MacroElement& macro : macros_.list) {
    std::vector<double> weights;
    for (int e : macro.elements) {
      const auto functions = functions_of(e);
      macro.functions.insert(macro.functions.end(), functions.begin(), functions.end());
      weights.insert(weights.end(), weights_of(e), weights_of(e) + element(e).points);
    }
    std::sort(macro.functions.begin(), macro.functions.end());
    macro.functions.erase(std::unique(macro.functions.begin(), macro.functions.end()), macro.functions.end());
    int modes = 1;
    for (int degree : macro.degrees) modes *= degree + 1;
    macro.weights = Eigen::Map<const VectorX>(weights.data(), std::ssize(weights));
    MatrixX polynomials(std::ssize(weights), modes);
    Eigen::Index row = 0;
    for (int e : macro.elements) {
      macro.places.emplace_back();
      for (int function : functions_of(e))
        macro.places.back().push_back(static_cast<int>(
            std::lower_bound(macro.functions.begin(), macro.functions.end(), function) - macro.functions.begin()));
      const ElementQuadrature rule = element_quadrature(*space_, e);
      for (Eigen::Index q = 0; q < rule.points.cols(); ++q)
        polynomials.row(row++) = legendre_products(macro, rule.points.col(q));
    }
    orthonormalize(macro, polynomials);
  }
}

template <int D> int Body<D>::macro_index(int m, int d) const {
  if (macros_.list.empty()) return space_->element_index(m, d);
  for (int lower = 0; lower < d; ++lower) m /= macros_.counts[lower];
  return m % macros_.counts[d];
}

template <int D> int Body<D>::macro_of(int e) const {
  return macro_containing(macros_, *space_, e);
}

template <int D> VectorX Body<D>::modes_at(int m, const VectorX& xi) const {
  return macro(m).combine.transpose() * legendre_products(macro(m), xi);
}

template <int D> int Body<D>::most_functions_of_macro() const {
  int most = macros_.list.empty() ? most_functions_ : 0;
  for (const MacroElement& macro : macros_.list) most = std::max(most, static_cast<int>(macro.functions.size()));
  return most;
}

template <int D> std::size_t Body<D>::memory() const {
  return sizeof(double) * (weights_.size() + gradients_.size() + hoops_.size() + constants_.size()) +
         sizeof(double) * volumes_.size() + sizeof(int) * functions_.size() + sizeof(ElementTable) * elements_.size() +
         solid::memory(macros_);
}

template <int D>
Body<D>::Body(nurbs::Discretization space, Material material)
    : Body(std::make_shared<const nurbs::Discretization>(std::move(space)), std::move(material)) {}

template <int D> KernelArguments Body<D>::arguments(int e) const {
  const ElementTable& table = element(e);
  const ElasticConstants& constants = material_.constants();
  KernelArguments arguments{table.functions, table.points, constants.lambda, constants.mu};
  arguments.gradients = gradients_of(e);
  arguments.weights = weights_of(e);
  arguments.hoop = hoops_of(e);
  arguments.constant = constants_.data() + table.constant;
  arguments.law = material_.law();
  arguments.respond = table.kernels.respond;
  return arguments;
}

template <int D> void Body<D>::add_element(int e, Construction& construction) {
  const auto& points = construction.points;
  nurbs::ElementBasis& basis = construction.basis;
  std::array<const double*, D> weights;
  std::array<int, D> counts;
  int count = 1;
  for (int d = 0; d < D; ++d) {
    QuadratureRule& rule = construction.rules[d][space_->element_index(e, d)];
    if (std::ssize(rule.points) != space_->degree(e, d) + 1) rule = element_rule(*space_, e, d);
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
      table.kernels =
          volumetric_ == Volumetric::projected ? projected_kernels<D>() : material_.kernels<D>(kind_, table.functions);
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
    if (kind_ == Kind::axisymmetric) {
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
template <int D> void Body<D>::add_constants() {
  const std::vector<double> rest(D * most_functions_, 0.0);
  std::vector<double> force(rest.size());
  for (int e = 0; e < elements(); ++e) {
    const ElementTable& table = element(e);
    if (!table.kernels.constant) continue;
    KernelArguments given = arguments(e);
    given.local = rest.data();
    given.force = force.data();
    given.blocks = constants_.data() + table.constant;
    table.kernels.constant(given);
  }
}

template <int D> VectorX Body<D>::reference_point(int e, int q) const {
  return space_->basis(e, element_quadrature(*space_, e).points.col(q)).combine(space_->points());
}

std::shared_ptr<const Body<2>> revolved(const Body<2>& body) {
  return std::make_shared<const Body<2>>(body.shared_space(), body.material(), Kind::axisymmetric, body.volumetric());
}

std::shared_ptr<const Body<2>> in_plane_stress(const Body<2>& body) {
  return std::make_shared<const Body<2>>(body.shared_space(), body.material(), Kind::plane_stress, body.volumetric());
}

template class Body<2>;
template class Body<3>;

} // namespace signorini::solid
