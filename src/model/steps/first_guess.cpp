#include "model/steps/first_guess.hpp"

#include "model/constants.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace signorini::model {

namespace {

/// The step from the accepted targets to the next ones as a multiple of the last accepted step; nothing if the path is
/// not straight.
template <int D> std::optional<double> straight_ratio(const Model<D>& model) {
  const VectorX step = model.targets - model.accepted.targets,
                last = model.accepted.targets - model.path.previous_targets;
  if (!(last.squaredNorm() > 0)) return std::nullopt;
  const double ratio = step.dot(last) / last.squaredNorm();
  if ((step - ratio * last).norm() > straight * step.norm()) return std::nullopt;
  return ratio;
}

/// An extrapolation Δu = a Δu₁ + b Δu₂ of the last step Δu₁ and the one before, Δu₂.
struct Extrapolation {
  double last, before;
};

/// In proportion to the targets: a = h, the length of the step relative to the last one.
template <int D> std::optional<Extrapolation> first_order(const Model<D>& model) {
  const std::optional<double> h = straight_ratio(model);
  if (!h) return std::nullopt;
  return Extrapolation{*h, 0};
}

/// The parabola through the last three states [theory 10.1], by Newton's divided differences. With the length g of the
/// step before the last one, relative to the last one: Δu = h Δu₁ + h (h + 1)/(1 + g) (Δu₁ − Δu₂/g).
template <int D> std::optional<Extrapolation> second_order(const Model<D>& model) {
  const PathHistory& path = model.path;
  const VectorX last = model.accepted.targets - path.previous_targets;
  const VectorX before = path.previous_targets - path.targets_before;
  const std::optional<double> h = straight_ratio(model);
  if (!h || *h <= 0) return std::nullopt;
  const double g = before.dot(last) / last.squaredNorm();
  if (g <= 0 || (before - g * last).norm() > straight * before.norm()) return std::nullopt;
  const double curvature = *h * (*h + 1) / (1 + g);
  return Extrapolation{*h + curvature, -curvature / g};
}

/// Free displacements by extrapolation, prescribed ones exactly.
template <int D> void move(Model<D>& model, const Extrapolation& by, const VectorX& prescribed) {
  const Drives<D>& drives = model.system.drives;
  const PathHistory& path = model.path;
  const VectorX driven = drives.displacement(path.previous_targets);
  model.present.displacement += by.last * (path.increment - drives.displacement(model.accepted.targets) + driven);
  if (by.before != 0)
    model.present.displacement += by.before * (path.before - driven + drives.displacement(path.targets_before));
  model.present.displacement += prescribed;
}

/// Relative difference of a step and its extrapolation; 1 without one.
template <int D>
double deviation(const Model<D>& model, const VectorX& increment, const std::optional<Extrapolation>& by) {
  if (!by) return 1;
  const auto displacements = model.system.unknowns.displacements();
  VectorX difference = increment - by->last * model.path.increment;
  if (by->before != 0) difference -= by->before * model.path.before;
  return difference.head(displacements).norm() / increment.head(displacements).norm();
}

/// True if a contact with friction, open in the accepted state, has closed in the present one.
template <int D> bool begins_friction(const Model<D>& model) {
  const auto& contacts = model.system.contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto& present = model.present.contacts[k];
    if (contacts[k]->parameters().slides(present.changes) && resultant(model.accepted.contacts[k]).active == 0 &&
        resultant(present).active > 0)
      return true;
  }
  return false;
}

} // namespace

template <int D> bool apply_predictor(Model<D>& model, Predictor predictor, const VectorX& prescribed) {
  if (predictor == Predictor::tangent) return false;
  if (predictor == Predictor::constant) {
    model.present.displacement += prescribed;
    return true;
  }
  const PathHistory& path = model.path;
  if (model.present.targets != model.accepted.targets) return false;
  std::optional<Extrapolation> by;
  if (predictor == Predictor::quadratic &&
      path.quadratic_error <= std::min(most_linear_error, std::max(small_quadratic_error, path.linear_error)))
    by = second_order(model);
  if (!by && path.linear_error <= most_linear_error) by = first_order(model);
  // Where the path turns back, points with friction stick that slipped in the last step.
  if (!by || (predictor == Predictor::quadratic && by->last <= 0)) return false;
  move(model, *by, prescribed);
  return true;
}

template <int D> void record_increment(Model<D>& model, const VectorX& increment) {
  PathHistory& path = model.path;
  // Rates jump where a contact begins: an extrapolation of such a step has an error of first order, and with it the
  // slip that friction leaves out before a touch.
  const bool kink = begins_friction(model), after_kink = path.linear_error == across_kink;
  path.linear_error = kink ? across_kink : deviation(model, increment, first_order(model));
  path.quadratic_error = kink || after_kink ? across_kink : deviation(model, increment, second_order(model));
  path.before = std::exchange(path.increment, increment);
  path.targets_before = std::exchange(path.previous_targets, model.accepted.targets);
}

template <int D> InitialContact initial_contact(const Model<D>& model) {
  return {gap_rounding * largest_position(model), straight_ratio(model).value_or(-1) > 0};
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template bool apply_predictor(Model<D>&, Predictor, const VectorX&);                                                 \
  template void record_increment(Model<D>&, const VectorX&);                                                           \
  template InitialContact initial_contact(const Model<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
