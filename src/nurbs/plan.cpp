// The rows of control points of a body by its plan.
#include "base/error.hpp"
#include "nurbs/constants.hpp"
#include "nurbs/discretization.hpp"
#include "nurbs/lagrange.hpp"
#include "nurbs/multi_degree.hpp"

#include <algorithm>
#include <utility>

namespace signorini::nurbs {

namespace {

/// The parametric direction of the patch that is direction a of a row.
int patch_direction(const Plan& plan, int a) {
  return plan.contact.empty() || a < plan.contact.front().direction ? a : a + 1;
}

/// The label that defines the layer's depth: the first that has a layer.
const Label& layer_label(const Plan& plan) {
  const auto layered = std::find_if(plan.labels.begin(), plan.labels.end(), [](auto& label) { return label.layer; });
  return layered == plan.labels.end() ? plan.labels.front() : *layered;
}

std::vector<double> inserted_knots(const Patch& patch, const Plan& plan, int d) {
  return element_knots(patch.direction(d), plan.elements[d], plan.grading.empty() ? std::nullopt : plan.grading[d]);
}

/// Throws Error unless `raised` and `layer_knots` fit the faces and elements.
void check_extent(const Plan& plan, int along) {
  if (!plan.raised.empty()) {
    const bool layer = std::any_of(plan.labels.begin(), plan.labels.end(), [](auto& label) { return label.layer; });
    require(layer, "nurbs.body.raised_nowhere", {{"label", plan.labels.front().text}});
    require(plan.raised.size() == plan.contact.size(), "nurbs.body.raised_faces",
            {{"expected", plan.contact.size()}, {"count", plan.raised.size()}});
  }
  for (const auto& face : plan.raised) {
    require(static_cast<int>(face.size()) == along, "nurbs.body.raised_directions",
            {{"expected", along}, {"count", face.size()}});
    for (int a = 0; a < along; ++a) {
      const int d = patch_direction(plan, a);
      require(face[a].empty() || static_cast<int>(face[a].size()) == plan.elements[d], "nurbs.body.raised_elements",
              {{"direction", d}, {"expected", plan.elements[d]}, {"count", face[a].size()}});
    }
  }
  if (plan.layer_knots.empty()) return;
  require(!plan.contact.empty(), "nurbs.body.layer_knots_nowhere");
  require(!plan.labels.front().lagrange, "nurbs.body.layer_knots_lagrange", {{"label", plan.labels.front().text}});
  require(static_cast<int>(plan.layer_knots.size()) == along, "nurbs.body.layer_knots",
          {{"expected", along}, {"count", plan.layer_knots.size()}});
}

void check(const Patch& patch, const Plan& plan) {
  const int dimensions = patch.parametric_dimension();
  require(dimensions == patch.dimension(), patch.dimension() == 2 ? "nurbs.body.surface" : "nurbs.body.volume",
          {{"directions", dimensions}});
  require(static_cast<int>(plan.elements.size()) == dimensions, "nurbs.body.elements",
          {{"expected", dimensions}, {"count", plan.elements.size()}});
  require(plan.grading.empty() || static_cast<int>(plan.grading.size()) == dimensions, "nurbs.body.grading",
          {{"expected", dimensions}, {"count", plan.grading.size()}});
  require(plan.contact.size() <= 2, "nurbs.body.contact_count", {{"count", plan.contact.size()}});
  for (const Side& side : plan.contact)
    require(side.direction == plan.contact.front().direction, "nurbs.body.contact_meets",
            {{"first", name_of(plan.contact.front())}, {"second", name_of(side)}});
  if (plan.contact.size() == 2)
    require(plan.contact[0].at_end != plan.contact[1].at_end, "nurbs.body.contact_twice",
            {{"face", name_of(plan.contact[0])}});
  const int along = plan.contact.empty() ? dimensions : dimensions - 1;
  require(static_cast<int>(plan.labels.size()) == along, "nurbs.body.labels",
          {{"expected", along}, {"count", plan.labels.size()}});
  for (const Label& label : plan.labels) {
    require(label.lagrange == plan.labels.front().lagrange, "nurbs.body.mixed_labels",
            {{"first", plan.labels.front().text}, {"second", label.text}});
    require(!label.layer || !plan.contact.empty(), "nurbs.body.layer_nowhere", {{"label", label.text}});
    require(!label.layer || label.rows == layer_label(plan).rows, "nurbs.body.layer_depths",
            {{"label", label.text}, {"other", layer_label(plan).text}});
  }
  check_extent(plan, along);
}

/// Throws Error unless a label's space contains the geometry, of degree `own`.
void check_contains(const Space& space, int own, const std::string& label) {
  require(space.degree >= own, "nurbs.body.degree", {{"label", label}, {"degree", space.degree}, {"lowest", own}});
}

/// k-refines direction d to the space Np.s. `label` is needed for errors only.
Patch refine_to(const Patch& patch, int d, const Space& space, const std::vector<double>& knots,
                const std::string& label) {
  check_contains(space, patch.direction(d).degree(), label);
  return elevate(k_refine(patch, d, space.degree, knots), d, space.elevations);
}

/// The space in the thickness direction: of the plan's degree, or of the bulk's, but at least of the geometry's degree.
Space through_space(const Patch& patch, const Plan& plan, int through) {
  const int own = patch.direction(through).degree();
  if (plan.thickness_degree) {
    require(*plan.thickness_degree >= own, "nurbs.body.thickness_degree",
            {{"degree", *plan.thickness_degree}, {"lowest", own}});
    return {*plan.thickness_degree};
  }
  if (plan.contact.empty()) return plan.labels.back().bulk;
  const Space bulk = bulk_space(plan.labels);
  return {std::max(own, bulk.degree), bulk.elevations};
}

/// All rows of C⁰ Lagrange elements: one patch, sliced along `through`.
Patch lagrange_patch(const Patch& patch, const Plan& plan, int through,
                     const std::vector<std::vector<double>>& inserted) {
  std::vector<int> degrees;
  std::vector<std::vector<double>> breaks;
  for (int d = 0, along = 0; d < patch.parametric_dimension(); ++d) {
    const bool labeled = plan.contact.empty() || d != through;
    degrees.push_back(labeled ? plan.labels[along++].bulk.degree : through_space(patch, plan, through).degree);
    breaks.push_back(insert_knots(patch, d, inserted[d]).direction(d).breaks());
  }
  return interpolate_lagrange(patch, degrees, breaks);
}

/// One direction along the contact face, as all rows share it.
struct RowDirection {
  const KnotVector& geometry;
  const Label& label;
  std::vector<double> inserted; ///< knots of the bulk's elements
  std::vector<double> cuts;     ///< knots of the layer's rows only
};

std::vector<double> merged(std::vector<double> first, const std::vector<double>& second) {
  first.insert(first.end(), second.begin(), second.end());
  std::sort(first.begin(), first.end());
  return first;
}

/// Cuts of direction d, increasing. Throws Error if one is not inside an element.
std::vector<double> cuts_of(const Patch& patch, const Plan& plan, int a, int d) {
  std::vector<double> cuts = plan.layer_knots.empty() ? std::vector<double>() : plan.layer_knots[a];
  std::sort(cuts.begin(), cuts.end());
  const std::vector<double> breaks = element_breaks(patch, plan, d);
  const double least = rounding * (breaks.back() - breaks.front());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    require(cuts[i] > breaks.front() && cuts[i] < breaks.back(), "nurbs.body.layer_knot_outside",
            {{"knot", cuts[i]}, {"first", breaks.front()}, {"last", breaks.back()}});
    require(i == 0 || cuts[i] - cuts[i - 1] > least, "nurbs.body.layer_knot_twice", {{"knot", cuts[i]}});
    const auto near = std::lower_bound(breaks.begin(), breaks.end(), cuts[i] - least);
    require(*near > cuts[i] + least, "nurbs.body.layer_knot_present", {{"knot", cuts[i]}});
  }
  return cuts;
}

/// The space of a row whose degree is the layer's in some elements (`raised`, of those without cuts) and the bulk's in
/// the others, with the bulk's continuity at the borders; smooth at cuts unless they are its knots (`cut`).
Space1D local_space(const RowDirection& along, const std::vector<bool>& raised, bool cut) {
  const KnotVector& geometry = along.geometry;
  const std::vector<double> whole = merged(geometry.breaks(), along.inserted);
  std::vector<double> breaks = merged(whole, along.cuts);
  const auto space_of = [&](bool high) { return high ? *along.label.layer : along.label.bulk; };
  check_contains(along.label.bulk, geometry.degree(), along.label.text);
  std::vector<int> degrees, smoothness{-1};
  for (std::size_t i = 0, element = 0; i + 1 < breaks.size(); ++i) {
    const bool border = i > 0 && breaks[i] == whole[element + 1];
    const bool before = raised[element];
    if (border) ++element;
    degrees.push_back(space_of(raised[element]).full_degree());
    if (i == 0) continue;
    // The geometry's knots keep their continuity; inserted ones have that of the degree before elevation.
    const int present = geometry.multiplicity(breaks[i]);
    smoothness.push_back(present > 0     ? geometry.degree() - present
                         : border || cut ? space_of(before && raised[element]).degree - 1
                                         : degrees.back());
  }
  smoothness.push_back(-1);
  return multi_degree_space(std::move(breaks), degrees, std::move(smoothness));
}

/// True if row j of `count` belongs to the layer of contact face f of the plan.
bool in_layer(const Plan& plan, std::size_t f, int j, int count) {
  return (plan.contact[f].at_end ? count - 1 - j : j) < layer_label(plan).rows;
}

/// Which of the plan's elements along direction a have the layer's degree in row j of `count`.
std::vector<bool> raised_in_row(const Plan& plan, int a, std::size_t elements, int j, int count) {
  std::vector<bool> raised(elements, false);
  for (std::size_t f = 0; f < plan.contact.size(); ++f) {
    if (!plan.labels[a].layer || !in_layer(plan, f, j, count)) continue;
    const bool all = plan.raised.empty() || plan.raised[f][a].empty();
    for (std::size_t e = 0; e < elements; ++e) raised[e] = raised[e] || all || plan.raised[f][a][e];
  }
  return raised;
}

/// The rows of a patch by a plan.
Discretization discretized(const Patch& patch, const Plan& plan) {
  check(patch, plan);
  const int dimensions = patch.parametric_dimension();
  const int through = plan.contact.empty() ? dimensions - 1 : plan.contact.front().direction;
  std::vector<std::vector<double>> inserted;
  inserted.reserve(dimensions);
  for (int d = 0; d < dimensions; ++d) inserted.push_back(inserted_knots(patch, plan, d));

  const bool lagrange = plan.labels.front().lagrange;
  const Patch whole = lagrange ? lagrange_patch(patch, plan, through, inserted)
                               : refine_to(patch, through, through_space(patch, plan, through), inserted[through],
                                           plan.labels.back().text);

  const int count = whole.direction(through).functions();
  const Label& deep = layer_label(plan);
  require(deep.rows <= count, "nurbs.body.layer_too_deep",
          {{"label", deep.text}, {"rows", deep.rows}, {"available", count}});
  std::vector<RowDirection> along;
  for (int a = 0; a < dimensions - 1; ++a) {
    const int d = a < through ? a : a + 1;
    along.push_back({patch.direction(d), plan.labels[a], inserted[d], cuts_of(patch, plan, a, d)});
  }
  // Most rows have the same knots: their space is tabulated once.
  std::vector<std::pair<KnotVector, Space1D>> tabulated;
  const auto space_of = [&](const KnotVector& knots) -> const Space1D& {
    for (const auto& [known, space] : tabulated)
      if (known == knots) return space;
    return tabulated.emplace_back(knots, spline_space(knots)).second;
  };
  std::vector<Row> rows;
  const auto add_row = [&](const Patch& row) {
    std::vector<Space1D> spaces;
    for (const KnotVector& knots : row.directions()) spaces.push_back(space_of(knots));
    rows.emplace_back(std::move(spaces), row.homogeneous());
  };
  for (int j = 0; j < count; ++j) {
    Patch row = control_row(whole, through, j);
    if (lagrange) {
      add_row(row);
      continue;
    }
    bool cut = false; // layer knots are knots of this row
    for (std::size_t f = 0; f < plan.contact.size(); ++f) cut = cut || in_layer(plan, f, j, count);
    std::vector<std::pair<int, Space1D>> local;
    for (int a = 0; a < dimensions - 1; ++a) {
      const RowDirection& one = along[a];
      const std::size_t elements = one.inserted.size() + one.geometry.breaks().size() - 1;
      const std::vector<bool> raised = raised_in_row(plan, a, elements, j, count);
      const auto high = std::count(raised.begin(), raised.end(), true);
      const bool uniform = high == 0 || high == static_cast<std::ptrdiff_t>(raised.size());
      if (uniform && (cut || one.cuts.empty()))
        row = refine_to(row, a, high == 0 ? one.label.bulk : *one.label.layer, merged(one.inserted, one.cuts),
                        one.label.text);
      else
        local.emplace_back(a, local_space(one, raised, cut));
    }
    add_row(row);
    for (const auto& [a, space] : local) rows.back() = with_space(rows.back(), a, space);
  }
  return {through, spline_space(whole.direction(through)), std::move(rows), plan.contact};
}

} // namespace

std::vector<double> element_breaks(const Patch& patch, const Plan& plan, int d) {
  return merged(patch.direction(d).breaks(), inserted_knots(patch, plan, d));
}

Discretization::Discretization(const Patch& patch, const Plan& plan) : Discretization(discretized(patch, plan)) {
  const bool layered = std::any_of(plan.labels.begin(), plan.labels.end(), [](auto& label) { return label.layer; });
  if (layered) recipe_ = std::make_shared<const Recipe>(Recipe{patch, plan});
}

Discretization with_layer(const Discretization& space, RaisedElements raised) {
  require(space.recipe() != nullptr, "nurbs.body.no_layer");
  Plan plan = space.recipe()->plan;
  plan.raised = std::move(raised);
  return {space.recipe()->patch, plan};
}

} // namespace signorini::nurbs
