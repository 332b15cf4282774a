#pragma once
// The Gauss points of a body in its reference configuration, tabulated element by element.

#include "nurbs/discretization.hpp"
#include "solid/material.hpp"
#include "solid/quadrature.hpp"

#include <span>
#include <vector>

namespace signorini::solid {

/// The Gauss points of one element in the tables.
struct ElementTable {
  int functions;        ///< n, number of functions on the element
  int points;           ///< Gauss points
  std::size_t function; ///< offset of its function indices
  std::size_t point;    ///< offset of its quadrature weights
  std::size_t gradient; ///< offset of its reference gradients: per point, D rows of n values ∂R_A/∂X_k
  std::size_t constant; ///< offset of the constant part of its tangent (see Kernels)
  Kernels kernels;      ///< for its material, its kind and its number of functions
};

/// Total Lagrangian: gradients with respect to the reference configuration are stored once [theory 2.8].
template <int D> class GaussTables {
public:
  /// (degree+1) Gauss points per direction and element, with the highest degree on the element. Throws Error if the map
  /// is not right-handed somewhere (Jacobian ≤ 0), if an axisymmetric body extends beyond its axis (R < 0), and for
  /// projected volume change under plane stress.
  GaussTables(const nurbs::Discretization& space, const Material& material, Kind kind, Volumetric volumetric);

  int elements() const { return std::ssize(elements_); }
  const ElementTable& element(int e) const { return elements_[e]; }
  /// Gauss points of the whole body, in the order of its elements.
  std::size_t points() const { return weights_.size(); }
  /// Largest numbers of functions and of Gauss points on one element.
  int most_functions() const { return most_functions_; }
  int most_points() const { return most_points_; }
  std::span<const int> functions_of(int e) const {
    return std::span(functions_.data() + element(e).function, element(e).functions);
  }
  /// Quadrature weight times reference volume per Gauss point; includes the circumference 2πR in a body of revolution.
  const double* weights_of(int e) const { return weights_.data() + element(e).point; }
  const double* gradients_of(int e) const { return gradients_.data() + element(e).gradient; }
  /// R_A/R per Gauss point, n values each, for the hoop stretch 1 + Σ_A u_rA R_A/R; null in plane strain and 3D.
  const double* hoops_of(int e) const { return hoops_.empty() ? nullptr : hoops_.data() + element(e).gradient / D; }
  /// ∫ R_A dV over the reference volume, per function; the sum is the body's volume.
  const VectorX& volumes() const { return volumes_; }
  /// Kernel arguments of an element; the caller adds displacements, results and work arrays.
  KernelArguments arguments(int e, const Material& material) const;
  /// Bytes of the tables.
  std::size_t memory() const;

private:
  struct Construction;
  void add_element(int e, Construction& construction);
  void add_constants(const Material& material);

  std::vector<ElementTable> elements_;
  std::vector<int> functions_;
  std::vector<double> weights_, gradients_, hoops_, constants_;
  VectorX volumes_;
  int most_functions_ = 0, most_points_ = 0;
};

/// Tensor-product Gauss points of an element, degree + 1 per direction, or `times` as many.
ElementQuadrature element_quadrature(const nurbs::Discretization& space, int e, int times = 1);

} // namespace signorini::solid
