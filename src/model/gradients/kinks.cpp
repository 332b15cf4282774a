#include "model/gradients/kinks.hpp"

#include "model/gradients/constants.hpp"
#include "model/gradients/neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace signorini::model {

namespace {

template <int D> double force_of(const contact::PointResult<D>& point) {
  return point.force.norm();
}
template <int D> double force_of(const contact::MultiplierResult<D>& multiplier) {
  return multiplier.area * std::hypot(multiplier.pressure, multiplier.friction.norm());
}

/// What is positive while a touching point or multiplier keeps its state: its pressure and, if it sticks, by how much
/// its friction is below the limit.
template <class Result> std::array<double, 2> margins(const Result& result, bool sticks) {
  const double rest = std::numeric_limits<double>::infinity();
  return {result.pressure, sticks ? result.mu * result.pressure - result.friction.norm() : rest};
}

/// The change of the parameter, over its size, at which one of the margins of a touching result vanishes.
template <class Result>
double change_to_kink(const Result& run, const Result& plus, const Result& minus, double step, double size) {
  const bool sticks = run.state == contact::ContactState::stick && run.mu > 0;
  const auto now = margins(run, sticks), above = margins(plus, sticks), below = margins(minus, sticks);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < (sticks ? 2 : 1); ++k) {
    const double slope = (above[k] - below[k]) / (2 * step);
    if (slope != 0) least = std::min(least, std::abs(now[k] / slope) / size);
  }
  return least;
}

/// Forces and their changes to the next kink, of all contacts.
struct Forces {
  double all = 0, largest = 0;
  std::vector<std::pair<double, double>> by_change = {}; ///< {change, force} of touching results
};

/// Adds the results of a contact.
template <int D, class Result, class Place>
void add_results(const std::array<std::span<const Result>, 3>& results, int contact, const Place& place,
                 const Neighbors<D>& neighbors, Forces& forces, Kinks<D>& kinks) {
  const auto& [run, plus, minus] = results;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const double force = std::max({force_of<D>(run[i]), force_of<D>(plus[i]), force_of<D>(minus[i])});
    forces.all += force;
    const auto state = run[i].state;
    if (plus[i].state == state && minus[i].state == state) {
      if (contact::touches(state))
        forces.by_change.emplace_back(change_to_kink(run[i], plus[i], minus[i], neighbors.step, neighbors.size), force);
      continue;
    }
    forces.by_change.emplace_back(0, force);
    ++kinks.points;
    kinks.share += force;
    if (kinks.contact >= 0 && force <= forces.largest) continue;
    forces.largest = force;
    kinks.contact = contact;
    kinks.place = place(i);
  }
}

double reach_of(Forces& forces) {
  std::sort(forces.by_change.begin(), forces.by_change.end());
  double sum = 0;
  for (const auto& [change, force] : forces.by_change)
    if (sum += force; sum >= heavy * forces.all && forces.all > 0) return change;
  return std::numeric_limits<double>::infinity();
}

} // namespace

template <int D> Kinks<D> find_kinks(const Model<D>& run, const Neighbors<D>& neighbors) {
  Kinks<D> kinks;
  Forces forces;
  for (std::size_t k = 0; k < run.system.contacts.size(); ++k) {
    const contact::History<D>&own = run.present.contacts[k], &plus = neighbors.plus.present.contacts[k],
          &minus = neighbors.minus.present.contacts[k];
    const contact::Formulation<D>& contact = *run.system.contacts[k];
    const int number = static_cast<int>(k);
    if (own.multipliers.empty())
      add_results<D, contact::PointResult<D>>(
          {own.results, plus.results, minus.results}, number,
          [&](std::size_t i) { return contact.points().reference[i]; }, neighbors, forces, kinks);
    else
      add_results<D, contact::MultiplierResult<D>>(
          {own.multiplier_results, plus.multiplier_results, minus.multiplier_results}, number,
          [&](std::size_t a) { return contact.points().reference[contact.multipliers()->points[a]]; }, neighbors,
          forces, kinks);
  }
  kinks.share = forces.all > 0 ? kinks.share / forces.all : 0;
  kinks.reach = reach_of(forces);
  return kinks;
}

#define SIGNORINI_INSTANTIATE(D) template Kinks<D> find_kinks(const Model<D>&, const Neighbors<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
