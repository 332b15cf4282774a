#pragma once
// The contacts' blocks in residual and tangent, and the unknowns on which contacts act.

#include "model/system/evaluation.hpp"

#include <unordered_map>

namespace signorini::model {

template <int D> class ContactAssembly {
public:
  /// `border`: unknowns that belong to unknowns() in any case. `linear`: all bodies are.
  ContactAssembly(const Unknowns<D>& unknowns, const contact::Formulations<D>& contacts, std::vector<int> border,
                  bool linear);

  /// The unknowns that each current block couples, with those of adjacent master elements, so that sliding by a part of
  /// an element does not need a new pattern.
  std::vector<std::vector<int>> groups() const;
  /// Determines the positions of all current blocks; returns false if the pattern does not contain them.
  bool locate(const solve::Pattern& pattern);
  /// Drops the positions in a former pattern.
  void forget_positions();
  /// Extends unknowns() if a contact acts on others: to the unknowns of all current blocks and of the slave elements
  /// around them, a quarter of the contact's width.
  void watch();
  /// Resets unknowns() to those known before any contact: the border and, if constant factors are condensed onto
  /// contact unknowns, all of the contacts' faces, unless these are so many that their dense factors would cost more
  /// than making the constant ones again as contacts spread. `entries`: of the tangent.
  void reset(int entries);
  /// Adds the current blocks, at the positions of locate().
  void add(const Evaluation<D>& evaluation) const;

  /// The unknowns on which contacts act or may soon act, sorted. The list is extended in large pieces, each with a new
  /// version(). It contains the border.
  const std::vector<int>& unknowns() const { return listed_; }
  int version() const { return version_; }
  double memory() const;

private:
  /// Rows of a block with consecutive unknowns, whose entries follow each other in every column of the tangent.
  struct RowRun {
    int first, count;
  };
  /// Positions of a block's entries, determined once per pattern.
  struct Placement {
    std::vector<int> rows, columns; ///< degrees of freedom
    std::vector<int> positions;     ///< run by run: of the first row in every column, −1 without unknown
    std::vector<RowRun> runs;
  };
  bool place(const contact::Block& block, std::vector<int> dofs, const solve::Pattern& pattern, Placement& placement);
  void mark(const std::vector<int>& dofs);
  void list_marked();

  const Unknowns<D>& unknowns_;
  const contact::Formulations<D>& contacts_;
  std::vector<int> border_;
  bool linear_;
  std::vector<std::unordered_map<std::uint64_t, Placement>> placements_; ///< by contact and Block::key()
  std::vector<int> listed_;
  std::vector<char> is_listed_; ///< by unknown
  int version_ = 0;
};

} // namespace signorini::model
