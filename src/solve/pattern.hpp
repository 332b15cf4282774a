#pragma once
// The fixed sparse pattern of a tangent, built from groups of coupled unknowns.

#include <vector>

namespace signorini::solve {

/// Compressed columns without values: row indices of column j are rows[starts[j] … starts[j+1]), sorted.
struct Pattern {
  int size = 0;
  std::vector<int> starts, rows;

  int entries() const { return std::ssize(rows); }
  /// Position of entry (row, column) in the value array; −1 if it is not in the pattern.
  int find(int row, int column) const;
};

/// A structurally symmetric pattern with a full diagonal: all unknowns of a group are coupled with each other. Negative
/// entries (prescribed unknowns) are ignored. Throws Error if there are more than 2³¹ − 1 entries.
Pattern couple(int size, const std::vector<std::vector<int>>& groups);

/// `base` with additional groups. `moved[k]` becomes the position of base entry k in the result.
Pattern extend(const Pattern& base, const std::vector<std::vector<int>>& groups, std::vector<int>& moved);

} // namespace signorini::solve
