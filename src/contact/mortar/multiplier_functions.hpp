#pragma once
// The multiplier functions M_A on a slave face: products over its directions, tabulated at the contact points.

#include "contact/face/multiplier_space.hpp"
#include "contact/point/contact_points.hpp"

#include <algorithm>
#include <span>

namespace signorini::contact {

/// Sorts a list and removes repetitions.
void sort_once(std::vector<int>& list);

/// Multipliers whose supports begin near each other, which couple nearly the same unknowns.
struct MultiplierGroup {
  std::vector<int> members, support; ///< multipliers, and the slave elements of their supports, increasing
  std::vector<int> nodes;            ///< face-local indices of all functions on the support, increasing
};

template <int D> class MultiplierFunctions {
public:
  /// `points` has `per_direction` Gauss points per element and direction. Throws Error as multiplier_space().
  MultiplierFunctions(const Surface<D>& slave, const ContactPoints<D>& points, int per_direction, MultiplierSpace kind,
                      int joined = 1);

  int count() const { return std::ssize(supports_); }
  /// Multipliers that do not vanish on a slave element.
  std::span<const int> on(int element) const { return numbers_[element]; }
  /// Index of a multiplier in on(element); the size of that list if it vanishes there.
  int index_on(int element, int multiplier) const {
    return static_cast<int>(std::ranges::find(numbers_[element], multiplier) - numbers_[element].begin());
  }
  /// Slave elements on which a multiplier does not vanish, increasing.
  std::span<const int> support(int multiplier) const { return supports_[multiplier]; }
  const std::vector<MultiplierGroup>& groups() const { return groups_; }
  /// M_A of on(element) at contact point i.
  const double* at_point(std::size_t i) const { return values_.data() + offsets_[i]; }
  /// The contact point at which each multiplier is largest; 0 if it has none.
  const std::vector<int>& largest() const { return largest_; }
  /// Reference areas of the multipliers, Σ w_k M_A over all points.
  std::vector<double> areas(const ContactPoints<D>& points) const;
  double memory() const;

private:
  void make_groups(const Surface<D>& slave);

  std::vector<std::vector<int>> numbers_, supports_;
  std::vector<MultiplierGroup> groups_;
  std::vector<std::size_t> offsets_;
  std::vector<double> values_;
  std::vector<int> largest_;
};

} // namespace signorini::contact
