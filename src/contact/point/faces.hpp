#pragma once
// The two faces of a contact and their motion in a step.

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
  std::optional<MasterPoint<D>> accepted_foot(const Vec<D>& position, const Projection<D>& seed) const {
    FaceGeometry<D> foot;
    const Projection<D> found = accepted.project(position, seed, foot);
    return found.foot == Foot::none ? std::nullopt : std::optional(found.point());
  }
};

} // namespace signorini::contact
