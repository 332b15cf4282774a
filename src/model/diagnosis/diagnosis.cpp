#include "model/diagnosis/diagnosis.hpp"

#include "model/checks/scene_warnings.hpp"
#include "model/constants.hpp"
#include "model/diagnosis/failure_places.hpp"
#include "model/diagnosis/sliding.hpp"
#include "model/diagnosis/weak_directions.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

using solve::Outcome;

/// Adds contact points, each with a message.
template <int D, class What>
void add_points(Diagnosis& diagnosis, const Model<D>& model, const std::vector<PointIndex>& points, What what) {
  for (std::size_t k = 0; k < std::min(points.size(), most_places); ++k) {
    const std::size_t contact = points[k].contact;
    const contact::Multipliers* multipliers = model.system.contacts[contact]->multipliers();
    const int i = multipliers ? multipliers->points[points[k].point] : points[k].point;
    const double gap = constraint(model.present.contacts[contact], points[k].point).gap;
    diagnosis.places.push_back(contact_point(model, contact, i, gap, what(points[k])));
  }
  if (points.empty()) return;
  const FailurePlace& first = diagnosis.places.front();
  const bool weighted = model.system.contacts[points.front().contact]->multipliers() != nullptr;
  diagnosis.messages.push_back(Message(
      weighted ? "model.diagnosis.multipliers" : "model.diagnosis.points",
      {{"count", points.size()}, {"contact", first.where}, {"element", first.index}, {"place", first.reference}}));
}

template <int D> void add_direction(Diagnosis& diagnosis, const Model<D>& model, const WeakDirection& weak) {
  if (weak.direction.norm() == 0) return;
  diagnosis.places = largest_shares(model, weak.direction, [](double part) {
    return Message("model.place.direction", {{"part", part}});
  });
  Message rigid = rigid_part(model, weak.direction);
  if (rigid.code.empty() && !diagnosis.places.empty()) {
    const FailurePlace& first = diagnosis.places.front();
    rigid = Message("model.diagnosis.moves_most",
                    {{"point", first.index}, {"body", first.where}, {"place", first.reference}});
  }
  diagnosis.messages.push_back(std::move(rigid));
}

/// A remedy by its message code. `control`: the control that it turns on, if any; `when_on`: the code if that is on.
struct Remedy {
  const char *control, *code, *when_on = nullptr;
};
using Remedies = std::vector<Remedy>;

constexpr Remedy smaller_steps{"step", "model.remedy.step", "model.remedy.step_min"};
constexpr Remedy pseudo_transient{"pseudo_transient", "model.remedy.pseudo_transient"};
constexpr Remedy line_search{"line_search", "model.remedy.line_search"};
constexpr Remedy no_line_search{"", "model.remedy.no_line_search"};
constexpr Remedy more_iterations{"", "model.remedy.iterations"}, tolerance{"", "model.remedy.tolerance"};
constexpr Remedy more_points{"", "model.remedy.points"}, finer_mesh{"", "model.remedy.mesh"};
constexpr Remedy active_set{"active_set_changes", "model.remedy.active_set"};
constexpr Remedy supported{"", "model.remedy.support"}, freed_obstacle{"", "model.remedy.obstacle"};
constexpr Remedy damped{"damping", "model.remedy.damping"};
constexpr Remedy limit_point{"arc_length", "model.remedy.arc_length", "model.remedy.stability"};
constexpr Remedy arc_length{"arc_length", "model.remedy.arc_length"};
constexpr Remedy extended_master{"", "model.remedy.extend_master"}, end_of_path{"", "model.remedy.end_path"};
constexpr Remedy penalty{"", "model.remedy.penalty"};
/// Before the first accepted step there is no path to a limit point, and arc length has no direction.
constexpr Remedy first_step{"", "model.remedy.first_step"}, no_arc_yet{"", "model.remedy.no_arc_yet"};
constexpr Remedy penalty_growth{"penalty", "model.remedy.penalty_growth"};

std::vector<Message> offered(const Remedies& list, const ControlsOn& on) {
  std::vector<Message> remedies;
  for (const Remedy& remedy : list)
    if (const char* code = on.contains(remedy.control) ? remedy.when_on : remedy.code) remedies.emplace_back(code);
  return remedies;
}

/// Adds reason and remedy if a penalty parameter is far above the bodies' stiffness.
template <int D> void add_stiffness(Diagnosis& diagnosis, const Model<D>& model) {
  const Scene<D>& scene = model.system.scene;
  PenaltyRatio worst{0, 0, ""};
  std::string name;
  for (std::size_t k = 0; k < scene.contacts.size(); ++k) {
    PenaltyRatio penalty = penalty_ratio(
        scene, scene.contacts[k], model.system.contacts[k]->parameters().penalty(model.present.contacts[k].changes));
    if (!(penalty.ratio > worst.ratio)) continue;
    worst = std::move(penalty);
    name = scene.contacts[k].name;
  }
  worst.ratio *= model.present.penalty_factor;
  if (worst.ratio < stiff_penalty) return;
  const bool is_cause = worst.ratio >= beyond_rounding;
  diagnosis.messages.push_back(Message(is_cause ? "model.diagnosis.rounding" : "model.diagnosis.stiffness",
                                       {{"contact", name}, {"ratio", worst.ratio}, {"body", worst.body}}));
  if (is_cause) diagnosis.remedies.clear();
  diagnosis.remedies.insert(diagnosis.remedies.begin(),
                            Message("model.remedy.lower_penalty", {{"contact", name}, {"stiffness", worst.stiffness}}));
}

/// Adds the number of bonds under high traction in the accepted state. Where bonds snap, no equilibrium lies ahead.
template <int D> void add_debonding(Diagnosis& diagnosis, const Model<D>& model, const ControlsOn& on) {
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k) {
    const auto& bond = model.system.scene.contacts[k].method.bond;
    if (!bond) continue;
    const contact::History<D>& history = model.accepted.contacts[k];
    int loaded = 0;
    for (std::size_t i = 0; i < history.bonds.size(); ++i) {
      const double tension = std::min(0.0, history.results[i].pressure), shear = history.bonds[i].shear.norm();
      loaded += std::hypot(tension, shear) > high_traction * bond->strength;
    }
    if (loaded == 0) continue;
    diagnosis.messages.push_back(
        Message("model.diagnosis.debonding", {{"contact", model.system.scene.contacts[k].name}, {"count", loaded}}));
    diagnosis.remedies.insert(diagnosis.remedies.begin(),
                              Message(on.contains("arc_length") ? "model.remedy.snap_steps" : "model.remedy.snap"));
  }
}

/// Replaces the reasons by the first contact whose formula of friction or wear is not a finite number, if there is one.
template <int D> bool find_undefined_law(Diagnosis& diagnosis, const Model<D>& model) {
  using contact::FrictionFlaw;
  const auto is_undefined = [](const auto& result) {
    return result.flaw == FrictionFlaw::undefined || result.flaw == FrictionFlaw::undefined_wear;
  };
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k) {
    const contact::History<D>& history = model.present.contacts[k];
    const contact::Formulation<D>& contact = *model.system.contacts[k];
    const auto add = [&](FrictionFlaw flaw, std::size_t i) {
      diagnosis.messages = {Message("model.diagnosis.undefined",
                                    {{"contact", model.system.scene.contacts[k].name},
                                     {"argument", flaw == FrictionFlaw::undefined ? "friction.mu" : "wear.rate"},
                                     {"place", contact.points().reference[i]}})};
      diagnosis.remedies = {Message("model.remedy.undefined")};
      return true;
    };
    const auto point = std::ranges::find_if(history.results, is_undefined);
    const auto multiplier = std::ranges::find_if(history.multiplier_results, is_undefined);
    if (point != history.results.end())
      return add(point->flaw, static_cast<std::size_t>(point - history.results.begin()));
    if (multiplier != history.multiplier_results.end())
      return add(multiplier->flaw, contact.multipliers()->points[multiplier - history.multiplier_results.begin()]);
  }
  return false;
}

/// A failed step and the controls that are on.
template <int D> struct Failure {
  const Model<D>& model;
  const ControlsOn& on;
  bool has_tangent() const {
    return model.system.unknowns.size() > 0 && model.system.assembly.tangent().diagonal_norm > 0;
  }
  /// A direction of the last tangent. A tangent that was too large for one process is not factored in one.
  template <class Search> WeakDirection direction(Search search) const {
    const bool by_mumps = model.linear.kind() == solve::LinearKind::mumps;
    const SparseTangent& tangent = model.system.assembly.tangent();
    return search(tangent.pattern, tangent.values, model.system.unknowns.free_displacements(),
                  by_mumps ? solve::LinearKind::mumps : solve::LinearKind::umfpack);
  }
};

// Detectors add places and reasons. They return remedies in place of those of the outcome, or none.

template <int D> std::vector<Message> find_inversion(Diagnosis& diagnosis, const Failure<D>& failure) {
  if (failure.model.inversion) diagnosis.places = {inverted_element(failure.model)};
  return {};
}

/// The message about the states between which a point alternates.
template <int D> auto states_of(const Model<D>& model) {
  return [&](const PointIndex& point) {
    return Message("model.place.states", {{"states", model.active_set.alternating(point)}});
  };
}

template <int D> std::vector<Message> find_cycling(Diagnosis& diagnosis, const Failure<D>& failure) {
  const Model<D>& model = failure.model;
  add_points(diagnosis, model, model.active_set.cycling_points(), states_of(model));
  return {};
}

template <int D> std::vector<Message> find_lost_points(Diagnosis& diagnosis, const Failure<D>& failure) {
  const Model<D>& model = failure.model;
  add_points(diagnosis, model, model.active_set.cycling_points(true), states_of(model));
  return {};
}

/// Finds the points that have passed through the master of the first contact with such points.
template <int D> std::vector<Message> find_crossed(Diagnosis& diagnosis, const Failure<D>& failure) {
  const Model<D>& model = failure.model;
  for (std::size_t k = 0; k < model.system.contacts.size() && diagnosis.places.empty(); ++k) {
    const contact::History<D>& history = model.present.contacts[k];
    const std::vector<int> points = crossed(*model.system.contacts[k], history, model.accepted.contacts[k]);
    if (points.empty()) continue;
    const std::vector<double> gaps = contact::gaps(*model.system.contacts[k], history);
    for (std::size_t n = 0; n < std::min(points.size(), most_places); ++n) {
      const double gap = gaps[points[n]];
      diagnosis.places.push_back(
          contact_point(model, k, points[n], gap, Message("model.place.behind", {{"distance", gap}})));
    }
    const FailurePlace& first = diagnosis.places.front();
    diagnosis.messages.push_back(Message(
        "model.diagnosis.points",
        {{"count", points.size()}, {"contact", first.where}, {"element", first.index}, {"place", first.reference}}));
  }
  return {};
}

template <int D> std::vector<Message> find_null_direction(Diagnosis& diagnosis, const Failure<D>& failure) {
  if (!failure.has_tangent()) return {};
  const Model<D>& model = failure.model;
  const WeakDirection weak = failure.direction(null_direction);
  add_direction(diagnosis, model, weak);
  if (!obstacle_part(model, model.system.unknowns.spread(weak.direction)).code.empty())
    return offered({freed_obstacle, damped}, failure.on);
  return weak.direction.norm() > 0 ? remedies_of_sliding(model, weak.direction) : std::vector<Message>();
}

/// An indefinite tangent is the reason why an iteration stalls.
template <int D> std::vector<Message> find_negative(Diagnosis& diagnosis, const Failure<D>& failure) {
  if (!failure.has_tangent()) return {};
  const Model<D>& model = failure.model;
  const WeakDirection softest = failure.direction(softest_direction);
  if (!(softest.negative ? *softest.negative > 0 : softest.stiffness < 0)) return {};
  diagnosis.outcome = Outcome::indefinite;
  diagnosis.messages.push_back(softest.negative ? Message("model.diagnosis.negative", {{"count", *softest.negative}})
                                                : Message("model.diagnosis.indefinite"));
  if (softest.stiffness < 0) add_direction(diagnosis, model, softest);
  if (auto remedies = remedies_of_sliding(model, softest.direction); !remedies.empty()) return remedies;
  if (!model.accepted.displacement.isZero(0)) return {};
  return offered({first_step, smaller_steps, penalty_growth, no_arc_yet}, failure.on);
}

template <int D> struct Reason {
  Outcome outcome;
  std::vector<Message> (*detect)(Diagnosis&, const Failure<D>&); ///< null: nothing to detect
  Remedies remedies;
  bool debonding; ///< bonds under high traction are counted
  bool stiffness; ///< penalties are compared with the bodies' stiffness
};

template <int D> const Reason<D>& reason_of(Outcome outcome) {
  static const Reason<D> reasons[] = {
      {Outcome::iteration_limit, find_negative<D>, {more_iterations, smaller_steps, tolerance}, true, true},
      {Outcome::diverged, find_negative<D>, {smaller_steps, line_search}, true, true},
      {Outcome::line_search, find_negative<D>, {smaller_steps, no_line_search}, true, true},
      {Outcome::cycling,
       find_cycling<D>,
       {smaller_steps, line_search, more_points, active_set, pseudo_transient},
       true,
       true},
      {Outcome::inverted_element, find_inversion<D>, {smaller_steps, line_search, finer_mesh}, true, true},
      {Outcome::singular_tangent, find_null_direction<D>, {supported, damped}, false, true},
      {Outcome::indefinite, nullptr, {limit_point, pseudo_transient}, false, true},
      {Outcome::not_finite, nullptr, {smaller_steps, line_search}, false, true},
      {Outcome::lost_projection, find_lost_points<D>, {extended_master, end_of_path}, false, false},
      {Outcome::crossed, find_crossed<D>, {smaller_steps, penalty, arc_length}, false, false},
  };
  static const Reason<D> other{Outcome::converged, nullptr, {}, false, true};
  const auto found = std::ranges::find(reasons, outcome, &Reason<D>::outcome);
  return found == std::end(reasons) ? other : *found;
}

} // namespace

template <int D> Diagnosis diagnose(const Model<D>& model, const solve::NewtonReport& report, const ControlsOn& on) {
  Diagnosis diagnosis{report.outcome, false, report.messages, {}, {}, {}};
  const Reason<D>& reason = reason_of<D>(report.outcome);
  if (reason.detect) diagnosis.remedies = reason.detect(diagnosis, {model, on});
  if (diagnosis.remedies.empty()) diagnosis.remedies = offered(reason_of<D>(diagnosis.outcome).remedies, on);
  if (model.unbalanced.size() > 0 && model.unbalanced.allFinite() && !report.residuals.empty())
    diagnosis.unbalanced = largest_shares(model, model.unbalanced, [](double force) {
      return Message("model.place.force", {{"force", force}});
    });
  if (diagnosis.places.empty()) diagnosis.places = diagnosis.unbalanced;
  if (reason.debonding) add_debonding(diagnosis, model, on);
  if (reason.stiffness) add_stiffness(diagnosis, model);
  if (find_undefined_law(diagnosis, model)) return diagnosis;
  // If friction cannot balance the loads on a body, that is the reason, and no other.
  if (Message exhausted = exhausted_friction(model); !exhausted.code.empty()) {
    diagnosis.friction_exhausted = true;
    diagnosis.messages = {std::move(exhausted)};
    diagnosis.remedies = {Message("model.remedy.exhausted")};
  }
  return diagnosis;
}

template Diagnosis diagnose<2>(const Model<2>&, const solve::NewtonReport&, const ControlsOn&);
template Diagnosis diagnose<3>(const Model<3>&, const solve::NewtonReport&, const ControlsOn&);

} // namespace signorini::model
