#pragma once
// A tie: two faces with nonmatching meshes that move as one, by mortar coupling with Lagrange multipliers
// [theory 9.1].

#include "contact/face/multiplier_space.hpp"
#include "contact/tie/seam.hpp"

#include <vector>

namespace signorini::contact {

/// The tractions λ = Σ_A M_A λ_A on the slave, per reference area, are unknown, and for every multiplier function
///     0 = ∫ M_A (u_m(ξ̄) − u_s) dA,   f_s = −∫ R λ dA,   f_m = ∫ R̄ λ dA,
/// with closest points ξ̄ that are fixed in the reference configuration. Displacements are tied, not positions, so that
/// a small distance between curved faces of different meshes does no harm. A tie neither opens nor slips, and it is
/// linear: all coefficients are constants.
template <int D> class Tie {
public:
  /// `seam`: of these faces, with points. Throws Error as multiplier_space().
  Tie(const Surface<D>& slave, const Surface<D>& master, Seam<D> seam, MultiplierSpace kind);

  /// ∫ M_A R dA by function of the body, the same for each component.
  struct Entry {
    int function;
    double value;
  };
  struct Row {
    double area; ///< ∫ M_A dA
    std::vector<Entry> slave, master;
  };
  /// One per multiplier function; functions without support opposite the master are left out.
  const std::vector<Row>& rows() const { return rows_; }
  /// Number of multipliers, D per row.
  int multipliers() const { return D * static_cast<int>(rows_.size()); }
  const Seam<D>& seam() const { return seam_; }
  const Surface<D>& slave() const { return slave_; }
  const Surface<D>& master() const { return master_; }
  /// Σ M_A z_A at a point of the seam, with D values per row.
  Vec<D> combine(std::size_t point, const double* values) const;
  double memory() const;

private:
  Surface<D> slave_, master_; ///< in the reference configuration
  Seam<D> seam_;
  std::vector<Row> rows_;
  /// Rows and values of the multiplier functions at the points: those of point i begin at first_[i].
  std::vector<std::size_t> first_;
  std::vector<int> row_at_;
  std::vector<double> value_at_;
};

/// All ties of a scene.
template <int D> using Ties = std::vector<Tie<D>>;

} // namespace signorini::contact
