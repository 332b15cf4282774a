#include "model/system/partition.hpp"

#include "model/constants.hpp"

#include <algorithm>

namespace signorini::model {

namespace {

/// The slabs of a body normal to one parametric direction.
struct Slabs {
  int direction, count;
  std::vector<int> reach; ///< per slab: the last slab with a common control point
};

template <int D> Slabs slabs_across(const solid::Body<D>& body, int direction) {
  Slabs slabs{direction, body.macro_elements(direction), std::vector<int>(body.macro_elements(direction), 0)};
  std::vector<int> last(body.functions(), 0); // last slab of each control point
  for (int e = 0; e < body.macro_elements(); ++e)
    for (int function : body.functions_of_macro(e))
      last[function] = std::max(last[function], body.macro_index(e, direction));
  for (int e = 0; e < body.macro_elements(); ++e)
    for (int function : body.functions_of_macro(e)) {
      int& reach = slabs.reach[body.macro_index(e, direction)];
      reach = std::max(reach, last[function]);
    }
  return slabs;
}

/// Divides the slabs into equal shares. Returns for each share its first slab and the first slab of its tail; empty if
/// tails would overlap.
std::vector<int> cut(const Slabs& slabs, int shares) {
  std::vector<int> starts;
  for (int k = 0; k < shares; ++k) {
    const int first = slabs.count * k / shares, end = slabs.count * (k + 1) / shares;
    // The head ends before the first slab that reaches the next share. The last share has none; its tail is as long as
    // the previous one, so that tails are as equal as heads.
    int tail = first;
    if (k + 1 == shares && k > 0)
      tail = std::max(first, end - (first - starts[2 * k - 1]));
    else
      while (tail < end && slabs.reach[tail] < end) ++tail;
    starts.insert(starts.end(), {first, tail});
  }
  for (int k = 0; k + 1 < shares; ++k)
    for (int slab = starts[2 * k + 1]; slab < starts[2 * k + 2]; ++slab)
      if (slabs.reach[slab] >= starts[2 * k + 3]) return {};
  return starts;
}

/// Time of two threads relative to that of one, if heads, then tails, are assigned to the first free thread.
double time_on_two(const Slabs& slabs, std::vector<int> starts) {
  starts.push_back(slabs.count);
  int sum = 0;
  for (std::size_t first : {0, 1}) {
    int busy[2] = {0, 0};
    for (std::size_t piece = first; piece + 1 < starts.size(); piece += 2)
      busy[busy[0] <= busy[1] ? 0 : 1] += starts[piece + 1] - starts[piece];
    sum += std::max(busy[0], busy[1]);
  }
  return static_cast<double>(sum) / slabs.count;
}

/// Marks the elements with an unknown of several bodies or, unless `one_share`, of several control points.
template <int D>
std::vector<char> on_shared_unknowns(const Unknowns<D>& unknowns, const solid::Body<D>& body, int offset,
                                     const std::vector<char>& of_several, bool one_share) {
  std::vector<int> owner(unknowns.size(), -1);
  std::vector<char> shared(unknowns.size(), false), result(body.macro_elements(), false);
  for (int dof = offset; dof < offset + D * body.functions(); ++dof)
    if (const int i = unknowns.unknown(dof); i >= 0) {
      shared[i] = (!of_several.empty() && of_several[i]) || (owner[i] >= 0 && !one_share);
      owner[i] = dof;
    }
  for (int e = 0; e < body.macro_elements(); ++e)
    for (int function : body.functions_of_macro(e))
      for (int c = 0; c < D; ++c)
        if (const int i = unknowns.unknown(offset + D * function + c); i >= 0 && shared[i]) result[e] = true;
  return result;
}

} // namespace

template <int D>
Partition partition(const Unknowns<D>& unknowns, const solid::Body<D>& body, int offset,
                    const std::vector<char>& of_several) {
  Slabs best{0, body.macro_elements(0), {}};
  std::vector<int> starts{0, best.count};
  double least = 1;
  for (int d = 0; d < D; ++d) {
    const Slabs slabs = slabs_across(body, d);
    for (int shares = 2; shares <= std::min(body.elements() / worth_sharing<D>, most_shares); ++shares)
      if (const std::vector<int> found = cut(slabs, shares); !found.empty())
        if (const double time = time_on_two(slabs, found);
            time < least || (time == least && time < 1 && found.size() > starts.size())) {
          least = time;
          best = slabs;
          starts = found;
        }
  }

  Partition result;
  const std::size_t shares = starts.size() / 2;
  result.heads.resize(shares);
  result.tails.resize(shares);
  const std::vector<char> in_rest = shares > 1 || !of_several.empty()
                                        ? on_shared_unknowns(unknowns, body, offset, of_several, shares == 1)
                                        : std::vector<char>(body.macro_elements(), false);
  for (int e = 0; e < body.macro_elements(); ++e) {
    // First slabs of heads and tails alternate in `starts`.
    const int slab = body.macro_index(e, best.direction);
    const int piece = static_cast<int>(std::upper_bound(starts.begin(), starts.end(), slab) - starts.begin()) - 1;
    result.share.push_back(piece / 2);
    auto& list = in_rest[e] ? result.rest : (piece % 2 == 0 ? result.heads : result.tails)[piece / 2];
    list.push_back(e);
  }
  return result;
}

template <int D> std::vector<char> of_several_bodies(const Scene<D>& scene, const Unknowns<D>& unknowns) {
  std::vector<int> owner(unknowns.free_displacements(), -1);
  std::vector<char> result(owner.size(), false);
  bool any = false;
  for (int b = 0; b < std::ssize(scene.bodies); ++b)
    for (int dof = unknowns.offset(b), end = dof + D * scene.bodies[b].body->functions(); dof < end; ++dof)
      if (const int i = unknowns.unknown(dof); i >= 0) {
        if (owner[i] >= 0 && owner[i] != b) result[i] = any = true;
        owner[i] = b;
      }
  return any ? result : std::vector<char>{};
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template Partition partition(const Unknowns<D>&, const solid::Body<D>&, int, const std::vector<char>&);              \
  template std::vector<char> of_several_bodies(const Scene<D>&, const Unknowns<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
