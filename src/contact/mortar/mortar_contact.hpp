#pragma once
// Mortar contact: gaps and slips weighted by multiplier functions on the slave face, and pressures by penalty and
// augmentation or as unknowns.

#include "contact/gauss/block_sums.hpp"
#include "contact/gauss/formulation.hpp"
#include "contact/mortar/multiplier_blocks.hpp"
#include "contact/point/point_geometry.hpp"

namespace signorini::contact {

struct MortarLaw {
  PenaltyLaw penalty; ///< at multipliers; per reference area, in a half pass per current area, whatever its `per`
  MultiplierSpace multipliers = MultiplierSpace::equal;
  double scale = 0; ///< of multipliers that are unknowns, pressure per length; 0: that of `penalty`
};

/// Tractions Σ M_A (z_A n̄ − t_A) per reference area with the pressures z_A and frictions t_A of mortar_law.hpp. Without
/// friction the virtual work is Σ z_A a_A δḡ_A, which has a potential. In a half pass tractions act per current area,
/// with which gaps and slips are weighted as well: a_A and ḡ_A of a face do not depend on its reference shape.
/// With Enforcement::multipliers z_A and t_A are unknowns with the equations of multiplier_law.hpp.
template <int D> class MortarContact final : public Formulation<D> {
public:
  /// Throws Error if a constant is invalid, no contact point is left, or the face has no such multipliers.
  MortarContact(const ContactSetting<D>& setting, const MortarLaw& law, Pass pass = Pass::full);

  int multipliers() const override { return functions_.count(); }
  int point_of(int constraint) const override { return std::max(functions_.largest(constraint), 0); }
  int extra_unknowns() const override;
  /// Except beyond open ends of the master, where the area on which tractions act changes.
  bool has_potential() const override { return !may_rub(law_) && !solves_multipliers() && pass_ == Pass::full; }
  int parts() const override { return std::ssize(parts_); }
  void evaluate_part(int part, const Trial<D>& trial, bool tangent) override;
  void gather(const Trial<D>& trial, bool tangent) override;
  void augment(History<D>& history) const override;
  double violation(const History<D>& history) const override;
  double stiffness(const History<D>& history, double penalty_factor) const override;
  double memory() const override;
  const MultiplierFunctions<D>& functions() const { return functions_; }

private:
  /// A piece of the slave face: whole elements.
  struct Part {
    std::size_t first, last; ///< points
    BlockSums<D> sums;
    MultiplierRows<D> rows;
    CouplingSpace space;
    double search_seconds = 0; ///< since the last gather()
    std::size_t blocks = 0;    ///< number of element blocks in the last gather()
  };
  /// Working space: foot point and former foot point on the master.
  struct Feet {
    FacePoint<D> foot, slip_point;
  };

  const PenaltyLaw* law() const override { return &law_; }
  double share() const override { return energy_share(pass_); }
  /// The law in a state.
  PenaltyLaw law(const History<D>& history, double penalty_factor) const {
    return scaled(changed(law_, history.changes), penalty_factor);
  }
  /// Whether slips are weighted: with friction and, since its unknowns remain, where multipliers may have it later.
  bool frictional(const History<D>& history) const {
    return solves_multipliers() ? may_rub(law_) : changed(law_, history.changes).friction > 0;
  }
  bool solves_multipliers() const { return law_.enforcement == Enforcement::multipliers; }
  double measure(std::size_t i, const Vec<D>& position) const;
  bool is_far(int multiplier, const Trial<D>& trial) const;
  void weigh(std::size_t i, const Trial<D>& trial, Part& part, Feet& at);
  void remember_foot(std::size_t i, const Trial<D>& trial) const;
  double gap_before(std::size_t i, const Trial<D>& trial, double now) const;
  void foresee_touch(int multiplier, const MultiplierSums<D>& sum, const Trial<D>& trial);
  void move_feet(const Trial<D>& trial);
  MultiplierSums<D> sum_up(int multiplier) const;
  void decide(const Trial<D>& trial);
  void distribute(Part& part, const Trial<D>& trial, bool tangent);
  void add_point(std::size_t i, const Trial<D>& trial, bool tangent, Part& part, Feet& at,
                 std::vector<double>& weights);
  Block& new_block();
  void couple_all(bool frictional);
  void add_conditions(bool tangent);
  void commit_points(History<D>& present, const History<D>& accepted, double penalty_factor) override;
  void release(History<D>& present, const History<D>& accepted, double penalty_factor) const;
  void take_back(std::vector<Block>& blocks) override;

  PenaltyLaw law_; ///< of the scene
  double scale_;   ///< of unknown multipliers
  Pass pass_;
  MultiplierFunctions<D> functions_;
  std::vector<Part> parts_;
  std::vector<std::size_t> first_sum_;            ///< per slave element: offset into element_sums_
  std::vector<MultiplierSums<D>> element_sums_;   ///< per slave element and multiplier on it
  std::vector<char> is_skipped_;                  ///< per slave element: its points were not projected
  std::vector<double> cleared_;                   ///< per slave element: least `cleared` of its points
  std::vector<MultiplierSums<D>> sums_;           ///< per multiplier, as the next
  std::vector<double> fractions_;                 ///< s*_A of a forecast, otherwise 0
  std::vector<MultiplierTangent<D>> tangents_;    ///< without unknown multipliers
  std::vector<ConditionRows<D>> conditions_;      ///< with unknown multipliers
  std::vector<double> whole_;                     ///< their areas without open ends
  std::vector<std::vector<const Strip*>> strips_; ///< per slave element
  std::vector<Block> spare_;
};

} // namespace signorini::contact
