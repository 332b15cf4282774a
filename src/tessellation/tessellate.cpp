#include "tessellation/tessellate.hpp"

#include "model/results/face_values.hpp"
#include "model/results/results.hpp"
#include "tessellation/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::tessellation {

using model::BodyPoint;
using model::FaceValues;

namespace {

/// A point of a side of a solid.
struct SkinPoint {
  Vec<3> position, normal;
  double value;
};

/// One side of a solid; its elements are numbered with the first of its two directions fastest.
struct SkinSide {
  const Model<3>& model;
  int body;
  nurbs::Side side;
  bool deformed;

  const solid::Body<3>& solid() const { return *model.system.scene.bodies[body].body; }
  const nurbs::Discretization& space() const { return solid().space(); }
  /// The solid's direction of the side's direction 0 or 1.
  int along(int i) const { return i == 0 ? (side.direction == 0 ? 1 : 0) : (side.direction == 2 ? 1 : 2); }
  int elements(int i) const { return space().elements(along(i)); }

  /// The solid's element at the side's element (i, j).
  int element(int i, int j) const { return space().element_behind(side, i + elements(0) * j); }

  /// The point at fractions s and t of element e's intervals on the side.
  VectorX parameter(int e, double s, double t) const {
    Vec<3> fractions;
    fractions(side.direction) = side.at_end;
    fractions(along(0)) = s;
    fractions(along(1)) = t;
    return space().parameter(e, fractions);
  }

  SkinPoint point(int e, double s, double t, const Field<3>* field) const {
    const BodyPoint<3> state = regular_point(model, body, e, parameter(e, s, t));
    // ∂x/∂ξ = F ∂X/∂ξ, normal ∥ ±τ₁×τ₂
    const Mat<3> tangents = deformed ? Mat<3>(state.state.deformation * state.jacobian) : state.jacobian;
    SkinPoint result{state.reference, {}, field ? value_at(model, body, *field, state) : 0};
    if (deformed) result.position += state.state.displacement;
    result.normal = nurbs::outward_sign(side) * tangents.col(along(0)).cross(tangents.col(along(1))).stableNormalized();
    return result;
  }
};

Grid grid_of(const Sampling<3>& sampling, const SkinSide& side, int i, int j, Eigen::Index first) {
  return {sampling[side.along(0)][i], sampling[side.along(1)][j], first};
}

std::array<SkinSide, 6> sides_of(const Model<3>& model, int body, bool deformed) {
  const auto side = [&](int direction, bool at_end) { return SkinSide{model, body, {direction, at_end}, deformed}; };
  return {side(0, false), side(0, true), side(1, false), side(1, true), side(2, false), side(2, true)};
}

/// Calls visit(side, i, j) for the elements of all sides, in the order of the skin's points.
template <class Visit> void each_side_element(const Model<3>& model, int body, bool deformed, Visit visit) {
  for (const SkinSide& side : sides_of(model, body, deformed))
    for (int j = 0; j < side.elements(1); ++j)
      for (int i = 0; i < side.elements(0); ++i) visit(side, i, j);
}

/// Control points (2D: with z = 0), and the lines that connect them within each row.
template <int D> void add_control_points(Skin& result, const Model<D>& model, int body, bool deformed) {
  const nurbs::Discretization& space = model.system.scene.bodies[body].body->space();
  result.control_points.setZero(3, space.functions());
  result.control_points.template topRows<D>() = space.points();
  if (deformed) result.control_points.template topRows<D>() += body_displacement(model, body);
  for (std::size_t r = 0; r < space.rows().size(); ++r) {
    const int first = space.first_function(static_cast<int>(r)), n = space.rows()[r].direction(0).functions(),
              count = space.rows()[r].functions();
    for (int f = 0; f < count; ++f) {
      if (f % n > 0) result.net_lines.push_back({first + f - 1, first + f});
      if (f >= n) result.net_lines.push_back({first + f - n, first + f});
    }
  }
}

} // namespace

Skin tessellate(const Model<2>& model, int body, const Field<2>* field, const Sampling<2>& sampling, bool deformed) {
  const solid::Body<2>& solid = *model.system.scene.bodies[body].body;
  const nurbs::Discretization& space = solid.space();
  const auto grid_at = [&](int e, Eigen::Index first) {
    return Grid{sampling[0][space.element_index(e, 0)], sampling[1][space.element_index(e, 1)], first};
  };
  Eigen::Index points = 0, triangles = 0;
  for (int e = 0; e < space.elements(); ++e) {
    points += grid_at(e, 0).size();
    triangles += grid_at(e, 0).triangles();
  }
  Skin result;
  result.points.setZero(3, points);
  result.triangles.resize(3, triangles);
  if (field) result.values.resize(points);

  Eigen::Index first = 0, triangle = 0;
  for (int e = 0; e < space.elements(); ++e) {
    const Grid grid = grid_at(e, first);
    for (int q = 0; q < grid.rows(); ++q)
      for (int p = 0; p < grid.columns(); ++p) {
        const VectorX xi = space.parameter(e, Vec<2>(grid.along[p], grid.across[q]));
        const BodyPoint<2> point = regular_point(model, body, e, xi);
        const Eigen::Index here = grid(p, q);
        result.points.col(here).head<2>() = point.reference;
        if (deformed) result.points.col(here).head<2>() += point.state.displacement;
        if (field) result.values(here) = value_at(model, body, *field, point);
      }
    add_triangles(result.triangles, triangle, grid);
    add_borders(result, grid, {space.element_index(e, 0), space.element_index(e, 1)},
                {space.elements(0), space.elements(1)});
    first += grid.size();
  }
  add_control_points(result, model, body, deformed);
  return result;
}

int surface_elements(const nurbs::Discretization& space) {
  return 2 * (space.elements(0) * space.elements(1) + space.elements(1) * space.elements(2) +
              space.elements(2) * space.elements(0));
}

Skin tessellate(const Model<3>& model, int body, const Field<3>* field, const Sampling<3>& sampling, bool deformed) {
  Eigen::Index points = 0, triangles = 0;
  each_side_element(model, body, deformed, [&](const SkinSide& side, int i, int j) {
    const Grid grid = grid_of(sampling, side, i, j, 0);
    points += grid.size();
    triangles += grid.triangles();
  });
  Skin skin;
  skin.points.resize(3, points);
  skin.normals.resize(3, points);
  skin.triangles.resize(3, triangles);
  if (field) skin.values.resize(points);

  Eigen::Index first = 0, triangle = 0;
  each_side_element(model, body, deformed, [&](const SkinSide& side, int i, int j) {
    const Grid grid = grid_of(sampling, side, i, j, first);
    for (int q = 0; q < grid.rows(); ++q)
      for (int p = 0; p < grid.columns(); ++p) {
        const SkinPoint point = side.point(side.element(i, j), grid.along[p], grid.across[q], field);
        skin.points.col(grid(p, q)) = point.position;
        skin.normals.col(grid(p, q)) = point.normal;
        if (field) skin.values(grid(p, q)) = point.value;
      }
    add_triangles(skin.triangles, triangle, grid);
    (j == 0 ? skin.rim : skin.mesh_lines).push_back(border(skin, grid, 0, false));
    (i == 0 ? skin.rim : skin.mesh_lines).push_back(border(skin, grid, 1, false));
    if (j == side.elements(1) - 1) skin.rim.push_back(border(skin, grid, 0, true));
    if (i == side.elements(0) - 1) skin.rim.push_back(border(skin, grid, 1, true));
    first += grid.size();
  });
  add_control_points(skin, model, body, deformed);
  return skin;
}

VectorX face_values(const Model<3>& model, model::FaceField field, int body, const Sampling<3>& sampling) {
  std::vector<FaceValues<3>> faces;
  for (std::size_t c = 0; c < model.system.scene.contacts.size(); ++c)
    for (std::size_t k = 0; k < model.system.scene.contacts[c].slave.size(); ++k)
      if (model.system.scene.contacts[c].slave[k].body == body && has(model.system.scene.contacts[c], field))
        faces.emplace_back(model, field, static_cast<int>(c), k);
  if (faces.empty()) return {};
  std::vector<double> values;
  each_side_element(model, body, false, [&](const SkinSide& side, int i, int j) {
    const int e = i + side.elements(0) * j;
    const Grid grid = grid_of(sampling, side, i, j, 0);
    for (double t : grid.across)
      for (double s : grid.along) {
        double sum = 0;
        for (const FaceValues<3>& face : faces)
          if (face.side() == side.side) sum += face.at_place(e, {s, t});
        values.push_back(sum);
      }
  });
  return Eigen::Map<const VectorX>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::vector<Inside> crossed_elements(const Model<3>& model, int body, const Field<3>* field, int divisions,
                                     bool deformed, const std::vector<CutPlane>& planes) {
  const solid::Body<3>& solid = *model.system.scene.bodies[body].body;
  const nurbs::Discretization& space = solid.space();
  Points control = space.points();
  if (deformed) control += body_displacement(model, body);
  const double tolerance = 1e-9 * (control.rowwise().maxCoeff() - control.rowwise().minCoeff()).norm();
  const int side = divisions + 1;
  std::vector<Inside> result;
  for (int e = 0; e < space.elements(); ++e) {
    // An element lies in the convex hull of its control points.
    const std::vector<int> functions = space.basis(e, space.parameter(e, Vec<3>::Constant(0.5))).functions;
    const bool crossed = std::any_of(planes.begin(), planes.end(), [&](const CutPlane& plane) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (int f : functions) {
        const double distance = plane.normal.normalized().dot(control.col(f) - plane.point);
        low = std::min(low, distance), high = std::max(high, distance);
      }
      return low <= tolerance && high >= -tolerance;
    });
    if (!crossed) continue;
    Inside inside{divisions, Points(3, side * side * side), {}};
    if (field) inside.values.resize(inside.points.cols());
    for (int p = 0; p < inside.points.cols(); ++p) {
      const Vec<3> fraction = Vec<3>(p % side, p / side % side, p / side / side) / divisions;
      const BodyPoint<3> point = regular_point(model, body, e, space.parameter(e, fraction));
      inside.points.col(p) = point.reference;
      if (deformed) inside.points.col(p) += point.state.displacement;
      if (field) inside.values(p) = value_at(model, body, *field, point);
    }
    result.push_back(std::move(inside));
  }
  return result;
}

} // namespace signorini::tessellation
