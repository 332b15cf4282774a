// Number and positions of the elements in each knot span of a direction.
#include "nurbs/refine.hpp"

#include "base/error.hpp"
#include "nurbs/constants.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::nurbs {

namespace {

/// Least fraction of elements and of length: below it, knots are as close as rounding errors.
constexpr double least_share = 1e-9;

/// The piecewise linear map of [0, 1] onto itself with one kink, and its inverse.
struct Kink {
  double from = 0.5, to = 0.5; ///< the kink maps `from` to `to`

  double operator()(double s) const { return s <= from ? s * (to / from) : 1 - (1 - s) * ((1 - to) / (1 - from)); }
  Kink inverse() const { return {to, from}; }
};

Kink kink_of(const std::optional<Grading>& grading) {
  if (!grading) return {};
  const auto check = [](const char* name, double share) {
    require(share >= least_share && share <= 1 - least_share, "nurbs.grading.share",
            {{"argument", name}, {"least", least_share}, {"share", share}});
  };
  check("elements", grading->elements);
  check("length", grading->length);
  return grading->at_end ? Kink{1 - grading->elements, 1 - grading->length} : Kink{grading->elements, grading->length};
}

/// Largest-remainder method: integers ≥ 1 with the sum `total`, close to the quotas, which have the same sum.
std::vector<int> distribute(const std::vector<double>& quotas, int total) {
  // Quotas that are equal or integer within rounding error count as such.
  std::vector<int> counts;
  int sum = 0;
  for (double quota : quotas) {
    counts.push_back(std::max(1, static_cast<int>(std::floor(quota + computed))));
    sum += counts.back();
  }
  // Increments where most is missing, or decrements where the excess is largest: the first of equals.
  while (sum != total) {
    const int step = sum < total ? 1 : -1;
    std::size_t chosen = quotas.size();
    double most = 0;
    for (std::size_t i = 0; i < quotas.size(); ++i) {
      const double missing = step * (quotas[i] - counts[i]);
      if (step < 0 && counts[i] == 1) continue;
      if (chosen == quotas.size() || missing > most + computed) {
        chosen = i;
        most = missing;
      }
    }
    counts[chosen] += step;
    sum += step;
  }
  return counts;
}

} // namespace

std::vector<double> element_knots(const KnotVector& knots, int elements, const std::optional<Grading>& grading) {
  require(elements >= knots.elements(), "nurbs.grading.elements",
          {{"elements", elements}, {"least", knots.elements()}});
  const Kink density = kink_of(grading), inverse = density.inverse();
  const double length = knots.last() - knots.first();
  // The patch's knots in the coordinate in which the elements are uniform.
  std::vector<double> even, quotas;
  for (double knot : knots.breaks()) even.push_back(inverse((knot - knots.first()) / length));
  for (std::size_t i = 1; i < even.size(); ++i) quotas.push_back((even[i] - even[i - 1]) * elements);
  const std::vector<int> counts = distribute(quotas, elements);

  std::vector<double> inserted;
  for (std::size_t i = 0; i < counts.size(); ++i)
    for (int k = 1; k < counts[i]; ++k)
      inserted.push_back(knots.first() + length * density(even[i] + (even[i + 1] - even[i]) * k / counts[i]));
  return inserted;
}

} // namespace signorini::nurbs
