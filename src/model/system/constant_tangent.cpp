#include "model/system/constant_tangent.hpp"

#include "solve/values.hpp"

#include <algorithm>
#include <utility>

namespace signorini::model {

template <int D> void ConstantTangent<D>::locate(const SparseTangent& tangent, std::vector<int> moved) {
  tie_positions_.clear(); // of each coupling and its transpose
  for (const auto& [multiplier, displacement, value] : ties_.couplings) {
    const int i = unknowns_.unknown(multiplier), j = unknowns_.unknown(displacement);
    tie_positions_.push_back(j < 0 ? -1 : tangent.pattern.find(i, j));
    tie_positions_.push_back(j < 0 ? -1 : tangent.pattern.find(j, i));
  }
  spring_positions_ = positions_of(springs_.parts(), unknowns_, tangent.pattern);
  if (bulk_.stiffness().empty()) return;
  if (values_.empty()) {
    build(tangent);
  } else {
    const std::vector<double> before = std::exchange(values_, std::vector<double>(tangent.values.size(), 0.0));
    for (std::size_t k = 0; k < moved.size(); ++k) values_[moved[k]] = before[positions_[k]];
  }
  positions_ = std::move(moved);
}

template <int D> void ConstantTangent<D>::build(const SparseTangent& tangent) {
  values_.assign(tangent.values.size(), 0.0);
  for (std::size_t b = 0; b < bulk_.stiffness().size(); ++b) {
    const int offset = unknowns_.offset(static_cast<int>(b));
    bulk_.stiffness()[b].visit_upper([&](int row, int column, int count, const double* values) {
      const int j = unknowns_.unknown(offset + row);
      int before = -2, position = 0; // the last unknown, and its position in column j
      for (int k = 0; k < count && j >= 0; ++k) {
        const int i = unknowns_.unknown(offset + column + k);
        if (i < 0) continue;
        position = i == before + 1 ? position + 1 : tangent.pattern.find(i, j);
        before = i;
        values_[position] += values[k];
      }
    });
  }
  solve::add_transpose(tangent.pattern, values_.data()); // K = Uᵀ + U
  add_ties_and_springs(tangent, values_.data());
}

template <int D> void ConstantTangent<D>::add_ties_and_springs(const SparseTangent& tangent, double* values) const {
  for (std::size_t k = 0; k < tie_positions_.size(); ++k)
    if (tie_positions_[k] >= 0) values[tie_positions_[k]] += ties_.couplings[k / 2].value;
  for (const auto& [multiplier, value] : ties_.proximal)
    values[tangent.on_diagonal[unknowns_.unknown(multiplier)]] += value;
  const int* position = spring_positions_.data();
  for (const auto& part : springs_.parts())
    for (Eigen::Index k = 0; k < part.stiffness.size(); ++k, ++position)
      if (*position >= 0) values[*position] += part.stiffness.data()[k];
}

template <int D> void ConstantTangent<D>::copy_to(SparseTangent& tangent) const {
  if (values_.empty()) {
    std::fill(tangent.values.begin(), tangent.values.end(), 0.0);
    add_ties_and_springs(tangent, tangent.values.data());
    return;
  }
  if (tangent.changed)
    for (const int position : *tangent.changed) tangent.values[position] = values_[position];
  else
    std::copy(values_.begin(), values_.end(), tangent.values.begin());
  tangent.changed.emplace();
}

template <int D> double ConstantTangent<D>::memory() const {
  return bytes_of(values_) + bytes_of(positions_) + bytes_of(tie_positions_) + bytes_of(spring_positions_);
}

template class ConstantTangent<2>;
template class ConstantTangent<3>;

} // namespace signorini::model
