#include "contact/moving_faces.hpp"

#include "base/timer.hpp"

#include <utility>

namespace signorini::contact {

template <int D>
MovingFaces<D>::MovingFaces(Surface<D> slave_face, Master<D> master_face)
    : slave(std::move(slave_face)), master(std::move(master_face)), accepted_master(master),
      previous_slave_(slave.points()) {}

template <int D>
double MovingFaces<D>::move(const double* slave_displacement, const double* master_displacement, bool timed) {
  slave.move(slave_displacement);
  double seconds = 0;
  const double moved = [&] {
    const ScopedTimer timer(timed ? &seconds : nullptr);
    return master.move(master_displacement);
  }();
  // A surface point is a convex combination of control points: none moves farther than the farthest of those.
  travel += std::sqrt((slave.points() - previous_slave_).colwise().squaredNorm().maxCoeff()) + moved;
  previous_slave_ = slave.points();
  return seconds;
}

template <int D> void MovingFaces<D>::stand() {
  accepted_master = master;
  accepted_travel = travel;
}

template struct MovingFaces<2>;
template struct MovingFaces<3>;

} // namespace signorini::contact
