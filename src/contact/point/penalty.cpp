#include "contact/point/penalty.hpp"

#include "base/error.hpp"

#include <algorithm>

namespace signorini::contact {

void check(const PenaltyLaw& law) {
  require(law.normal > 0, "contact.penalty.normal", {{"value", law.normal}});
  require(law.friction >= 0, "contact.penalty.friction", {{"value", law.friction}});
  require(!may_rub(law) || law.tangential > 0, "contact.penalty.tangential", {{"value", law.tangential}});
}

PenaltyLaw changed(PenaltyLaw law, const Changes& changes) {
  law.normal = changes.normal.value_or(law.normal);
  law.tangential = changes.tangential.value_or(law.tangential);
  law.friction = changes.friction.value_or(law.friction);
  return law;
}

PenaltyLaw scaled(PenaltyLaw law, double factor) {
  law.normal *= factor;
  law.tangential *= factor;
  return law;
}

double limit_before(double limit, double mu_before, double mu, double held) {
  return mu < mu_before ? std::max(mu / mu_before * limit, held) : limit;
}

double largest_penalty(const PenaltyLaw& law) {
  return std::max(law.normal, law.friction > 0 ? law.tangential : 0);
}

namespace {

/// Calls visit<first, count>() for the columns of xˢ, and of x̄ᵐ and τ_α: gap, normal and ξ̄ do not depend on others.
template <int D, class Visit> void each_range(const Visit& visit) {
  visit.template operator()<0, D>();
  visit.template operator()<LocalForce<D>::master_column, D * D>();
}

} // namespace

template <int D> void penalty_force(const PenaltyLaw& law, const LocalGeometry<D>& geometry, LocalForce<D>& result) {
  using Force = LocalForce<D>;
  constexpr int tangents = D - 1;
  const FacePoint<D>& master = *geometry.master;
  const Vec<D>& n = geometry.normal;
  const double g = geometry.gap - geometry.offset;
  const GapRows<D> rows = gap_rows(geometry, result.shift);

  // t_N = −ε_N g,  δ(t_N n̄) = −ε_N δg n̄ + t_N δn̄
  result.pressure = -law.normal * g;
  Vec<D> traction = result.pressure * n;
  LocalBlock<D> traction_rows = LocalBlock<D>::Zero();
  each_range<D>([&]<int From, int Count>() {
    traction_rows.template middleCols<Count>(From) = result.pressure * rows.normal.template middleCols<Count>(From) -
                                                     (law.normal * n) * rows.gap.template middleCols<Count>(From);
  });

  result.state = ContactState::stick;
  result.friction.setZero();
  // ε_N g²/2, and with friction |t_T|²/(2 ε_T)
  result.potential = 0.5 * law.normal * g * g;
  // A point with a fixed state may be in tension, where Coulomb's limit does not exist.
  const bool sticks = geometry.fixed_state == FixedContactState::stick;
  if (law.friction > 0 && geometry.slip_point && (result.pressure > 0 || sticks)) {
    // Trial t_T = ε_T (xᵐ(ξ̄) − xᵐ(ξ_sl)) (thesis 3.74), both on the current master
    const Vec<D> trial = law.tangential * (master.position - *geometry.slip_point);
    LocalBlock<D> trial_rows = LocalBlock<D>::Zero();
    each_range<D>([&]<int From, int Count>() {
      for (int a = 0; a < tangents; ++a)
        trial_rows.template middleCols<Count>(From) +=
            (law.tangential * master.tangent[a]) * result.shift.row(a).template middleCols<Count>(From);
    });
    trial_rows.template middleCols<D>(Force::master_column).diagonal().array() += law.tangential;
    trial_rows.template middleCols<D>(Force::slip_column).diagonal().setConstant(-law.tangential);

    const double magnitude = trial.norm(), limit = law.friction * result.pressure;
    // (ε_T + μ ε_N) |tie|: change of |t| − μ t_N due to an error |tie| of gap and slip
    const double tie = (law.tangential + law.friction * law.normal) * geometry.tie;
    if (magnitude == 0 || !slips(geometry.fixed_state, magnitude, limit, tie)) {
      result.friction = trial;
      traction_rows -= trial_rows;
    } else {
      // t_T = μ t_N n_T,  δt_T = μ δt_N n_T + μ t_N/|t| (I − n_T n_Tᵀ) δt   (thesis 3.76)
      result.state = ContactState::slip;
      const Vec<D> direction = trial / magnitude;
      result.friction = limit * direction;
      const Mat<D> projector = (limit / magnitude) * (Mat<D>::Identity() - direction * direction.transpose());
      each_range<D>([&]<int From, int Count>() {
        traction_rows.template middleCols<Count>(From) +=
            (law.friction * law.normal * direction) * rows.gap.template middleCols<Count>(From) -
            projector * trial_rows.template middleCols<Count>(From);
      });
      traction_rows.template middleCols<D>(Force::slip_column) = law.tangential * projector;
    }
    traction -= result.friction;
    result.potential += result.friction.squaredNorm() / (2 * law.tangential);
  }

  LocalRow<D> measure_row;
  const double current = slave_measure(geometry, measure_row);
  result.measure = current;
  result.stretch = 1;
  if (law.per == TractionArea::reference) {
    // dA is constant: δ(t_c dA) = δt_c dA
    result.measure = geometry.reference_measure;
    result.stretch = current / geometry.reference_measure;
    measure_row.setZero();
  }
  fade_area(geometry, result.shift, result.measure, measure_row);
  result.force = result.measure * traction;
  result.tangent = result.measure * traction_rows;
  result.tangent.noalias() += traction * measure_row;
}

template void penalty_force<2>(const PenaltyLaw&, const LocalGeometry<2>&, LocalForce<2>&);
template void penalty_force<3>(const PenaltyLaw&, const LocalGeometry<3>&, LocalForce<3>&);

} // namespace signorini::contact
