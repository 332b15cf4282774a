#include "nurbs/space1d.hpp"

#include "base/error.hpp"
#include "nurbs/bezier.hpp"
#include "nurbs/constants.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::nurbs {

Space1D::Space1D(std::vector<double> breaks, std::vector<int> smoothness, const std::vector<Element1D>& elements,
                 std::optional<KnotVector> knots)
    : breaks_(std::move(breaks)), smoothness_(std::move(smoothness)), knots_(std::move(knots)) {
  require(!elements.empty() && breaks_.size() == elements.size() + 1 && smoothness_.size() == breaks_.size(),
          "nurbs.space.breakpoints",
          {{"elements", elements.size()}, {"breakpoints", breaks_.size()}, {"smoothness", smoothness_.size()}});
  std::vector<bool> seen;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto& [degree, functions, extraction] = elements[e];
    require(std::isfinite(breaks_[e]) && breaks_[e] < breaks_[e + 1] && std::isfinite(breaks_[e + 1]),
            "nurbs.space.rising", {{"first", breaks_[e]}, {"second", breaks_[e + 1]}});
    require(degree >= 0 && degree <= max_degree, "nurbs.space.degree", {{"degree", degree}, {"most", max_degree}});
    require(extraction.rows() == static_cast<Eigen::Index>(functions.size()) && extraction.cols() == degree + 1 &&
                std::ssize(functions) <= max_degree + 1,
            "nurbs.space.extraction",
            {{"element", e},
             {"degree", degree},
             {"functions", functions.size()},
             {"rows", extraction.rows()},
             {"columns", extraction.cols()}});
    require((extraction.colwise().sum().array() - 1).abs().maxCoeff() <= rounding, "nurbs.space.sum", {{"element", e}});
    tables_.push_back({degree, functions.size(), numbers_.size(), extraction_.size()});
    for (std::size_t a = 0; a < functions.size(); ++a) {
      require(functions[a] >= 0 && (a == 0 || functions[a - 1] < functions[a]), "nurbs.space.numbers",
              {{"element", e}});
      const auto row = extraction.row(static_cast<Eigen::Index>(a));
      extraction_.insert(extraction_.end(), row.begin(), row.end());
    }
    numbers_.insert(numbers_.end(), functions.begin(), functions.end());
    functions_ = std::max(functions_, functions.back() + 1);
    degree_ = std::max(degree_, degree);
    seen.resize(functions_);
    for (int function : functions) seen[function] = true;
  }
  require(std::find(seen.begin(), seen.end(), false) == seen.end(), "nurbs.space.unused");
}

Element1D Space1D::element(int e) const {
  const std::span<const int> functions = functions_on(e);
  return {degree(e), {functions.begin(), functions.end()}, extraction(e)};
}

std::vector<double> sites(const Space1D& space) {
  std::vector<double> result{space.first()};
  for (int e = 0; e < space.elements(); ++e) {
    const auto [from, to] = space.interval(e);
    for (int k = 1, p = space.degree(e); k <= p; ++k) result.push_back(k < p ? from + (to - from) * k / p : to);
  }
  return result;
}

Space1D spline_space(const KnotVector& knots) {
  const int p = knots.degree();
  std::vector<int> smoothness;
  std::vector<Element1D> elements;
  for (double knot : knots.breaks()) smoothness.push_back(std::max(p - knots.multiplicity(knot), -1));
  for (int e = 0; e < knots.elements(); ++e)
    elements.push_back({p, knots.functions_on(e), bezier_extraction(knots, e)});
  return {knots.breaks(), std::move(smoothness), elements, knots};
}

} // namespace signorini::nurbs
