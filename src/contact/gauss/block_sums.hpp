#pragma once
// Sums of contact points: residual and tangent by slave, master and slip-point element.

#include "contact/face/products.hpp"
#include "contact/gauss/block.hpp"
#include "contact/point/faces.hpp"
#include "contact/point/local.hpp"
#include "contact/point/parameters.hpp"
#include "contact/point/point_geometry.hpp"

#include <optional>

namespace signorini::contact {

/// The chain rule at a contact point: derivatives with respect to the displacements of nodes, of the slave element, the
/// master element and, if the slip point lies in another one, of that.
template <int D> struct ColumnNodes {
  /// `own`: R_A, R_A,1 … of the slave; `foot`, `slip_point`: with their functions, of the foot first derivatives as
  /// well; `slip_point`: null if not used; `slip_point_nodes`: 0 if it lies in the master element.
  ColumnNodes(const double* own, int own_nodes, const FacePoint<D>& foot, int foot_nodes,
              const FacePoint<D>* slip_point, int slip_point_nodes);

  /// Writes D columns per node, and in 3D one more value: `weight` times those of a row with respect to the local
  /// variables (LocalForce).
  void expand(const LocalRow<D>& row, double weight, double* out) const;
  /// Expands a row of ∂ξ̄/∂q, which does not depend on the slave's tangents and the slip point.
  void expand_shift(const LocalRow<D>& row, double weight, double* out) const;

  std::array<const double*, D> slave, master;
  const double* slip;
  int slave_nodes, master_nodes, slip_nodes;
};

/// Moves an element of `spare` to the end of a list, to reuse its memory, or appends a new one.
template <class T> T& reuse(std::vector<T>& spare, std::vector<T>& list) {
  if (spare.empty()) return list.emplace_back();
  list.push_back(std::move(spare.back()));
  spare.pop_back();
  return list.back();
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

  /// Appends the blocks to `to` by moving them.
  void hand_over(std::vector<Block>& to);
  /// Takes the blocks that it has handed over last back to reuse their memory, from `first` on, which is moved on.
  void take_back(std::vector<Block>::iterator& first);
  double memory() const;

private:
  std::size_t find(int slave_element, int master_element, int slip_element, bool tangent);
  /// Number of the master's nodes with rows.
  int master_rows(int nodes) const { return pass_ == Pass::half ? 0 : nodes; }

  const Surface<D>& slave_;
  const Master<D>& master_;
  Pass pass_;
  std::vector<Block> blocks_, spare_;
  std::size_t first_ = 0;          ///< first block of the current slave element
  int handed_over_ = 0;            ///< number of blocks
  std::vector<double> columns_;    ///< working space of add() in the plane: ∂force and ∂ξ̄ by column
  std::vector<Products> products_; ///< of the blocks of the current slave element
};

/// A piece of the slave face with its own sums, evaluated by one thread: whole elements.
template <int D> struct SumPart {
  std::size_t first, last; ///< points
  BlockSums<D> sums;
  bool tangent = false;
  std::optional<InterfaceLaw> law = {}; ///< of the state that is evaluated
  double search_seconds = 0;            ///< since the last hand_over()
  std::vector<PointRange> watched = {}; ///< elements, after the last evaluation
};
template <int D> std::vector<SumPart<D>> parts_of(const Faces<D>& faces, const ContactPoints<D>& points, Pass pass);
/// Moves blocks and times of all parts.
template <int D> void hand_over(std::vector<SumPart<D>>& parts, std::vector<Block>& blocks, double& search_seconds);

} // namespace signorini::contact
