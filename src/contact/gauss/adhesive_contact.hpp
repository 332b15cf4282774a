#pragma once
// Van der Waals adhesion at the Gauss points of the slave face.

#include "contact/gauss/gauss_point_contact.hpp"
#include "contact/point/adhesion.hpp"

namespace signorini::contact {

template <int D> class AdhesiveContact final : public GaussPointContact<D> {
public:
  /// Throws Error if a constant is invalid or no contact point is left.
  AdhesiveContact(ContactSetting<D> setting, const Adhesion& law);

  bool has_potential() const override { return true; }
  double stiffness(const History<D>& history, double penalty_factor) const override;

private:
  /// Ignores the controls: adhesion acts at any gap.
  void evaluate_point(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet) override;

  Adhesion law_;
};

} // namespace signorini::contact
