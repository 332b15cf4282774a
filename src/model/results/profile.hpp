#pragma once
// Results along a contact, one entry per contact point.

#include "contact/gauss/contact_area.hpp"
#include "model/steps/model.hpp"

namespace signorini::model {

/// Contact points in the order of the slave face's parameters: current and reference position, and the area on which
/// the traction acts. In 2D z and the components of the traction are empty.
struct Profile {
  std::vector<double> x, y, z, reference_x, reference_y, reference_z, area;
  std::vector<double> pressure, gap;
  std::vector<double> inside;   ///< 1 in the contact area, 0 outside
  std::vector<double> traction; ///< tangential: signed along the slave face's direction (2D), |t_T| (3D)
  std::vector<double> damage;   ///< of the points' bonds; empty unless the contact is cohesive
  std::vector<double> mix;      ///< share of shear in the energy that these have dissipated; empty unless by formula
  std::vector<double> mu, slip; ///< coefficient of friction, slip since the touch; empty without friction
  std::vector<double> worn;     ///< depth of wear; empty without wear
  std::vector<double> traction_x, traction_y, traction_z; ///< t_T; the traction on the slave is t_N n̄ − t_T
  std::vector<std::string> state;                         ///< contact::name_of()
  std::vector<std::string> face;                          ///< of a set of faces "<body>.<face>", otherwise empty
};
template <int D> Profile profile(const Model<D>& model, int contact);

/// The contact area in a state, to which the faces have been moved.
template <int D>
contact::ContactArea contact_area(const Model<D>& model, std::size_t contact, const contact::History<D>& history);

} // namespace signorini::model
