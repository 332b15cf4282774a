#pragma once
// The volume change of bodies with projection (projection.hpp): at the Gauss points of macro-elements, and at any
// point.

#include "solid/internal.hpp"

namespace signorini::solid {

/// Writes F, without the rows up to whole vectors, T = ∂θ/∂F (at small strains I) and θ at the Gauss points of
/// macro-element m. Returns the first inverted point, where it stops; with small strains there is none.
template <int D>
std::optional<Inversion> write_deformations(const Body<D>& body, int m, const double* displacement,
                                            MacroArrays<D>& arrays);

/// Writes the projection of values at the Gauss points of a macro-element.
template <int D>
void project(const MacroElement& macro, const VectorX& values, MacroArrays<D>& arrays, VectorX& projection);

/// The projected volume change of a body. The coefficients of a macro-element are kept until its displacements change,
/// since one of them costs as much as the force of the macro-element.
template <int D> class ProjectedVolume {
public:
  /// c = (Pθ − θ)/3 at the parametric point xi of element e, where the deformation gradient in space is f; 0 if the
  /// macro-element is inverted.
  double change(const Body<D>& body, int e, const VectorX& xi, const Mat<3>& f, const double* displacement);
  /// c at Gauss point q.
  double change_at(const Body<D>& body, int e, int q, const Mat<3>& f, const double* displacement);

private:
  struct Kept {
    std::vector<double> displacement;
    VectorX coefficients; ///< of Pθ; empty: inverted
  };
  const VectorX& coefficients(const Body<D>& body, int m, const double* displacement);

  std::vector<Kept> kept_; ///< by macro-element
  std::vector<double> displacement_;
  MacroArrays<D> arrays_;
};

} // namespace signorini::solid
