#pragma once
// Gauss-point penalty contact with Coulomb friction, optionally with the augmented Lagrangian method.

#include "contact/gauss/gauss_point_contact.hpp"
#include "contact/point/penalty.hpp"

#include <optional>

namespace signorini::contact {

template <int D> class PenaltyContact : public GaussPointContact<D> {
public:
  /// Throws Error if a constant is invalid or no contact point is left.
  PenaltyContact(ContactSetting<D> setting, const PenaltyLaw& law, Pass pass = Pass::full);

  /// Tractions per current area are not the derivative of an energy: δ(t_c a) contains t_c δa. Those of a half pass
  /// depend on the master's position, but do not act on it.
  bool has_potential() const override {
    return law_.per == TractionArea::reference && !may_rub(law_) && this->pass() == Pass::full;
  }
  void augment(History<D>& history) const override;
  double violation(const History<D>& history) const override;
  double stiffness(const History<D>& history, double penalty_factor) const override;

protected:
  using typename GaussPointContact<D>::Part;
  using typename GaussPointContact<D>::Feet;
  const PenaltyLaw* law() const override { return &law_; }
  /// The law in a state.
  PenaltyLaw law(const History<D>& history, double penalty_factor) const {
    return scaled(changed(law_, history.changes), penalty_factor);
  }
  void evaluate_point(std::size_t i, const Trial<D>& trial, Part& part, Feet& at) override;
  void commit_points(History<D>& present, const History<D>& accepted, double penalty_factor) override;
  /// The fixed state of point i if the penalty acts on it, with its closest point in at.foot; none: it is open.
  std::optional<FixedContactState> close(std::size_t i, const Trial<D>& trial, Part& part, Feet& at) const;
  /// The geometry of a closed point, with the slip point in at.slip_point if there is friction.
  LocalGeometry<D> closed_geometry(std::size_t i, const Trial<D>& trial, const PenaltyLaw& law, FixedContactState fixed,
                                   Feet& at) const;
  /// Fraction of a point's area on which friction acts, and the friction and the pressure of the penalties there.
  virtual double rubbing(const History<D>& /*history*/, std::size_t /*i*/) const { return 1; }
  virtual Vec<D> friction_of(const History<D>& history, std::size_t i) const { return history.results[i].friction; }
  virtual double pressure_of(const History<D>& history, std::size_t i) const { return history.results[i].pressure; }

private:
  void foresee_touch(std::size_t i, const Trial<D>& trial, const PenaltyLaw& law) const;
  void remember_touch(std::size_t i, const Trial<D>& trial) const;
  void release(History<D>& present, const History<D>& accepted, double penalty_factor) const;
  void advance_slip_point(std::size_t i, History<D>& history, const History<D>& accepted, const PenaltyLaw& law) const;

  PenaltyLaw law_; ///< of the scene
};

} // namespace signorini::contact
