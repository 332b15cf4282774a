#pragma once
// Gauss-point-to-surface contact: a traction at each Gauss point of the slave face, the opposite at its foot
// point [theory 5.8].

#include "contact/gauss/block_sums.hpp"
#include "contact/gauss/formulation.hpp"
#include "contact/point/point_geometry.hpp"

namespace signorini::contact {

/// Common part of Gauss-point formulations: projection, local geometry, blocks, threads.
template <int D> class GaussPointContact : public Formulation<D> {
public:
  using Formulation<D>::Formulation;

  int parts() const final { return std::ssize(parts_); }
  void evaluate_part(int part, const Trial<D>& trial, bool tangent) override;
  void gather(const Trial<D>& trial, bool tangent) override;
  /// Also chooses the rules of elements for the next step.
  void commit(History<D>& present, const History<D>& accepted, double penalty_factor) override;
  double memory() const override;

protected:
  using Formulation<D>::faces_, Formulation<D>::points_, Formulation<D>::parameters_;

  /// Adds one contact point to results and blocks. On entry its result is that of an open point, with its position.
  virtual void evaluate_point(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet) = 0;
  /// Writes the closest point to feet.foot. Returns false if it is an open end of the master.
  bool find_foot(std::size_t i, const Trial<D>& trial, SumPart<D>& part, FootPoints<D>& feet) const;
  /// The geometry at feet.foot, whose functions are evaluated as well.
  LocalGeometry<D> geometry(std::size_t i, const Trial<D>& trial, FootPoints<D>& feet) const;
  /// Stores the result of the law and adds it to the blocks.
  void record(std::size_t i, const Trial<D>& trial, const LocalGeometry<D>& geometry, const LocalForce<D>& force,
              SumPart<D>& part, const FootPoints<D>& feet) const;

  void take_back(std::vector<Block>& blocks) override;

  std::vector<SumPart<D>> parts_ = parts_of(faces_, points_, parameters_.pass);

private:
  void choose_points(History<D>& present, double moved, double penalty_factor);
  bool is_near(const History<D>& present, std::span<const std::size_t> points, double distance) const;
  void evaluate_points(History<D>& present, const std::vector<std::size_t>& points, double penalty_factor);
};

} // namespace signorini::contact
