#include "nurbs/knots.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "nurbs/constants.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini::nurbs {

namespace {

void check(int degree, const std::vector<double>& knots) {
  require(degree >= 0 && degree <= max_degree, "degree: ", degree, " is not in 0 … ", max_degree);
  const std::size_t p = static_cast<std::size_t>(degree);
  require(knots.size() >= 2 * (p + 1), "knots: degree ", degree, " needs at least ", 2 * (p + 1), " knots (", p + 1,
          " at each end), got ", knots.size());
  for (std::size_t i = 0; i < knots.size(); ++i)
    require(std::isfinite(knots[i]), "knots: knot ", i + 1, " is ", knots[i], ", expected a finite number");
  for (std::size_t i = 1; i < knots.size(); ++i)
    require(knots[i - 1] <= knots[i], "knots: they must not fall, but knot ", i + 1, " (", knots[i], ") is below knot ",
            i, " (", knots[i - 1], ")");
  require(knots.front() < knots.back(), "knots: all are ", knots.front(), "; the last must be above the first");

  // Distinct knots closer than this leave elements that rounding cannot resolve.
  const double least = rounding * (knots.back() - knots.front());
  for (std::size_t i = 0; i < knots.size();) {
    const std::size_t start = i;
    while (i < knots.size() && knots[i] == knots[start]) ++i;
    const std::size_t count = i - start;
    const bool at_start = start == 0, at_end = i == knots.size();
    if (at_start || at_end)
      require(count == p + 1, "knots: the ", at_start ? "first" : "last", " knot, ", knots[start], ", occurs ", count,
              " times; an open knot vector of degree ", degree, " repeats it ", p + 1, " times");
    else
      require(count <= std::max<std::size_t>(p, 1), "knots: interior knot ", knots[start], " occurs ", count,
              " times, more than the degree ", degree, ": the curve would fall apart there");
    require(at_end || knots[i] - knots[start] >= least, "knots: ", knots[start], " and the next one differ by only ",
            at_end ? 0.0 : knots[i] - knots[start], "; make them equal or move them apart");
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
  std::vector<double> knots(at(degree + 1), 0.0);
  knots.insert(knots.end(), at(degree + 1), 1.0);
  return {degree, std::move(knots)};
}

int find_element(const std::vector<double>& breaks, double xi) {
  const double first = breaks.front(), last = breaks.back();
  const double beyond = std::max(first - xi, xi - last), slack = rounding * (last - first);
  require(beyond <= slack, "xi: ", xi, " is outside the knots, [", first, ", ", last, "]",
          beyond > 0 && beyond < just_outside * (last - first) ? text(", by ", beyond) : "");
  const auto next = std::upper_bound(breaks.begin(), breaks.end() - 1, xi);
  return std::max(static_cast<int>(next - breaks.begin()) - 1, 0);
}

std::vector<int> KnotVector::functions_on(int element) const {
  std::vector<int> functions(at(degree_ + 1));
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
    // Rounding must not carry an end's abscissa out of the interval.
    result.push_back(std::clamp(sum / degree_, knot[1], knot[degree_]));
  }
  return result;
}

} // namespace signorini::nurbs
