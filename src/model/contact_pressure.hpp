#pragma once
// The pressure of a contact between its contact points, for pictures and samples.

#include "model/model.hpp"

namespace signorini::model {

/// The pressures at the contact points of each slave element, one column per element; 0 at those that a region leaves
/// out.
template <int D> MatrixX contact_point_pressures(const Model<D>& model, int contact);

/// The pressures at the contact points of a slave face: between an element's points linear in each direction, beyond
/// the outer ones constant; 0 where the contact does not act.
template <int D> class FacePressure {
public:
  FacePressure(const Model<D>& model, int contact);

  const nurbs::Side& side() const { return side_; }
  /// In element e of the face, ξ¹ running fastest; fractions of its way in the face's directions.
  double at_place(int e, const contact::FaceCoordinates<D>& fraction) const;

private:
  nurbs::Side side_;
  int points_;                 ///< per element and direction
  std::vector<double> places_; ///< of these in a direction, as fractions of the element
  MatrixX values_;             ///< contact_point_pressures()
};

/// The sum of the contacts in which faces of the body that xi lies on are slaves. Throws Error when there is none.
template <int D> double sample_contact_pressure(const Model<D>& model, int body, const VectorX& xi);

} // namespace signorini::model
