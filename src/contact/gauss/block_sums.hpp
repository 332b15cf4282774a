#pragma once
// Sums of contact points: residual and tangent by slave, master and slip-point element.

#include "contact/face/products.hpp"
#include "contact/gauss/block.hpp"
#include "contact/point/contact_points.hpp"
#include "contact/point/local.hpp"
#include "contact/point/master.hpp"

namespace signorini::contact {

/// Where forces act: on both faces, or in a half pass on the slave alone.
enum class Pass : unsigned char { full, half };
/// Both half passes compute the whole energy of the springs and the whole work of friction between the faces: each
/// counts half.
constexpr double energy_share(Pass pass) {
  return pass == Pass::half ? 0.5 : 1;
}

/// Sums the contributions of all points that share a slave, a master and a slip-point element. Points must be added
/// slave element by slave element, with close_element() after each.
template <int D> class BlockSums {
public:
  /// Keeps references to both.
  BlockSums(const Surface<D>& slave, const Master<D>& master, Pass pass = Pass::full);

  /// Adds the local force at point i. `master` holds the closest point with its functions, `slip_point` the slip point
  /// (null if not used).
  void add(const ContactPoints<D>& points, std::size_t i, const FacePoint<D>& master, const FacePoint<D>* slip_point,
           const LocalForce<D>& force, bool tangent);
  void close_element(bool tangent);

  /// Appends the blocks to `to` by moving them; returns their number.
  std::size_t hand_over(std::vector<Block>& to);
  /// Takes a block back to reuse its memory.
  void recycle(Block&& block) { spare_.push_back(std::move(block)); }
  double memory() const;

private:
  std::size_t find(int slave_element, int master_element, int slip_element, bool tangent);
  /// Number of the master's nodes with rows.
  int master_rows(int nodes) const { return pass_ == Pass::half ? 0 : nodes; }
  void fill_columns(const Block& block, const double* slave, double weight, const FacePoint<D>& master,
                    const FacePoint<D>* slip_point, const LocalForce<D>& force, double* dt, double* dxi) const;

  const Surface<D>& slave_;
  const Master<D>& master_;
  Pass pass_;
  std::vector<Block> blocks_, spare_;
  std::size_t first_ = 0;          ///< first block of the current slave element
  std::vector<double> columns_;    ///< working space of add() in the plane: ∂force and ∂ξ̄ by column
  std::vector<Products> products_; ///< of the blocks of the current slave element
};

} // namespace signorini::contact
