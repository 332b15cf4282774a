#include "contact/mortar/multiplier_law.hpp"

#include "contact/point/frame.hpp"

namespace signorini::contact {

namespace {

/// Subtracts the friction P(x) of a law with an axis from the conditions: in components, δx = ε_T δv − δλ.
template <int D>
void subtract_friction(const InterfaceLaw& law, const LocalGeometry<D>& geometry, const Vec<D>& x,
                       const LocalBlock<D>& slip, double q, const LocalRow<D>& q_row, const GapRows<D>& gap,
                       PointCondition<D>& condition) {
  const PlaneSlide<D> found = slide_along_axes(law, geometry, Vec<D>(x / law.tangential), q);
  condition.state = found.step.state;
  condition.slipped = found.step.slipped;
  condition.mu = found.step.mu;
  condition.flaw = found.step.flaw;
  condition.residual -= found.friction;
  condition.rows -= found.of_pressure * q_row;
  condition.rows -= friction_rows(found, geometry, slip, gap);
  condition.of_multiplier -= found.of_pressure * geometry.normal.transpose() - found.of_slip / law.tangential;
}

} // namespace

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
  const double pressure = n.dot(multiplier), q = pressure - law.normal * g;
  // δq = λ·δn + n·δλ − ε_N δg,  c = q n − t − λ
  const LocalRow<D> q_row = multiplier.transpose() * gap.normal - law.normal * gap.gap;
  condition.residual = q * n - multiplier;
  condition.of_multiplier = n * n.transpose() - Mat<D>::Identity();
  condition.rows = n * q_row + q * gap.normal;
  if (law.friction > 0 && geometry.slip_point) {
    // x = ε_T v − λ
    const Vec<D> x = law.tangential * (geometry.master->position - *geometry.slip_point) - multiplier;
    const LocalBlock<D> slip = slip_rows(geometry, shift);
    if (law.along) {
      subtract_friction(law, geometry, x, slip, q, q_row, gap, condition);
      return condition;
    }
    // y = T x,  δy = T δx − (n·x) δn − n (x·δn)
    const Vec<D> y = plane * x;
    LocalBlock<D> rows =
        law.tangential * (plane * slip) - (n.dot(x) * Mat<D>::Identity() + n * x.transpose()) * gap.normal;
    Mat<D> of_multiplier = -plane;
    const Slide<D> step = slide<D>(law, y, q, geometry.fixed_state, geometry.tie, geometry.interface);
    condition.mu = step.mu;
    condition.flaw = step.flaw;
    if (step.state == ContactState::slip) {
      condition.state = ContactState::slip;
      condition.slipped = step.slipped;
      rows = step.of_trial * rows;
      of_multiplier = step.of_trial * of_multiplier;
      if (step.of_pressure != 0) {
        rows += (step.of_pressure * step.direction) * q_row;
        of_multiplier += (step.of_pressure * step.direction) * n.transpose();
      }
    }
    condition.residual -= step.friction;
    condition.rows -= rows;
    condition.of_multiplier -= of_multiplier;
  }
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
