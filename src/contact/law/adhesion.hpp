#pragma once
// Van der Waals adhesion at one contact point: traction over distance [theory 9.2].

namespace signorini::contact {

/// Traction between two half spaces at distance r, from a Lennard-Jones potential between all their atoms (thesis 3.85
/// to 3.87; R. A. Sauer, J. Adhesion 2011). It acts on the slave's reference area, along the master's normal.
struct Adhesion {
  double hamaker;  ///< A_H > 0, force × length
  double distance; ///< r₀ > 0, length
};

/// Throws Error unless both are positive numbers.
void check(const Adhesion& law);

/// Distance without traction, r_eq = 15^(−1/6) r₀. Below it the law is extended linearly, by its tangent.
double equilibrium_distance(const Adhesion& law);
/// Distance of the strongest attraction, r_max = 5^(−1/6) r₀.
double strongest_distance(const Adhesion& law);
/// T(r) = A_H/(2π r₀³) [(r₀/r)⁹/45 − (r₀/r)³/3]; positive in repulsion.
double traction(const Adhesion& law, double r);
/// ∫_r^∞ T ds, energy per area: zero at infinity, negative where the traction attracts.
double potential(const Adhesion& law, double r);
/// T′(r).
double stiffness(const Adhesion& law, double r);

} // namespace signorini::contact
