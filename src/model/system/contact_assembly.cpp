#include "model/system/contact_assembly.hpp"

#include "model/constants.hpp"
#include "model/system/free_angles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::model {

template <int D>
ContactAssembly<D>::ContactAssembly(const Unknowns<D>& unknowns, const contact::Formulations<D>& contacts,
                                    std::vector<int> border, bool linear)
    : unknowns_(unknowns), contacts_(contacts), border_(std::move(border)), linear_(linear),
      placements_(contacts.size()), is_listed_(unknowns.size(), false) {}

template <int D> std::vector<std::vector<int>> ContactAssembly<D>::groups() const {
  std::vector<std::vector<int>> groups;
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    for (const contact::Block& block : contacts_[k]->blocks()) {
      const contact::Offsets& offsets = unknowns_.of_contact(k);
      std::vector<int> dofs;
      append_dofs(contacts_[k]->faces(), block, offsets, dofs);
      if (block.group < 0) append_master(contacts_[k]->master(), block.master_element, offsets, dofs, true);
      for (const int element : block.master_elements)
        append_master(contacts_[k]->master(), element, offsets, dofs, true);
      for (int& dof : dofs) dof = unknowns_.independent(dof);
      groups.push_back(std::move(dofs));
    }
  return groups;
}

template <int D> bool ContactAssembly<D>::locate(const solve::Pattern& pattern) {
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const auto& blocks = contacts_[k]->blocks();
    // On a long slide every pair of elements meets once.
    if (!blocks.empty() && placements_[k].size() > most_placements * blocks.size()) placements_[k].clear();
    for (const contact::Block& block : blocks) {
      Placement& placement = placements_[k][block.key()];
      if (!placement.positions.empty() && block.group < 0) continue;
      std::vector<int> dofs;
      append_dofs(contacts_[k]->faces(), block, unknowns_.of_contact(k), dofs);
      if (!placement.positions.empty() && dofs == placement.columns) continue;
      if (!place(block, std::move(dofs), pattern, placement)) return false;
    }
  }
  return true;
}

/// Returns false if the pattern does not contain the block.
template <int D>
bool ContactAssembly<D>::place(const contact::Block& block, std::vector<int> dofs, const solve::Pattern& pattern,
                               Placement& placement) {
  placement.columns = std::move(dofs);
  placement.rows.assign(placement.columns.begin(), placement.columns.begin() + block.rows);
  placement.runs.clear();
  std::vector<int> positions;
  for (int first = 0, count; first < block.rows; first += count) {
    const int i = unknowns_.independent(placement.rows[first]);
    count = 1;
    if (i < 0) continue;
    while (first + count < block.rows && unknowns_.independent(placement.rows[first + count]) == i + count) ++count;
    placement.runs.push_back({first, count});
    for (int column : placement.columns) {
      const int j = unknowns_.independent(column);
      positions.push_back(j < 0 ? -1 : pattern.find(i, j));
      // Rows are sorted, so that the whole run is in the column if its ends are at their distance.
      if (j >= 0 && (positions.back() < 0 || pattern.find(i + count - 1, j) != positions.back() + count - 1))
        return false;
    }
  }
  placement.positions = std::move(positions);
  return true;
}

template <int D> void ContactAssembly<D>::forget_positions() {
  for (auto& placements : placements_) placements.clear();
}

/// Marks the unknowns of degrees of freedom as those of contacts.
template <int D> void ContactAssembly<D>::mark(const std::vector<int>& dofs) {
  for (int dof : dofs)
    if (const int i = unknowns_.independent(dof); i >= 0) is_listed_[i] = true;
}

/// Lists the marked unknowns and the border.
template <int D> void ContactAssembly<D>::list_marked() {
  for (const int i : border_) is_listed_[i] = true;
  listed_.clear();
  for (int i = 0; i < unknowns_.size(); ++i)
    if (is_listed_[i]) listed_.push_back(i);
  ++version_;
}

template <int D> void ContactAssembly<D>::reset(int entries) {
  std::fill(is_listed_.begin(), is_listed_.end(), false);
  for (std::size_t k = 0; k < contacts_.size() && linear_; ++k) {
    const contact::Formulation<D>& contact = *contacts_[k];
    const contact::Offsets& offsets = unknowns_.of_contact(k);
    std::vector<int> dofs;
    for (int e = 0; e < contact.slave().elements(); ++e) append_element(contact.slave(), e, 0, dofs);
    const int masters = contact.master().rigid() ? 1 : contact.master().surface()->elements();
    for (int e = 0; e < masters; ++e) append_master(contact.master(), e, offsets, dofs);
    for (int number = 0; number < contact.extra_unknowns(); ++number) dofs.push_back(offsets.extra + number);
    mark(dofs);
  }
  const double all = static_cast<double>(std::count(is_listed_.begin(), is_listed_.end(), true));
  if (2.0 / 3.0 * all * all * all > whole_faces * entries) std::fill(is_listed_.begin(), is_listed_.end(), false);
  list_marked();
}

template <int D> void ContactAssembly<D>::watch() {
  const auto columns = [&](std::size_t k, const contact::Block& block) -> const std::vector<int>& {
    return placements_[k].find(block.key())->second.columns;
  };
  const auto is_known = [&](int dof) {
    const int i = unknowns_.independent(dof);
    return i < 0 || is_listed_[i];
  };
  bool known = true;
  for (std::size_t k = 0; k < contacts_.size() && known; ++k)
    for (const contact::Block& block : contacts_[k]->blocks())
      known = known && std::ranges::all_of(columns(k, block), is_known);
  if (known) return;

  std::fill(is_listed_.begin(), is_listed_.end(), false);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const contact::Formulation<D>& contact = *contacts_[k];
    const double blocks = static_cast<double>(contact.blocks().size());
    const int margin = 2 + static_cast<int>((D == 2 ? blocks : std::sqrt(blocks)) / 4);
    std::vector<int> dofs;
    for (const contact::Block& block : contact.blocks()) {
      mark(columns(k, block));
      for (int alpha = 0; alpha < D - 1; ++alpha)
        for (bool at_end : {false, true})
          for (int i = 0, e = block.slave_element; e >= 0 && i < margin; ++i) {
            e = contact.slave().neighbor(e, alpha, at_end);
            if (e < 0) break;
            append_element(contact.slave(), e, 0, dofs);
          }
    }
    mark(dofs);
  }
  list_marked();
}

template <int D> void ContactAssembly<D>::add(const Evaluation<D>& evaluation) const {
  auto& [present, accepted, controls, loads, before] = evaluation.states;
  SparseTangent& tangent = evaluation.matrix;
  const bool turns = evaluation.tangent && !unknowns_.free_angles().empty();
  const VectorX rates = turns ? angle_rates(unknowns_, present.displacement) : VectorX();
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    for (const contact::Block& block : contacts_[k]->blocks()) {
      const Placement& placement = placements_[k].find(block.key())->second;
      const double* matrix = block.matrix.data();
      for (int r = 0; r < block.rows; ++r) {
        present.force(placement.rows[r]) += block.force[r];
        for (int c = 0; c < block.columns && evaluation.direction; ++c)
          evaluation.product(placement.rows[r]) +=
              matrix[r * block.columns + c] * (*evaluation.direction)(placement.columns[c]);
      }
      if (!evaluation.tangent) continue;
      const int* position = placement.positions.data();
      for (const auto& [first, count] : placement.runs)
        for (int c = 0; c < block.columns; ++c, ++position) {
          if (*position < 0) continue;
          double* const to = tangent.values.data() + *position;
          const double* const from = matrix + first * block.columns + c;
          for (int k = 0; k < count && !turns; ++k) to[k] += from[k * block.columns];
          for (int k = 0; k < count && turns; ++k)
            to[k] += rates(placement.rows[first + k]) * from[k * block.columns] * rates(placement.columns[c]);
          for (int k = 0; k < count && tangent.changed; ++k) tangent.changed->push_back(*position + k);
        }
    }
}

template <int D> double ContactAssembly<D>::memory() const {
  double sum = 0;
  for (const auto& placements : placements_)
    for (const auto& [key, placement] : placements) sum += bytes_of(placement.positions);
  return sum;
}

template class ContactAssembly<2>;
template class ContactAssembly<3>;

} // namespace signorini::model
