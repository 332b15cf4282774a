#include "model/checks/neutral_motion.hpp"

#include "base/index.hpp"
#include "base/orthonormal.hpp"
#include "model/constants.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace signorini::model {

namespace {

template <int D> using Points = Eigen::Matrix<double, D, Eigen::Dynamic>;

/// v(x) = at + gradient · x.
template <int D> struct RigidMotion {
  Vec<D> at;
  Mat<D> gradient;
};

/// The rigid part of a body's displacements; empty if it has no unconstrained motion or others prevail.
template <int D> std::optional<Points<D>> rigid_part(System<D>& system, std::size_t body, const VectorX& direction) {
  std::vector<VectorX> motions;
  for (const auto& [mover, motion] : system.unconstrained())
    if (at(mover) == body) motions.push_back(motion);
  if (motions.empty()) return std::nullopt;
  const auto size = motions.front().size();
  MatrixX columns(size, static_cast<Eigen::Index>(motions.size()));
  for (std::size_t m = 0; m < motions.size(); ++m) columns.col(static_cast<Eigen::Index>(m)) = motions[m];
  const VectorX all = system.unknowns.spread(direction);
  const VectorX own = all.segment(system.unknowns.offset(static_cast<int>(body)), size);
  const VectorX rigid = own - residual_of(orthonormal(columns), own);
  if (rigid.squaredNorm() < rigid_share * all.squaredNorm()) return std::nullopt;
  return Points<D>(rigid.reshaped(D, size / D));
}

template <int D> RigidMotion<D> fitted(const Points<D>& points, const Points<D>& moves) {
  MatrixX columns(points.cols(), D + 1);
  columns.col(0).setOnes();
  columns.rightCols(D) = points.transpose();
  const MatrixX coefficients = pseudo_inverse(columns) * moves.transpose();
  return {coefficients.row(0).transpose(), coefficients.bottomRows(D).transpose()};
}

/// The center of the circle or sphere on which points lie, of |x|² = 2 c·x + d; nothing if they do not.
std::optional<VectorX> center_of(const MatrixX& points) {
  constexpr double round = 1e-6, flat = 1e6; // squared radius per squared extent
  const VectorX middle = points.rowwise().mean();
  const MatrixX relative = points.colwise() - middle;
  MatrixX columns(points.cols(), points.rows() + 1);
  columns.leftCols(points.rows()) = 2 * relative.transpose();
  columns.rightCols(1).setOnes();
  const VectorX squares = relative.colwise().squaredNorm().transpose();
  const VectorX solution = pseudo_inverse(columns) * squares;
  if (!solution.allFinite()) return std::nullopt;
  const VectorX center = solution.head(points.rows());
  const VectorX distances = (relative.colwise() - center).colwise().squaredNorm().transpose();
  const double mean = distances.mean();
  const bool is_round = (distances.array() - mean).abs().maxCoeff() < round * mean; // false for nan
  if (!is_round || mean > flat * squares.maxCoeff()) return std::nullopt;
  return VectorX(center + middle);
}

/// The center of a face that is round about the axis of a rotation: in space a sphere, or a cylinder along it.
template <int D> std::optional<VectorX> center_of_rotation(const Points<D>& points, const Mat<D>& spin) {
  if (const auto center = center_of(points); center || D == 2 || spin.isZero(0)) return center;
  Mat<D> across = -spin * spin / (0.5 * spin.squaredNorm()); // projector onto the plane of rotation
  Eigen::Index along = 0; // its column that is shortest, zero where the axis is one of coordinates
  across.colwise().squaredNorm().minCoeff(&along);
  across.col(along).swap(across.col(D - 1));
  const MatrixX plane = orthonormal(MatrixX(across)).leftCols(2);
  const auto center = center_of(plane.transpose() * points);
  if (!center) return std::nullopt;
  return VectorX(plane * *center);
}

/// Whether a body touches others and obstacles by round faces only, which turn about their centers or roll on planes.
template <int D> bool rolls(const Model<D>& model, int body, const RigidMotion<D>& motion) {
  constexpr double small = 0.05;
  const Mat<D> spin = 0.5 * (motion.gradient - motion.gradient.transpose());
  bool touches = false;
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k) {
    const Contact<D>& contact = model.system.scene.contacts[k];
    if (!acts_on(contact, body) || contact::resultant(model.accepted.contacts[k]).active == 0) continue;
    touches = true;
    const auto* obstacle = std::get_if<ObstacleReference>(&contact.master);
    if (!contact.slave.on(body)) return false;
    const auto& reference = model.system.contacts[k]->points().reference;
    Points<D> points(D, static_cast<Eigen::Index>(reference.size()));
    for (std::size_t i = 0; i < reference.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = reference[i];
    const auto center = center_of_rotation<D>(points, spin);
    if (!center) return false;
    const bool flat =
        obstacle && std::holds_alternative<contact::Plane<D>>(model.system.scene.obstacles[at(obstacle->obstacle)]);
    const double radius = (points.colwise() - Vec<D>(*center)).norm() / std::sqrt(static_cast<double>(points.cols()));
    const double moved = (motion.at + motion.gradient * *center).norm();
    if (!flat && moved > small * spin.norm() * radius) return false;
  }
  return touches;
}

/// The sum of the forces of the contacts.
template <int D> double contact_force(const Model<D>& model) {
  double sum = 0;
  for (const contact::History<D>& history : model.accepted.contacts)
    for (const contact::PointResult<D>& point : history.results) sum += point.force.norm();
  return sum;
}

} // namespace

template <int D> bool is_neutral(Model<D>& model, const VectorX& direction, double stiffness) {
  System<D>& system = model.system;
  for (std::size_t b = 0; b < system.scene.bodies.size(); ++b) {
    const auto moves = rigid_part(system, b, direction);
    if (!moves) continue;
    const double largest = moves->template lpNorm<Eigen::Infinity>();
    if (-stiffness < neutral_share * contact_force(model) / system.extent * largest * largest) return true;
    return rolls(model, static_cast<int>(b), fitted<D>(system.scene.bodies[b].body->space().points(), *moves));
  }
  return false;
}

template bool is_neutral(Model<2>&, const VectorX&, double);
template bool is_neutral(Model<3>&, const VectorX&, double);

} // namespace signorini::model
