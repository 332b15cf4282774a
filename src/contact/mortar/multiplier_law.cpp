#include "contact/mortar/multiplier_law.hpp"

#include "contact/law/wear.hpp"

namespace signorini::contact {

template <int D> PointCondition<D> open_condition(const Vec<D>& multiplier, bool frictional) {
  PointCondition<D> condition;
  condition.residual = -multiplier;
  condition.of_multiplier = -Mat<D>::Identity();
  if (!frictional) condition.of_multiplier.template bottomRightCorner<D - 1, D - 1>().setZero();
  return condition;
}

template <int D>
PointCondition<D> closed_condition(const InterfaceLaw& law, const LocalGeometry<D>& geometry, const Vec<D>& multiplier,
                                   bool frictional, const GapRows<D>& gap, const LocalShift<D>& shift) {
  using Force = LocalForce<D>;
  PointCondition<D> condition;
  condition.state = ContactState::stick;
  condition.mu = law.coefficient ? 0 : law.friction;
  const double g = geometry.gap - geometry.offset;
  if (!frictional) {
    condition.residual(0) = -law.normal * g;
    condition.rows.row(0) = -law.normal * gap.gap;
    return condition;
  }
  const Vec<D>& n = geometry.normal;
  const Mat<D> plane = Mat<D>::Identity() - n * n.transpose();
  double q = n.dot(multiplier) - law.normal * g;
  // δq = λ·δn + n·δλ − ε_N δg,  c = q n − t − λ
  LocalRow<D> q_row = multiplier.transpose() * gap.normal - law.normal * gap.gap;
  Eigen::Matrix<double, 1, D> q_of_multiplier = n.transpose();
  Vec<D> friction = Vec<D>::Zero();
  LocalBlock<D> friction_rows = LocalBlock<D>::Zero();
  Mat<D> friction_of_multiplier = Mat<D>::Zero();
  if (slides(law) && geometry.slip_point) {
    // y = T x,  δy = T δx − (n·x) δn − n (x·δn),  x = ε_T v − λ
    const Vec<D> x = law.tangential * (geometry.master->position - *geometry.slip_point) - multiplier, y = plane * x;
    LocalBlock<D> slip = LocalBlock<D>::Zero();
    slip.template middleCols<D>(Force::master_column).setIdentity();
    slip.template middleCols<D>(Force::slip_column).diagonal().setConstant(-1);
    for (int a = 0; a < D - 1; ++a) slip.noalias() += geometry.master->tangent[a] * shift.row(a);
    friction_rows = law.tangential * (plane * slip) - (n.dot(x) * Mat<D>::Identity() + n * x.transpose()) * gap.normal;
    friction_of_multiplier = -plane;
    const Rubbing<D> rubbing =
        rub<D>(law, {q, -law.normal}, g, y, geometry.fixed_state, geometry.tie, geometry.interface);
    const Slide<D>& step = rubbing.slide;
    condition.mu = step.mu;
    condition.flaw = step.flaw;
    if (rubbing.worn != 0) {
      condition.worn = rubbing.worn;
      q = rubbing.response.pressure;
      q_row = rubbing.of_held * q_row + rubbing.of_trial.transpose() * friction_rows;
      q_of_multiplier = rubbing.of_held * q_of_multiplier + rubbing.of_trial.transpose() * friction_of_multiplier;
    }
    if (step.state == ContactState::slip) {
      condition.state = ContactState::slip;
      condition.slipped = step.slipped;
      friction_rows = step.of_trial * friction_rows;
      friction_of_multiplier = step.of_trial * friction_of_multiplier;
      if (step.of_pressure != 0) {
        friction_rows += (step.of_pressure * step.direction) * q_row;
        friction_of_multiplier += (step.of_pressure * step.direction) * q_of_multiplier;
      }
    }
    friction = step.friction;
  }
  condition.residual = q * n - multiplier - friction;
  condition.of_multiplier = n * q_of_multiplier - Mat<D>::Identity() - friction_of_multiplier;
  condition.rows = n * q_row + q * gap.normal - friction_rows;
  return condition;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template PointCondition<D> open_condition(const Vec<D>&, bool);                                                      \
  template PointCondition<D> closed_condition(const InterfaceLaw&, const LocalGeometry<D>&, const Vec<D>&, bool,       \
                                              const GapRows<D>&, const LocalShift<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
