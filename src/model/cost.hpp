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
