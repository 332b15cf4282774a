#pragma once
// Gauss-point penalty contact between faces that are bonded in the initial state, with debonding and friction.

#include "contact/gauss/gauss_point_contact.hpp"
#include "contact/point/bond_force.hpp"

namespace signorini::contact {

/// At a point whose bond has the damage d, friction acts on the fraction d of its area (G. Alfano, E. Sacco, IJNME 68,
/// 2006). Points that are not bonded are in penalty contact.
template <int D> class CohesiveContact final : public GaussPointContact<D> {
public:
  /// Throws Error if a constant is invalid, or no contact point is left or bonded.
  CohesiveContact(const ContactSetting<D>& setting, const InterfaceLaw& law, const Cohesion& cohesion);

  const Bonds<D>* bonds() const override { return &bonds_; }
  /// A damage that depends on the mode mix, or shear of another weight, has no energy of its own.
  bool has_potential() const override { return !tells_shear(bonds_.law) && GaussPointContact<D>::has_potential(); }
  void commit(History<D>& present, const History<D>& accepted, double penalty_factor) override;
  double stiffness(const History<D>& history, double penalty_factor) const override;

private:
  using GaussPointContact<D>::faces_, GaussPointContact<D>::points_, GaussPointContact<D>::parameters_;
  void evaluate_point(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet) override;
  double rubbing(const History<D>& history, std::size_t i) const override { return bonds_.damage(history, i); }
  Vec<D> friction_of(const History<D>& history, std::size_t i) const override;
  double pressure_of(const History<D>& history, std::size_t i) const override;
  void record_bond(std::size_t i, const Trial<D>& trial, const Bond<D>& bond, const Separation& separation,
                   const FacePoint<D>& bonded, SumPart<D>& part, const FacePoint<D>* foot = nullptr) const;
  void dissipate(PointResult<D>& result, PointBond<D>& bond, const PointBond<D>& before) const;

  Bonds<D> bonds_;
};

} // namespace signorini::contact
