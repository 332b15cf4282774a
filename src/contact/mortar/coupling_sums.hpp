#pragma once
// Sums of contact points with multipliers that are unknowns: derivatives of forces with respect to multipliers, and of
// conditions with respect to displacements.

#include "contact/gauss/block_sums.hpp"
#include "contact/mortar/multiplier_functions.hpp"
#include "contact/mortar/multiplier_law.hpp"

namespace signorini::contact {

/// A point with its condition, and what multiplies its multiplier in the traction.
template <int D> struct CoupledPoint {
  const FacePoint<D>*foot, *slip_point; ///< closest point with first derivatives; former place, null if not used
  Eigen::Matrix<double, D, D>
      direction;      ///< ∂traction/∂λ times the area per parametric area, the first column alone without friction
  LocalBlock<D> rows; ///< ∂(area c)/∂q
};

/// Points that share a slave, a master and a slip-point element share a block. They are added slave element by slave
/// element.
template <int D> class CouplingSums {
public:
  /// Keeps references. `each`: unknowns per multiplier; `scale`: of these.
  CouplingSums(const Faces<D>& faces, const MultiplierFunctions<D>& functions, int each, double scale);
  void add(const ContactPoints<D>& points, std::size_t i, const CoupledPoint<D>& point);
  /// Appends the blocks to `to` by moving them.
  void hand_over(std::vector<Block>& to);
  void take_back(std::vector<Block>::iterator& first);

private:
  Block& find(int slave_element, int master_element, int slip_element);

  const Faces<D>& faces_;
  const MultiplierFunctions<D>& functions_;
  int each_;
  double scale_;
  std::vector<Block> blocks_, spare_;
  int handed_over_ = 0;
  std::vector<double> base_; ///< working space of add()
};

} // namespace signorini::contact
