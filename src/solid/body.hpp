#pragma once
// A solid body: its function space, its material, and the Gauss-point tables of the reference configuration.

#include "base/eigen.hpp"
#include "nurbs/discretization.hpp"
#include "solid/material.hpp"
#include "solid/projection.hpp"
#include "solid/quadrature.hpp"

#include <memory>
#include <span>
#include <vector>

namespace signorini::solid {

/// Place of an inverted element.
struct Inversion {
  int element;
  VectorX point; ///< in the reference configuration
  double jacobian;
};

/// The Gauss points of one element in the body's tables.
struct ElementTable {
  int functions;        ///< n, number of functions on the element
  int points;           ///< Gauss points
  std::size_t function; ///< offset of its function indices
  std::size_t point;    ///< offset of its quadrature weights
  std::size_t gradient; ///< offset of its reference gradients: per point, D rows of n values ∂R_A/∂X_k
  std::size_t constant; ///< offset of the constant part of its tangent (see Kernels)
  Kernels kernels;      ///< for its material, its kind and its number of functions
};

/// A body in D dimensions, total Lagrangian: gradients with respect to the reference configuration are stored once.
template <int D> class Body {
public:
  /// Builds the tables with (degree+1) Gauss points per direction and element, with the highest degree on the element.
  /// Throws Error if the map is not right-handed somewhere (Jacobian ≤ 0), or if an axisymmetric body extends beyond
  /// its axis (R < 0).
  /// Throws Error for projected volume change under plane stress.
  Body(std::shared_ptr<const nurbs::Discretization> space, Material material, Kind kind = Kind::plane_strain,
       Volumetric volumetric = Volumetric::pointwise);
  Body(nurbs::Discretization space, Material material);

  const nurbs::Discretization& space() const { return *space_; }
  const std::shared_ptr<const nurbs::Discretization>& shared_space() const { return space_; }
  const Material& material() const { return material_; }
  Kind kind() const { return kind_; }
  Volumetric volumetric() const { return volumetric_; }
  /// Whether forces are linear in displacements: the tangent is constant.
  bool linear() const { return material_.linear(); }
  int functions() const { return space_->functions(); }
  int elements() const { return std::ssize(elements_); }
  const ElementTable& element(int e) const { return elements_[e]; }
  /// Gauss points of the whole body, in the order of its elements.
  std::size_t points() const { return weights_.size(); }
  /// Number of internal variables of the material per Gauss point; their values are stored by the caller.
  int internal_variables() const { return internal_variables_; }
  /// Largest numbers of functions and of Gauss points on one element.
  int most_functions() const { return most_functions_; }
  int most_points() const { return most_points_; }
  /// Parts of the body with a force and a tangent of their own: elements or, with projected volume change,
  /// macro-elements of several; of them in direction d; the place of part m in that direction.
  int macro_elements() const { return macros_.list.empty() ? elements() : static_cast<int>(macros_.list.size()); }
  int macro_elements(int d) const { return macros_.list.empty() ? space_->elements(d) : macros_.counts[d]; }
  int macro_index(int m, int d) const;
  std::span<const int> functions_of_macro(int m) const {
    return macros_.list.empty() ? functions_of(m) : std::span<const int>(macro(m).functions);
  }
  int most_functions_of_macro() const;
  /// Only with projected volume change: macro-element m, the one that contains element e, and the modes at a point.
  const MacroElement& macro(int m) const { return macros_.list[m]; }
  int macro_of(int e) const;
  VectorX modes_at(int m, const VectorX& xi) const;
  /// Bytes of the tables.
  std::size_t memory() const;

  std::span<const int> functions_of(int e) const {
    return std::span(functions_.data() + element(e).function, element(e).functions);
  }
  /// Quadrature weight times reference volume per Gauss point; includes the circumference 2πR in a body of revolution.
  const double* weights_of(int e) const { return weights_.data() + element(e).point; }
  const double* gradients_of(int e) const { return gradients_.data() + element(e).gradient; }
  /// ∫ R_A dV over the reference volume, per function; the sum is the body's volume.
  const VectorX& volumes() const { return volumes_; }
  /// R_A/R per Gauss point, n values each, for the hoop stretch 1 + Σ_A u_rA R_A/R; null in plane strain and 3D.
  const double* hoops_of(int e) const { return hoops_.empty() ? nullptr : hoops_.data() + element(e).gradient / D; }
  /// Kernel arguments of an element; the caller adds displacements, results and work arrays.
  KernelArguments arguments(int e) const;
  /// Reference position of Gauss point q of element e.
  VectorX reference_point(int e, int q) const;

private:
  struct Construction;
  void add_element(int e, Construction& construction);
  void add_macro_elements();
  void add_constants();

  std::shared_ptr<const nurbs::Discretization> space_;
  Material material_;
  Kind kind_;
  Volumetric volumetric_;
  std::vector<ElementTable> elements_;
  std::vector<int> functions_;
  std::vector<double> weights_, gradients_, hoops_, constants_;
  VectorX volumes_;
  MacroElements macros_; ///< empty unless the volume change is projected
  int most_functions_ = 0, most_points_ = 0, internal_variables_ = 0;
};

/// The body of revolution about x = 0 with the same meridian, space and material.
std::shared_ptr<const Body<2>> revolved(const Body<2>& body);

/// The body of unit thickness under plane stress with the same shape, space and material.
std::shared_ptr<const Body<2>> in_plane_stress(const Body<2>& body);

/// Tensor-product Gauss points of an element, degree + 1 per direction, or `times` as many.
ElementQuadrature element_quadrature(const nurbs::Discretization& space, int e, int times = 1);

} // namespace signorini::solid
