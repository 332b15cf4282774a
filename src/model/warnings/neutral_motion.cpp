#include "model/warnings/neutral_motion.hpp"

#include "base/orthonormal.hpp"
#include "model/checks/outline.hpp"
#include "model/constants.hpp"
#include "model/system/damping.hpp"
#include "solve/eigenpairs.hpp"

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

/// The rigid part of the displacements of bodies that move as one; empty if they have no unconstrained motion or others
/// prevail.
template <int D>
std::optional<Points<D>> rigid_part(System<D>& system, const std::vector<int>& group, const VectorX& direction) {
  const VectorX all = system.unknowns.spread(direction);
  VectorX own(0);
  MatrixX columns(0, 0);
  for (const int b : group) {
    std::vector<VectorX> motions; // of all bodies of the group in the same order
    for (const auto& [body, motion] : system.unconstrained())
      if (body == b) motions.push_back(motion);
    if (motions.empty()) return std::nullopt;
    const auto size = motions.front().size();
    own.conservativeResize(own.size() + size);
    own.tail(size) = all.segment(system.unknowns.offset(b), size);
    columns.conservativeResize(own.size(), static_cast<Eigen::Index>(motions.size()));
    for (std::size_t m = 0; m < motions.size(); ++m) columns.col(static_cast<Eigen::Index>(m)).tail(size) = motions[m];
  }
  const VectorX rigid = own - residual_of(orthonormal(columns), own);
  if (rigid.squaredNorm() < rigid_share * all.squaredNorm()) return std::nullopt;
  return Points<D>(rigid.reshaped(D, rigid.size() / D));
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

/// Pieces of faces before the first step.
template <int D> std::vector<Facet<D>> facets_on(const Scene<D>& scene, const Faces& faces) {
  std::vector<Facet<D>> list;
  for (const FaceReference& face : faces) {
    const nurbs::Discretization& space = scene.bodies[face.body].body->space();
    const Outline<D> outline(space, space.points());
    for (const Facet<D>& facet : outline.facets())
      if (facet.side == face.side) list.push_back(facet);
  }
  return list;
}

/// Points on faces.
template <int D> Points<D> corners_of(const std::vector<Facet<D>>& facets) {
  Points<D> points(D, D * static_cast<Eigen::Index>(facets.size()));
  Eigen::Index column = 0;
  for (const Facet<D>& facet : facets)
    for (const Vec<D>& corner : facet.corners) points.col(column++) = corner;
  return points;
}

/// True if points lie in a plane, or on a line in 2D.
template <int D> bool is_flat(const Points<D>& points) {
  constexpr double thin = 1e-12; // squared
  const Points<D> relative = points.colwise() - Vec<D>(points.rowwise().mean());
  const MatrixX spread = relative * relative.transpose();
  return solve::least_eigenpair(spread).value < thin * spread.trace();
}

/// True if bodies that move as one touch others and obstacles by round faces only, which turn about their centers or
/// roll on planes.
template <int D> bool rolls(const Model<D>& model, const std::vector<int>& group, const RigidMotion<D>& motion) {
  constexpr double small = 0.05;
  const Scene<D>& scene = model.system.scene;
  const Mat<D> spin = 0.5 * (motion.gradient - motion.gradient.transpose());
  const auto moves = [&](const Faces& faces) { return std::ranges::any_of(group, [&](int b) { return faces.on(b); }); };
  bool touches = false;
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k) {
    const Contact<D>& contact = scene.contacts[k];
    const auto* master = std::get_if<Faces>(&contact.master);
    const bool as_slave = moves(contact.slave), as_master = master && moves(*master);
    if (as_slave == as_master) {
      if (as_slave) return false;
      continue;
    }
    if (contact::resultant(model.accepted.contacts[k]).active == 0) continue;
    touches = true;
    const Points<D> points = corners_of(facets_on(scene, as_slave ? contact.slave : *master));
    const auto center = center_of_rotation<D>(points, spin);
    if (!center) return false;
    const auto* obstacle = std::get_if<ObstacleReference>(&contact.master);
    const bool flat = obstacle ? std::holds_alternative<contact::Plane<D>>(scene.obstacles[obstacle->obstacle])
                               : is_flat<D>(corners_of(facets_on(scene, as_slave ? *master : contact.slave)));
    const double radius = (points.colwise() - Vec<D>(*center)).norm() / std::sqrt(static_cast<double>(points.cols()));
    const double moved = (motion.at + motion.gradient * *center).norm();
    if (!flat && moved > small * spin.norm() * radius) return false;
  }
  return touches;
}

/// True if round faces, such as a disc's and not those of a hook, lie on top of a ball or cylinder, off which they
/// roll.
template <int D> bool lies_on_top(const Scene<D>& scene, const Contact<D>& contact) {
  const auto* obstacle = std::get_if<ObstacleReference>(&contact.master);
  if (!obstacle || full_radius<D>(scene.obstacles[obstacle->obstacle]) == 0) return false;
  const std::vector<Facet<D>> facets = facets_on(scene, contact.slave);
  const auto center = center_of(corners_of(facets));
  if (!center) return false;
  double outward = 0;
  for (const Facet<D>& facet : facets) outward += facet.area * facet.normal.dot(facet.middle - Vec<D>(*center));
  return outward > 0;
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
  for (const std::vector<int>& group : connected_groups(system.scene)) {
    const auto moves = rigid_part(system, group, direction);
    if (!moves) continue;
    std::vector<const Contact<D>*> touching;
    for (std::size_t k = 0; k < system.contacts.size(); ++k) {
      const Contact<D>& contact = system.scene.contacts[k];
      if (std::ranges::any_of(group, [&](int b) { return acts_on(contact, b); }) &&
          contact::resultant(model.accepted.contacts[k]).active > 0)
        touching.push_back(&contact);
    }
    // The turning disc is neutral there, but not its way to the side.
    if (touching.size() == 1 && lies_on_top(system.scene, *touching.front())) return false;
    const double largest = moves->template lpNorm<Eigen::Infinity>();
    if (-stiffness < neutral_share * contact_force(model) / system.extent * largest * largest) return true;
    return rolls(model, group, fitted<D>(reference_points(system.scene, group), *moves));
  }
  return false;
}

template bool is_neutral(Model<2>&, const VectorX&, double);
template bool is_neutral(Model<3>&, const VectorX&, double);

} // namespace signorini::model
