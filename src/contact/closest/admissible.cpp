#include "contact/closest/admissible.hpp"

#include "contact/constants.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

template <int D>
bool admissible(const Lookout<D>& from, const FaceGeometry<D>& foot, const Vec<D>& normal, double gap, bool kept) {
  if (!from.set) return true;
  const int sheet = from.set->reference.sheet(foot.element);
  // g ≥ −½ t̄
  if (!(gap >= -deepest_part * from.set->thickness[sheet])) return false;
  if (from.set->bodies[sheet] != from.sight.body) return true;
  // n_s·n̄ ≤ ½
  const bool faces = from.sight.normal.dot(normal) <= least_facing_cosine;
  if (!(faces || kept)) return false;
  if (faces && gap >= 0) return true;
  // Across a void, N_s·N̄ < 0 and (X_s − X̄)·N̄ ≥ 0, or g ≥ −¼ (|X_s − X̄| − β)
  FaceGeometry<D> reference;
  from.set->reference.locate(foot.element, foot.xi, 1, reference);
  const Vec<D> apart = from.place - reference.position, there = outward(from.set->reference, reference).normalized();
  if (faces && from.outward.dot(there) < 0 && apart.dot(there) >= 0) return true;
  // Not the point itself, of which a search may lead to the surroundings
  if (!faces && apart.norm() <= from.set->lengths[sheet]) return false;
  // Through the body, as around a convex corner: β = ⟨−(X_s − X̄)·N̄⟩ + ⟨(X_s − X̄)·N_s⟩ ≤ 2 t
  const double thin = std::min(from.set->thickness[sheet], from.set->thickness[from.sheet]);
  const double through = std::min(std::max(-apart.dot(there), 0.0) + std::max(apart.dot(from.outward), 0.0), 2 * thin);
  return std::abs(gap) <= deepest_own * (apart.norm() - through);
}

template bool admissible(const Lookout<2>&, const FaceGeometry<2>&, const Vec<2>&, double, bool);
template bool admissible(const Lookout<3>&, const FaceGeometry<3>&, const Vec<3>&, double, bool);

} // namespace signorini::contact
