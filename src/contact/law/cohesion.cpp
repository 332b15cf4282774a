#include "contact/law/cohesion.hpp"

#include "base/error.hpp"
#include "contact/constants.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::contact {

namespace {

Separation separate_exponentially(const Cohesion& law, double opening, double largest) {
  const double peak = strongest_opening(law), most = std::max(opening, largest), x = most / peak;
  if (x > broken_opening) return {0, 0, 1, 0, law.energy};
  // k = k₀ exp(−x),  k₀ = e σ_c/δ_c,  ∫T dδ − ½ T δ = G_c [1 − (1 + x + x²/2) exp(−x)]
  const double left = std::exp(-x), stiffness = std::numbers::e * law.strength / peak * left;
  const bool opens = opening >= largest;
  return {stiffness, opens ? -stiffness / peak : 0, 1 - left, opens ? left / peak : 0,
          law.energy * (1 - (1 + x + x * x / 2) * left)};
}

Separation separate_linearly(const Cohesion& law, double opening, double largest) {
  const double first = strongest_opening(law), last = 2 * law.energy / law.strength;
  const double most = std::max({opening, largest, first});
  if (most >= last) return {0, 0, 1, 0, law.energy};
  // T = σ_c (δ_f − δ)/(δ_f − δ₀),  k = T/δ,  ∫T dδ − ½ T δ = ½ (σ_c δ − T δ₀)
  const double slope = law.strength / (last - first), traction = slope * (last - most);
  const bool opens = opening >= std::max(largest, first);
  const double rate = opens ? -slope * last / (most * most) : 0;
  return {traction / most, rate, 1 - traction / most / law.stiffness, -rate / law.stiffness,
          0.5 * (law.strength * most - traction * first)};
}

Separation separate_by_formula(const Cohesion& law, double opening, double mix, double left) {
  const CohesionFormula::Left now = law.formula->left(opening, mix);
  const double stiffness = law.formula->stiffness;
  // k = (1 − d) K,  1 − d = min(1 − d₀, T/(K u)),  d₀ the damage so far
  if (now.value > left) return {left * stiffness, 0, 1 - left, 0, 0, 0, left};
  return {now.value * stiffness,
          now.of_opening * stiffness,
          1 - now.value,
          -now.of_opening,
          0,
          now.of_mix * stiffness,
          now.value};
}

} // namespace

Cohesion cohesive(std::shared_ptr<const CohesionFormula> formula) {
  return {formula->peak(0).traction, formula->rest(0, 0), Softening::exponential, 0, formula};
}

void check(const Cohesion& law) {
  require(std::isfinite(law.strength) && law.strength > 0, "contact.cohesion.strength", {{"value", law.strength}});
  require(std::isfinite(law.energy) && law.energy > 0, "contact.cohesion.energy", {{"value", law.energy}});
  if (law.softening == Softening::exponential) return;
  require(std::isfinite(law.stiffness) && law.stiffness > 0, "contact.cohesion.stiffness", {{"value", law.stiffness}});
  // δ_f > δ₀:  K > σ_c²/(2 G_c)
  const double least = law.strength * law.strength / (2 * law.energy);
  require(law.stiffness > least, "contact.cohesion.snap_back", {{"stiffness", law.stiffness}, {"least", least}});
}

double strongest_opening(const Cohesion& law) {
  if (law.formula) return law.formula->peak(0).opening;
  return law.softening == Softening::exponential ? law.energy / (std::numbers::e * law.strength)
                                                 : law.strength / law.stiffness;
}

Separation separate(const Cohesion& law, double opening, double largest, double mix, double left) {
  if (law.formula) return separate_by_formula(law, opening, mix, left);
  return law.softening == Softening::exponential ? separate_exponentially(law, opening, largest)
                                                 : separate_linearly(law, opening, largest);
}

} // namespace signorini::contact
