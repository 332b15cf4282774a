#include "contact/mortar/multiplier_law.hpp"

#include "contact/point/frame.hpp"

namespace signorini::contact {

namespace {

/// The augmented pressure q = n̄·λ − ε_N (g − o) and the friction of a point, with their derivatives with respect to the
/// local variables and the multiplier; those of the friction at constant q.
template <int D> struct Augmented {
  double q;
  LocalRow<D> q_row;
  Eigen::Matrix<double, 1, D> q_of_multiplier;
  Vec<D> friction = Vec<D>::Zero(), of_pressure = Vec<D>::Zero();
  LocalBlock<D> rows = LocalBlock<D>::Zero();
  Mat<D> of_multiplier = Mat<D>::Zero();
};

/// What wear changes of q at a point, δq = of_held δq₀ + row + of_multiplier δλ.
template <int D, int N>
void wear(const Rubbing<N>& rubbing, const LocalRow<D>& row, const Eigen::Matrix<double, 1, D>& of_multiplier,
          Augmented<D>& point) {
  point.q = rubbing.response.pressure;
  point.q_row = rubbing.of_held * point.q_row + row;
  point.q_of_multiplier = rubbing.of_held * point.q_of_multiplier + of_multiplier;
}

template <int N, int D> void store(const Rubbing<N>& rubbing, PointCondition<D>& condition) {
  condition.mu = rubbing.slide.mu;
  condition.flaw = rubbing.slide.flaw;
  condition.worn = rubbing.worn;
  condition.state = rubbing.slide.state;
  condition.slipped = rubbing.slide.state == ContactState::slip ? rubbing.slide.slipped : 0;
}

/// The friction P(y) of y = T x, x = ε_T v − λ.
template <int D>
void rub_in_plane(const InterfaceLaw& law, const LocalGeometry<D>& geometry, const Vec<D>& x, const LocalBlock<D>& slip,
                  const GapRows<D>& gap, Augmented<D>& point, PointCondition<D>& condition) {
  // δy = T δx − (n·x) δn − n (x·δn)
  const Vec<D>& n = geometry.normal;
  const Mat<D> plane = Mat<D>::Identity() - n * n.transpose();
  const Vec<D> y = plane * x;
  point.rows = law.tangential * (plane * slip) - (n.dot(x) * Mat<D>::Identity() + n * x.transpose()) * gap.normal;
  point.of_multiplier = -plane;
  const Rubbing<D> rubbing = rub<D>(law, {point.q, -law.normal}, geometry.gap - geometry.offset, y,
                                    geometry.fixed_state, geometry.tie, geometry.interface);
  const Slide<D>& step = rubbing.slide;
  store(rubbing, condition);
  if (rubbing.worn != 0)
    wear<D>(rubbing, rubbing.of_trial.transpose() * point.rows, rubbing.of_trial.transpose() * point.of_multiplier,
            point);
  point.friction = step.friction;
  if (step.state != ContactState::slip) return;
  point.rows = step.of_trial * point.rows;
  point.of_multiplier = step.of_trial * point.of_multiplier;
  point.of_pressure = step.of_pressure * step.direction;
}

/// The same of a law with an axis: in components, δx = ε_T δv − δλ.
template <int D>
void rub_along_axes(const InterfaceLaw& law, const LocalGeometry<D>& geometry, const Vec<D>& x,
                    const LocalBlock<D>& slip, const GapRows<D>& gap, Augmented<D>& point,
                    PointCondition<D>& condition) {
  const PlaneSlide<D> found = slide_along_axes(law, geometry, Vec<D>(x / law.tangential), {point.q, -law.normal});
  store(found.rubbing, condition);
  if (found.worn)
    wear<D>(found.rubbing, pressure_row(found, geometry, slip, gap), -found.worn->of_slip.transpose() / law.tangential,
            point);
  point.friction = found.friction;
  point.rows = friction_rows(found, geometry, slip, gap);
  point.of_multiplier = -found.of_slip / law.tangential;
  point.of_pressure = found.of_pressure;
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
  // δq = λ·δn + n·δλ − ε_N δg
  Augmented<D> point{n.dot(multiplier) - law.normal * g, multiplier.transpose() * gap.normal - law.normal * gap.gap,
                     n.transpose()};
  if (slides(law) && geometry.slip_point) {
    const Vec<D> x = law.tangential * slip_of(geometry) - multiplier;
    const LocalBlock<D> slip = slip_rows(geometry, gap, shift);
    (law.along ? rub_along_axes<D> : rub_in_plane<D>)(law, geometry, x, slip, gap, point, condition);
    if (!point.of_pressure.isZero(0)) {
      point.rows += point.of_pressure * point.q_row;
      point.of_multiplier += point.of_pressure * point.q_of_multiplier;
    }
  }
  // c = q n − t − λ
  condition.residual = point.q * n - multiplier - point.friction;
  condition.of_multiplier = n * point.q_of_multiplier - Mat<D>::Identity() - point.of_multiplier;
  condition.rows = n * point.q_row + point.q * gap.normal - point.rows;
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
