#include "model/system/evaluation.hpp"

#include <cmath>
#include <utility>

namespace signorini::model {

void SparseTangent::set_pattern(solve::Pattern wanted, int scratch_entries) {
  pattern = std::move(wanted);
  values.resize(pattern.entries() + scratch_entries);
  on_diagonal.clear();
  for (int i = 0; i < pattern.size; ++i) on_diagonal.push_back(pattern.find(i, i));
  changed.reset();
  ++version;
}

VectorX SparseTangent::diagonal() const {
  VectorX result(on_diagonal.size());
  for (std::size_t i = 0; i < on_diagonal.size(); ++i) result(static_cast<Eigen::Index>(i)) = values[on_diagonal[i]];
  return result;
}

void SparseTangent::add_diagonal(const VectorX& shift) {
  changed.reset();
  for (std::size_t i = 0; i < on_diagonal.size(); ++i) values[on_diagonal[i]] += shift(static_cast<Eigen::Index>(i));
}

void SparseTangent::find_diagonal_norm() {
  double sum = 0;
  for (const int position : on_diagonal) sum += values[position] * values[position];
  diagonal_norm = std::sqrt(sum);
}

} // namespace signorini::model
