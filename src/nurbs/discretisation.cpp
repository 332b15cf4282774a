#include "nurbs/discretisation.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "nurbs/basis.hpp"
#include "nurbs/lagrange.hpp"

#include <algorithm>

namespace signorini::nurbs {

namespace {

std::vector<int> other_directions(int dimensions, int through) {
  std::vector<int> result;
  for (int d = 0; d < dimensions; ++d)
    if (d != through) result.push_back(d);
  return result;
}

/// The label that says how deep the layer is: the first that has one.
const Label& layer_label(const Plan& plan) {
  const auto layered = std::find_if(plan.labels.begin(), plan.labels.end(), [](auto& label) { return label.layer; });
  return layered == plan.labels.end() ? plan.labels.front() : *layered;
}

void check(const Patch& patch, const Plan& plan) {
  const int dimensions = patch.parametric_dimension();
  require(dimensions == patch.dimension(), "patch: a body of dimension ", patch.dimension(), " needs a ",
          patch.dimension() == 2 ? "surface" : "volume", "; this patch has ", dimensions, " parametric direction",
          dimensions == 1 ? "" : "s");
  require(static_cast<int>(plan.elements.size()) == dimensions, "elements: ", dimensions,
          " numbers are needed, one per parametric direction; got ", plan.elements.size());
  require(plan.grading.empty() || static_cast<int>(plan.grading.size()) == dimensions, "grading: ", dimensions,
          " entries are needed, one per parametric direction; got ", plan.grading.size());
  require(plan.contact.size() <= 2, "contact: one face or two opposite ones carry layers; got ", plan.contact.size());
  for (const Side& side : plan.contact)
    require(side.direction == plan.contact.front().direction, "contact: '", name_of(plan.contact.front()), "' and '",
            name_of(side), "' meet; two contact faces of a body must be opposite ones");
  if (plan.contact.size() == 2)
    require(plan.contact[0].at_end != plan.contact[1].at_end, "contact: face '", name_of(plan.contact[0]),
            "' is named twice");
  const int along = plan.contact.empty() ? dimensions : dimensions - 1;
  require(static_cast<int>(plan.labels.size()) == along, "order: ", along, " label", along == 1 ? "" : "s",
          " needed, one per direction along the contact face; got ", plan.labels.size());
  for (const Label& label : plan.labels) {
    require(label.lagrange == plan.labels.front().lagrange, "order: '", plan.labels.front().text, "' and '", label.text,
            "' cannot be mixed: a body is of L or of N elements");
    require(!label.layer || !plan.contact.empty(), "order: '", label.text,
            "' has a layer, but the body names no contact face to put it on; add contact = \"south\" or the like");
    require(!label.layer || label.rows == layer_label(plan).rows, "order: the layer is as deep in '", label.text,
            "' as in '", layer_label(plan).text, "'; give both the same xr");
  }
}

/// k-refines direction d to the space Np.s. `label` only words the error.
Patch refine_to(const Patch& patch, int d, const Space& space, const std::vector<double>& knots,
                const std::string& label) {
  const int own = patch.direction(d).degree();
  require(space.degree >= own, "order: '", label, "' asks for degree ", space.degree,
          ", but the geometry is of degree ", own, " there; N", own, " is the lowest that is exact");
  return elevate(k_refine(patch, d, space.degree, knots), d, space.elevations);
}

/// The space in the thickness direction: of the degree that the plan names, or the bulk's, but never below the
/// geometry's own degree.
Space through_space(const Patch& patch, const Plan& plan, int through) {
  const int own = patch.direction(through).degree();
  if (plan.through) {
    require(*plan.through >= own, "through: degree ", *plan.through, " is below the geometry's own, ", own);
    return {*plan.through};
  }
  if (plan.contact.empty()) return plan.labels.back().bulk;
  const Space bulk = bulk_space(plan.labels);
  return {std::max(own, bulk.degree), bulk.elevations};
}

/// All rows of classical C⁰ elements, one patch sliced along `through`.
Patch lagrange_patch(const Patch& patch, const Plan& plan, int through,
                     const std::vector<std::vector<double>>& inserted) {
  std::vector<int> degrees;
  std::vector<std::vector<double>> breaks;
  for (int d = 0, along = 0; d < patch.parametric_dimension(); ++d) {
    const bool labelled = plan.contact.empty() || d != through;
    degrees.push_back(labelled ? plan.labels[at(along++)].bulk.degree : through_space(patch, plan, through).degree);
    breaks.push_back(insert_knots(patch, d, inserted[at(d)]).direction(d).breaks());
  }
  return interpolate_lagrange(patch, degrees, breaks);
}

} // namespace

Discretisation::Discretisation(const Patch& patch, const Plan& plan)
    : through_(plan.contact.empty() ? patch.parametric_dimension() - 1 : plan.contact.front().direction),
      through_knots_(KnotVector::single(1)), contact_(plan.contact) {
  check(patch, plan);
  const int dimensions = patch.parametric_dimension();
  std::vector<std::vector<double>> inserted;
  for (int d = 0; d < dimensions; ++d) {
    inserted.push_back(element_knots(patch.direction(d), plan.elements[at(d)],
                                     plan.grading.empty() ? std::nullopt : plan.grading[at(d)]));
    elements_.push_back(patch.direction(d).elements() + static_cast<int>(inserted.back().size()));
  }

  const bool lagrange = plan.labels.front().lagrange;
  const Patch stack = lagrange ? lagrange_patch(patch, plan, through_, inserted)
                               : refine_to(patch, through_, through_space(patch, plan, through_),
                                           inserted[at(through_)], plan.labels.back().text);
  through_knots_ = stack.direction(through_);

  const int count = through_knots_.functions();
  const Label& deep = layer_label(plan);
  require(deep.rows <= count, "order: '", deep.text, "' is ", deep.rows, " rows deep, but the body has only ", count,
          " rows of control points through it");
  const auto in_layer = [&](int row) {
    return std::any_of(contact_.begin(), contact_.end(),
                       [&](const Side& side) { return (side.at_end ? count - 1 - row : row) < deep.rows; });
  };
  for (int j = 0; j < count; ++j) {
    Patch row = control_row(stack, through_, j);
    const std::vector<int> directions = other_directions(dimensions, through_);
    for (int a = 0; a < dimensions - 1 && !lagrange; ++a) {
      const Label& label = plan.labels[at(a)];
      const Space space = label.layer && in_layer(j) ? *label.layer : label.bulk;
      row = refine_to(row, a, space, inserted[at(directions[at(a)])], label.text);
    }
    rows_.push_back(std::move(row));
  }
  gather_rows();
}

Discretisation::Discretisation(int through, KnotVector through_knots, std::vector<Patch> rows,
                               std::vector<Side> contact)
    : through_(through), through_knots_(std::move(through_knots)), rows_(std::move(rows)),
      contact_(std::move(contact)) {
  require(static_cast<int>(rows_.size()) == through_knots_.functions(), "a body of ", through_knots_.functions(),
          " rows of control points was given ", rows_.size());
  const Patch& first = rows_.front();
  require(first.parametric_dimension() + 1 == first.dimension() && through_ >= 0 && through_ < first.dimension(),
          "a body's rows are of one dimension less than space");
  for (const Patch& row : rows_) {
    bool fits = row.dimension() == first.dimension() && row.parametric_dimension() == first.parametric_dimension();
    for (int a = 0; fits && a < row.parametric_dimension(); ++a)
      fits = row.direction(a).breaks() == first.direction(a).breaks();
    require(fits, "all rows of a body must have the same elements");
  }
  for (int d = 0; d < first.dimension(); ++d)
    elements_.push_back((d == through_ ? through_knots_ : first.direction(d < through_ ? d : d - 1)).elements());
  gather_rows();
}

/// Numbers the functions row after row.
void Discretisation::gather_rows() {
  int count = 0;
  for (const Patch& row : rows_) {
    first_.push_back(count);
    count += row.functions();
  }
  homogeneous_.resize(rows_.front().dimension() + 1, count);
  for (std::size_t j = 0; j < rows_.size(); ++j)
    homogeneous_.middleCols(first_[j], rows_[j].functions()) = rows_[j].homogeneous();
}

MatrixX Discretisation::points() const {
  return homogeneous_.topRows(dimension()).array().rowwise() / homogeneous_.bottomRows(1).row(0).array();
}

int Discretisation::elements() const {
  int product = 1;
  for (int count : elements_) product *= count;
  return product;
}

int Discretisation::element_index(int e, int d) const {
  for (int k = 0; k < d; ++k) e /= elements_[at(k)];
  return e % elements_[at(d)];
}

std::array<double, 2> Discretisation::interval(int e, int d) const {
  const int a = d < through_ ? d : d - 1;
  const auto& breaks = (d == through_ ? through_knots_ : rows_.front().direction(a)).breaks();
  const std::size_t i = at(element_index(e, d));
  return {breaks[i], breaks[i + 1]};
}

int Discretisation::degree(int e, int d) const {
  if (d == through_) return through_knots_.degree();
  const int first = through_knots_.first_function(element_index(e, through_));
  int highest = 0;
  for (int j = first; j <= first + through_knots_.degree(); ++j)
    highest = std::max(highest, rows_[at(j)].direction(d < through_ ? d : d - 1).degree());
  return highest;
}

int Discretisation::find_element(const VectorX& xi) const {
  int e = 0;
  for (int d = parametric_dimension() - 1; d >= 0; --d) {
    const int a = d < through_ ? d : d - 1;
    e = e * elements_[at(d)] + (d == through_ ? through_knots_ : rows_.front().direction(a)).find_element(xi(d));
  }
  return e;
}

ElementBasis Discretisation::basis(int e, const VectorX& xi) const {
  const int dimensions = parametric_dimension();
  const int p = through_knots_.degree();
  const int layer = element_index(e, through_);
  double through[2 * (max_degree + 1)];
  basis_derivatives(through_knots_, layer, xi(through_), 1, through);

  ElementBasis result;
  std::vector<double> values;                 // w_A N_A(ξ)
  std::vector<std::vector<double>> gradients; // ∂(w_A N_A)/∂ξ^d
  gradients.resize(at(dimensions));
  for (int k = 0; k <= p; ++k) {
    const int j = through_knots_.first_function(layer) + k;
    const Patch& row = rows_[at(j)];
    double along[2][2 * (max_degree + 1)] = {};
    int first[2] = {0, 0}, count[2] = {1, 1}, stride = 1;
    for (int d = 0, a = 0; d < dimensions; ++d) {
      if (d == through_) continue;
      const KnotVector& knots = row.direction(a);
      const int i = element_index(e, d);
      basis_derivatives(knots, i, xi(d), 1, along[a]);
      first[a] = knots.first_function(i);
      count[a] = knots.degree() + 1;
      if (a == 0) stride = knots.functions();
      ++a;
    }
    if (dimensions == 2) along[1][0] = 1;
    for (int n = 0; n < count[1]; ++n)
      for (int m = 0; m < count[0]; ++m) {
        const int function = first_[at(j)] + first[0] + m + stride * (dimensions == 3 ? first[1] + n : 0);
        const double w = homogeneous_(dimension(), function);
        result.functions.push_back(function);
        values.push_back(w * through[k] * along[0][m] * along[1][n]);
        for (int d = 0, a = 0; d < dimensions; ++d) {
          const double t = through[d == through_ ? p + 1 + k : k];
          const double u = along[0][d != through_ && a == 0 ? count[0] + m : m];
          const double v = along[1][d != through_ && a == 1 ? count[1] + n : n];
          gradients[at(d)].push_back(w * t * u * v);
          if (d != through_) ++a;
        }
      }
  }

  // R_A = w_A N_A / W,  ∂R_A = (∂(w_A N_A) − R_A ∂W) / W
  const int size = static_cast<int>(values.size());
  result.values = Eigen::Map<const VectorX>(values.data(), size);
  const double weight = result.values.sum();
  result.values /= weight;
  result.gradients.resize(dimensions, size);
  for (int d = 0; d < dimensions; ++d) {
    const auto raw = Eigen::Map<const VectorX>(gradients[at(d)].data(), size);
    result.gradients.row(d) = (raw - result.values * raw.sum()).transpose() / weight;
  }
  return result;
}

std::vector<int> Discretisation::row_end(int j, int a, bool at_end) const {
  const Patch& row = rows_[at(j)];
  const int n0 = row.direction(0).functions(), end = at_end ? row.direction(a).functions() - 1 : 0;
  std::vector<int> result;
  for (int i = 0; i < row.functions(); ++i)
    if ((a == 0 ? i % n0 : i / n0) == end) result.push_back(first_[at(j)] + i);
  return result;
}

std::vector<int> Discretisation::face_functions(Side side) const {
  std::vector<int> result;
  if (side.direction == through_) {
    const int row = side.at_end ? through_knots_.functions() - 1 : 0;
    for (int i = 0; i < rows_[at(row)].functions(); ++i) result.push_back(first_[at(row)] + i);
    return result;
  }
  // The side cuts every row at one end of direction a of the row.
  const int a = side.direction < through_ ? side.direction : side.direction - 1;
  std::vector<std::vector<int>> cuts;
  for (std::size_t j = 0; j < rows_.size(); ++j) cuts.push_back(row_end(static_cast<int>(j), a, side.at_end));
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

Patch Discretisation::face_patch(Side side) const {
  if (side.direction == through_) return rows_[at(side.at_end ? through_knots_.functions() - 1 : 0)];
  const std::vector<int> functions = face_functions(side);
  MatrixX points(dimension() + 1, static_cast<int>(functions.size()));
  for (std::size_t i = 0; i < functions.size(); ++i) points.col(static_cast<int>(i)) = homogeneous_.col(functions[i]);
  std::vector<KnotVector> directions;
  for (int d = 0; d < parametric_dimension(); ++d) {
    if (d == side.direction) continue;
    if (d == through_) {
      directions.push_back(through_knots_);
      continue;
    }
    const int a = d < through_ ? d : d - 1;
    for (const Patch& row : rows_)
      if (!(row.direction(a) == rows_.front().direction(a)))
        fail("face '", name_of(side),
             "' crosses the layer of this body, so it is no NURBS of its own; contact and loads act on '",
             name_of(contact_.front()), "', or take a uniform label");
    directions.push_back(rows_.front().direction(a));
  }
  return {std::move(directions), std::move(points)};
}

} // namespace signorini::nurbs
