#include "contact/multiplier_space.hpp"

#include "base/error.hpp"
#include "nurbs/multi_degree.hpp"

#include <algorithm>
#include <utility>

namespace signorini::contact {

nurbs::Space1D multiplier_space(const nurbs::Space1D& trace, MultiplierSpace kind) {
  if (kind == MultiplierSpace::equal) {
    for (int e = 0; e < trace.elements(); ++e)
      require(trace.extraction(e).minCoeff() >= 0, "contact.mortar.negative", {{"element", e}});
    return trace;
  }
  std::vector<int> degrees;
  for (int e = 0; e < trace.elements(); ++e) {
    require(trace.degree(e) >= 2, "contact.mortar.reduced_degree", {{"degree", trace.degree(e)}});
    degrees.push_back(trace.degree(e) - 2);
  }
  std::vector<int> smoothness;
  for (const int k : trace.smoothness()) smoothness.push_back(std::max(k - 2, -1));
  return nurbs::multi_degree_space(trace.breaks(), degrees, std::move(smoothness));
}

} // namespace signorini::contact
