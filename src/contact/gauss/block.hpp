#pragma once
// Contributions of a contact to residual and tangent: dense blocks with row and column unknowns.

#include <cstdint>
#include <vector>

namespace signorini::contact {

/// A block of two elements, or of a group of multipliers. Rows belong to the degrees of freedom of the slave element's
/// functions, then of the master element's (the nodes of a rigid master are element 0), D each, then to the
/// formulation's additional unknowns; columns belong to the same, then to the degrees of freedom of the slip element's
/// functions. A half pass has rows for the slave element only. Rows and columns of a group's block belong to those of
/// its slave nodes, then of its master nodes, then to additional unknowns. See block_dofs.hpp.
struct Block {
  int slave_element, master_element;
  int slip_element = -1;       ///< −1 if the slip points lie in the master element or are not used
  std::vector<int> extra = {}; ///< indices of the formulation's additional unknowns
  int group = -1;              ///< of multipliers, in a block without elements
  std::vector<int> slave_nodes = {}, master_nodes = {}; ///< of a group's block, face-local
  std::vector<int> master_elements = {};                ///< those of the master nodes
  int rows = 0, columns = 0;                            ///< of the matrix, in scalars
  std::vector<double> force = {};                       ///< residual contribution
  std::vector<double> matrix = {};                      ///< ∂force, row by row; empty if not requested

  /// Blocks of a contact with the same key have the same degrees of freedom, except that those of a group change with
  /// its master nodes.
  std::uint64_t key() const {
    constexpr int bits = 20; // a million elements on a face
    if (group >= 0) return std::uint64_t{1} << 63 | static_cast<std::uint64_t>(group);
    return (static_cast<std::uint64_t>(!extra.empty()) << (3 * bits)) |
           (static_cast<std::uint64_t>(slave_element) << (2 * bits)) |
           (static_cast<std::uint64_t>(master_element) << bits) | static_cast<std::uint64_t>(slip_element + 1);
  }
};

} // namespace signorini::contact
