#include "contact/point/interface_force.hpp"

#include "contact/point/frame.hpp"

namespace signorini::contact {

namespace {

/// Calls visit<first, count>() for the columns of xˢ, and of x̄ᵐ and τ_α: gap, normal and ξ̄ do not depend on others.
template <int D, class Visit> void each_range(const Visit& visit) {
  visit.template operator()<0, D>();
  visit.template operator()<LocalForce<D>::master_column, D * D>();
}

/// What a law of friction and wear has found at a point, in axes or not.
template <int D, int N>
void store(const InterfaceLaw& law, double gap, const Rubbing<N>& rubbing, const Vec<D>& friction,
           LocalForce<D>& result) {
  result.state = rubbing.slide.state;
  result.mu = rubbing.slide.mu;
  result.flaw = rubbing.slide.flaw;
  result.worn = rubbing.worn;
  result.friction = friction;
  if (result.worn != 0 && !law.pressure) result.potential = energy(law, gap + result.worn, {});
  result.potential += friction.squaredNorm() / (2 * law.tangential); // |t_T|²/(2 ε_T)
}

/// Subtracts the friction of a point with a slip point from the derivatives of its traction.
template <int D>
void subtract_friction(const InterfaceLaw& law, const Rubbing<D>& rubbing, const LocalGeometry<D>& geometry,
                       const GapRows<D>& rows, const LocalShift<D>& shift, LocalBlock<D>& traction_rows) {
  using Force = LocalForce<D>;
  LocalBlock<D> trial_rows = LocalBlock<D>::Zero();
  each_range<D>([&]<int From, int Count>() {
    for (int a = 0; a < D - 1; ++a)
      trial_rows.template middleCols<Count>(From) +=
          (law.tangential * geometry.master->tangent[a]) * shift.row(a).template middleCols<Count>(From);
  });
  trial_rows.template middleCols<D>(Force::master_column).diagonal().array() += law.tangential;
  trial_rows.template middleCols<D>(Force::slip_column).diagonal().setConstant(-law.tangential);
  turn_slip(geometry, rows, law.tangential, trial_rows);

  const Slide<D>& step = rubbing.slide;
  if (step.state == ContactState::stick) {
    traction_rows -= trial_rows;
    return;
  }
  each_range<D>([&]<int From, int Count>() {
    traction_rows.template middleCols<Count>(From) -=
        (step.of_pressure * rubbing.response.rate * step.direction) * rows.gap.template middleCols<Count>(From) +
        step.of_trial * trial_rows.template middleCols<Count>(From);
  });
  traction_rows.template middleCols<D>(Force::slip_column) =
      -step.of_trial * trial_rows.template middleCols<D>(Force::slip_column);
  // δp = … + of_trial·δt* by wear
  if (rubbing.worn != 0)
    traction_rows.noalias() +=
        (geometry.normal - step.of_pressure * step.direction) * (rubbing.of_trial.transpose() * trial_rows);
}

/// The same of a law with an axis, whose friction is in the plane normal to n̄.
template <int D>
void subtract_friction(const PlaneSlide<D>& found, const LocalGeometry<D>& geometry, const GapRows<D>& rows,
                       const LocalShift<D>& shift, LocalBlock<D>& traction_rows) {
  const LocalBlock<D> slip = slip_rows(geometry, rows, shift);
  traction_rows -=
      (found.rubbing.response.rate * found.of_pressure) * rows.gap + friction_rows(found, geometry, slip, rows);
  if (found.worn)
    traction_rows.noalias() += (geometry.normal - found.of_pressure) * pressure_row(found, geometry, slip, rows);
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
  std::optional<PlaneSlide<D>> in_plane;
  if (slides(law) && geometry.slip_point && rubs) {
    const Vec<D> slip = slip_of(geometry);
    if (law.along) {
      in_plane = slide_along_axes(law, geometry, slip, response);
      response = in_plane->rubbing.response;
      store<D, D - 1>(law, g, in_plane->rubbing, in_plane->friction, result);
    } else {
      // Trial t_T = ε_T (xᵐ(ξ̄) − xᵐ(ξ_sl)) (thesis 3.74)
      rubbing = rub<D>(law, response, g, law.tangential * slip, geometry.fixed_state, geometry.tie, geometry.interface);
      response = rubbing->response;
      store<D, D>(law, g, *rubbing, rubbing->slide.friction, result);
    }
  }
  // δ(p n̄) = p′ δg n̄ + p δn̄
  result.pressure = response.pressure;
  LocalBlock<D> traction_rows = LocalBlock<D>::Zero();
  each_range<D>([&]<int From, int Count>() {
    traction_rows.template middleCols<Count>(From) = result.pressure * rows.normal.template middleCols<Count>(From) +
                                                     (response.rate * n) * rows.gap.template middleCols<Count>(From);
  });
  if (rubbing) subtract_friction(law, *rubbing, geometry, rows, result.shift, traction_rows);
  if (in_plane) subtract_friction(*in_plane, geometry, rows, result.shift, traction_rows);
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
