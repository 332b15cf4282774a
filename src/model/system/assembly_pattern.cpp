// Patterns of the tangent, and the positions of the elements' entries in them.
#include "model/system/assembly.hpp"

#include <utility>

namespace signorini::model {

namespace {

/// Whether at every node of an element either no component is an unknown, or all are, with consecutive numbers: then
/// the entries of a node's rows follow each other in every column of the tangent.
template <int D> bool whole_nodes(const std::vector<int>& unknowns) {
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const int first = unknowns[k - k % D];
    if (unknowns[k] != (first < 0 ? -1 : first + static_cast<int>(k % D))) return false;
  }
  return true;
}

} // namespace

template <int D> void Assembly<D>::build_bulk() {
  std::vector<Nodes> groups;
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
    const solid::Body<D>& body = *scene_.bodies[b].body;
    if (!linear_) supports_.emplace_back();
    for (int e = 0; e < body.macro_elements(); ++e) {
      Nodes group;
      bool supported = false;
      const auto functions = body.functions_of_macro(e);
      group.reserve(D * functions.size());
      for (int function : functions)
        for (int c = 0; c < D; ++c) {
          const int dof = unknowns_.offset(static_cast<int>(b)) + D * function + c;
          group.push_back(unknowns_.unknown(dof));
          supported = supported || unknowns_.constrained(dof);
        }
      if (!linear_) supports_.back().push_back({supported, whole_nodes<D>(group)});
      groups.push_back(std::move(group));
    }
  }
  for (const auto& [multiplier, displacement, value] : ties_.couplings)
    groups.push_back({unknowns_.unknown(multiplier), unknowns_.unknown(displacement)});
  bulk_pattern_ = solve::couple(unknowns_.size(), groups);
  if (linear_) return;

  // Positions in the order in which scatter() reads ElementArrays::blocks
  int trash = bulk_pattern_.entries(), first_trash = trash;
  std::size_t positions = 0;
  for (const Nodes& group : groups) positions += group.size() * group.size() / (whole_nodes<D>(group) ? D : 1);
  bulk_positions_.resize(positions);
  std::size_t next_position = 0;
  std::vector<int> found; // of an element, column by column
  const auto find = [&](const Nodes& group) {
    found.resize(group.size() * group.size());
    int* entry = found.data();
    for (const int column : group) {
      int before = -2, next = 0; // the last unknown, and the position after it
      for (const int row : group) {
        if (row < 0 || column < 0) {
          *entry++ = trash;
          continue;
        }
        // Unknowns with consecutive numbers, such as a node's free components, follow each other in every column.
        const int position = row == before + 1 ? next : bulk_pattern_.find(row, column);
        *entry++ = position;
        before = row, next = position + 1;
      }
    }
  };
  std::size_t g = 0;
  for (std::size_t body = 0; body < scene_.bodies.size(); ++body) {
    const Partition& shares = partitions_[body];
    first_position_.emplace_back();
    for (int e = 0; e < scene_.bodies[body].body->macro_elements(); ++e, ++g) {
      trash = first_trash + D * shares.share[e];
      const Nodes& group = groups[g];
      find(group);
      const int n = std::ssize(scene_.bodies[body].body->functions_of_macro(e));
      const auto add = [&](int row, int column) { bulk_positions_[next_position++] = found[column * D * n + row]; };
      first_position_.back().push_back(next_position);
      const bool whole = supports_[body][e].whole;
      for (int column = 0; column < D * n && whole; ++column)
        for (int a = 0; a < n; ++a) add(D * a, column);
      for (int i = 0; i < D && !whole; ++i)
        for (int j = i; j < D; ++j) {
          for (int a = 0; a < n; ++a)
            for (int b = 0; b < n; ++b) add(D * a + i, D * b + j);
          if (i == j) continue;
          for (int a = 0; a < n; ++a)
            for (int b = 0; b < n; ++b) add(D * b + j, D * a + i);
        }
    }
    first_trash += D * static_cast<int>(shares.heads.size());
  }
}

/// Sets the pattern to that of the bodies and, if `contacts`, of all current contact blocks with the adjacent master
/// elements, so that sliding by a part of an element does not need a new pattern.
template <int D> void Assembly<D>::cover(bool contacts) {
  std::vector<Nodes> groups;
  for (std::size_t k = 0; k < contacts_.size() && contacts; ++k)
    for (const contact::Block& block : contacts_[k]->blocks()) {
      Nodes dofs;
      contacts_[k]->append_dofs(block, unknowns_.of_contact(k), dofs);
      if (block.group < 0) contacts_[k]->append_master(block.master_element, unknowns_.of_contact(k), dofs, true);
      for (const int element : block.master_elements)
        contacts_[k]->append_master(element, unknowns_.of_contact(k), dofs, true);
      for (int& dof : dofs) dof = unknowns_.mover(dof);
      groups.push_back(std::move(dofs));
    }
  std::vector<int> moved;
  pattern_ = solve::extend(bulk_pattern_, groups, moved);
  const int trash = D * static_cast<int>(arrays_.size());
  for (int k = 0; k < trash; ++k) moved.push_back(pattern_.entries() + k);
  positions_.resize(bulk_positions_.size());
  for (std::size_t i = 0; i < positions_.size(); ++i) positions_[i] = moved[bulk_positions_[i]];
  diagonal_.clear();
  for (int i = 0; i < pattern_.size; ++i) diagonal_.push_back(pattern_.find(i, i));
  tie_positions_.clear();
  for (const auto& [multiplier, displacement, value] : ties_.couplings) {
    const int i = unknowns_.unknown(multiplier), j = unknowns_.unknown(displacement);
    tie_positions_.push_back(j < 0 ? -1 : pattern_.find(i, j));
    tie_positions_.push_back(j < 0 ? -1 : pattern_.find(j, i));
  }
  locate_face_terms();
  values_.resize(pattern_.entries() + trash);
  for (auto& placements : placements_) placements.clear();
  if (linear_) move_constant(std::move(moved));
  ++version_;
}

template void Assembly<2>::build_bulk();
template void Assembly<2>::cover(bool);
template void Assembly<3>::build_bulk();
template void Assembly<3>::cover(bool);

} // namespace signorini::model
