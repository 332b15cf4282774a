#include "contact/law/adhesion.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::contact {

namespace {

double strength(const Adhesion& law) {
  return law.hamaker / (2 * std::numbers::pi * law.distance * law.distance * law.distance);
}

/// T′(r) of the law without extension.
double slope(const Adhesion& law, double r) {
  const double q = law.distance / r, q3 = q * q * q, q9 = q3 * q3 * q3;
  // d/dr (r₀/r)ⁿ = −n (r₀/r)ⁿ/r
  return strength(law) * (q3 - q9 / 5) / r;
}

} // namespace

void check(const Adhesion& law) {
  require(std::isfinite(law.hamaker) && law.hamaker > 0, "contact.adhesion.hamaker", {{"value", law.hamaker}});
  require(std::isfinite(law.distance) && law.distance > 0, "contact.adhesion.distance", {{"value", law.distance}});
}

double equilibrium_distance(const Adhesion& law) {
  return law.distance * std::pow(15.0, -1.0 / 6);
}

double strongest_distance(const Adhesion& law) {
  return law.distance * std::pow(5.0, -1.0 / 6);
}

double traction(const Adhesion& law, double r) {
  const double nearest = equilibrium_distance(law);
  if (r < nearest) return slope(law, nearest) * (r - nearest); // T(r_eq) = 0
  const double q = law.distance / r, q3 = q * q * q;
  return strength(law) * (q3 * q3 * q3 / 45 - q3 / 3);
}

double stiffness(const Adhesion& law, double r) {
  return slope(law, std::max(r, equilibrium_distance(law)));
}

double potential(const Adhesion& law, double r) {
  // ∫_r^∞ T ds = A_H/(2π r₀²) [(r₀/r)⁸/360 − (r₀/r)²/6], below r_eq less T′(r_eq) (r − r_eq)²/2
  const double nearest = equilibrium_distance(law), q = law.distance / std::max(r, nearest), q2 = q * q;
  const double outside = strength(law) * law.distance * (q2 * q2 * q2 * q2 / 360 - q2 / 6);
  return r < nearest ? outside - slope(law, nearest) * (r - nearest) * (r - nearest) / 2 : outside;
}

} // namespace signorini::contact
