#pragma once
// Gauss-point penalty contact with Coulomb friction, optionally with the augmented Lagrangian method.

#include "contact/gauss_point_contact.hpp"
#include "contact/penalty.hpp"

namespace signorini::contact {

template <int D> class PenaltyContact final : public GaussPointContact<D> {
public:
  /// Throws Error if a constant is invalid or no contact point is left.
  PenaltyContact(ContactSetting<D> setting, const PenaltyLaw& law, Pass pass = Pass::full);

  /// Tractions per current area are not the derivative of an energy: δ(t_c a) contains t_c δa. Those of a half pass
  /// depend on the master's position, but do not act on it.
  bool has_potential() const override {
    return law_.per == TractionArea::reference && !frictional() && this->pass() == Pass::full;
  }
  double friction() const override { return law_.friction; }
  double penalty() const override { return law_.normal; }
  bool augmented() const override { return law_.enforcement == Enforcement::augmented; }
  void augment(History<D>& history) const override;
  double violation(const History<D>& history) const override;
  double stiffness(const History<D>& history, double penalty_factor) const override;

private:
  using typename GaussPointContact<D>::Part;
  using typename GaussPointContact<D>::Feet;
  bool frictional() const { return law_.friction > 0; }
  void evaluate_point(std::size_t i, const Trial<D>& trial, Part& part, Feet& at) override;
  void commit_points(History<D>& present, double penalty_factor) override;
  void remember_touch(std::size_t i, const Trial<D>& trial) const;
  void advance_slip_point(std::size_t i, History<D>& history, const PenaltyLaw& law) const;

  PenaltyLaw law_; ///< without penalty factor
};

} // namespace signorini::contact
