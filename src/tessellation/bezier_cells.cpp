#include "tessellation/bezier_cells.hpp"

#include "base/orthonormal.hpp"
#include "model/results/face_values.hpp"
#include "model/results/results.hpp"
#include "model/results/sample.hpp"
#include "nurbs/bezier.hpp"
#include "nurbs/bezier_element.hpp"
#include "solid/quadrature.hpp"

#include <numeric>
#include <unsupported/Eigen/KroneckerProduct>

namespace signorini::tessellation {

using model::BodyPoint;
using model::Contact;
using model::Field;
using model::FieldPoint;

namespace {

/// Matrix from values at `places` in [0, 1] to Bernstein coefficients of their least-squares fit, which interpolates up
/// to degree+1 values.
MatrixX fit(int degree, const std::vector<double>& places) {
  const int n = std::ssize(places), own = std::min(degree, n - 1);
  MatrixX values(n, own + 1);
  for (int i = 0; i < n; ++i) {
    VectorX bernstein(own + 1);
    nurbs::bernstein(own, places[i], 1, 0, bernstein.data());
    values.row(i) = bernstein;
  }
  return nurbs::bernstein_elevation(own, degree).transpose().lazyProduct(pseudo_inverse(values));
}

/// Kronecker product of matrices, the indices of the first one fastest.
MatrixX tensor_product(const std::vector<MatrixX>& factors) {
  MatrixX result = MatrixX::Ones(1, 1);
  for (const MatrixX& factor : factors) result = Eigen::kroneckerProduct(factor, result).eval();
  return result;
}

/// Projection of values at a lattice of points onto a cell: the matrix from values to Bernstein coefficients, and the
/// Bernstein polynomials at the points.
struct Projector {
  MatrixX fit, values;

  Projector(const std::vector<int>& degrees, const std::vector<std::vector<double>>& places) {
    std::vector<MatrixX> fits, all;
    for (std::size_t d = 0; d < degrees.size(); ++d) {
      fits.push_back(tessellation::fit(degrees[d], places[d]));
      MatrixX one(static_cast<Eigen::Index>(places[d].size()), degrees[d] + 1);
      for (std::size_t i = 0; i < places[d].size(); ++i) {
        VectorX bernstein(degrees[d] + 1);
        nurbs::bernstein(degrees[d], places[d][i], 1, 0, bernstein.data());
        one.row(static_cast<Eigen::Index>(i)) = bernstein;
      }
      all.push_back(std::move(one));
    }
    fit = tensor_product(fits);
    values = tensor_product(all);
  }

  /// c_k of a rational field with the given values (components × places): W f = Σ_k B_k (w_k c_k).
  MatrixX operator()(const MatrixX& field, const VectorX& weights) const {
    const VectorX denominator = values.lazyProduct(weights);
    const MatrixX numerator = field * denominator.asDiagonal();
    return numerator.lazyProduct(fit.transpose()) * weights.cwiseInverse().asDiagonal();
  }
};

/// A field of the cells and the scalar fields of its components; null: zero.
template <int D> struct Composition {
  const char* name;
  std::vector<const Field<D>*> components;
};

template <int D> const std::vector<Composition<D>>& compositions() {
  static const std::vector<Composition<D>> all = [] {
    const auto both = [](const char* name) { return &model::find_field<D>(name); };
    const auto third = [](const char* name) { return D == 3 ? &model::find_field<D>(name) : nullptr; };
    return std::vector<Composition<D>>{
        {"stress", {both("sxx"), both("syy"), both("szz"), both("sxy"), third("syz"), third("sxz")}},
        {"von_mises", {both("von_mises")}},
        {"pressure", {both("pressure")}},
        {"F",
         {both("F11"), both("F12"), third("F13"), both("F21"), both("F22"), third("F23"), third("F31"), third("F32"),
          both("F33")}}};
  }();
  return all;
}

/// All components of all compositions at a point, stacked.
template <int D> VectorX composed(const solid::Material& material, const FieldPoint<D>& point) {
  std::vector<double> values;
  for (const Composition<D>& composition : compositions<D>())
    for (const Field<D>* field : composition.components) values.push_back(field ? field->value(material, point) : 0.0);
  return Eigen::Map<const VectorX>(values.data(), static_cast<Eigen::Index>(values.size()));
}

int points_of(const std::vector<int>& degrees) {
  return std::accumulate(degrees.begin(), degrees.end(), 1, [](int product, int p) { return product * (p + 1); });
}

/// Indices of a cell's points on a side among all its points.
std::vector<int> points_on(nurbs::Side side, const std::vector<int>& degrees) {
  int stride = 1;
  for (int d = 0; d < side.direction; ++d) stride *= degrees[d] + 1;
  const int count = degrees[side.direction] + 1, wanted = side.at_end ? count - 1 : 0;
  std::vector<int> result;
  for (int point = 0; point < points_of(degrees); ++point)
    if (point / stride % count == wanted) result.push_back(point);
  return result;
}

} // namespace

template <int D> BezierCells bezier_cells(const Model<D>& model, int body, bool deformed) {
  const solid::Body<D>& solid = *model.system.scene.bodies[body].body;
  const nurbs::Discretization& space = solid.space();
  const MatrixX weighted = body_displacement(model, body) * space.homogeneous().row(D).asDiagonal();
  BezierCells cells;
  std::vector<nurbs::BezierElement> elements;
  int count = 0, components = 0;
  for (int e = 0; e < space.elements(); ++e) {
    elements.push_back(nurbs::bezier_element(space, e));
    cells.degrees.push_back(elements.back().degrees);
    count += points_of(cells.degrees.back());
  }
  for (const Composition<D>& composition : compositions<D>()) components += std::ssize(composition.components);
  cells.points.setZero(3, count);
  cells.weights.resize(count);
  MatrixX displacement = MatrixX::Zero(3, count), all(components, count);
  for (int e = 0, first = 0; e < space.elements(); ++e) {
    const nurbs::BezierElement& element = elements[e];
    const int size = points_of(element.degrees);
    const MatrixX homogeneous = space.homogeneous()(Eigen::all, element.functions).lazyProduct(element.extraction);
    const VectorX weights = homogeneous.row(D).transpose();
    const auto divided = weights.cwiseInverse().asDiagonal();
    displacement.block(0, first, D, size) =
        weighted(Eigen::all, element.functions).lazyProduct(element.extraction) * divided;
    cells.points.block(0, first, D, size) = homogeneous.topRows(D) * divided;
    cells.weights.segment(first, size) = weights;

    std::vector<std::vector<double>> places;
    for (int p : element.degrees) places.push_back(solid::gauss_legendre(p + 1, 0, 1).points);
    MatrixX values(components, size);
    for (int g = 0; g < size; ++g) {
      VectorX xi(D);
      for (int d = 0, rest = g; d < D; ++d) {
        const auto [from, to] = space.interval(e, d);
        xi(d) = from + (to - from) * places[d][rest % (element.degrees[d] + 1)];
        rest /= element.degrees[d] + 1;
      }
      BodyPoint<D> point = body_point(model, body, e, xi);
      add_volume_change(model, body, point);
      values.col(g) = composed<D>(solid.material(), point.state);
    }
    all.middleCols(first, size) = Projector(element.degrees, places)(values, weights);
    first += size;
  }
  if (deformed) cells.points += displacement;
  cells.fields.push_back({"displacement", std::move(displacement)});
  int row = 0;
  for (const Composition<D>& composition : compositions<D>()) {
    const int rows = std::ssize(composition.components);
    cells.fields.push_back({composition.name, all.middleRows(row, rows)});
    row += rows;
  }
  return cells;
}

template <int D>
BezierCells contact_cells(const Model<D>& model, int contact, std::size_t face, const BezierCells& cells) {
  const Contact<D>& definition = model.system.scene.contacts[contact];
  const auto& [body, side] = definition.slave[face];
  const nurbs::Discretization& space = model.system.scene.bodies[body].body->space();
  std::vector<int> first_point = {0};
  for (const std::vector<int>& degrees : cells.degrees) first_point.push_back(first_point.back() + points_of(degrees));

  const std::vector<std::vector<double>> places(D - 1, solid::gauss_legendre(definition.points, 0, 1).points);
  std::vector<model::FaceField> fields;
  for (const model::FaceField field : model::face_fields)
    if (has(definition, field)) fields.push_back(field);
  std::vector<MatrixX> values;
  for (const model::FaceField field : fields) values.push_back(contact_point_values(model, field, contact, face));
  BezierCells result;
  std::vector<int> chosen;                                    // among the points of the body's cells
  std::vector<std::vector<double>> on_contact(fields.size()); // values there
  for (int f = 0; f < values.front().cols(); ++f) {
    const int e = space.element_behind(side, f);
    std::vector<int> degrees = cells.degrees[e], own = points_on(side, degrees);
    for (int& point : own) point += first_point[e];
    degrees.erase(degrees.begin() + side.direction);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const MatrixX fitted = Projector(degrees, places)(values[i].col(f).transpose(), cells.weights(own));
      on_contact[i].insert(on_contact[i].end(), fitted.data(), fitted.data() + fitted.size());
    }
    chosen.insert(chosen.end(), own.begin(), own.end());
    result.degrees.push_back(std::move(degrees));
  }
  result.points = cells.points(Eigen::all, chosen);
  result.weights = cells.weights(chosen);
  for (const CellField& field : cells.fields) result.fields.push_back({field.name, field.values(Eigen::all, chosen)});
  const auto count = static_cast<Eigen::Index>(chosen.size());
  for (std::size_t i = 0; i < fields.size(); ++i)
    result.fields.push_back({name_of(fields[i]), Eigen::Map<const MatrixX>(on_contact[i].data(), 1, count)});
  return result;
}

template BezierCells bezier_cells<2>(const Model<2>&, int, bool);
template BezierCells bezier_cells<3>(const Model<3>&, int, bool);
template BezierCells contact_cells<2>(const Model<2>&, int, std::size_t, const BezierCells&);
template BezierCells contact_cells<3>(const Model<3>&, int, std::size_t, const BezierCells&);

} // namespace signorini::tessellation
