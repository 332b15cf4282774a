#pragma once
// What pictures and tables need of a model's present state: fields at points, tessellated bodies.

#include "model/field.hpp"
#include "model/model.hpp"

namespace signorini::model {

/// The state of a body at parametric point xi of element e.
template <int D> struct BodyPoint {
  Vec<D> reference; ///< X
  FieldPoint<D> state;
};
template <int D> BodyPoint<D> body_point(const Model<D>& model, int body, int e, const VectorX& xi);

/// A field's value at a parametric point. Throws Error when xi lies outside the body.
template <int D> double sample(const Model<D>& model, int body, const Field<D>& field, const VectorX& xi);

/// A plane body as triangles over its true curved geometry.
struct Tessellation {
  Eigen::Matrix<double, 3, Eigen::Dynamic> points; ///< z = 0
  Eigen::Matrix<int, 3, Eigen::Dynamic> triangles;
  VectorX values;                                                   ///< of the field, per point; empty without a field
  std::vector<Eigen::Matrix<double, 3, Eigen::Dynamic>> mesh_lines; ///< element borders
  Eigen::Matrix<double, 3, Eigen::Dynamic> control_points;
  std::vector<std::array<int, 2>> net_lines; ///< control points joined along every row
};

/// Cuts every element into divisions × divisions quadrilaterals of two triangles. Points on element borders are
/// doubled, so that fields may jump there. `field` may be null.
Tessellation tessellate(const Model<2>& model, int body, const Field<2>* field, int divisions, bool deformed);

/// Contact points along the slave face, in the order of its parameter: current and reference position, and the area
/// that the traction acts on.
struct Profile {
  std::vector<double> x, y, reference_x, reference_y, area;
  std::vector<double> pressure, traction, gap; ///< traction: tangential, signed along the slave face's direction
  std::vector<std::string> state;              ///< "open", "stick", "slip", "adhesion"
};
Profile profile(const Model<2>& model, int contact);

} // namespace signorini::model
