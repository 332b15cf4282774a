// The unknowns on which contacts and ties act, and the positions of contact blocks in the tangent.
#include "model/system/assembly.hpp"

#include "model/constants.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

/// Lists the unknowns that are marked as those of contacts, and the border.
template <int D> void Assembly<D>::list_contact_unknowns() {
  for (const int i : border_) is_contact_unknown_[i] = true;
  contact_unknowns_.clear();
  for (int i = 0; i < unknowns_.size(); ++i)
    if (is_contact_unknown_[i]) contact_unknowns_.push_back(i);
  ++contact_version_;
}

/// Lists the unknowns known before any contact: the border and, if constant factors are condensed onto contact
/// unknowns, all of the contacts' faces, unless these are so many that their dense factors would cost more than making
/// the constant ones again as contacts spread.
template <int D> void Assembly<D>::forget_contact_unknowns() {
  std::fill(is_contact_unknown_.begin(), is_contact_unknown_.end(), false);
  for (std::size_t k = 0; k < contacts_.size() && linear_; ++k) {
    const contact::Formulation<D>& contact = *contacts_[k];
    const contact::Offsets& offsets = unknowns_.of_contact(k);
    Nodes dofs;
    for (int e = 0; e < contact.slave().elements(); ++e) contact.append_slave(e, dofs);
    const int masters = contact.master().rigid() ? 1 : contact.master().surface()->elements();
    for (int e = 0; e < masters; ++e) contact.append_master(e, offsets, dofs);
    for (int number = 0; number < contact.extra_unknowns(); ++number) dofs.push_back(offsets.extra + number);
    for (int dof : dofs)
      if (const int i = unknowns_.mover(dof); i >= 0) is_contact_unknown_[i] = true;
  }
  const double all = static_cast<double>(std::count(is_contact_unknown_.begin(), is_contact_unknown_.end(), true));
  if (2.0 / 3.0 * all * all * all > whole_faces * pattern_.entries())
    std::fill(is_contact_unknown_.begin(), is_contact_unknown_.end(), false);
  list_contact_unknowns();
}

/// Extends contact_unknowns() if a contact acts on others: to the unknowns of all current blocks and of the slave
/// elements around them, a quarter of the contact's width.
template <int D> void Assembly<D>::watch_contacts() {
  const auto all_known = [&](std::size_t k, const contact::Block& block) {
    const Nodes& list = placements_[k].find(block.key())->second.columns;
    return std::all_of(list.begin(), list.end(), [&](int dof) {
      const int i = unknowns_.mover(dof);
      return i < 0 || is_contact_unknown_[i];
    });
  };
  bool known = true;
  for (std::size_t k = 0; k < contacts_.size() && known; ++k)
    for (const contact::Block& block : contacts_[k]->blocks()) known = known && all_known(k, block);
  if (known) return;

  std::fill(is_contact_unknown_.begin(), is_contact_unknown_.end(), false);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const contact::Formulation<D>& contact = *contacts_[k];
    const double blocks = static_cast<double>(contact.blocks().size());
    const int margin = 2 + static_cast<int>((D == 2 ? blocks : std::sqrt(blocks)) / 4);
    Nodes dofs;
    for (const contact::Block& block : contact.blocks()) {
      const Nodes& own = placements_[k].find(block.key())->second.columns;
      dofs.insert(dofs.end(), own.begin(), own.end());
      for (int alpha = 0; alpha < D - 1; ++alpha)
        for (bool at_end : {false, true})
          for (int i = 0, e = block.slave_element; e >= 0 && i < margin; ++i) {
            e = contact.slave().neighbor(e, alpha, at_end);
            if (e < 0) break;
            contact.append_slave(e, dofs);
          }
    }
    for (int dof : dofs)
      if (const int i = unknowns_.mover(dof); i >= 0) is_contact_unknown_[i] = true;
  }
  list_contact_unknowns();
}

/// Determines the positions of all current blocks; returns false if the pattern does not contain them.
template <int D> bool Assembly<D>::locate() {
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    for (const contact::Block& block : contacts_[k]->blocks()) {
      Placement& placement = placements_[k][block.key()];
      if (!placement.positions.empty() && block.group < 0) continue;
      Nodes dofs;
      contacts_[k]->append_dofs(block, unknowns_.of_contact(k), dofs);
      if (!placement.positions.empty() && dofs == placement.columns) continue;
      placement.columns = std::move(dofs);
      placement.rows.assign(placement.columns.begin(), placement.columns.begin() + block.rows);
      placement.runs.clear();
      std::vector<int> positions;
      for (int first = 0, count; first < block.rows; first += count) {
        const int i = unknowns_.mover(placement.rows[first]);
        count = 1;
        if (i < 0) continue;
        while (first + count < block.rows && unknowns_.mover(placement.rows[first + count]) == i + count) ++count;
        placement.runs.push_back({first, count});
        for (int column : placement.columns) {
          const int j = unknowns_.mover(column);
          positions.push_back(j < 0 ? -1 : pattern_.find(i, j));
          // Rows are sorted, so that the whole run is in the column if its ends are at their distance.
          if (j >= 0 && (positions.back() < 0 || pattern_.find(i + count - 1, j) != positions.back() + count - 1))
            return false;
        }
      }
      placement.positions = std::move(positions);
    }
  return true;
}

template <int D> void Assembly<D>::forget_contacts() {
  cover(false);
  forget_contact_unknowns();
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template void Assembly<D>::list_contact_unknowns();                                                                  \
  template void Assembly<D>::forget_contact_unknowns();                                                                \
  template void Assembly<D>::watch_contacts();                                                                         \
  template bool Assembly<D>::locate();                                                                                 \
  template void Assembly<D>::forget_contacts();
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
