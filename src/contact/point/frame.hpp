#pragma once
// Friction in the tangent plane of a contact: axes of the plane, and the return mapping in them.

#include "contact/law/wear.hpp"
#include "contact/point/local.hpp"

#include <optional>

namespace signorini::contact {

/// Plane normal to N, n = N/|N|, with the direction e₁ of a vector a in it and in space e₂ = n × e₁, and their
/// derivatives:
///   δn = turn δN,   δe₁ = −(e₁·δn) n + φ e₂,   δe₂ = −(e₂·δn) n − φ e₁,   φ = spin_normal δn + spin_along δa.
template <int D> struct Frame {
  Vec<D> normal;
  Eigen::Matrix<double, D, D - 1> axes;
  Mat<D> turn;
  Eigen::Matrix<double, 1, D> spin_normal = Eigen::Matrix<double, 1, D>::Zero(), spin_along = spin_normal; ///< 3D only
};
template <int D> Frame<D> frame_of(const Vec<D>& normal, const Vec<D>& along);

/// State to which a closed point or multiplier is fixed, and Controls::tie().
struct FrictionControl {
  FixedContactState fixed;
  double tie;
  Interface interface = {};
};

/// Derivatives of a pressure with respect to a slip V, N and a.
template <int D> struct PlaneGradient { Vec<D> of_slip, of_normal, of_along; };

/// Friction t = Σ t_i e_i of a slip V, and its derivatives with respect to V, N and a at constant pressure.
template <int D> struct PlaneSlide {
  Rubbing<D - 1> rubbing;  ///< in components
  FaceCoordinates<D> slip; ///< e_i·V
  Vec<D> friction, of_pressure = Vec<D>::Zero();
  Mat<D> of_slip, of_normal, of_along;
  std::optional<PlaneGradient<D>> worn = {}; ///< of the pressure at a constant gap, where the point wears
};

/// Returns the trial ε_T (η_i + e_i·V) to the law, η_i the elastic slip of the accepted state. Pressure and gap as in
/// rub().
template <int D>
PlaneSlide<D> slide_in(const Frame<D>& frame, const InterfaceLaw& law, const FaceCoordinates<D>& elastic,
                       const Vec<D>& slip, const GapResponse& unworn, double gap, const FrictionControl& control);

/// The friction of a law with an axis at a point, of a slip v.
template <int D>
PlaneSlide<D> slide_along_axes(const InterfaceLaw& law, const LocalGeometry<D>& geometry, const Vec<D>& slip,
                               const GapResponse& unworn);
/// Its derivatives at constant pressure, from δv and δn̄.
template <int D>
LocalBlock<D> friction_rows(const PlaneSlide<D>& found, const LocalGeometry<D>& geometry, const LocalBlock<D>& slip,
                            const GapRows<D>& gap);
/// That of the pressure at a constant gap.
template <int D>
LocalRow<D> pressure_row(const PlaneSlide<D>& found, const LocalGeometry<D>& geometry, const LocalBlock<D>& slip,
                         const GapRows<D>& gap);

} // namespace signorini::contact
