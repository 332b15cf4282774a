#pragma once
// What a model is made of, in numbers: unknowns, elements, points, nonzeros, bytes.

#include "model/model.hpp"

namespace signorini::model {

struct BodyCost {
  int unknowns;      ///< those shared by control points count once
  int contact_layer; ///< of these, on the rows of the contact faces
  int prescribed;    ///< degrees of freedom that supports prescribe
  int elements;
  long gauss_points;
};
template <int D> BodyCost body_cost(const Model<D>& model, int body);

/// Contact points with so many per slave element and direction, if no region leaves any out.
template <int D> int points_everywhere(const Model<D>& model, int contact, int per_direction);
/// Whether a region leaves points of the slave face out.
template <int D> bool limited(const Model<D>& model, int contact) {
  const auto k = static_cast<std::size_t>(contact);
  return static_cast<int>(model.system.contacts[k]->points().size()) <
         points_everywhere(model, contact, model.system.scene.contacts[k].points);
}

/// The accepted target of a support's component among those it drives, or of a load's; the other index is −1. 0 where
/// the component is −1.
template <int D> double accepted_value(const Model<D>& model, int support, int load, int component);

/// Bytes.
struct MemoryCost {
  double bodies;   ///< tables of Gauss points
  double contacts; ///< points with their history, and what the last evaluation made
  double tangent;  ///< with its patterns
  double factors;
  bool measured; ///< whether the linear solver has told `factors`; otherwise counted (solve/factor_estimate.hpp)
  solve::LinearKind solver;
};
template <int D> MemoryCost memory_cost(const Model<D>& model);

} // namespace signorini::model
