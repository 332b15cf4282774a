#pragma once
// Gauss-point-to-surface contact: a traction at each Gauss point of the slave face, the opposite at its foot
// point [theory 5.8].

#include "contact/gauss/block_sums.hpp"
#include "contact/gauss/formulation.hpp"
#include "contact/point/point_geometry.hpp"

namespace signorini::contact {

/// A law at contact points.
template <int D> class GaussPointContact : public Formulation<D> {
public:
  /// Throws Error if a constant is invalid or no contact point is left.
  using Formulation<D>::Formulation;

  /// Tractions per current area are not the derivative of an energy: δ(t_c a) contains t_c δa. Those of a half pass
  /// depend on the master's position, but do not act on it.
  bool has_potential() const override {
    const InterfaceLaw& law = *parameters_.law;
    return law.per == TractionArea::reference && !may_rub(law) && parameters_.pass == Pass::full;
  }
  int parts() const final { return std::ssize(parts_); }
  void evaluate_part(int part, const Trial<D>& trial, bool tangent) override;
  void gather(const Trial<D>& trial, bool tangent) override;
  /// Also chooses the rules of elements for the next step.
  void commit(History<D>& present, const History<D>& accepted, double penalty_factor) override;
  double stiffness(const History<D>& history, double penalty_factor) const override;
  double memory() const override;

protected:
  using Formulation<D>::faces_, Formulation<D>::points_, Formulation<D>::parameters_;

  /// Adds one contact point to results and blocks. On entry its result is that of an open point, with its position.
  virtual void evaluate_point(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet);
  /// Writes the closest point to feet.foot. Returns false if it is an open end of the master.
  bool find_foot(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet) const;
  /// The geometry at feet.foot, whose functions are evaluated as well.
  LocalGeometry<D> geometry(std::size_t i, const Trial<D>& trial, FootPoints<D>& feet) const;
  /// The fixed state of point i if the law acts on it, with its closest point in feet.foot; none: it is open. A law
  /// that acts at any gap ignores the controls.
  std::optional<FixedContactState> close(std::size_t i, const Trial<D>& trial, SumPart<D>& part,
                                         FootPoints<D>& feet) const;
  /// The geometry of a closed point, with the slip point in feet.slip_point if there is friction.
  LocalGeometry<D> closed_geometry(std::size_t i, const Trial<D>& trial, const InterfaceLaw& law,
                                   FixedContactState fixed, FootPoints<D>& feet) const;
  /// Stores the result of the law and adds it to the blocks.
  void record(std::size_t i, const Trial<D>& trial, const LocalGeometry<D>& geometry, const LocalForce<D>& force,
              SumPart<D>& part, const FootPoints<D>& feet) const;
  /// The part of commit() that does not depend on the law.
  void accept(History<D>& present, const History<D>& accepted, double penalty_factor);
  /// Fraction of a point's area on which friction acts, and the friction and the pressure of the law there.
  virtual double rubbing(const History<D>& /*history*/, std::size_t /*i*/) const { return 1; }
  virtual Vec<D> friction_of(const History<D>& history, std::size_t i) const { return history.results[i].friction; }
  virtual double pressure_of(const History<D>& history, std::size_t i) const { return history.results[i].pressure; }

  void take_back(std::vector<Block>& blocks) override;

  std::vector<SumPart<D>> parts_ = parts_of(faces_, points_, parameters_.pass);

private:
  void choose_points(History<D>& present, double moved, double penalty_factor);
  bool is_near(const History<D>& present, std::span<const std::size_t> points, double distance) const;
  void evaluate_points(History<D>& present, const std::vector<std::size_t>& points, double penalty_factor);
  std::optional<MasterPoint<D>> foresee_touch(std::size_t i, const Trial<D>& trial) const;
  void wear(History<D>& present, const History<D>& accepted) const;
  void place_others(History<D>& present) const;
  void release(History<D>& present, const History<D>& accepted, double tangential) const;
  void advance_slip_point(std::size_t i, History<D>& history, const History<D>& accepted,
                          const InterfaceLaw& law) const;
};

} // namespace signorini::contact
