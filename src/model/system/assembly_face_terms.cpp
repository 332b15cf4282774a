// Contributions of springs and of the loads that follow the deformation to the tangent.
#include "model/system/assembly.hpp"

namespace signorini::model {

namespace {

/// Positions of the entries in the tangent's values, part by part, column by column; −1 without unknown. The pattern
/// has them, because the functions of a part act on one element.
template <int D, class Parts>
std::vector<int> positions_of(const Parts& parts, const Unknowns<D>& unknowns, const solve::Pattern& pattern) {
  std::vector<int> positions;
  for (const auto& part : parts)
    for (const int column : part.dofs)
      for (const int row : part.dofs) {
        const int i = unknowns.unknown(row), j = unknowns.unknown(column);
        positions.push_back(i < 0 || j < 0 ? -1 : pattern.find(i, j));
      }
  return positions;
}

} // namespace

/// Finds the entries of followers and springs.
template <int D> void Assembly<D>::locate_face_terms() {
  follower_positions_ = positions_of(followers_.parts(), unknowns_, pattern_);
  spring_positions_ = positions_of(springs_.parts(), unknowns_, pattern_);
}

/// Adds −∂f/∂u to the tangent, and its product with the direction.
template <int D> void Assembly<D>::add_followers(const Request& request) {
  if (!followers_.empty()) changed_.reset();
  const int* position = follower_positions_.data();
  for (const auto& part : followers_.parts()) {
    const auto entries = static_cast<Eigen::Index>(part.dofs.size() * part.dofs.size());
    if (request.states.loads(part.target) != 0) {
      const MatrixX tangent = followers_.tangent(part, request.states.present.displacement, request.states.loads);
      if (request.direction) product_(part.dofs) -= tangent * (*request.direction)(part.dofs);
      for (Eigen::Index k = 0; k < entries && request.tangent; ++k)
        if (position[k] >= 0) values_[position[k]] -= tangent.data()[k];
    }
    position += entries;
  }
}

/// Adds the springs' constant tangent.
template <int D> void Assembly<D>::add_springs(double* values) const {
  const int* position = spring_positions_.data();
  for (const auto& part : springs_.parts())
    for (Eigen::Index k = 0; k < part.stiffness.size(); ++k, ++position)
      if (*position >= 0) values[*position] += part.stiffness.data()[k];
}

template void Assembly<2>::add_springs(double*) const;
template void Assembly<3>::add_springs(double*) const;
template void Assembly<2>::locate_face_terms();
template void Assembly<2>::add_followers(const Request&);
template void Assembly<3>::locate_face_terms();
template void Assembly<3>::add_followers(const Request&);

} // namespace signorini::model
