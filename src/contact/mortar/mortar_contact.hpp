#pragma once
// Mortar contact: gaps and slips weighted by multiplier functions on the slave face, and pressures by a penalty.

#include "contact/gauss/formulation.hpp"
#include "contact/mortar/element_sums.hpp"
#include "contact/mortar/multiplier_coupling.hpp"

namespace signorini::contact {

/// Tractions Σ M_A (z_A n̄ − t_A) per reference area, whatever the law's `per`, with the pressures z_A and frictions t_A
/// of mortar_law.hpp. Without friction the virtual work is Σ z_A a_A δḡ_A, which has a potential. In a half pass
/// tractions act per current area, with which gaps and slips are weighted as well: a_A and ḡ_A of a face do not depend
/// on its reference shape.
template <int D> class MortarContact final : public Formulation<D> {
public:
  /// Throws Error if a constant is invalid, no contact point is left, or the face has no such multipliers.
  MortarContact(const ContactSetting<D>& setting, const InterfaceLaw& law, MultiplierSpace multipliers, Pass pass);

  const Multipliers* multipliers() const override { return &multipliers_; }
  /// Except beyond open ends of the master, where the area on which tractions act changes.
  bool has_potential() const override { return !may_rub(*parameters_.law) && parameters_.pass == Pass::full; }
  int parts() const override { return std::ssize(parts_); }
  void evaluate_part(int part, const Trial<D>& trial, bool tangent) override;
  void gather(const Trial<D>& trial, bool tangent) override;
  void commit(History<D>& present, const History<D>& accepted, double penalty_factor) override;
  double stiffness(const History<D>& history, double penalty_factor) const override;
  double memory() const override;
  const MultiplierFunctions<D>& functions() const { return functions_; }

private:
  using Formulation<D>::faces_, Formulation<D>::points_, Formulation<D>::parameters_, Formulation<D>::blocks_;
  bool frictional(const History<D>& history) const { return parameters_.slides(history.changes); }
  bool is_far(int multiplier, const Trial<D>& trial) const;
  double measure(std::size_t i, const Vec<D>& position) const;
  void weigh(std::size_t i, const Trial<D>& trial, FootPoints<D>& feet, double* seconds);
  double gap_before(std::size_t i, const Trial<D>& trial, double now) const;
  void decide(const Trial<D>& trial);
  void distribute(int part, const Trial<D>& trial, bool tangent);
  void add_point(std::size_t i, int part, const Trial<D>& trial, bool tangent, FootPoints<D>& feet,
                 std::vector<double>& weights);
  void move_slip_points(const Trial<D>& trial);
  void couple(bool frictional);
  void advance(History<D>& present, const History<D>& accepted) const;
  void wear(History<D>& present, const History<D>& accepted) const;
  void spread(History<D>& present) const;
  void release(History<D>& present, const History<D>& accepted, double tangential) const;
  void take_back(std::vector<Block>& blocks) override;

  MultiplierFunctions<D> functions_;
  Multipliers multipliers_;
  std::vector<SumPart<D>> parts_;
  std::vector<MultiplierRows<D>> rows_; ///< by part
  ElementSums<D> element_sums_;
  std::vector<WeightedMultiplier<D>> weighted_; ///< by multiplier
  MultiplierCoupling<D> coupling_;
  std::vector<Block> spare_;
};

} // namespace signorini::contact
