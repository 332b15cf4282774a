#pragma once
// Lagrange multipliers as functions on the slave face, with contact conditions that are integrated point by point.

#include "contact/gauss/gauss_point_contact.hpp"
#include "contact/mortar/coupling_sums.hpp"
#include "contact/mortar/multiplier_functions.hpp"
#include "contact/mortar/multiplier_law.hpp"

namespace signorini::contact {

/// Constants of multipliers that are unknowns.
struct UnknownMultipliers {
  double scale = 0; ///< pressure per length; 0: that of the penalty
  int joined = 1;   ///< elements per function of MultiplierSpace::linear
};

/// λ = s Σ M_A χ_A is a pressure, with friction a vector, per reference area; the unknowns χ_A are lengths, so that
/// their rows are forces. Points are open, stick and slip, and transmit λ + c with the c of multiplier_law.hpp; the
/// equations of multiplier A are 0 = ∫ M_A c dA. Both are the derivatives of the augmented Lagrangian
/// ∫ (⟨λ − ε_N g⟩² − λ²)/(2 ε_N) dA, which makes the tangent without friction symmetric. In the derivatives only, a
/// proximal term −proximal_contact a_A δλ_A, a_A = ∫ M_A dA, makes the system regular where conditions depend on each
/// other or on supports; it vanishes with the correction δλ [theory 8.2].
template <int D> class MultiplierContact final : public GaussPointContact<D> {
public:
  /// Throws Error if a constant is invalid, no contact point is left, or the face has no such multipliers.
  MultiplierContact(ContactSetting<D> setting, const InterfaceLaw& law, MultiplierSpace multipliers,
                    const UnknownMultipliers& constants);

  int extra_unknowns() const override { return functions_.count() * each_; }
  bool has_potential() const override { return false; }
  void evaluate_part(int part, const Trial<D>& trial, bool tangent) override;
  void gather(const Trial<D>& trial, bool tangent) override;
  void commit(History<D>& present, const History<D>& accepted, double penalty_factor) override;
  double memory() const override;

private:
  using GaussPointContact<D>::faces_, GaussPointContact<D>::points_, GaussPointContact<D>::parameters_,
      GaussPointContact<D>::parts_;
  bool frictional() const { return each_ > 1; }
  Vec<D> multiplier_at(std::size_t i, const double* unknowns) const;
  void start_conditions(int element, bool tangent);
  void add_unused(const Trial<D>& trial, bool tangent);
  void add_condition(std::size_t i, double area, const PointCondition<D>& condition, bool tangent);
  void evaluate_point(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet) override;
  void transmit(std::size_t i, const Trial<D>& trial, const Vec<D>& multiplier, const LocalGeometry<D>& geometry,
                SumPart<D>& part, FootPoints<D>& feet);
  MasterPoint<D> slipped_to(const PointHistory<D>& point, const Vec<D>& slip) const;
  Vec<D> slip_direction(std::size_t i, const PointHistory<D>& point, const PointResult<D>& result) const;
  void take_back(std::vector<Block>& blocks) override;

  MultiplierFunctions<D> functions_;
  int each_; ///< unknowns of a multiplier
  double scale_;
  std::vector<CouplingSums<D>> couplings_; ///< by part
  std::vector<Block> conditions_;          ///< by slave element
  std::vector<double> areas_;              ///< of the multipliers
};

} // namespace signorini::contact
