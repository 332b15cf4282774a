#pragma once
// A slave face and its master in motion, with what bounds how near their points can have come to each other.

#include "contact/master.hpp"

namespace signorini::contact {

template <int D> struct MovingFaces {
  MovingFaces(Surface<D> slave, Master<D> master);

  /// Takes over displacements: D values per function of the slave's body; of the master's body, or of an obstacle's
  /// translation. Returns the seconds that moving the search tree took where `timed`.
  double move(const double* slave_displacement, const double* master_displacement, bool timed = false);
  /// The faces stand in the accepted state.
  void stand();

  Surface<D> slave;
  Master<D> master;
  Master<D> accepted_master; ///< where it is in the accepted state
  /// Bound on how far slave and master points have moved towards each other, summed over all moves, and when the
  /// accepted state was reached or returned to.
  double travel = 0, accepted_travel = 0;

private:
  Eigen::Matrix<double, D, Eigen::Dynamic> previous_slave_;
};

} // namespace signorini::contact
