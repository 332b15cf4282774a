#include "contact/mortar/multiplier_law.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

template <int D> PointCondition<D> open_condition(const Vec<D>& multiplier, bool frictional) {
  PointCondition<D> condition;
  condition.residual = -multiplier;
  condition.of_multiplier = -Mat<D>::Identity();
  if (!frictional) condition.of_multiplier.template bottomRightCorner<D - 1, D - 1>().setZero();
  return condition;
}

template <int D>
PointCondition<D> closed_condition(const PenaltyLaw& law, const LocalGeometry<D>& geometry, const Vec<D>& multiplier,
                                   bool frictional, const GapRows<D>& gap, const LocalShift<D>& shift) {
  using Force = LocalForce<D>;
  PointCondition<D> condition;
  condition.state = ContactState::stick;
  const double g = geometry.gap - geometry.offset;
  if (!frictional) {
    condition.residual(0) = -law.normal * g;
    condition.rows.row(0) = -law.normal * gap.gap;
    return condition;
  }
  const Vec<D>& n = geometry.normal;
  const Mat<D> plane = Mat<D>::Identity() - n * n.transpose();
  const double pressure = n.dot(multiplier), q = pressure - law.normal * g;
  // δq = λ·δn + n·δλ − ε_N δg,  c = q n − t − λ
  const LocalRow<D> q_row = multiplier.transpose() * gap.normal - law.normal * gap.gap;
  condition.residual = q * n - multiplier;
  condition.of_multiplier = n * n.transpose() - Mat<D>::Identity();
  condition.rows = n * q_row + q * gap.normal;
  if (law.friction > 0 && geometry.slip_point) {
    // y = T x,  δy = T δx − (n·x) δn − n (x·δn),  x = ε_T v − λ
    const Vec<D> x = law.tangential * (geometry.master->position - *geometry.slip_point) - multiplier, y = plane * x;
    LocalBlock<D> slip = LocalBlock<D>::Zero();
    slip.template middleCols<D>(Force::master_column).setIdentity();
    slip.template middleCols<D>(Force::slip_column).diagonal().setConstant(-1);
    for (int a = 0; a < D - 1; ++a) slip.noalias() += geometry.master->tangent[a] * shift.row(a);
    LocalBlock<D> rows =
        law.tangential * (plane * slip) - (n.dot(x) * Mat<D>::Identity() + n * x.transpose()) * gap.normal;
    Mat<D> of_multiplier = -plane;
    const double magnitude = y.norm(), limit = law.friction * std::max(0.0, q);
    const double tie = (law.tangential + law.friction * law.normal) * geometry.tie;
    Vec<D> friction = y;
    if (slips(geometry.fixed_state, magnitude, limit, tie) && magnitude > 0) {
      // t = μ q d,  δt = μ δq d + μ q/|y| (I − d dᵀ) δy
      condition.state = ContactState::slip;
      condition.slipped = (magnitude - limit) / law.tangential;
      const Vec<D> d = y / magnitude;
      const Mat<D> across = (limit / magnitude) * (Mat<D>::Identity() - d * d.transpose());
      friction = limit * d;
      rows = across * rows;
      of_multiplier = across * of_multiplier;
      if (limit > 0) {
        rows += (law.friction * d) * q_row;
        of_multiplier += (law.friction * d) * n.transpose();
      }
    }
    condition.residual -= friction;
    condition.rows -= rows;
    condition.of_multiplier -= of_multiplier;
  }
  return condition;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template PointCondition<D> open_condition(const Vec<D>&, bool);                                                      \
  template PointCondition<D> closed_condition(const PenaltyLaw&, const LocalGeometry<D>&, const Vec<D>&, bool,         \
                                              const GapRows<D>&, const LocalShift<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
