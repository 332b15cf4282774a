#include "model/partition.hpp"

#include <algorithm>

namespace signorini::model {

namespace {

constexpr int most_shares = 4;    // more than cores: contacts are shared out beside them
constexpr int worth_sharing = 64; // elements in a share: 30 µs of work, several times what it takes to wake a thread

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Heads and tails of a number of even shares; false when tails would meet. `last`: the last element of each control
/// point.
template <int D> bool cut(const solid::Body<D>& body, const std::vector<int>& last, int shares, Partition& result) {
  const int elements = body.elements();
  const auto reaches = [&](int e, int element) {
    const auto functions = body.functions_of(e);
    return std::any_of(functions.begin(), functions.end(), [&](int function) { return last[at(function)] >= element; });
  };
  result.heads.clear();
  result.tails.clear();
  for (int k = 0; k < shares; ++k) {
    const int first = elements * k / shares, end = elements * (k + 1) / shares;
    // The head ends before the first element that shares a control point with what follows the range.
    int tail = first;
    while (tail < end && !reaches(tail, end)) ++tail;
    result.heads.push_back({first, tail});
    result.tails.push_back({tail, end});
  }
  for (int k = 0; k + 1 < shares; ++k)
    for (int e = result.tails[at(k)].first; e < result.tails[at(k)].last; ++e)
      if (reaches(e, result.tails[at(k + 1)].first)) return false;
  return true;
}

} // namespace

template <int D> Partition partition(const Unknowns<D>& unknowns, const solid::Body<D>& body, int offset) {
  const int elements = body.elements();
  Partition result{{}, {}, {}, std::vector<char>(at(elements), false)};
  std::vector<int> last(at(body.functions()), 0);
  for (int e = 0; e < elements; ++e)
    for (int function : body.functions_of(e)) last[at(function)] = e;
  int shares = std::clamp(elements / worth_sharing, 1, most_shares);
  while (!cut(body, last, shares, result)) --shares;
  if (shares == 1) return result;

  // Elements with unknowns that several control points share
  std::vector<int> owner(at(unknowns.size()), -1);
  std::vector<char> shared(at(unknowns.size()), false);
  for (int dof = offset; dof < offset + D * body.functions(); ++dof)
    if (const int i = unknowns.unknown(dof); i >= 0) {
      shared[at(i)] = owner[at(i)] >= 0;
      owner[at(i)] = dof;
    }
  for (int e = 0; e < elements; ++e) {
    for (int function : body.functions_of(e))
      for (int c = 0; c < D; ++c)
        if (const int i = unknowns.unknown(offset + D * function + c); i >= 0 && shared[at(i)])
          result.in_rest[at(e)] = true;
    if (result.in_rest[at(e)]) result.rest.push_back(e);
  }
  return result;
}

template Partition partition<2>(const Unknowns<2>&, const solid::Body<2>&, int);
template Partition partition<3>(const Unknowns<3>&, const solid::Body<3>&, int);

} // namespace signorini::model
