#pragma once
// Interpolated contact pressure, for pictures and samples.

#include "model/model.hpp"

namespace signorini::model {

/// The pressures at the contact points of one of the slave faces, one column per element of this face; 0 at points
/// outside the region.
template <int D> MatrixX contact_point_pressures(const Model<D>& model, int contact, std::size_t face);

/// Contact pressure on a slave face: linear in each direction between the contact points of an element, constant beyond
/// the outer ones, 0 at points outside the region.
template <int D> class FacePressure {
public:
  FacePressure(const Model<D>& model, int contact, std::size_t face);

  const nurbs::Side& side() const { return side_; }
  /// At fractions of the parametric intervals of the face's element e (ξ¹ fastest).
  double at_place(int e, const contact::FaceCoordinates<D>& fraction) const;

private:
  nurbs::Side side_;
  int points_;                 ///< per element and direction
  std::vector<double> places_; ///< of the points in one direction, as fractions of the element
  MatrixX values_;             ///< contact_point_pressures()
};

/// Contact pressure at a parametric point, summed over the contacts whose slave face contains it. Throws Error if there
/// is none or xi lies outside the body.
template <int D> double sample_contact_pressure(const Model<D>& model, int body, const VectorX& xi);

} // namespace signorini::model
