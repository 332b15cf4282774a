#include "contact/point/interface_force.hpp"

#include "contact/law/wear.hpp"

namespace signorini::contact {

namespace {

/// Calls visit<first, count>() for the columns of xˢ, and of x̄ᵐ and τ_α: gap, normal and ξ̄ do not depend on others.
template <int D, class Visit> void each_range(const Visit& visit) {
  visit.template operator()<0, D>();
  visit.template operator()<LocalForce<D>::master_column, D * D>();
}

/// The trial friction ε_T (xᵐ(ξ̄) − xᵐ(ξ_sl)) of a point with a slip point (thesis 3.74), both on the current master.
template <int D> Vec<D> trial_friction(const InterfaceLaw& law, const LocalGeometry<D>& geometry) {
  return law.tangential * (geometry.master->position - *geometry.slip_point);
}

template <int D>
LocalBlock<D> trial_rows(const InterfaceLaw& law, const LocalGeometry<D>& geometry, const LocalShift<D>& shift) {
  using Force = LocalForce<D>;
  LocalBlock<D> rows = LocalBlock<D>::Zero();
  each_range<D>([&]<int From, int Count>() {
    for (int a = 0; a < D - 1; ++a)
      rows.template middleCols<Count>(From) +=
          (law.tangential * geometry.master->tangent[a]) * shift.row(a).template middleCols<Count>(From);
  });
  rows.template middleCols<D>(Force::master_column).diagonal().array() += law.tangential;
  rows.template middleCols<D>(Force::slip_column).diagonal().setConstant(-law.tangential);
  return rows;
}

/// Subtracts the friction of a point with a slip point from the derivatives of its traction.
template <int D>
void subtract_friction(const InterfaceLaw& law, const Rubbing<D>& rubbing, const LocalGeometry<D>& geometry,
                       const LocalRow<D>& gap, const LocalShift<D>& shift, LocalBlock<D>& traction_rows) {
  using Force = LocalForce<D>;
  const LocalBlock<D> trial = trial_rows(law, geometry, shift);
  const Slide<D>& step = rubbing.slide;
  if (step.state == ContactState::stick) {
    traction_rows -= trial;
    return;
  }
  each_range<D>([&]<int From, int Count>() {
    traction_rows.template middleCols<Count>(From) -=
        (step.of_pressure * rubbing.response.rate * step.direction) * gap.template middleCols<Count>(From) +
        step.of_trial * trial.template middleCols<Count>(From);
  });
  traction_rows.template middleCols<D>(Force::slip_column) = law.tangential * step.of_trial;
  // δp = … + of_trial·δt* by wear
  if (rubbing.worn != 0)
    traction_rows.noalias() +=
        (geometry.normal - step.of_pressure * step.direction) * (rubbing.of_trial.transpose() * trial);
}

} // namespace

template <int D>
void interface_force(const InterfaceLaw& law, const LocalGeometry<D>& geometry, LocalForce<D>& result) {
  const Vec<D>& n = geometry.normal;
  const double g = geometry.gap - geometry.offset;
  const GapRows<D> rows = gap_rows(geometry, result.shift);
  GapResponse response = respond(law, g, geometry.interface);

  result.state = state_of(law, g, response.pressure);
  result.friction.setZero();
  result.mu = law.coefficient ? 0 : law.friction;
  result.flaw = FrictionFlaw::none;
  result.worn = 0;
  result.potential = law.pressure ? 0 : energy(law, g, {});
  // A point with a fixed state may be in tension, where Coulomb's limit does not exist.
  const bool rubs = response.pressure > 0 || geometry.fixed_state == FixedContactState::stick;
  std::optional<Rubbing<D>> rubbing;
  if (slides(law) && geometry.slip_point && rubs) {
    rubbing =
        rub<D>(law, response, g, trial_friction(law, geometry), geometry.fixed_state, geometry.tie, geometry.interface);
    response = rubbing->response;
    result.state = rubbing->slide.state;
    result.mu = rubbing->slide.mu;
    result.flaw = rubbing->slide.flaw;
    result.worn = rubbing->worn;
    result.friction = rubbing->slide.friction;
    if (rubbing->worn != 0 && !law.pressure) result.potential = energy(law, g + rubbing->worn, {});
    result.potential += result.friction.squaredNorm() / (2 * law.tangential); // |t_T|²/(2 ε_T)
  }
  // δ(p n̄) = p′ δg n̄ + p δn̄
  result.pressure = response.pressure;
  LocalBlock<D> traction_rows = LocalBlock<D>::Zero();
  each_range<D>([&]<int From, int Count>() {
    traction_rows.template middleCols<Count>(From) = result.pressure * rows.normal.template middleCols<Count>(From) +
                                                     (response.rate * n) * rows.gap.template middleCols<Count>(From);
  });
  if (rubbing) subtract_friction(law, *rubbing, geometry, rows.gap, result.shift, traction_rows);
  const Vec<D> traction = result.pressure * n - result.friction;

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

template void interface_force<2>(const InterfaceLaw&, const LocalGeometry<2>&, LocalForce<2>&);
template void interface_force<3>(const InterfaceLaw&, const LocalGeometry<3>&, LocalForce<3>&);

} // namespace signorini::contact
