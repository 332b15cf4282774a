#pragma once
// Derivatives of the weighted quantities of multipliers with respect to the displacements.

#include "contact/gauss/block_sums.hpp"
#include "contact/mortar/multiplier_functions.hpp"

namespace signorini::contact {

/// Rows of the derivatives of one point's contributions, per unit of w M_A, with the area J per reference area on which
/// tractions act (the fraction ω beyond open ends of the master, in a half pass times the stretch of the slave's area):
/// J δg, g δJ, δJ, and with friction J δn̄ + n̄ δJ, J δv + v δJ, in 3D J δa + a δJ,
/// a = a^α xˢ_,α.
template <int D> struct PointRows {
  static constexpr int gap = 0, gap_area = 1, area = 2, normal = 3, slip = 3 + D, along = 3 + 2 * D;
  static constexpr int most = D == 2 ? along : along + D;
  static constexpr int count(bool frictional) { return frictional ? most : normal; }
};
template <int D> using LocalRows = Eigen::Matrix<double, PointRows<D>::most, LocalForce<D>::columns, Eigen::RowMajor>;
/// The rows of a point. `area`, `area_row`: J and δJ; `slip_point`: its former place, null if there is none.
template <int D>
LocalRows<D> point_rows(const LocalGeometry<D>& geometry, const GapRows<D>& gap, const LocalShift<D>& shift,
                        double area, const LocalRow<D>& area_row, const FacePoint<D>* slip_point, bool frictional);

using RowMajorX = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Sums of these rows over the points that share a slave, a master and a slip-point element, by node.
struct Strip {
  int slave_element, master_element;
  int slip_element; ///< −1 if it is the master element, or without friction
  int count;        ///< rows of each multiplier
  int columns;      ///< degrees of freedom of the elements' nodes
  int nodes;        ///< of slave and master element
  std::vector<double> rows, shares;

  /// The rows of a multiplier of the slave element, by its index there.
  Eigen::Map<RowMajorX> rows_of(int multiplier) { return {rows.data() + multiplier * count * columns, count, columns}; }
  Eigen::Map<const RowMajorX> rows_of(int multiplier) const {
    return {rows.data() + multiplier * count * columns, count, columns};
  }
  /// Σ w M_A J (−R, R̄) of a multiplier by node of slave and master element.
  Eigen::Map<VectorX> shares_of(int multiplier) { return {shares.data() + multiplier * nodes, nodes}; }
  Eigen::Map<const VectorX> shares_of(int multiplier) const { return {shares.data() + multiplier * nodes, nodes}; }
};

template <int D> class MultiplierRows {
public:
  /// Keeps references to both.
  MultiplierRows(const Faces<D>& faces, const MultiplierFunctions<D>& functions);

  /// Adds point i. `area`: J; `weights`: w M_A of the slave element's multipliers, 0 for those to be left out. `foot`
  /// holds the closest point with functions and first derivatives, `slip_point` its former place (null if not used).
  /// Points are added slave element by slave element.
  void add(const ContactPoints<D>& points, std::size_t i, const FacePoint<D>& foot, const FacePoint<D>* slip_point,
           const LocalRows<D>& local, int count, double area, const std::vector<double>& weights);
  const std::vector<Strip>& strips() const { return strips_; }
  void clear();

private:
  Strip& find(int slave_element, int master_element, int slip_element, int count);

  const Faces<D>& faces_;
  const MultiplierFunctions<D>& functions_;
  std::vector<Strip> strips_, spare_;
  std::vector<double> base_; ///< working space of add(): a point's rows by column
};

} // namespace signorini::contact
