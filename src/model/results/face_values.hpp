#pragma once
// Interpolated results of contacts on their slave faces, for pictures and samples.

#include "model/steps/model.hpp"

#include <limits>
#include <optional>
#include <string>

namespace signorini::model {

/// A field that is defined on slave faces only; damage: of cohesive contacts; mu and slip: of contacts with friction;
/// worn: of those with wear.
enum class FaceField { pressure, damage, mu, slip, worn };
constexpr FaceField face_fields[] = {FaceField::pressure, FaceField::damage, FaceField::mu, FaceField::slip,
                                     FaceField::worn};
/// "contact_pressure", "damage", "mu", "slip", "worn"; none: another field.
std::optional<FaceField> face_field(const std::string& name);
const char* name_of(FaceField field);
const char* label_of(FaceField field);
/// True if a contact has it.
template <int D> bool has(const Contact<D>& contact, FaceField field) {
  if (field == FaceField::damage) return contact.method.bond.has_value();
  if (field == FaceField::worn) return contact.method.law.wear.has_value();
  return field == FaceField::pressure || may_rub(contact.method.law);
}

/// The value inside bodies and on faces without it: pressure is 0 there, other fields do not exist.
constexpr double elsewhere(FaceField field) {
  return field == FaceField::pressure ? 0 : std::numeric_limits<double>::quiet_NaN();
}

/// The values at the contact points of one of the slave faces, one column per element of this face; 0 at points outside
/// the region.
template <int D> MatrixX contact_point_values(const Model<D>& model, FaceField field, int contact, std::size_t face);

/// A field on a slave face: linear in each direction between the contact points of an element, constant beyond
/// the outer ones, 0 at points outside the region.
template <int D> class FaceValues {
public:
  FaceValues(const Model<D>& model, FaceField field, int contact, std::size_t face);

  const nurbs::Side& side() const { return side_; }
  /// At fractions of the parametric intervals of the face's element e (ξ¹ fastest).
  double at_place(int e, const contact::FaceCoordinates<D>& fraction) const;

private:
  nurbs::Side side_;
  int points_;                 ///< per element and direction
  std::vector<double> places_; ///< of the points in one direction, as fractions of the element
  MatrixX values_;             ///< contact_point_values()
};

/// A field at a parametric point, summed over the contacts that have it and whose slave face contains the point. Throws
/// Error if there is none or xi lies outside the body.
template <int D> double sample_face(const Model<D>& model, FaceField field, int body, const VectorX& xi);

} // namespace signorini::model
