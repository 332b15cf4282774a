#pragma once
// The zone of contact around the largest pressure of a contact, pressures averaged over slave elements, and mean slip.

#include "contact/gauss/formulation.hpp"

namespace signorini::contact {

/// Extent along one direction of the slave face, through the element with the largest pressure. Open elements end it.
struct ZoneExtent {
  double elements = 0; ///< by the share of an element's points that touch
  int edges = 0;       ///< its ends at which the face or the region of the contact ends, 0 to 2
};
template <int D> struct PeakZone {
  int element; ///< of the largest pressure
  std::array<ZoneExtent, D - 1> extent;
};

/// Empty if no point has a pressure.
template <int D> std::optional<PeakZone<D>> peak_zone(const Formulation<D>& formulation, const History<D>& history);

/// The largest mean pressure over a slave element, Σ p a / Σ a with the areas a of its points, those of open points in
/// the reference configuration.
template <int D> double mean_pressure(const ContactPoints<D>& points, const History<D>& history);

/// The mean slip since the touch over the points that touch, Σ γ a / Σ a with their areas a; 0 without any.
template <int D> double mean_slip(const History<D>& history);

} // namespace signorini::contact
