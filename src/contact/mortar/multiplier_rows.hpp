#pragma once
// Derivatives of the weighted quantities of multipliers, and their coupling of all unknowns below a multiplier.

#include "contact/gauss/block_sums.hpp"
#include "contact/mortar/mortar_law.hpp"
#include "contact/mortar/multiplier_functions.hpp"

namespace signorini::contact {

/// Rows of the derivatives of one point's contributions, per unit of w M_A, with the area J per reference area on which
/// tractions act (the fraction ω beyond open ends of the master, in a half pass times the stretch of the slave's area):
/// J δg, g δJ, δJ, and with friction J δn̄ + n̄ δJ, J δv + v δJ, in 3D J δxˢ_,1 + xˢ_,1 δJ.
template <int D> struct PointRows {
  static constexpr int gap = 0, gap_area = 1, area = 2, normal = 3, slip = 3 + D, along = 3 + 2 * D;
  static constexpr int most = D == 2 ? along : along + D;
  static constexpr int count(bool frictional) { return frictional ? most : normal; }
};
template <int D> using LocalRows = Eigen::Matrix<double, PointRows<D>::most, LocalForce<D>::columns, Eigen::RowMajor>;
/// The rows of a point. `area`, `area_row`: ω and δω; `slip_point`: its former place, null if there is none.
template <int D>
LocalRows<D> point_rows(const LocalGeometry<D>& geometry, const GapRows<D>& gap, const LocalShift<D>& shift,
                        double area, const LocalRow<D>& area_row, const FacePoint<D>* slip_point, bool frictional);

/// Sums of these rows over the points that share a slave, a master and a slip-point element, by node.
struct Strip {
  int slave_element, master_element;
  int slip_element;           ///< −1 if it is the master element, or without friction
  int columns;                ///< degrees of freedom of the elements' nodes
  std::vector<double> rows;   ///< by multiplier of the slave element, row and column
  std::vector<double> shares; ///< by multiplier and node of slave and master element: Σ w M_A J (−R, R̄)
};

template <int D> class MultiplierRows {
public:
  /// Keeps references to all.
  MultiplierRows(const Surface<D>& slave, const Master<D>& master, const MultiplierFunctions<D>& functions);

  /// Adds point i. `area`: J; `weights`: w M_A of the slave element's multipliers, 0 for those to be left out. `master`
  /// holds the closest point with functions and first derivatives, `slip_point` its former place (null if not used).
  /// Points are added slave element by slave element.
  void add(const ContactPoints<D>& points, std::size_t i, const FacePoint<D>& master, const FacePoint<D>* slip_point,
           const LocalRows<D>& local, int count, double area, const double* weights);
  const std::vector<Strip>& strips() const { return strips_; }
  void clear();

private:
  Strip& find(int slave_element, int master_element, int slip_element, int count);
  void expand(const Strip& strip, const double* slave, const FacePoint<D>& master, const FacePoint<D>* slip_point,
              const LocalRows<D>& local, int count);

  const Surface<D>& slave_;
  const Master<D>& master_;
  const MultiplierFunctions<D>& functions_;
  std::vector<Strip> strips_, spare_;
  std::vector<double> base_; ///< working space of add(): a point's rows by column
};

/// Working space of couple().
struct CouplingSpace {
  std::vector<int> slave_column, master_column; ///< by face-local node
  std::vector<int> active;                      ///< members of the group that are not open
  MatrixX rows, left, right;
  VectorX shares;
};

/// Fills the block of a group: Σ ∂f/∂z_A δz_A + ∂f/∂t_A δt_A over its members that are not open, from the strips of
/// each element, with rows for the slave only in a half pass. `sums` and `tangents` are by multiplier.
template <int D>
void couple(const MultiplierGroup& group, const MultiplierFunctions<D>& functions,
            const std::vector<MultiplierSums<D>>& sums, const std::vector<MultiplierTangent<D>>& tangents,
            const Surface<D>& slave, const Master<D>& master, const std::vector<std::vector<const Strip*>>& strips,
            int count, Pass pass, CouplingSpace& space, Block& block);

} // namespace signorini::contact
