// The part of the tangent that does not depend on displacements.
#include "model/assembly.hpp"

#include "base/index.hpp"

#include <algorithm>
#include <utility>

namespace signorini::model {

/// Computes the tangent of linear bodies, with ties and springs.
template <int D> void Assembly<D>::build_constant() {
  constant_.assign(values_.size(), 0.0);
  const VectorX rest = VectorX::Zero(unknowns_.dofs());
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
    const solid::Body<D>& body = *scene_.bodies[b].body;
    solid::ElementArrays<D> arrays(body);
    for (int e = 0; e < body.macro_elements(); ++e) {
      internal_force(body, e, rest.data(), arrays);
      scatter(static_cast<int>(b), e, arrays, constant_.data());
    }
  }
  add_ties(constant_.data());
  add_springs(constant_.data());
}

/// Sets the constant tangent for the pattern in which entry k of bulk_pattern_ is at moved[k].
template <int D> void Assembly<D>::move_constant(std::vector<int> moved) {
  if (constant_.empty()) {
    build_constant();
  } else {
    const std::vector<double> before = std::exchange(constant_, std::vector<double>(values_.size(), 0.0));
    for (std::size_t k = 0; k < moved.size(); ++k) constant_[at(moved[k])] = before[at(constant_positions_[k])];
  }
  constant_positions_ = std::move(moved);
  changed_.reset();
}

/// Sets the tangent to its part that does not depend on displacements.
template <int D> void Assembly<D>::set_values(const Request& request) {
  if (!request.tangent) return;
  if (linear_) {
    if (changed_)
      for (const int position : *changed_) values_[at(position)] = constant_[at(position)];
    else
      std::copy(constant_.begin(), constant_.end(), values_.begin());
    changed_.emplace();
  } else {
    std::fill(values_.begin(), values_.end(), 0.0);
    add_ties(values_.data());
    add_springs(values_.data());
  }
}

template void Assembly<2>::build_constant();
template void Assembly<2>::move_constant(std::vector<int>);
template void Assembly<2>::set_values(const Request&);
template void Assembly<3>::build_constant();
template void Assembly<3>::move_constant(std::vector<int>);
template void Assembly<3>::set_values(const Request&);

} // namespace signorini::model
