#pragma once
// Results along a tie.

#include "model/steps/model.hpp"

namespace signorini::model {

/// The force that the master exerts on the slave in the present state; the tied reference area, its fraction of the
/// slave face, and the largest distance of the two faces in the reference configuration.
template <int D> struct TieResultant {
  Vec<D> force;
  double area, part, distance;
};
template <int D> TieResultant<D> tie_resultant(const Model<D>& model, int tie);

/// One entry per quadrature point opposite the master, in the order of the slave face's elements: current and reference
/// position, reference area, and the traction on the slave per reference area. z is empty in 2D.
struct TieProfile {
  std::array<std::vector<double>, 3> position, reference, traction;
  std::vector<double> area;
  std::vector<double> pressure; ///< −t·n with the slave face's current outward normal n
  std::vector<double> shear;    ///< t·τ with its unit tangent in 2D, |t − (t·n) n| in 3D
  std::vector<double> jump;     ///< |u_m − u_s|, which vanishes in the weighted mean only
};
template <int D> TieProfile tie_profile(const Model<D>& model, int tie);

} // namespace signorini::model
