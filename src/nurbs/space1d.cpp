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
          "space: ", elements.size(), " elements lie between ", elements.size() + 1, " breakpoints, got ",
          breaks_.size(), " breakpoints and ", smoothness_.size(), " orders of smoothness");
  std::vector<bool> seen;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto& [degree, functions, extraction] = elements[e];
    require(std::isfinite(breaks_[e]) && breaks_[e] < breaks_[e + 1] && std::isfinite(breaks_[e + 1]),
            "space: breakpoints must be finite and rise, got ", breaks_[e], " and ", breaks_[e + 1]);
    require(degree >= 0 && degree <= max_degree, "space: degree ", degree, " is not in 0 … ", max_degree);
    require(extraction.rows() == static_cast<Eigen::Index>(functions.size()) && extraction.cols() == degree + 1 &&
                functions.size() <= at(max_degree + 1),
            "space: element ", e + 1, " of degree ", degree, " has ", functions.size(),
            " functions with an extraction of ", extraction.rows(), " x ", extraction.cols());
    require((extraction.colwise().sum().array() - 1).abs().maxCoeff() <= rounding, "space: the functions of element ",
            e + 1, " do not sum to 1");
    tables_.push_back({degree, functions.size(), numbers_.size(), extraction_.size()});
    for (std::size_t a = 0; a < functions.size(); ++a) {
      require(functions[a] >= 0 && (a == 0 || functions[a - 1] < functions[a]), "space: the functions of element ",
              e + 1, " must be numbered from 0 and rise");
      const auto row = extraction.row(static_cast<Eigen::Index>(a));
      extraction_.insert(extraction_.end(), row.begin(), row.end());
    }
    numbers_.insert(numbers_.end(), functions.begin(), functions.end());
    functions_ = std::max(functions_, functions.back() + 1);
    degree_ = std::max(degree_, degree);
    seen.resize(at(functions_));
    for (int function : functions) seen[at(function)] = true;
  }
  require(std::find(seen.begin(), seen.end(), false) == seen.end(), "space: a function lives on no element");
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
