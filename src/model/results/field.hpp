#pragma once
// Scalar fields of a deformed body, by name.

#include "solid/material.hpp"

#include <string>
#include <vector>

namespace signorini::model {

/// The state at one material point.
template <int D> struct FieldPoint {
  Vec<D> displacement;
  Mat<D> deformation; ///< F
  double hoop = 1;    ///< F₃₃ of a plane body: the hoop stretch, under plane stress that of the thickness
  std::vector<double> internal = {}; ///< internal variables of the material, see solid::values_at()
  double dilation = 0; ///< c = (Pθ − θ)/3 with projected volume change, for the stress (solid/projection.hpp)
};

/// A scalar field: name for scripts, label for color bars, and function.
template <int D> struct Field {
  std::string name, label;
  double (*value)(const solid::Material& material, const FieldPoint<D>& point);
  bool of_stress = false; ///< whether it depends on FieldPoint::dilation
};

/// All fields: components and size of the displacement (ux uy u), of the Cauchy stress (sxx syy szz sxy), its von Mises
/// value, pressure = −tr σ/3, I1 = tr σ, and the deformation gradient (F11 F12 F21 F22 F33); in 3D those of z as well.
/// The stress of a linear elastic body is that of its small strains; szz of an axisymmetric body is the hoop stress,
/// F33 the hoop stretch; under plane stress szz is 0 up to rounding error.
template <int D> const std::vector<Field<D>>& fields();

/// The field of a name. Throws Error with the known names if there is none.
template <int D> const Field<D>& find_field(const std::string& name);

} // namespace signorini::model
