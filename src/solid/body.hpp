#pragma once
// A solid body: its function space, its material, and the Gauss-point tables of the reference configuration.

#include "base/eigen.hpp"
#include "nurbs/discretisation.hpp"
#include "solid/kernel.hpp"
#include "solid/material.hpp"

#include <span>
#include <vector>

namespace signorini::solid {

/// Where an element turned inside out.
struct Inversion {
  int element;
  VectorX point; ///< in the reference configuration
  double jacobian;
};

/// The Gauss points of one element in the body's tables.
struct ElementTable {
  int functions;        ///< n, how many functions live on it
  int points;           ///< Gauss points
  std::size_t function; ///< offset of its function indices
  std::size_t point;    ///< offset of its point weights
  std::size_t gradient; ///< offset of its reference gradients: per point, D rows of n values ∂R_A/∂X_k
  std::size_t constant; ///< offset of its constant n×n matrix Σ w μ ∇R_A·∇R_B
  Kernel kernel;        ///< for its number of functions
};

/// A body in D dimensions, total Lagrangian: gradients with respect to the reference configuration are stored once.
template <int D> class Body {
public:
  /// Builds the tables with (degree+1) Gauss points per direction and element, the degree being the highest that lives
  /// there. Throws Error when the map is not right-handed somewhere (Jacobian ≤ 0).
  Body(nurbs::Discretisation space, NeoHookean material);

  const nurbs::Discretisation& space() const { return space_; }
  const NeoHookean& material() const { return material_; }
  int functions() const { return space_.functions(); }
  int elements() const { return static_cast<int>(elements_.size()); }
  const ElementTable& element(int e) const { return elements_[static_cast<std::size_t>(e)]; }
  /// Most functions, and most Gauss points, on one element.
  int most_functions() const { return most_functions_; }
  int most_points() const { return most_points_; }

  std::span<const int> functions_of(int e) const {
    return {functions_.data() + element(e).function, static_cast<std::size_t>(element(e).functions)};
  }
  const double* weights_of(int e) const { return weights_.data() + element(e).point; }
  const double* gradients_of(int e) const { return gradients_.data() + element(e).gradient; }
  const double* constant_of(int e) const { return constants_.data() + element(e).constant; }
  /// Reference position of Gauss point q of element e.
  VectorX reference_point(int e, int q) const;

private:
  nurbs::Discretisation space_;
  NeoHookean material_;
  std::vector<ElementTable> elements_;
  std::vector<int> functions_;
  std::vector<double> weights_, gradients_, constants_;
  int most_functions_ = 0, most_points_ = 0;
};

/// Tensor-product Gauss points of an element: parametric positions (columns) and weights of the parametric box.
struct ElementQuadrature {
  MatrixX points;
  VectorX weights;
};
ElementQuadrature element_quadrature(const nurbs::Discretisation& space, int e);

} // namespace signorini::solid
