#include "contact/point/interface_force.hpp"

#include "contact/point/frame.hpp"

namespace signorini::contact {

namespace {

/// Calls visit<first, count>() for the columns of xˢ, and of x̄ᵐ and τ_α: gap, normal and ξ̄ do not depend on others.
template <int D, class Visit> void each_range(const Visit& visit) {
  visit.template operator()<0, D>();
  visit.template operator()<LocalForce<D>::master_column, D * D>();
}

/// What a law of friction has found at a point, in axes or not.
template <int D, int N>
void store(const Slide<N>& step, const Vec<D>& friction, double tangential, LocalForce<D>& result) {
  result.state = step.state;
  result.mu = step.mu;
  result.flaw = step.flaw;
  result.friction = friction;
  result.potential += friction.squaredNorm() / (2 * tangential); // |t_T|²/(2 ε_T)
}

/// Subtracts the friction of a point with a slip point from its traction, with the response to its gap.
template <int D>
void rub(const InterfaceLaw& law, const LocalGeometry<D>& geometry, const LocalRow<D>& gap, double rate,
         LocalForce<D>& result, LocalBlock<D>& traction_rows) {
  using Force = LocalForce<D>;
  const FacePoint<D>& master = *geometry.master;
  // Trial t_T = ε_T (xᵐ(ξ̄) − xᵐ(ξ_sl)) (thesis 3.74), both on the current master
  const Vec<D> trial = law.tangential * (master.position - *geometry.slip_point);
  LocalBlock<D> trial_rows = LocalBlock<D>::Zero();
  each_range<D>([&]<int From, int Count>() {
    for (int a = 0; a < D - 1; ++a)
      trial_rows.template middleCols<Count>(From) +=
          (law.tangential * master.tangent[a]) * result.shift.row(a).template middleCols<Count>(From);
  });
  trial_rows.template middleCols<D>(Force::master_column).diagonal().array() += law.tangential;
  trial_rows.template middleCols<D>(Force::slip_column).diagonal().setConstant(-law.tangential);

  const Slide<D> step = slide<D>(law, trial, result.pressure, geometry.fixed_state, geometry.tie, geometry.interface);
  store<D, D>(step, step.friction, law.tangential, result);
  if (step.state == ContactState::stick) {
    traction_rows -= trial_rows;
    return;
  }
  each_range<D>([&]<int From, int Count>() {
    traction_rows.template middleCols<Count>(From) -=
        (step.of_pressure * rate * step.direction) * gap.template middleCols<Count>(From) +
        step.of_trial * trial_rows.template middleCols<Count>(From);
  });
  traction_rows.template middleCols<D>(Force::slip_column) = law.tangential * step.of_trial;
}

/// The same of a law with an axis, whose friction is in the plane normal to n̄.
template <int D>
void rub_along_axes(const InterfaceLaw& law, const LocalGeometry<D>& geometry, const GapRows<D>& rows, double rate,
                    LocalForce<D>& result, LocalBlock<D>& traction_rows) {
  const Vec<D> slip = geometry.master->position - *geometry.slip_point;
  const PlaneSlide<D> found = slide_along_axes(law, geometry, slip, result.pressure);
  store<D, D - 1>(found.step, found.friction, law.tangential, result);
  traction_rows -=
      (rate * found.of_pressure) * rows.gap + friction_rows(found, geometry, slip_rows(geometry, result.shift), rows);
}

} // namespace

template <int D>
void interface_force(const InterfaceLaw& law, const LocalGeometry<D>& geometry, LocalForce<D>& result) {
  const Vec<D>& n = geometry.normal;
  const double g = geometry.gap - geometry.offset;
  const GapRows<D> rows = gap_rows(geometry, result.shift);
  const GapResponse response = respond(law, g, geometry.interface);

  // δ(p n̄) = p′ δg n̄ + p δn̄
  result.pressure = response.pressure;
  LocalBlock<D> traction_rows = LocalBlock<D>::Zero();
  each_range<D>([&]<int From, int Count>() {
    traction_rows.template middleCols<Count>(From) = result.pressure * rows.normal.template middleCols<Count>(From) +
                                                     (response.rate * n) * rows.gap.template middleCols<Count>(From);
  });
  result.state = state_of(law, g, response.pressure);
  result.friction.setZero();
  result.mu = law.coefficient ? 0 : law.friction;
  result.flaw = FrictionFlaw::none;
  result.potential = response.potential;
  // A point with a fixed state may be in tension, where Coulomb's limit does not exist.
  const bool rubs = result.pressure > 0 || geometry.fixed_state == FixedContactState::stick;
  if (law.friction > 0 && geometry.slip_point && rubs) {
    if (law.along)
      rub_along_axes(law, geometry, rows, response.rate, result, traction_rows);
    else
      rub(law, geometry, rows.gap, response.rate, result, traction_rows);
  }
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
