#pragma once
// The two faces of a contact, or a set of faces, and their motion in a step.

#include "contact/point/contact_points.hpp"
#include "contact/point/master.hpp"

#include <optional>

namespace signorini::contact {

template <int D> struct Faces {
  Surface<D> slave;
  Master<D> master;
  Master<D> accepted = master; ///< the master in the accepted state
  double travel = 0;           ///< bound on the approach of slave and master points, summed over all moves

  /// A bound on the approach of any point of the master to the slave since the accepted state.
  double master_moved() const { return master.moved_since(accepted, slave.points()); }
  /// The foot point of a slave point's position in the accepted state; none at an open end of the master.
  std::optional<MasterPoint<D>> accepted_foot(const Vec<D>& position, const Projection<D>& seed,
                                              const Lookout<D>& from = {}) const {
    FaceGeometry<D> foot;
    const Projection<D> found = accepted.project(position, seed, foot, from);
    return found.foot == Foot::none ? std::nullopt : std::optional(found.point());
  }
};

/// From where point i of a set of faces looks for its foot, on its own body in the next elements; otherwise every foot
/// counts.
template <int D> Lookout<D> lookout(const Faces<D>& faces, const ContactPoints<D>& points, std::size_t i) {
  const FaceSet<D>* set = faces.master.set();
  if (!set) return {};
  const int element = points.list[i].element, sheet = faces.slave.sheet(element);
  const Sight<D> sight{.body = set->bodies[sheet],
                       .normal = normal_at(points, faces.slave, i),
                       .left_out = set->surroundings[element],
                       .reach = {.own = near_elements * set->lengths[sheet]}};
  return {set, sheet, sight, points.reference[i], points.outward[i]};
}

} // namespace signorini::contact
