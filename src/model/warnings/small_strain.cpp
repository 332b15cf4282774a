#include "model/warnings/small_strain.hpp"

#include "model/constants.hpp"
#include "model/results/results.hpp"
#include "solid/internal.hpp"
#include "solve/eigenpairs.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace signorini::model {

namespace {

/// Angle of rotation, in radians, and the principal strain with the largest magnitude.
struct Distortion {
  double angle, strain;
  /// The larger of both, each relative to what is small.
  double excess() const { return std::max(angle / most_small_rotation, std::abs(strain) / most_small_strain); }
};

double angle_of(const Mat<2>& rotation) {
  return std::abs(std::atan2(rotation(1, 0) - rotation(0, 1), rotation.trace()));
}

/// Accurate also for small angles, where the trace is not.
double angle_of(const Mat<3>& rotation) {
  const Mat<3> skew = 0.5 * (rotation - rotation.transpose());
  return std::atan2(skew.norm() / std::numbers::sqrt2, 0.5 * (rotation.trace() - 1));
}

/// R of F = R U, by Newton's method (N. J. Higham, SIAM J. Sci. Stat. Comput. 7, 1986); not finite if F is singular.
template <int D> Mat<D> rotation_of(const Mat<D>& f) {
  constexpr int most = 20; // quadratic convergence; far from it the singular values are halved
  Mat<D> r = f;
  for (int i = 0; i < most; ++i) r = 0.5 * (r + Mat<D>(r.inverse().transpose()));
  return r;
}

/// The smallest stretch of an inverted element is negative, so that R is a rotation.
template <int D> Distortion distortion(const solid::MeanDeformation<D>& mean) {
  // ‖F − I‖ bounds strains, and angles in radians that are small.
  if ((mean.gradient - Mat<D>::Identity()).norm() < 0.5 * most_small_strain) return {0, mean.hoop - 1};
  Mat<D> r = rotation_of(mean.gradient);
  if (!r.allFinite()) return {0, -1};
  const Mat<D> u = 0.5 * (r.transpose() * mean.gradient + mean.gradient.transpose() * r);
  auto [least, direction] = solve::least_eigenpair(u);
  const double largest = -solve::least_eigenpair(-u).value;
  if (r.determinant() < 0) {
    r -= 2 * (r * direction) * direction.transpose();
    least = -least;
  }
  Distortion found{angle_of(r), mean.hoop - 1};
  for (const double stretch : {least, largest})
    if (std::abs(stretch - 1) > std::abs(found.strain)) found.strain = stretch - 1;
  return found;
}

template <int D> VectorX middle_of(const nurbs::Discretization& space, int e) {
  const nurbs::ElementBasis basis = space.basis(e, space.parameter(e, Vec<D>::Constant(0.5)));
  return space.points()(Eigen::all, basis.functions) * basis.values;
}

} // namespace

template <int D> void warn_of_large_strains(const Model<D>& model, std::vector<Message>& warnings) {
  for (std::size_t b = 0; b < model.system.scene.bodies.size(); ++b) {
    const auto& [name, body] = model.system.scene.bodies[b];
    const auto displacement = body_displacement(model, static_cast<int>(b));
    if (!body->small_strains() || displacement.isZero(0)) continue;
    const auto means = solid::mean_deformations(*body, displacement.data());
    Distortion worst{0, 0};
    int element = 0;
    for (int e = 0; e < body->elements(); ++e)
      if (const Distortion found = distortion(means[e]); found.excess() > worst.excess()) {
        worst = found;
        element = e;
      }
    if (worst.excess() < 1) continue;
    // Hundredths of a degree and of a percent.
    const double angle = std::round(18000 / std::numbers::pi * worst.angle) / 100;
    const double strain = std::round(10000 * worst.strain) / 100;
    warnings.push_back(Message("model.warning.large_strains", {{"body", name},
                                                               {"element", element},
                                                               {"place", middle_of<D>(body->space(), element)},
                                                               {"angle", angle},
                                                               {"strain", strain}}));
  }
}

template void warn_of_large_strains(const Model<2>&, std::vector<Message>&);
template void warn_of_large_strains(const Model<3>&, std::vector<Message>&);

} // namespace signorini::model
