#include "model/changed_space.hpp"

#include "base/index.hpp"
#include "nurbs/coincident.hpp"

#include <bit>
#include <map>
#include <numeric>

namespace signorini::model {

namespace {

/// Functions that are one point, and along which directions they lie.
struct Folds {
  std::vector<int> group; ///< of each function; −1: none
  std::vector<std::array<bool, 3>> reach;
};

Folds find_folds(const nurbs::Discretisation& space) {
  const std::vector<std::vector<int>> groups = nurbs::coincident_functions(space);
  Folds folds{std::vector<int>(at(space.functions()), -1), {}};
  if (groups.empty()) return folds;
  const std::vector<Place> all = places(space);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    folds.reach.emplace_back();
    for (int function : groups[g]) {
      folds.group[at(function)] = static_cast<int>(g);
      for (std::size_t d = 0; d < 3; ++d)
        if (all[at(function)][d] != all[at(groups[g].front())][d]) folds.reach[g][d] = true;
    }
  }
  return folds;
}

/// Calls visit(function, place) for every function of a changed space.
template <class Visit> void for_each(const nurbs::Discretisation& space, const ChangedSpace& changed, Visit visit) {
  for (std::size_t j = 0; j < changed.size(); ++j) {
    const auto& [source, along] = changed[j];
    const int width = space.rows()[at(source)].direction(0).functions();
    const std::size_t lines = along.size() > 1 ? along[1].size() : 1;
    for (std::size_t l = 0; l < lines; ++l)
      for (std::size_t i = 0; i < along[0].size(); ++i) {
        const int line = along.size() > 1 ? along[1][l] : 0;
        Place place{};
        const std::size_t through = at(space.through());
        place[through] = static_cast<int>(j);
        place[through == 0 ? 1 : 0] = static_cast<int>(i);
        if (along.size() > 1) place[through == 2 ? 1 : 2] = static_cast<int>(l);
        visit(space.first_function(source) + along[0][i] + width * line, place);
      }
  }
}

} // namespace

ChangedSpace unchanged(const nurbs::Discretisation& space) {
  ChangedSpace same;
  for (int j = 0; j < static_cast<int>(space.rows().size()); ++j) {
    same.push_back({j, {}});
    for (const nurbs::Space1D& direction : space.rows()[at(j)].directions()) {
      same.back().along.emplace_back(at(direction.functions()));
      std::iota(same.back().along.back().begin(), same.back().along.back().end(), 0);
    }
  }
  return same;
}

std::vector<Place> places(const nurbs::Discretisation& space) {
  std::vector<Place> all(at(space.functions()));
  for_each(space, unchanged(space), [&](int function, const Place& place) { all[at(function)] = place; });
  return all;
}

int count_free(const nurbs::Discretisation& space, const ChangedSpace& changed, int components,
               const Prescribed& prescribed) {
  const Folds folds = find_folds(space);
  int count = 0;
  // By fold and by the place along the directions that it does not lie along: which components are free.
  std::map<std::array<int, 4>, unsigned> shared;
  for_each(space, changed, [&](int function, const Place& place) {
    unsigned free = 0;
    for (int c = 0; c < components; ++c)
      if (!prescribed(c, function, place)) free |= 1u << c;
    const int group = folds.group[at(function)];
    if (group < 0) {
      count += std::popcount(free);
      return;
    }
    std::array<int, 4> key{group};
    for (std::size_t d = 0; d < 3; ++d) key[d + 1] = folds.reach[at(group)][d] ? 0 : place[d];
    const auto [entry, made] = shared.try_emplace(key, free);
    if (!made) entry->second &= free;
  });
  for (const auto& [key, free] : shared) count += std::popcount(free);
  return count;
}

} // namespace signorini::model
