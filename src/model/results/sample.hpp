#pragma once
// The present state at points of bodies.

#include "model/results/field.hpp"
#include "model/steps/model.hpp"

namespace signorini::model {

/// A point of a body and its state. Where ∂X/∂ξ is singular (poles, collapsed edges) the deformation gradient is not
/// finite.
template <int D> struct BodyPoint {
  Vec<D> reference; ///< X
  Mat<D> jacobian;  ///< ∂X/∂ξ
  FieldPoint<D> state;
  int element; ///< the gradients are those at xi of this element
  Vec<D> xi;
};
/// At parametric point xi of element e. The state is without projected volume change, see add_volume_change().
template <int D> BodyPoint<D> body_point(const Model<D>& model, int body, int e, const VectorX& xi);

/// As body_point(), but with finite gradients: at a pole, where ∂X/∂ξ is singular, those of a nearby point in the
/// element; between a corner with parallel columns of ∂X/∂ξ and the nearest Gauss point, and where a nonlinear body is
/// inverted between Gauss points, those of the nearest Gauss point.
template <int D> BodyPoint<D> regular_point(const Model<D>& model, int body, int e, const VectorX& xi);

/// Adds the projected volume change of a body, if it has one, for the stress.
template <int D> void add_volume_change(const Model<D>& model, int body, BodyPoint<D>& point);

/// A field's value at a point of a body.
template <int D> double value_at(const Model<D>& model, int body, const Field<D>& field, BodyPoint<D> point);

/// A field's value at a parametric point. Throws Error if xi lies outside the body.
template <int D> double sample(const Model<D>& model, int body, const Field<D>& field, const VectorX& xi);

} // namespace signorini::model
