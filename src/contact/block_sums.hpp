#pragma once
// The blocks that contact points add to: residual and tangent by slave, master and slip-point element.

#include "contact/block.hpp"
#include "contact/contact_points.hpp"
#include "contact/local.hpp"
#include "contact/master.hpp"
#include "contact/products.hpp"

namespace signorini::contact {

/// Adds up the contributions of all points that share a slave, a master and a slip-point element. Points come slave
/// element by slave element, with close_element() after each.
template <int D> class BlockSums {
public:
  /// Both must stay.
  BlockSums(const Surface<D>& slave, const Master<D>& master);

  /// Adds point i, where the local force acts. `master` holds the closest point with its functions, `slip_point` the
  /// slip point, null where it plays no part.
  void add(const ContactPoints<D>& points, std::size_t i, const FacePoint<D>& master, const FacePoint<D>* slip_point,
           const LocalForce<D>& force, bool tangent);
  void close_element(bool tangent);

  /// Moves the blocks behind others; returns how many there were.
  std::size_t hand_over(std::vector<Block>& to);
  /// Takes a block back, for its memory.
  void recycle(Block&& block) { spare_.push_back(std::move(block)); }
  double memory() const;

private:
  std::size_t find(int slave_element, int master_element, int slip_element, bool tangent);
  void fill_columns(const Block& block, const double* slave, double weight, const FacePoint<D>& master,
                    const FacePoint<D>* slip_point, const LocalForce<D>& force);

  const Surface<D>& slave_;
  const Master<D>& master_;
  std::vector<Block> blocks_, spare_;
  std::size_t first_ = 0;          ///< block of the present slave element
  std::vector<double> columns_;    ///< working space of add(): ∂force and ∂ξ̄ by column
  std::vector<Products> products_; ///< of the last blocks, those of the present slave element
};

} // namespace signorini::contact
