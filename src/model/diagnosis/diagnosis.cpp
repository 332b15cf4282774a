#include "model/diagnosis/diagnosis.hpp"

#include "base/error.hpp"
#include "base/orthonormal.hpp"
#include "model/checks/scene_warnings.hpp"
#include "model/constants.hpp"
#include "model/diagnosis/sliding.hpp"
#include "model/diagnosis/unheld_motions.hpp"
#include "model/diagnosis/weak_directions.hpp"
#include "model/scene/turning.hpp"
#include "model/system/rigid_motions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace signorini::model {

namespace {

using solve::Outcome;

/// Displacement of a control point in the accepted state.
template <int D> VectorX accepted_displacement(const Model<D>& model, int body, int function) {
  return model.accepted.displacement.template segment<D>(model.system.unknowns.offset(body) + D * function);
}

/// A control point of a body.
template <int D> FailurePlace control_point(const Model<D>& model, int body, int function) {
  const auto& named = model.system.scene.bodies[body];
  const VectorX reference = named.body->space().points().col(function);
  return {"control point",
          named.name,
          function,
          reference,
          reference + accepted_displacement(model, body, function),
          0,
          {}};
}

/// The control points with the largest shares of a vector of unknowns, at most three, and these shares. Where an
/// obstacle's motion or a multiplier has nearly all of it, what is left are rounding errors.
template <int D, class What>
std::vector<FailurePlace> largest(const Model<D>& model, const VectorX& values, What what) {
  struct Share {
    int body, function;
    double size;
  };
  std::vector<Share> shares;
  const VectorX all = model.system.unknowns.spread(values);
  for (int b = 0; b < std::ssize(model.system.scene.bodies); ++b)
    for (int a = 0; a < model.system.scene.bodies[b].body->functions(); ++a)
      shares.push_back({b, a, all.template segment<D>(model.system.unknowns.offset(b) + D * a).norm()});
  const std::size_t count = std::min<std::size_t>(3, shares.size());
  std::partial_sort(shares.begin(), shares.begin() + static_cast<std::ptrdiff_t>(count), shares.end(),
                    [](const Share& a, const Share& b) { return a.size > b.size; });
  std::vector<FailurePlace> spots;
  for (std::size_t k = 0; k < count && shares[k].size > least_share * values.lpNorm<Eigen::Infinity>(); ++k) {
    FailurePlace spot = control_point(model, shares[k].body, shares[k].function);
    spot.value = shares[k].size;
    spot.what = what(spot.value);
    spots.push_back(std::move(spot));
  }
  return spots;
}

template <int D>
FailurePlace contact_point(const Model<D>& model, std::size_t contact, std::size_t i, double gap, Message what) {
  const contact::ContactPoints<D>& points = model.system.contacts[contact]->points();
  return {"contact point",
          model.system.scene.contacts[contact].name,
          points.list[i].element,
          points.reference[i],
          model.accepted.contacts[contact].results[i].position,
          gap,
          std::move(what)};
}

/// Adds contact points, each with a message.
template <int D, class What>
void add_points(Diagnosis& diagnosis, const Model<D>& model, const std::vector<PointIndex>& points, What what) {
  for (std::size_t k = 0; k < std::min(points.size(), most_places); ++k) {
    const std::size_t contact = points[k].contact;
    const int i = model.system.contacts[contact]->point_of(points[k].point);
    const double gap = constraint(model.present.contacts[contact], points[k].point).gap;
    diagnosis.places.push_back(contact_point(model, contact, i, gap, what(points[k])));
  }
  if (points.empty()) return;
  const FailurePlace& first = diagnosis.places.front();
  const bool weighted = model.system.contacts[points.front().contact]->multipliers() > 0;
  diagnosis.messages.push_back(Message(
      weighted ? "model.diagnosis.multipliers" : "model.diagnosis.points",
      {{"count", points.size()}, {"contact", first.where}, {"element", first.index}, {"place", first.reference}}));
}

/// Adds the points that have passed through the master of the first contact with such points.
template <int D> void add_crossed(Diagnosis& diagnosis, const Model<D>& model) {
  for (std::size_t k = 0; k < model.system.contacts.size() && diagnosis.places.empty(); ++k) {
    const contact::History<D>& history = model.present.contacts[k];
    const std::vector<int> points = model.system.contacts[k]->crossed(history, model.accepted.contacts[k]);
    if (points.empty()) continue;
    const std::vector<double> gaps = model.system.contacts[k]->gaps(history);
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
}

/// The points of augmented contacts that are not open, those with the largest |gap| first.
template <int D> std::vector<PointIndex> farthest(const Model<D>& model) {
  const auto& contacts = model.present.contacts;
  const auto result = [&](const PointIndex& p) { return constraint(contacts[p.contact], p.point); };
  std::vector<PointIndex> points;
  for (int k = 0; k < std::ssize(contacts); ++k)
    for (int i = 0; model.system.contacts[k]->augmented() && i < constraints(contacts[k]); ++i)
      if (result({k, i}).state != contact::ContactState::open) points.push_back({k, i});
  std::stable_sort(points.begin(), points.end(), [&](const PointIndex& a, const PointIndex& b) {
    return std::abs(result(a).gap) > std::abs(result(b).gap);
  });
  return points;
}

/// The inverted Gauss point of an element.
template <int D> FailurePlace inverted_element(const Model<D>& model) {
  const auto& [body, inversion] = *model.inversion;
  const auto& named = model.system.scene.bodies[body];
  const nurbs::Discretization& space = named.body->space();
  const solid::ElementQuadrature rule = solid::element_quadrature(space, inversion.element);
  VectorX current = inversion.point;
  for (Eigen::Index q = 0; q < rule.points.cols(); ++q)
    if (solid::reference_point(*named.body, inversion.element, static_cast<int>(q)) == inversion.point) {
      const nurbs::ElementBasis basis = space.basis(inversion.element, rule.points.col(q));
      for (std::size_t a = 0; a < basis.functions.size(); ++a)
        current += basis.values(static_cast<Eigen::Index>(a)) * accepted_displacement(model, body, basis.functions[a]);
    }
  return {"element",
          named.name,
          inversion.element,
          inversion.point,
          current,
          inversion.jacobian,
          Message("model.place.jacobian", {{"jacobian", inversion.jacobian}})};
}

/// Displacements of a body's control points, one column each, in a direction of all degrees of freedom.
template <int D>
Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic>> moves_of(const Model<D>& model, std::size_t body,
                                                                    const VectorX& all) {
  return {all.data() + model.system.unknowns.offset(static_cast<int>(body)), D,
          model.system.scene.bodies[body].body->functions()};
}

/// Message about the obstacle that a direction moves; empty if there is none.
template <int D> Message obstacle_part(const Model<D>& model, const VectorX& all) {
  const Scene<D>& scene = model.system.scene;
  const Unknowns<D>& unknowns = model.system.unknowns;
  const auto message = [&](int obstacle, const std::string& component) {
    return Message("model.diagnosis.obstacle",
                   {{"component", component}, {"support", support_of(scene, obstacle, component)}});
  };
  for (int k = 0; k < std::ssize(scene.obstacles); ++k)
    for (int c = 0; c < D; ++c)
      if (std::abs(all(unknowns.obstacle_offset(k) + c)) > own_part * all.norm()) return message(k, component_name(c));
  for (const FreeAngle<D>& angle : unknowns.free_angles())
    if (std::abs(all(angle.dof)) > own_part * all.norm()) return message(angle.obstacle, "angle");
  return {};
}

/// Message about the body or obstacle that a direction moves as a rigid body; empty if there is none.
template <int D> Message rigid_part(const Model<D>& model, const VectorX& direction) {
  const VectorX all = model.system.unknowns.spread(direction);
  if (Message obstacle = obstacle_part(model, all); !obstacle.code.empty()) return obstacle;
  for (std::size_t b = 0; b < model.system.scene.bodies.size(); ++b) {
    const auto& named = model.system.scene.bodies[b];
    const auto own = moves_of(model, b, all);
    const Vec<D> mean = own.rowwise().mean();
    if (own.norm() < own_part * all.norm()) continue;
    // An axisymmetric body translates as a rigid one along its axis alone.
    const bool radial =
        model.system.scene.kind == solid::Kind::axisymmetric && std::abs(mean(0)) > deformed_part * mean.norm();
    if (Message several = unheld_motions(model, static_cast<int>(b)); !several.code.empty()) return several;
    if (!radial && (own.colwise() - mean).norm() <= deformed_part * own.norm())
      return Message("model.diagnosis.moves", {{"body", named.name}, {"direction", Vec<D>(mean / mean.norm())}});
    // least-squares residual of u = Σ_m a_m m with the rigid-body modes m
    const std::vector<VectorX> motions = rigid_motions<D>(named.body->space().points(), model.system.scene.kind);
    MatrixX columns(own.size(), static_cast<Eigen::Index>(motions.size()));
    for (std::size_t m = 0; m < motions.size(); ++m) columns.col(static_cast<Eigen::Index>(m)) = motions[m];
    const VectorX flat = Eigen::Map<const VectorX>(own.data(), own.size());
    if (residual_of(orthonormal(columns), flat).norm() <= deformed_part * flat.norm())
      return Message("model.diagnosis.turns", {{"body", named.name}});
  }
  return {};
}

template <int D> void add_direction(Diagnosis& diagnosis, const Model<D>& model, const WeakDirection& weak) {
  if (weak.direction.norm() == 0) return;
  diagnosis.places = largest(model, weak.direction, [](double part) {
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
struct Advice {
  const char *control, *code, *when_on = nullptr;
};

constexpr Advice smaller_steps{"step", "model.remedy.step", "model.remedy.step_min"};
constexpr Advice pseudo_transient{"pseudo_transient", "model.remedy.pseudo_transient"};
constexpr Advice line_search{"line_search", "model.remedy.line_search"};

std::vector<Advice> remedies(Outcome outcome) {
  switch (outcome) {
  case Outcome::iteration_limit:
    return {{"", "model.remedy.iterations"}, smaller_steps, {"", "model.remedy.tolerance"}};
  case Outcome::diverged:
  case Outcome::not_finite:
    return {smaller_steps, line_search};
  case Outcome::cycling:
    return {smaller_steps,
            line_search,
            {"", "model.remedy.points"},
            {"active_set_changes", "model.remedy.active_set"},
            pseudo_transient};
  case Outcome::lost_projection:
    return {{"", "model.remedy.extend_master"}, {"", "model.remedy.end_path"}};
  case Outcome::inverted_element:
    return {smaller_steps, line_search, {"", "model.remedy.mesh"}};
  case Outcome::singular_tangent:
    return {{"", "model.remedy.support"}, {"damping", "model.remedy.damping"}};
  case Outcome::indefinite:
    return {{"arc_length", "model.remedy.arc_length", "model.remedy.stability"}, pseudo_transient};
  case Outcome::line_search:
    return {smaller_steps, {"", "model.remedy.no_line_search"}};
  case Outcome::crossed:
    return {smaller_steps, {"", "model.remedy.penalty"}, {"arc_length", "model.remedy.arc_length"}};
  case Outcome::penetration:
    return {{"", "model.remedy.penalty"}, {"", "model.remedy.augmented"}};
  default:
    return {};
  }
}

/// Before the first accepted step there is no path to a limit point, and arc length has no direction.
std::vector<Advice> first_step_cures() {
  return {{"", "model.remedy.first_step"},
          smaller_steps,
          {"penalty", "model.remedy.penalty_growth"},
          {"", "model.remedy.no_arc_yet"}};
}

std::vector<Message> offered(const std::vector<Advice>& list, const ControlsOn& on) {
  std::vector<Message> remedies;
  for (const Advice& advice : list)
    if (const char* code = on.contains(advice.control) ? advice.when_on : advice.code) remedies.emplace_back(code);
  return remedies;
}

/// Adds reason and remedy if a penalty parameter is far above the bodies' stiffness.
template <int D> void add_stiffness(Diagnosis& diagnosis, const Model<D>& model) {
  const Scene<D>& scene = model.system.scene;
  PenaltyRatio worst{0, 0, ""};
  std::string name;
  for (std::size_t k = 0; k < scene.contacts.size(); ++k) {
    PenaltyRatio penalty =
        penalty_ratio(scene, scene.contacts[k], model.system.contacts[k]->penalty(model.present.contacts[k]));
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
    const auto* law = std::get_if<contact::CohesiveLaw>(&model.system.scene.contacts[k].method);
    if (!law) continue;
    const contact::History<D>& history = model.accepted.contacts[k];
    int loaded = 0;
    for (std::size_t i = 0; i < history.bonds.size(); ++i) {
      const double tension = std::min(0.0, history.results[i].pressure), shear = history.bonds[i].shear.norm();
      loaded += std::hypot(tension, shear) > high_traction * law->cohesion.strength;
    }
    if (loaded == 0) continue;
    diagnosis.messages.push_back(
        Message("model.diagnosis.debonding", {{"contact", model.system.scene.contacts[k].name}, {"count", loaded}}));
    diagnosis.remedies.insert(diagnosis.remedies.begin(),
                              Message(on.contains("arc_length") ? "model.remedy.snap_steps" : "model.remedy.snap"));
  }
}

} // namespace

template <int D> Diagnosis diagnose(const Model<D>& model, const solve::NewtonReport& report, const ControlsOn& on) {
  Diagnosis diagnosis{report.outcome, false, report.messages, {}, {}, {}};
  const Assembly<D>& assembly = model.system.assembly;
  const bool has_tangent = model.system.unknowns.size() > 0 && assembly.diagonal_norm() > 0;
  if (report.outcome == Outcome::inverted_element && model.inversion) diagnosis.places = {inverted_element(model)};
  const ActiveSet<D>& set = model.active_set;
  const auto states = [&](const PointIndex& point) {
    return Message("model.place.states", {{"states", set.alternating(point)}});
  };
  if (report.outcome == Outcome::cycling) add_points(diagnosis, model, set.cycling_points(), states);
  if (report.outcome == Outcome::lost_projection) add_points(diagnosis, model, set.cycling_past_end(), states);
  if (report.outcome == Outcome::crossed) add_crossed(diagnosis, model);
  if (report.outcome == Outcome::penetration)
    add_points(diagnosis, model, farthest(model), [&](const PointIndex& point) {
      return Message("model.place.gap", {{"gap", constraint(model.present.contacts[point.contact], point.point).gap}});
    });
  // A tangent that was too large for one process is not factored in one.
  const bool by_mumps = model.linear.kind() == solve::LinearKind::mumps;
  const solve::LinearKind solver = by_mumps ? solve::LinearKind::mumps : solve::LinearKind::umfpack;
  if (report.outcome == Outcome::singular_tangent && has_tangent) {
    const WeakDirection weak =
        null_direction(assembly.pattern(), assembly.values(), model.system.unknowns.free_displacements(), solver);
    add_direction(diagnosis, model, weak);
    if (weak.direction.norm() > 0) diagnosis.remedies = cure_of_sliding(model, weak.direction);
    if (!obstacle_part(model, model.system.unknowns.spread(weak.direction)).code.empty())
      diagnosis.remedies = offered({{"", "model.remedy.obstacle"}, {"damping", "model.remedy.damping"}}, on);
  }
  const bool stalls = report.outcome == Outcome::iteration_limit || report.outcome == Outcome::diverged ||
                      report.outcome == Outcome::line_search;
  if (stalls && has_tangent) {
    const WeakDirection softest =
        softest_direction(assembly.pattern(), assembly.values(), model.system.unknowns.free_displacements(), solver);
    if (softest.negative ? *softest.negative > 0 : softest.stiffness < 0) {
      diagnosis.outcome = Outcome::indefinite;
      diagnosis.messages.push_back(softest.negative
                                       ? Message("model.diagnosis.negative", {{"count", *softest.negative}})
                                       : Message("model.diagnosis.indefinite"));
      if (softest.stiffness < 0) add_direction(diagnosis, model, softest);
      diagnosis.remedies = cure_of_sliding(model, softest.direction);
      if (diagnosis.remedies.empty() && model.accepted.displacement.isZero(0))
        diagnosis.remedies = offered(first_step_cures(), on);
    }
  }
  if (model.unbalanced.size() > 0 && model.unbalanced.allFinite() && !report.residuals.empty())
    diagnosis.unbalanced = largest(model, model.unbalanced, [](double force) {
      return Message("model.place.force", {{"force", force}});
    });
  if (diagnosis.places.empty()) diagnosis.places = diagnosis.unbalanced;
  if (diagnosis.remedies.empty()) diagnosis.remedies = offered(remedies(diagnosis.outcome), on);
  if (stalls || report.outcome == Outcome::cycling || report.outcome == Outcome::inverted_element)
    add_debonding(diagnosis, model, on);
  if (report.outcome != Outcome::penetration && report.outcome != Outcome::lost_projection &&
      report.outcome != Outcome::crossed)
    add_stiffness(diagnosis, model);
  // If friction cannot balance the loads on a body, that is the reason, and no other.
  if (Message reason = exhausted_friction(model); !reason.code.empty()) {
    diagnosis.friction_exhausted = true;
    diagnosis.messages = {std::move(reason)};
    diagnosis.remedies = {Message("model.remedy.exhausted")};
  }
  return diagnosis;
}

template Diagnosis diagnose<2>(const Model<2>&, const solve::NewtonReport&, const ControlsOn&);
template Diagnosis diagnose<3>(const Model<3>&, const solve::NewtonReport&, const ControlsOn&);

} // namespace signorini::model
