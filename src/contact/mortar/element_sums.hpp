#pragma once
// Gaps and slips of contact points, weighted by multiplier functions and summed by slave element.

#include "contact/mortar/mortar_law.hpp"
#include "contact/mortar/multiplier_functions.hpp"

namespace signorini::contact {

/// Different elements may be filled by different threads.
template <int D> class ElementSums {
public:
  /// Keeps a reference.
  ElementSums(const MultiplierFunctions<D>& functions, int elements);

  /// Starts an element; `skipped`: its points are not projected.
  void start(int element, bool skipped);
  /// Adds the gap and slip of point i, without a factor M_A, to the sums of the multipliers on its element.
  void add(int element, std::size_t i, const MultiplierSums<D>& point);
  /// Lowers the travel up to which all points of an element stay open (PointHistory::cleared).
  void clear_up_to(int element, double travel) { cleared_[element] = std::min(cleared_[element], travel); }

  bool skipped(int element) const { return skipped_[element]; }
  /// Travel up to which all points of a multiplier stay open.
  double cleared(int multiplier) const;
  /// Sums over the elements of a multiplier.
  MultiplierSums<D> sum(int multiplier) const;
  double memory() const;

private:
  const MultiplierFunctions<D>& functions_;
  std::vector<std::size_t> first_; ///< per element: offset into sums_
  std::vector<MultiplierSums<D>> sums_;
  std::vector<char> skipped_;
  std::vector<double> cleared_;
};

} // namespace signorini::contact
