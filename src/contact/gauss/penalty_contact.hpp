#pragma once
// Gauss-point penalty contact with Coulomb friction.

#include "contact/gauss/gauss_point_contact.hpp"

namespace signorini::contact {

template <int D> class PenaltyContact : public GaussPointContact<D> {
public:
  /// Throws Error if a constant is invalid or no contact point is left.
  PenaltyContact(ContactSetting<D> setting, const PenaltyLaw& law, Pass pass = Pass::full)
      : GaussPointContact<D>(std::move(setting), law, pass) {}

  /// Tractions per current area are not the derivative of an energy: δ(t_c a) contains t_c δa. Those of a half pass
  /// depend on the master's position, but do not act on it.
  bool has_potential() const override {
    const PenaltyLaw& law = *parameters_.law;
    return law.per == TractionArea::reference && !may_rub(law) && parameters_.pass == Pass::full;
  }
  void commit(History<D>& present, const History<D>& accepted, double penalty_factor) override;
  double stiffness(const History<D>& history, double penalty_factor) const override;

protected:
  using GaussPointContact<D>::faces_, GaussPointContact<D>::points_, GaussPointContact<D>::parameters_;
  void evaluate_point(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet) override;
  /// The fixed state of point i if the penalty acts on it, with its closest point in feet.foot; none: it is open.
  std::optional<FixedContactState> close(std::size_t i, const Trial<D>& trial, SumPart<D>& part,
                                         FootPoints<D>& feet) const;
  /// The geometry of a closed point, with the slip point in feet.slip_point if there is friction.
  LocalGeometry<D> closed_geometry(std::size_t i, const Trial<D>& trial, const PenaltyLaw& law, FixedContactState fixed,
                                   FootPoints<D>& feet) const;
  /// Fraction of a point's area on which friction acts, and the friction and the pressure of the penalties there.
  virtual double rubbing(const History<D>& /*history*/, std::size_t /*i*/) const { return 1; }
  virtual Vec<D> friction_of(const History<D>& history, std::size_t i) const { return history.results[i].friction; }
  virtual double pressure_of(const History<D>& history, std::size_t i) const { return history.results[i].pressure; }

private:
  std::optional<MasterPoint<D>> foresee_touch(std::size_t i, const Trial<D>& trial) const;
  void release(History<D>& present, const History<D>& accepted, double tangential) const;
  void advance_slip_point(std::size_t i, History<D>& history, const History<D>& accepted, const PenaltyLaw& law) const;
};

} // namespace signorini::contact
