#include "nurbs/knots.hpp"

#include "base/error.hpp"
#include "nurbs/constants.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini::nurbs {

namespace {

void check(int degree, const std::vector<double>& knots) {
  require(degree >= 0 && degree <= max_degree, "nurbs.knots.degree", {{"degree", degree}, {"most", max_degree}});
  const std::size_t p = static_cast<std::size_t>(degree);
  require(knots.size() >= 2 * (p + 1), "nurbs.knots.count",
          {{"degree", degree}, {"least", 2 * (p + 1)}, {"ends", p + 1}, {"count", knots.size()}});
  for (std::size_t i = 0; i < knots.size(); ++i)
    require(std::isfinite(knots[i]), "nurbs.knots.finite", {{"number", i}, {"knot", knots[i]}});
  for (std::size_t i = 1; i < knots.size(); ++i)
    require(knots[i - 1] <= knots[i], "nurbs.knots.order",
            {{"number", i}, {"knot", knots[i]}, {"before", i - 1}, {"knot_before", knots[i - 1]}});
  require(knots.front() < knots.back(), "nurbs.knots.equal", {{"knot", knots.front()}});

  // Distinct knots that are closer would form elements that rounding error cannot resolve.
  const double least = rounding * (knots.back() - knots.front());
  for (std::size_t i = 0; i < knots.size();) {
    const std::size_t start = i;
    while (i < knots.size() && knots[i] == knots[start]) ++i;
    const std::size_t count = i - start;
    const bool at_start = start == 0, at_end = i == knots.size();
    if (at_start || at_end)
      require(count == p + 1, at_start ? "nurbs.knots.first_ends" : "nurbs.knots.last_ends",
              {{"knot", knots[start]}, {"count", count}, {"degree", degree}, {"expected", p + 1}});
    else
      require(count <= std::max<std::size_t>(p, 1), "nurbs.knots.interior",
              {{"knot", knots[start]}, {"count", count}, {"degree", degree}});
    require(at_end || knots[i] - knots[start] >= least, "nurbs.knots.close",
            {{"knot", knots[start]}, {"distance", at_end ? 0.0 : knots[i] - knots[start]}});
  }
}

} // namespace

KnotVector::KnotVector(int degree, std::vector<double> knots) : degree_(degree), knots_(std::move(knots)) {
  check(degree_, knots_);
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i)
    if (knots_[i] < knots_[i + 1]) {
      spans_.push_back(static_cast<int>(i));
      breaks_.push_back(knots_[i]);
    }
  breaks_.push_back(knots_.back());
}

KnotVector KnotVector::single(int degree) {
  std::vector<double> knots(degree + 1, 0.0);
  knots.insert(knots.end(), degree + 1, 1.0);
  return {degree, std::move(knots)};
}

int find_element(const std::vector<double>& breaks, double xi) {
  const double first = breaks.front(), last = breaks.back();
  const double beyond = std::max(first - xi, xi - last), slack = rounding * (last - first);
  if (!(beyond <= slack)) { // also for nan
    if (beyond < just_outside * (last - first))
      fail("nurbs.knots.just_outside", {{"xi", xi}, {"first", first}, {"last", last}, {"distance", beyond}});
    fail("nurbs.knots.outside", {{"xi", xi}, {"first", first}, {"last", last}});
  }
  const auto next = std::upper_bound(breaks.begin(), breaks.end() - 1, xi);
  return std::max(static_cast<int>(next - breaks.begin()) - 1, 0);
}

std::vector<int> KnotVector::functions_on(int element) const {
  std::vector<int> functions(degree_ + 1);
  std::iota(functions.begin(), functions.end(), first_function(element));
  return functions;
}

int KnotVector::multiplicity(double knot) const {
  const auto [from, to] = std::equal_range(knots_.begin(), knots_.end(), knot);
  return static_cast<int>(to - from);
}

std::vector<double> KnotVector::greville() const {
  std::vector<double> result;
  for (int i = 0; i < functions(); ++i) {
    const auto knot = knots_.begin() + i;
    if (degree_ == 0) {
      result.push_back(0.5 * (knot[0] + knot[1]));
      continue;
    }
    double sum = 0;
    for (int k = 1; k <= degree_; ++k) sum += knot[k];
    // Rounding error must not move the abscissa of an end out of the interval.
    result.push_back(std::clamp(sum / degree_, knot[1], knot[degree_]));
  }
  return result;
}

} // namespace signorini::nurbs
