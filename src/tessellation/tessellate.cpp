#include "tessellation/tessellate.hpp"

#include "model/results/face_values.hpp"
#include "model/results/results.hpp"
#include "tessellation/grid.hpp"

#include <algorithm>
#include <limits>

namespace signorini::tessellation {

using model::BodyPoint;
using model::FaceValues;

namespace {

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

std::array<SkinSide, 6> sides_of(const Model<3>& model, int body, bool deformed) {
  const auto side = [&](int direction, bool at_end) { return SkinSide{model, body, {direction, at_end}, deformed}; };
  return {side(0, false), side(0, true), side(1, false), side(1, true), side(2, false), side(2, true)};
}

/// Element (i, j) of a side.
struct SideElement {
  const SkinSide& side;
  int i, j;
};

/// Calls visit(element, along, across) for the elements of all sides and their fractions.
template <class Visit>
void each_side_element(const Model<3>& model, int body, bool deformed, const Sampling<3>& sampling, Visit visit) {
  for (const SkinSide& side : sides_of(model, body, deformed))
    for (int j = 0; j < side.elements(1); ++j)
      for (int i = 0; i < side.elements(0); ++i)
        visit(SideElement{side, i, j}, sampling[side.along(0)][i], sampling[side.along(1)][j]);
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
  const auto each = [&](const auto& visit) {
    for (int e = 0; e < space.elements(); ++e)
      visit(e, sampling[0][space.element_index(e, 0)], sampling[1][space.element_index(e, 1)]);
  };
  const auto point_at = [&](int e, double s, double t) {
    const BodyPoint<2> point = regular_point(model, body, e, space.parameter(e, Vec<2>(s, t)));
    SkinPoint at;
    at.position.head<2>() = point.reference;
    if (deformed) at.position.head<2>() += point.state.displacement;
    if (field) at.value = value_at(model, body, *field, point);
    return at;
  };
  const auto add_lines = [&](Skin& skin, const Grid& grid, int e) {
    add_borders(skin, grid, {space.element_index(e, 0), space.element_index(e, 1)},
                {space.elements(0), space.elements(1)});
  };
  Skin result = make_skin(false, field != nullptr, each, point_at, add_lines);
  add_control_points(result, model, body, deformed);
  return result;
}

int surface_elements(const nurbs::Discretization& space) {
  return 2 * (space.elements(0) * space.elements(1) + space.elements(1) * space.elements(2) +
              space.elements(2) * space.elements(0));
}

Skin tessellate(const Model<3>& model, int body, const Field<3>* field, const Sampling<3>& sampling, bool deformed) {
  const auto each = [&](const auto& visit) { each_side_element(model, body, deformed, sampling, visit); };
  const auto point_at = [&](const SideElement& of, double s, double t) {
    return of.side.point(of.side.element(of.i, of.j), s, t, field);
  };
  const auto add_lines = [](Skin& skin, const Grid& grid, const SideElement& of) {
    (of.j == 0 ? skin.rim : skin.mesh_lines).push_back(border(skin, grid, 0, false));
    (of.i == 0 ? skin.rim : skin.mesh_lines).push_back(border(skin, grid, 1, false));
    if (of.j == of.side.elements(1) - 1) skin.rim.push_back(border(skin, grid, 0, true));
    if (of.i == of.side.elements(0) - 1) skin.rim.push_back(border(skin, grid, 1, true));
  };
  Skin skin = make_skin(true, field != nullptr, each, point_at, add_lines);
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
  each_side_element(model, body, false, sampling, [&](const SideElement& of, const auto& along, const auto& across) {
    const int e = of.i + of.side.elements(0) * of.j;
    const bool on_slave = std::ranges::any_of(faces, [&](const auto& face) { return face.side() == of.side.side; });
    for (double t : across)
      for (double s : along) {
        double sum = on_slave ? 0 : elsewhere(field);
        for (const FaceValues<3>& face : faces)
          if (face.side() == of.side.side) sum += face.at_place(e, {s, t});
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
