#pragma once
// Gauss-point-to-surface contact: a traction at each Gauss point of the slave face, the opposite at its foot point.

#include "contact/gauss/block_sums.hpp"
#include "contact/gauss/formulation.hpp"
#include "contact/point/point_geometry.hpp"

namespace signorini::contact {

/// Common part of Gauss-point formulations: projection, local geometry, blocks, threads.
template <int D> class GaussPointContact : public Formulation<D> {
public:
  explicit GaussPointContact(ContactSetting<D> setting, Pass pass = Pass::full);

  int parts() const final { return std::ssize(parts_); }
  void evaluate_part(int part, const Trial<D>& trial, bool tangent) final;
  void gather(const Trial<D>& trial, bool tangent) final;
  double memory() const final;

protected:
  Pass pass() const { return pass_; }
  double share() const final { return energy_share(pass_); }

  /// A piece of the slave face: whole elements.
  struct Part {
    std::size_t first, last; ///< points
    BlockSums<D> sums;
    bool tangent = false;
    double search_seconds = 0; ///< since the last gather()
    std::size_t blocks = 0;    ///< number of blocks in the last gather()
  };

  /// Working space: foot point and slip point on the master.
  struct Feet {
    FacePoint<D> foot, slip_point;
  };

  /// Adds one contact point to results and blocks. On entry its result is that of an open point, with its position.
  virtual void evaluate_point(std::size_t i, const Trial<D>& trial, Part& part, Feet& at) = 0;
  /// Writes the closest point to at.foot. Returns false if it is an open end of the master.
  bool find_foot(std::size_t i, const Trial<D>& trial, Part& part, Feet& at) const;
  /// The geometry at at.foot, whose functions are evaluated as well.
  LocalGeometry<D> geometry(std::size_t i, const Trial<D>& trial, Feet& at) const;
  /// Stores the result of the law and adds it to the blocks.
  void record(std::size_t i, const Trial<D>& trial, const LocalGeometry<D>& geometry, const LocalForce<D>& force,
              Part& part, const Feet& at) const;

private:
  void evaluate_points(History<D>& present, const std::vector<std::size_t>& points, double penalty_factor) final;
  void take_back(std::vector<Block>& blocks) final;

  Pass pass_;
  std::vector<Part> parts_;
};

} // namespace signorini::contact
