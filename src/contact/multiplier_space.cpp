#include "contact/multiplier_space.hpp"

#include "base/error.hpp"
#include "nurbs/bezier.hpp"

#include <algorithm>
#include <utility>

namespace signorini::contact {

namespace {

/// Appends the splines of degree p − 2 on the elements `first` … `last` − 1, between which the trace is at least C²,
/// with functions numbered from `function`; returns the next number.
int append_smooth_part(const nurbs::Space1D& trace, int first, int last, int function,
                       std::vector<nurbs::Element1D>& elements) {
  const int degree = trace.degree(first) - 2;
  std::vector<double> knots(at(degree + 1), trace.breaks()[at(first)]);
  for (int e = first + 1; e < last; ++e) {
    require(trace.degree(e) == trace.degree(first), "contact.mortar.join",
            {{"first", trace.degree(first)}, {"second", trace.degree(e)}});
    // A knot of the trace of multiplicity p − k keeps it: C^k becomes C^(k−2).
    knots.insert(knots.end(), at(trace.degree(e) - trace.smoothness()[at(e)]), trace.breaks()[at(e)]);
  }
  knots.insert(knots.end(), at(degree + 1), trace.breaks()[at(last)]);
  const nurbs::KnotVector vector(degree, std::move(knots));
  for (int e = 0; e < last - first; ++e) {
    elements.push_back({degree, vector.functions_on(e), nurbs::bezier_extraction(vector, e)});
    for (int& number : elements.back().functions) number += function;
  }
  return function + vector.functions();
}

} // namespace

nurbs::Space1D multiplier_space(const nurbs::Space1D& trace, MultiplierSpace kind) {
  if (kind == MultiplierSpace::equal) {
    for (int e = 0; e < trace.elements(); ++e)
      require(trace.extraction(e).minCoeff() >= 0, "contact.mortar.negative", {{"element", e}});
    return trace;
  }
  for (int e = 0; e < trace.elements(); ++e)
    require(trace.degree(e) >= 2, "contact.mortar.reduced_degree", {{"degree", trace.degree(e)}});
  std::vector<int> smoothness;
  for (const int k : trace.smoothness()) smoothness.push_back(std::max(k - 2, -1));
  std::vector<nurbs::Element1D> elements;
  for (int first = 0, last = 1, functions = 0; first < trace.elements(); first = last++) {
    while (last < trace.elements() && smoothness[at(last)] >= 0) ++last;
    functions = append_smooth_part(trace, first, last, functions, elements);
  }
  return {trace.breaks(), std::move(smoothness), elements};
}

} // namespace signorini::contact
