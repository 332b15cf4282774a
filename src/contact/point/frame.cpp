#include "contact/point/frame.hpp"

namespace signorini::contact {

namespace {

/// The vector e₂ of a frame for components (c₁, c₂): c₁ e₂ − c₂ e₁, by which Σ c_i e_i changes per spin.
template <int D> Vec<D> turned(const Frame<D>& frame, const FaceCoordinates<D>& c) {
  if constexpr (D == 2)
    return Vec<D>::Zero();
  else
    return c(0) * frame.axes.col(1) - c(1) * frame.axes.col(0);
}

} // namespace

template <int D> Frame<D> frame_of(const Vec<D>& normal, const Vec<D>& along) {
  Frame<D> frame;
  const double length = normal.norm();
  const Vec<D> n = normal / length;
  frame.normal = n;
  frame.turn = (Mat<D>::Identity() - n * n.transpose()) / length;
  const double across = n.dot(along);
  const Vec<D> first = along - across * n;
  frame.axes.col(0) = first.normalized();
  if constexpr (D == 3) {
    const Vec<D> second = n.cross(Vec<D>(frame.axes.col(0)));
    frame.axes.col(1) = second;
    // φ = e₂·δe₁ = e₂·(δa − (n·a) δn)/|first|
    frame.spin_along = second.transpose() / first.norm();
    frame.spin_normal = -across * frame.spin_along;
  }
  return frame;
}

template <int D>
PlaneSlide<D> slide_in(const Frame<D>& frame, const InterfaceLaw& law, const FaceCoordinates<D>& elastic,
                       const Vec<D>& v, const GapResponse& unworn, double gap, const FrictionControl& control) {
  using Components = FaceCoordinates<D>;
  using Square = Eigen::Matrix<double, D - 1, D - 1>;
  PlaneSlide<D> result;
  const auto& e = frame.axes;
  const Components slip = e.transpose() * v, trial = law.tangential * (elastic + slip);
  result.rubbing = rub<D - 1>(law, unworn, gap, trial, control.fixed, control.tie, control.interface);
  const Slide<D - 1>& step = result.rubbing.slide;
  Square scale = Square::Identity(); // ∂traction/∂trial
  if (step.state == ContactState::slip) {
    scale = step.of_trial;
    result.of_pressure = step.of_pressure * (e * step.direction);
  }
  result.slip = slip;
  result.friction = e * step.friction;

  // t = Σ_i t_i e_i,  δtrial_i = ε_T (e_i·δV + δe_i·V),  with δe_i of the frame
  const Eigen::Matrix<double, D, D - 1> stiff = law.tangential * e * scale;
  const Vec<D>& n = frame.normal;
  result.of_slip = stiff * e.transpose();
  Components spun = Components::Zero(); // ∂(e_i·V)/∂φ
  if constexpr (D == 3) spun = Components(slip(1), -slip(0));
  const Vec<D> by_spin = stiff * spun + turned(frame, step.friction);
  Mat<D> by_normal = -n.dot(v) * (stiff * e.transpose()) - n * result.friction.transpose();
  by_normal += by_spin * frame.spin_normal;
  result.of_normal = by_normal * frame.turn;
  result.of_along = by_spin * frame.spin_along;
  if (result.rubbing.worn == 0) return result;
  const Vec<D> by_slip = law.tangential * (e * result.rubbing.of_trial);
  const double turns = law.tangential * result.rubbing.of_trial.dot(spun);
  result.worn = {by_slip, frame.turn.transpose() * (turns * frame.spin_normal.transpose() - n.dot(v) * by_slip),
                 turns * frame.spin_along.transpose()};
  return result;
}

template <int D>
PlaneSlide<D> slide_along_axes(const InterfaceLaw& law, const LocalGeometry<D>& geometry, const Vec<D>& slip,
                               const GapResponse& unworn) {
  const Frame<D> frame = frame_of<D>(geometry.normal, direction_of<D>(geometry.axis, geometry.slave_tangent));
  return slide_in<D>(frame, law, FaceCoordinates<D>::Zero(), slip, unworn, geometry.gap - geometry.offset,
                     {geometry.fixed_state, geometry.tie, geometry.interface});
}

template <int D>
LocalBlock<D> friction_rows(const PlaneSlide<D>& found, const LocalGeometry<D>& geometry, const LocalBlock<D>& slip,
                            const GapRows<D>& gap) {
  LocalBlock<D> rows = found.of_slip * slip + found.of_normal * gap.normal;
  for (int a = 0; a < D - 1; ++a)
    rows.template middleCols<D>(LocalForce<D>::slave_tangent_column + D * a) += geometry.axis(a) * found.of_along;
  return rows;
}

template <int D>
LocalRow<D> pressure_row(const PlaneSlide<D>& found, const LocalGeometry<D>& geometry, const LocalBlock<D>& slip,
                         const GapRows<D>& gap) {
  if (!found.worn) return LocalRow<D>::Zero();
  LocalRow<D> row = found.worn->of_slip.transpose() * slip + found.worn->of_normal.transpose() * gap.normal;
  for (int a = 0; a < D - 1; ++a)
    row.template middleCols<D>(LocalForce<D>::slave_tangent_column + D * a) +=
        geometry.axis(a) * found.worn->of_along.transpose();
  return row;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template Frame<D> frame_of(const Vec<D>&, const Vec<D>&);                                                            \
  template PlaneSlide<D> slide_in(const Frame<D>&, const InterfaceLaw&, const FaceCoordinates<D>&, const Vec<D>&,      \
                                  const GapResponse&, double, const FrictionControl&);                                 \
  template PlaneSlide<D> slide_along_axes(const InterfaceLaw&, const LocalGeometry<D>&, const Vec<D>&,                 \
                                          const GapResponse&);                                                         \
  template LocalRow<D> pressure_row(const PlaneSlide<D>&, const LocalGeometry<D>&, const LocalBlock<D>&,               \
                                    const GapRows<D>&);                                                                \
  template LocalBlock<D> friction_rows(const PlaneSlide<D>&, const LocalGeometry<D>&, const LocalBlock<D>&,            \
                                       const GapRows<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
