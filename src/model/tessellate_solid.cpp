#include "base/index.hpp"
#include "model/contact_pressure.hpp"
#include "model/tessellate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::model {

namespace {

/// A point of a side of a solid.
struct SkinPoint {
  Vec<3> position, normal;
  double value;
};

/// One side of a solid, its elements counted with the first of its two directions fastest.
struct SkinSide {
  const Model<3>& model;
  int body;
  nurbs::Side side;
  bool deformed;

  const solid::Body<3>& solid() const { return *model.scene().bodies[at(body)].body; }
  const nurbs::Discretisation& space() const { return solid().space(); }
  /// The side's own directions 0 and 1 among the solid's.
  int along(int i) const { return i == 0 ? (side.direction == 0 ? 1 : 0) : (side.direction == 2 ? 1 : 2); }
  int elements(int i) const { return space().elements(along(i)); }

  /// The solid's element behind the side's element (i, j).
  int element(int i, int j) const {
    std::array<int, 3> index{};
    index[at(side.direction)] = side.at_end ? space().elements(side.direction) - 1 : 0;
    index[at(along(0))] = i;
    index[at(along(1))] = j;
    return index[0] + space().elements(0) * (index[1] + space().elements(1) * index[2]);
  }

  /// At the fractions s and t of element e's way along the side.
  VectorX parameter(int e, double s, double t) const {
    VectorX xi(3);
    const auto through = space().interval(e, side.direction);
    xi(side.direction) = side.at_end ? through[1] : through[0];
    for (auto [direction, fraction] : {std::pair{along(0), s}, std::pair{along(1), t}}) {
      const auto [from, to] = space().interval(e, direction);
      xi(direction) = from + (to - from) * fraction;
    }
    return xi;
  }

  SkinPoint point(int e, double s, double t, const Field<3>* field) const {
    const BodyPoint<3> state = regular_point(model, body, e, parameter(e, s, t));
    // ∂x/∂ξ = F ∂X/∂ξ, normal ∥ ±τ₁×τ₂
    const Mat<3> tangents = deformed ? Mat<3>(state.state.deformation * state.jacobian) : state.jacobian;
    SkinPoint result{state.reference, {}, field ? field->value(solid().material(), state.state) : 0};
    if (deformed) result.position += state.state.displacement;
    result.normal = nurbs::outward_sign(side) * tangents.col(along(0)).cross(tangents.col(along(1))).stableNormalized();
    return result;
  }
};

/// The grid of points of one element's side.
struct Grid {
  int divisions;
  Eigen::Index first; ///< index of its first point in the skin

  Eigen::Index operator()(int i, int j) const { return first + i + (divisions + 1) * j; }
};

/// The element's border along one of the side's directions, at the start or the end of the other one.
SkinLine border(const Skin& skin, const Grid& grid, int along, bool at_end) {
  const int n = grid.divisions, fixed = at_end ? n : 0, half = n / 2;
  SkinLine line{Points(3, n + 1), Points(3, n + 1), 0};
  for (int k = 0; k <= n; ++k) {
    const Eigen::Index point = along == 0 ? grid(k, fixed) : grid(fixed, k);
    line.points.col(k) = skin.points.col(point);
    line.normals.col(k) = skin.normals.col(point);
  }
  line.spacing = along == 0 ? (skin.points.col(grid(half, n)) - skin.points.col(grid(half, 0))).norm()
                            : (skin.points.col(grid(n, half)) - skin.points.col(grid(0, half))).norm();
  return line;
}

void add_triangles(Triangles& triangles, Eigen::Index& next, const Grid& grid) {
  for (int j = 0; j < grid.divisions; ++j)
    for (int i = 0; i < grid.divisions; ++i) {
      const int corner = static_cast<int>(grid(i, j)), side = grid.divisions + 1;
      triangles.col(next++) << corner, corner + 1, corner + side + 1;
      triangles.col(next++) << corner, corner + side + 1, corner + side;
    }
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

void add_control_points(Skin& skin, const Model<3>& model, int body, bool deformed) {
  const nurbs::Discretisation& space = model.scene().bodies[at(body)].body->space();
  skin.control_points = space.points();
  if (deformed) skin.control_points += model.body_displacement(body);
  for (std::size_t r = 0; r < space.rows().size(); ++r) {
    const int first = space.first_function(static_cast<int>(r)), n = space.rows()[r].direction(0).functions(),
              count = space.rows()[r].functions();
    for (int f = 0; f < count; ++f) {
      if (f % n > 0) skin.net_lines.push_back({first + f - 1, first + f});
      if (f >= n) skin.net_lines.push_back({first + f - n, first + f});
    }
  }
}

} // namespace

int surface_elements(const nurbs::Discretisation& space) {
  return 2 * (space.elements(0) * space.elements(1) + space.elements(1) * space.elements(2) +
              space.elements(2) * space.elements(0));
}

Skin tessellate(const Model<3>& model, int body, const Field<3>* field, int divisions, bool deformed) {
  const int elements = surface_elements(model.scene().bodies[at(body)].body->space()), n = divisions,
            per_element = (n + 1) * (n + 1);
  Skin skin;
  skin.points.resize(3, per_element * elements);
  skin.normals.resize(3, per_element * elements);
  skin.triangles.resize(3, 2 * n * n * elements);
  if (field) skin.values.resize(per_element * elements);

  Grid grid{n, 0};
  Eigen::Index triangle = 0;
  each_side_element(model, body, deformed, [&](const SkinSide& side, int i, int j) {
    for (int q = 0; q <= n; ++q)
      for (int p = 0; p <= n; ++p) {
        const SkinPoint point = side.point(side.element(i, j), double(p) / n, double(q) / n, field);
        skin.points.col(grid(p, q)) = point.position;
        skin.normals.col(grid(p, q)) = point.normal;
        if (field) skin.values(grid(p, q)) = point.value;
      }
    add_triangles(skin.triangles, triangle, grid);
    (j == 0 ? skin.rim : skin.mesh_lines).push_back(border(skin, grid, 0, false));
    (i == 0 ? skin.rim : skin.mesh_lines).push_back(border(skin, grid, 1, false));
    if (j == side.elements(1) - 1) skin.rim.push_back(border(skin, grid, 0, true));
    if (i == side.elements(0) - 1) skin.rim.push_back(border(skin, grid, 1, true));
    grid.first += per_element;
  });
  add_control_points(skin, model, body, deformed);
  return skin;
}

VectorX contact_pressure(const Model<3>& model, int body, int divisions) {
  std::vector<FacePressure<3>> faces;
  for (std::size_t c = 0; c < model.scene().contacts.size(); ++c)
    if (model.scene().contacts[c].slave.body == body) faces.emplace_back(model, static_cast<int>(c));
  if (faces.empty()) return {};
  const int n = divisions;
  std::vector<double> values;
  each_side_element(model, body, false, [&](const SkinSide& side, int i, int j) {
    const int e = i + side.elements(0) * j;
    for (int q = 0; q <= n; ++q)
      for (int p = 0; p <= n; ++p) {
        double sum = 0;
        for (const FacePressure<3>& face : faces)
          if (face.side() == side.side) sum += face.at_place(e, {double(p) / n, double(q) / n});
        values.push_back(sum);
      }
  });
  return Eigen::Map<const VectorX>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::vector<Inside> crossed_elements(const Model<3>& model, int body, const Field<3>* field, int divisions,
                                     bool deformed, const std::vector<Plane>& planes) {
  const solid::Body<3>& solid = *model.scene().bodies[at(body)].body;
  const nurbs::Discretisation& space = solid.space();
  Points control = space.points();
  if (deformed) control += model.body_displacement(body);
  const double tolerance = 1e-9 * (control.rowwise().maxCoeff() - control.rowwise().minCoeff()).norm();
  const int side = divisions + 1;
  std::vector<Inside> result;
  for (int e = 0; e < space.elements(); ++e) {
    const auto parameter = [&](const Vec<3>& fraction) {
      VectorX xi(3);
      for (int d = 0; d < 3; ++d) {
        const auto [from, to] = space.interval(e, d);
        xi(d) = from + (to - from) * fraction(d);
      }
      return xi;
    };
    // An element lies in the hull of its control points.
    const std::vector<int> functions = space.basis(e, parameter(Vec<3>::Constant(0.5))).functions;
    const bool crossed = std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) {
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
      const BodyPoint<3> point = regular_point(model, body, e, parameter(fraction));
      inside.points.col(p) = point.reference;
      if (deformed) inside.points.col(p) += point.state.displacement;
      if (field) inside.values(p) = field->value(solid.material(), point.state);
    }
    result.push_back(std::move(inside));
  }
  return result;
}

} // namespace signorini::model
