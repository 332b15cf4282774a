#pragma once
// Multipliers that are unknowns: their conditions, and their coupling with the displacements.

#include "contact/mortar/multiplier_law.hpp"
#include "contact/mortar/multiplier_rows.hpp"

namespace signorini::contact {

template <int D> class UnknownMultipliers {
public:
  /// `scale`: s, see multiplier_law.hpp; `frictional`: friction acts or may act later.
  UnknownMultipliers(double scale, bool frictional, const MultiplierFunctions<D>& functions,
                     const ContactPoints<D>& points);

  double scale() const { return scale_; }
  bool frictional() const { return frictional_; }
  /// Number of unknowns of a multiplier: pressure, and with friction a vector.
  int each() const { return frictional_ ? 1 + D : 1; }
  /// s χ_N of a multiplier, from the unknowns of all.
  double pressure(const double* all, int multiplier) const { return scale_ * unknowns(all, multiplier).normal; }

  /// Sets the conditions of a multiplier, which is open or closed with these arguments of multiplier_law().
  void open(int multiplier, const double* all) {
    conditions_[multiplier] = open_multiplier(scale_, whole_[multiplier], unknowns(all, multiplier));
  }
  void close(int multiplier, const double* all, const PenaltyLaw& law, const MultiplierSums<D>& sums,
             const Vec<D>& touch, const FrictionControl& control, MultiplierResult<D>& result) {
    conditions_[multiplier] =
        multiplier_law(law, scale_, sums, whole_[multiplier], unknowns(all, multiplier), touch, control, result);
  }

  /// Fills the block of a multiplier's own rows and columns.
  void fill_conditions(int multiplier, bool tangent, Block& block) const;
  /// Fills the block that couples the nodes of a strip with the multipliers of its slave element: derivatives of the
  /// conditions with respect to displacements, and of forces with respect to the multipliers' unknowns.
  void fill_coupling(const Strip& strip, Block& block) const;

private:
  MultiplierUnknowns<D> unknowns(const double* all, int multiplier) const;
  void number_unknowns(int multiplier, std::vector<int>& numbers) const;

  double scale_;
  bool frictional_;
  const MultiplierFunctions<D>& functions_;
  std::vector<double> whole_; ///< areas of the multipliers without open ends
  std::vector<ConditionRows<D>> conditions_;
};

} // namespace signorini::contact
