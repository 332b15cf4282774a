#pragma once
// The present state at points of bodies.

#include "model/field.hpp"
#include "model/model.hpp"

namespace signorini::model {

/// A point of a body and its state. Where ∂X/∂ξ is singular (poles, collapsed edges) the deformation gradient is not
/// finite.
template <int D> struct BodyPoint {
  Vec<D> reference; ///< X
  Mat<D> jacobian;  ///< ∂X/∂ξ
  FieldPoint<D> state;
};
/// At parametric point xi of element e.
template <int D> BodyPoint<D> body_point(const Model<D>& model, int body, int e, const VectorX& xi);

/// As body_point(), but with finite gradients: at a pole, where ∂X/∂ξ is singular, those of a nearby point in the
/// element; between a corner with parallel columns of ∂X/∂ξ and the nearest Gauss point, and where a nonlinear body is
/// inverted between Gauss points, those of the nearest Gauss point.
template <int D> BodyPoint<D> regular_point(const Model<D>& model, int body, int e, const VectorX& xi);

/// A field's value at a parametric point. Throws Error if xi lies outside the body.
template <int D> double sample(const Model<D>& model, int body, const Field<D>& field, const VectorX& xi);

} // namespace signorini::model
