#pragma once
// What contact points remember and what they did: plain values, part of a model's state.

#include "contact/contact_points.hpp"
#include "contact/local.hpp"

namespace signorini::contact {

/// What a contact point did in an evaluation.
template <int D> struct PointResult {
  ContactState state = ContactState::open;
  Vec<D> position = Vec<D>::Zero(); ///< current slave point
  double gap = 0;                   ///< of a point that the law acts on
  bool beyond = false;              ///< its closest point is an open end of the master
  bool settled = true;              ///< the searches for its closest point and, once accepted, its slip point converged
  double pressure = 0;
  /// Of the slave face at a touching point, current, not of unit length
  Eigen::Matrix<double, D, D - 1> tangents = Eigen::Matrix<double, D, D - 1>::Zero();
  Vec<D> friction = Vec<D>::Zero(); ///< t_T; the traction on the slave is t_N n̄ − t_T
  Vec<D> force = Vec<D>::Zero();    ///< on the slave: traction × current area of the point
  double area = 0;                  ///< that the traction acts on: current, adhesion: reference
  double potential = 0;             ///< energy of the law at this point
};

/// What a contact point remembers from one evaluation to the next.
template <int D> struct PointHistory {
  Projection<D> projection; ///< where the next search for the closest point starts
  double cleared = 0;       ///< value of Formulation::travel_ up to which an open point cannot touch
  bool slips = false;       ///< has a slip point
  FaceCoordinates<D> slip = FaceCoordinates<D>::Zero();
  double limit = 0;      ///< μ t_N times the area in the accepted state
  double multiplier = 0; ///< λ_N, what augmentation adds to the pressure
};

/// One entry per contact point in both lists.
template <int D> struct History {
  explicit History(const ContactPoints<D>& of);

  std::vector<PointHistory<D>> points;
  std::vector<PointResult<D>> results;
  double dissipated = 0; ///< work of friction in all accepted steps: ∫ μ t_N dγ da, by the trapezoidal rule over each
};

/// Sums over a contact. Area, largest pressure and penetration are those of the points that are not open.
template <int D> struct Resultant {
  Vec<D> force = Vec<D>::Zero(); ///< that the master exerts on the slave
  double area = 0, max_pressure = 0, max_penetration = 0;
  int active = 0, slipping = 0;
};
template <int D> Resultant<D> resultant(const History<D>& history);

/// Energy of the law: springs of the penalty law, or adhesion.
template <int D> double potential(const History<D>& history);

/// Bytes that it takes.
template <int D> double memory(const History<D>& history);

/// Has all points that a multiplier presses looked at again: after a change of the penalty they touch at another gap.
template <int D> void look_again(History<D>& history);

} // namespace signorini::contact
