#include "contact/face/multiplier_space.hpp"

#include "base/error.hpp"
#include "nurbs/multi_degree.hpp"

#include <algorithm>
#include <map>
#include <numeric>
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

namespace {

/// By product of linear functions: the first one of the same function, where opposite borders coincide or a border is a
/// pole.
template <int D> std::vector<int> joined_borders(const Surface<D>& slave, const std::vector<nurbs::Space1D>& along) {
  std::array<int, 2> trace{1, 1}, own{1, 1};
  for (int d = 0; d < D - 1; ++d) {
    trace[d] = slave.direction(d).functions();
    own[d] = along[d].functions();
  }
  std::vector<int> first(own[0] * own[1]);
  std::iota(first.begin(), first.end(), 0);
  const auto merge = [&](int a, int b) {
    std::replace(first.begin(), first.end(), std::max(first[a], first[b]), std::min(first[a], first[b]));
  };
  for (int d = 0; d < D - 1; ++d) {
    const int across = 1 - d, last = own[d] - 1;
    const auto index = [&](const std::array<int, 2>& count, int i, int j) {
      return d == 0 ? i + count[0] * j : j + count[0] * i;
    };
    const auto point = [&](int i, int j) { return slave.shared(index(trace, i, j)); };
    bool closes = true;
    std::array<bool, 2> pole{D == 3, D == 3};
    for (int j = 0; j < trace[across]; ++j) {
      closes = closes && point(0, j) == point(trace[d] - 1, j);
      pole[0] = pole[0] && point(0, j) == point(0, 0);
      pole[1] = pole[1] && point(trace[d] - 1, j) == point(trace[d] - 1, 0);
    }
    for (int j = 0; j < own[across]; ++j) {
      if (closes) merge(index(own, 0, j), index(own, last, j));
      if (pole[0]) merge(index(own, 0, j), index(own, 0, 0));
      if (pole[1]) merge(index(own, last, j), index(own, last, 0));
    }
  }
  return first;
}

} // namespace

template <int D> FaceMultipliers<D>::FaceMultipliers(const Surface<D>& slave, MultiplierSpace kind, int joined) {
  int products = 1;
  for (int d = 0; d < D - 1; ++d) {
    along.push_back(multiplier_space(slave.direction(d), kind, joined));
    products *= along.back().functions();
  }
  const std::vector<int> first = kind == MultiplierSpace::linear ? joined_borders(slave, along) : std::vector<int>();
  std::map<int, int> numbers; // of functions, in the order of their first products
  for (int i = 0; i < products; ++i) {
    const int same = kind == MultiplierSpace::equal ? slave.shared(i) : first.empty() ? i : first[i];
    number.push_back(numbers.emplace(same, static_cast<int>(numbers.size())).first->second);
  }
  count = std::ssize(numbers);
}

template struct FaceMultipliers<2>;
template struct FaceMultipliers<3>;

} // namespace signorini::contact
