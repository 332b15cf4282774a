#include "contact/mortar/multiplier_law.hpp"

#include "contact/constants.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

namespace {

template <int D>
void add_friction(const PenaltyLaw& law, double s, const MultiplierSums<D>& sums, const MultiplierUnknowns<D>& unknowns,
                  const Vec<D>& touch, const FrictionControl& control, MultiplierResult<D>& result,
                  ConditionRows<D>& rows) {
  const double a = sums.area, length = sums.normal.norm();
  const Vec<D> n = sums.normal / length, slip = sums.slip / a;
  const Mat<D> plane = Mat<D>::Identity() - n * n.transpose();
  // y = T x,  δy = T δx − (n·x) δn − n (x·δn),   x = s χ_T + ε_T (V − V*),   δn = T δ(Σ w n̄)/‖·‖
  const Vec<D> x = s * unknowns.tangential + law.tangential * (slip - touch), y = plane * x;
  const Mat<D> by_normal = -(n.dot(x) * Mat<D>::Identity() + n * x.transpose()) * plane / length;
  const double magnitude = y.norm(),
               limit = law.friction * std::max(0.0, s * unknowns.normal - law.normal * result.gap);
  const double tie = (law.tangential + law.friction * law.normal) * control.tie;
  Vec<D> traction = y;
  Mat<D> part = Mat<D>::Identity(); // ∂P/∂y
  result.state = ContactState::stick;
  if (slips(control.fixed, magnitude, limit, tie) && magnitude > 0) {
    // P = μ q d,  δP = μ (s δχ_N − ε_N δḡ) d + μ q/|y| (I − d dᵀ) δy
    result.state = ContactState::slip;
    const Vec<D> d = y / magnitude;
    traction = limit * d;
    part = (limit / magnitude) * (Mat<D>::Identity() - d * d.transpose());
    if (limit > 0) {
      // δḡ = (δ(Σ w g) − ḡ δa)/a
      rows.of_unknowns.template block<D, 1>(1, 0) = (a * law.friction * s) * d;
      rows.of_gap.template tail<D>() = (-law.friction * law.normal) * d;
      rows.of_area.template tail<D>() = (law.friction * law.normal * result.gap) * d;
    }
  }
  const Vec<D> difference = traction - s * unknowns.tangential;
  rows.residual.template tail<D>() = a * difference;
  rows.of_unknowns.template bottomRightCorner<D, D>() += a * s * (part * plane - Mat<D>::Identity());
  // δV = (δ(Σ w v) − V δa)/a
  const Mat<D> by_slip = law.tangential * part * plane;
  rows.of_slip.template bottomRows<D>() = by_slip;
  rows.of_area.template tail<D>() += difference - by_slip * slip;
  rows.of_normal.template bottomRows<D>() = a * part * by_normal;

  result.friction = s * unknowns.tangential;
  result.slipped = (plane * (slip - touch)).norm();
  const Vec<D> along = sums.along - n.dot(sums.along) * n;
  const auto components = [&](const Vec<D>& vector) {
    FaceCoordinates<D> parts;
    parts(0) = along.dot(vector) / along.norm();
    if constexpr (D == 3) parts(1) = n.cross(along).dot(vector) / along.norm();
    return parts;
  };
  result.components = components(result.friction);
  result.trial = components(y);
}

} // namespace

template <int D> ConditionRows<D> open_multiplier(double s, double whole, const MultiplierUnknowns<D>& unknowns) {
  ConditionRows<D> rows;
  rows.residual << unknowns.normal, unknowns.tangential;
  rows.residual *= -s * whole;
  rows.of_unknowns.diagonal().setConstant(-s * whole);
  return rows;
}

template <int D>
ConditionRows<D> multiplier_law(const PenaltyLaw& law, double s, const MultiplierSums<D>& sums, double whole,
                                const MultiplierUnknowns<D>& unknowns, const Vec<D>& touch,
                                const FrictionControl& control, MultiplierResult<D>& result) {
  ConditionRows<D> rows;
  result.state = ContactState::stick;
  result.pressure = s * unknowns.normal;
  rows.residual(0) = -s * sums.gap;
  rows.of_gap(0) = -s;
  rows.of_unknowns.diagonal().setConstant(-proximal * s * whole);
  if (law.friction > 0) {
    add_friction(law, s, sums, unknowns, touch, control, result, rows);
  } else { // χ_T = 0, where it is an unknown because friction acts later
    rows.residual.template tail<D>() = -s * whole * unknowns.tangential;
    rows.of_unknowns.diagonal().template tail<D>().setConstant(-s * whole);
    result.friction = s * unknowns.tangential;
  }
  return rows;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template ConditionRows<D> open_multiplier(double, double, const MultiplierUnknowns<D>&);                             \
  template ConditionRows<D> multiplier_law(const PenaltyLaw&, double, const MultiplierSums<D>&, double,                \
                                           const MultiplierUnknowns<D>&, const Vec<D>&, const FrictionControl&,        \
                                           MultiplierResult<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
