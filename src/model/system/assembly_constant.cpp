// The part of the tangent that does not depend on displacements.
#include "model/system/assembly.hpp"

#include "solve/values.hpp"

#include <algorithm>
#include <utility>

namespace signorini::model {

/// Computes the stiffness of linear bodies. It depends on the bodies alone: not on supports, contacts or patterns.
template <int D> void Assembly<D>::build_stiffness() {
  for (const auto& named : scene_.bodies) {
    const solid::Body<D>& body = *named.body;
    std::vector<Nodes> groups;
    for (int e = 0; e < body.macro_elements(); ++e) {
      const auto functions = body.functions_of_macro(e);
      groups.emplace_back(functions.begin(), functions.end());
    }
    stiffness_.emplace_back(body.functions(), groups);
    const VectorX rest = VectorX::Zero(D * body.functions());
    solid::ElementArrays<D> arrays(body);
    for (int e = 0; e < body.macro_elements(); ++e) {
      internal_force(body, e, rest.data(), arrays);
      stiffness_.back().add(body.functions_of_macro(e), arrays.blocks.data());
    }
  }
}

template <int D>
double Assembly<D>::stored_energy(int index, const VectorX& displacement,
                                  const std::vector<std::vector<double>>& internal) const {
  const double* own = displacement.data() + unknowns_.offset(index);
  const solid::Body<D>& body = *scene_.bodies[index].body;
  if (!linear_) {
    energies_.resize(scene_.bodies.size());
    KnownEnergy& known = energies_[index];
    const Eigen::Map<const VectorX> moved(own, D * body.functions());
    if (known.displacement.size() != moved.size() || known.displacement != moved || known.internal != internal[index])
      known = {moved, internal[index], solid::stored_energy(body, own, internal[index])};
    return known.energy;
  }
  // ½ u·K u
  VectorX force = VectorX::Zero(D * body.functions());
  stiffness_[index].multiply(own, force.data());
  return 0.5 * force.dot(Eigen::Map<const VectorX>(own, force.size()));
}

template <int D>
double Assembly<D>::stored_energy(const VectorX& displacement, const std::vector<std::vector<double>>& internal) const {
  double sum = 0;
  for (int b = 0; b < std::ssize(scene_.bodies); ++b) sum += stored_energy(b, displacement, internal);
  return sum;
}

/// Computes the tangent of linear bodies, with ties and springs.
template <int D> void Assembly<D>::build_constant() {
  constant_.assign(values_.size(), 0.0);
  for (std::size_t b = 0; b < stiffness_.size(); ++b) {
    const int offset = unknowns_.offset(static_cast<int>(b));
    stiffness_[b].visit_upper([&](int row, int column, int count, const double* values) {
      const int j = unknowns_.unknown(offset + row);
      int before = -2, position = 0; // the last unknown, and its position in column j
      for (int k = 0; k < count && j >= 0; ++k) {
        const int i = unknowns_.unknown(offset + column + k);
        if (i < 0) continue;
        position = i == before + 1 ? position + 1 : pattern_.find(i, j);
        before = i;
        constant_[position] += values[k];
      }
    });
  }
  solve::add_transpose(pattern_, constant_.data()); // K = Uᵀ + U
  add_ties(constant_.data());
  add_springs(constant_.data());
}

/// Sets the constant tangent for the pattern in which entry k of bulk_pattern_ is at moved[k].
template <int D> void Assembly<D>::move_constant(std::vector<int> moved) {
  if (constant_.empty()) {
    build_constant();
  } else {
    const std::vector<double> before = std::exchange(constant_, std::vector<double>(values_.size(), 0.0));
    for (std::size_t k = 0; k < moved.size(); ++k) constant_[moved[k]] = before[constant_positions_[k]];
  }
  constant_positions_ = std::move(moved);
  changed_.reset();
}

/// Sets the tangent to its part that does not depend on displacements.
template <int D> void Assembly<D>::set_values(const Request& request) {
  if (!request.tangent) return;
  if (linear_) {
    if (changed_)
      for (const int position : *changed_) values_[position] = constant_[position];
    else
      std::copy(constant_.begin(), constant_.end(), values_.begin());
    changed_.emplace();
  } else {
    std::fill(values_.begin(), values_.end(), 0.0);
    add_ties(values_.data());
    add_springs(values_.data());
  }
}

template void Assembly<2>::build_stiffness();
template double Assembly<2>::stored_energy(const VectorX&, const std::vector<std::vector<double>>&) const;
template double Assembly<2>::stored_energy(int, const VectorX&, const std::vector<std::vector<double>>&) const;
template void Assembly<2>::build_constant();
template void Assembly<2>::move_constant(std::vector<int>);
template void Assembly<2>::set_values(const Request&);
template void Assembly<3>::build_stiffness();
template double Assembly<3>::stored_energy(const VectorX&, const std::vector<std::vector<double>>&) const;
template double Assembly<3>::stored_energy(int, const VectorX&, const std::vector<std::vector<double>>&) const;
template void Assembly<3>::build_constant();
template void Assembly<3>::move_constant(std::vector<int>);
template void Assembly<3>::set_values(const Request&);

} // namespace signorini::model
