#pragma once
// A solid body: its function space, its material, and its Gauss points.

#include "solid/projection.hpp"

#include <memory>
#include <span>

namespace signorini::solid {

/// Place of an inverted element.
struct Inversion {
  int element;
  VectorX point; ///< in the reference configuration
  double jacobian;
};

/// A body in D dimensions.
template <int D> class Body {
public:
  /// Throws Error as GaussTables does.
  Body(std::shared_ptr<const nurbs::Discretization> space, Material material, Kind kind = Kind::plane_strain,
       Volumetric volumetric = Volumetric::pointwise, double density = 1);
  Body(nurbs::Discretization space, Material material);

  const nurbs::Discretization& space() const { return *space_; }
  const std::shared_ptr<const nurbs::Discretization>& shared_space() const { return space_; }
  const Material& material() const { return material_; }
  Kind kind() const { return kind_; }
  Volumetric volumetric() const { return volumetric_; }
  /// Mass per reference volume.
  double density() const { return density_; }
  /// True if forces are linear in displacements: the tangent is constant.
  bool linear() const { return material_.linear(); }
  bool small_strains() const { return material_.small_strains(); }
  /// Number of internal variables of the material per Gauss point; their values are stored by the caller.
  int internal_variables() const { return static_cast<int>(material_.initial_values(D).size()); }
  int functions() const { return space_->functions(); }
  int elements() const { return tables_.elements(); }
  const GaussTables<D>& tables() const { return tables_; }
  /// Empty unless the volume change is projected.
  const MacroElements& macros() const { return macros_; }

  /// Parts of the body with a force and a tangent of their own: elements or, with projected volume change,
  /// macro-elements of several; of them in direction d; the place of part m in that direction.
  int macro_elements() const { return macros_.list.empty() ? elements() : static_cast<int>(macros_.list.size()); }
  int macro_elements(int d) const { return macros_.list.empty() ? space_->elements(d) : macros_.counts[d]; }
  int macro_index(int m, int d) const;
  std::span<const int> functions_of_macro(int m) const {
    return macros_.list.empty() ? tables_.functions_of(m) : std::span<const int>(macros_.list[m].functions);
  }
  /// Bytes of the tables.
  std::size_t memory() const { return tables_.memory() + macros_.memory(); }

private:
  std::shared_ptr<const nurbs::Discretization> space_;
  Material material_;
  Kind kind_;
  Volumetric volumetric_;
  double density_;
  GaussTables<D> tables_;
  MacroElements macros_;
};

/// Reference position of Gauss point q of element e.
template <int D> VectorX reference_point(const Body<D>& body, int e, int q);

/// The body of revolution about x = 0 with the same meridian, space, material and density.
std::shared_ptr<const Body<2>> revolved(const Body<2>& body);

/// The body of unit thickness under plane stress with the same shape, space, material and density.
std::shared_ptr<const Body<2>> in_plane_stress(const Body<2>& body);

} // namespace signorini::solid
