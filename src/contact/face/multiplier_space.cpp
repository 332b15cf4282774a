#include "contact/face/multiplier_space.hpp"

#include "base/error.hpp"
#include "nurbs/multi_degree.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace signorini::contact {

nurbs::Space1D multiplier_space(const nurbs::Space1D& trace, MultiplierSpace kind, int joined) {
  if (kind == MultiplierSpace::linear) {
    std::vector<int> smoothness;
    for (std::size_t i = 0; i < trace.smoothness().size(); ++i)
      smoothness.push_back(static_cast<int>(i) % joined == 0 ? 0 : 1);
    return nurbs::multi_degree_space(trace.breaks(), std::vector<int>(trace.elements(), 1), std::move(smoothness));
  }
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

template <int D> FaceMultipliers<D>::FaceMultipliers(const Surface<D>& slave, MultiplierSpace kind, int joined) {
  int products = 1;
  for (int d = 0; d < D - 1; ++d) {
    along.push_back(multiplier_space(slave.direction(d), kind, joined));
    products *= along.back().functions();
  }
  std::map<int, int> numbers; // of functions, in the order of their first products
  for (int i = 0; i < products; ++i)
    number.push_back(
        numbers.emplace(kind == MultiplierSpace::equal ? slave.shared(i) : i, static_cast<int>(numbers.size()))
            .first->second);
  count = std::ssize(numbers);
}

template struct FaceMultipliers<2>;
template struct FaceMultipliers<3>;

} // namespace signorini::contact
