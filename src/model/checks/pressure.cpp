#include "model/checks/pressure.hpp"

#include "base/error.hpp"
#include "model/scene/thickness.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

constexpr int sampled_gaps = 200, sampled_places = 20;
/// Rounding error of a pressure, relative to the largest one.
constexpr double pressure_rounding = 1e-9;

template <int D> void check(const Contact<D>& contact, const contact::ContactPoints<D>& points, double depth) {
  const contact::PressureFormula& law = *contact.method.law.pressure;
  const bool bounded = std::isfinite(law.clearance);
  const double top = bounded ? law.clearance : depth;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / sampled_places);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const Vec<3> place = contact::place_of(points.reference[i]);
    double largest = 0;
    for (int k = 0; k <= sampled_gaps; ++k) {
      const double gap = top - (top + depth) * k / sampled_gaps;
      const contact::GapResponse found = law(gap, place);
      require(std::isfinite(found.pressure) && std::isfinite(found.rate), "model.pressure.finite",
              {{"contact", contact.name}, {"gap", gap}, {"value", found.pressure}});
      largest = std::max(largest, std::abs(found.pressure));
      const double rounding = pressure_rounding * largest;
      require(found.pressure <= 0 || found.rate * depth <= rounding, "model.pressure.falls",
              {{"contact", contact.name}, {"gap", gap}, {"value", found.rate}});
      const bool reference = contact.method.law.per == contact::TractionArea::reference;
      require(found.pressure >= -rounding || k == 0 || reference, "model.pressure.pulls",
              {{"contact", contact.name}, {"gap", gap}, {"value", found.pressure}});
    }
    require(largest > 0, "model.pressure.none", {{"contact", contact.name}, {"gap", -depth}});
    const double rest = bounded ? law(top, place).pressure : 0;
    require(std::abs(rest) <= pressure_rounding * largest, "model.pressure.clearance",
            {{"contact", contact.name}, {"gap", top}, {"value", rest}});
  }
}

} // namespace

template <int D> void check_pressures(const System<D>& system) {
  for (std::size_t k = 0; k < system.contacts.size(); ++k) {
    const Contact<D>& contact = system.scene.contacts[k];
    if (contact.method.law.pressure && !contact.own)
      check(contact, system.contacts[k]->points(), 0.5 * thinner_body(system.scene, contact));
  }
}

template void check_pressures(const System<2>&);
template void check_pressures(const System<3>&);

} // namespace signorini::model
