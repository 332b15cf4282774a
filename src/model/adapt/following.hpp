#pragma once
// Layers that follow the contact: the elements of the contact faces that touch, and models with the layer there.

#include "model/adapt/adaptation.hpp"

namespace signorini::model {

/// A direction along a contact face of a body with a layer, by the elements of its plan (nurbs::Plan).
struct LayerLine {
  int body;
  std::size_t face;         ///< index into Discretization::contact()
  int direction;            ///< along that face
  std::vector<bool> raised; ///< the elements that have the layer
  /// By element, 0 if none of its points is in contact, otherwise positive: the largest jump, in any of them,
  /// between the traction of the contact and that of the body's stress on the face, relative to the largest traction
  /// of the contact; at least `touch`.
  std::vector<double> jump;
};
inline constexpr double touch = 1e-300;

/// All lines of all bodies with a layer, without jumps.
template <int D> std::vector<LayerLine> layer_lines(const Model<D>& model);
/// Sets the jumps of the accepted state. `measured`: by tractions; otherwise elements in contact have the jump 1.
template <int D> void mark_contact(const Model<D>& model, bool measured, std::vector<LayerLine>& lines);

/// Where the layers of all bodies are, as in their plans; of bodies without a layer an empty list.
template <int D> std::vector<nurbs::RaisedElements> layers(const Model<D>& model);
/// The layers by lines.
template <int D> std::vector<nurbs::RaisedElements> layers(const Model<D>& model, const std::vector<LayerLine>& lines);
/// The model with its layers there, see with_bodies().
template <int D>
std::shared_ptr<Model<D>> with_layers(const Model<D>& model, const std::vector<nurbs::RaisedElements>& layers);

/// Throws Error if no body has a layer, or as check_replaceable().
template <int D> void check_following(const Model<D>& model);

} // namespace signorini::model
