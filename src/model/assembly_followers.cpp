// Contributions of the loads that follow the deformation to the tangent.
#include "model/assembly.hpp"

#include "base/index.hpp"

namespace signorini::model {

/// Finds the positions of the entries in values_, part by part, column by column; −1 without unknown. The pattern has
/// them, because the functions of a part act on one element.
template <int D> void Assembly<D>::locate_followers() {
  follower_positions_.clear();
  for (const auto& part : followers_.parts())
    for (const int column : part.dofs)
      for (const int row : part.dofs) {
        const int i = unknowns_.unknown(row), j = unknowns_.unknown(column);
        follower_positions_.push_back(i < 0 || j < 0 ? -1 : pattern_.find(i, j));
      }
}

/// Adds −∂f/∂u to the tangent, and its product with the direction.
template <int D> void Assembly<D>::add_followers(const Request& request) {
  const int* position = follower_positions_.data();
  for (const auto& part : followers_.parts()) {
    const auto entries = static_cast<Eigen::Index>(part.dofs.size() * part.dofs.size());
    if (request.states.loads(part.target) != 0) {
      const MatrixX tangent = followers_.tangent(part, request.states.present.displacement, request.states.loads);
      if (request.direction) product_(part.dofs) -= tangent * (*request.direction)(part.dofs);
      for (Eigen::Index k = 0; k < entries && request.tangent; ++k)
        if (position[k] >= 0) values_[at(position[k])] -= tangent.data()[k];
    }
    position += entries;
  }
}

template void Assembly<2>::locate_followers();
template void Assembly<2>::add_followers(const Request&);
template void Assembly<3>::locate_followers();
template void Assembly<3>::add_followers(const Request&);

} // namespace signorini::model
