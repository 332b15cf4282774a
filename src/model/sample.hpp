#pragma once
// A model's present state at points of its bodies.

#include "model/field.hpp"
#include "model/model.hpp"

namespace signorini::model {

/// The state of a body at parametric point xi of element e. Where ∂X/∂ξ is singular (poles, collapsed edges) the
/// deformation gradient is not finite.
template <int D> struct BodyPoint {
  Vec<D> reference; ///< X
  Mat<D> jacobian;  ///< ∂X/∂ξ
  FieldPoint<D> state;
};
template <int D> BodyPoint<D> body_point(const Model<D>& model, int body, int e, const VectorX& xi);

/// As body_point with gradients that are finite: where ∂X/∂ξ is singular at a pole those of a point close by within the
/// element; between a corner where its columns are parallel and the nearest Gauss point those of that point; so where a
/// body that is not linear is inverted between its Gauss points.
template <int D> BodyPoint<D> regular_point(const Model<D>& model, int body, int e, const VectorX& xi);

/// A field's value at a parametric point. Throws Error when xi lies outside the body.
template <int D> double sample(const Model<D>& model, int body, const Field<D>& field, const VectorX& xi);

} // namespace signorini::model
