#pragma once
// What a contact adds to residual and tangent: dense blocks with row and column unknowns.

#include <cstdint>
#include <vector>

namespace signorini::contact {

/// Rows belong to the degrees of freedom of the slave element's functions, then the master element's (a rigid master's
/// one node is element 0), D each, then to unknowns of the formulation's own; columns to the same, then to those of the
/// slip element's functions. See Formulation::append_dofs.
struct Block {
  int slave_element, master_element;
  int slip_element = -1;           ///< −1 when the slip points lie in the master element or play no part
  std::vector<int> extra = {};     ///< numbers of the formulation's own unknowns
  int rows = 0, columns = 0;       ///< of the matrix, in scalars
  std::vector<double> force = {};  ///< residual contribution
  std::vector<double> matrix = {}; ///< ∂force, row by row; empty when it was not wanted

  /// Blocks of a contact with the same key have the same degrees of freedom.
  std::uint64_t key() const {
    constexpr int bits = 21; // two million elements on a face
    return (static_cast<std::uint64_t>(slave_element) << (2 * bits)) |
           (static_cast<std::uint64_t>(master_element) << bits) | static_cast<std::uint64_t>(slip_element + 1);
  }
};

} // namespace signorini::contact
