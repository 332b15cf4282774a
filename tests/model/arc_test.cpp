// Paths with turning points: an adhesive bar with snap-back, whose path is known, and a shallow arch with snap-through.
#include "base/dense.hpp"
#include "model/bench.hpp"
#include "model/scenes.hpp"
#include "model/system/path_norm.hpp"
#include "text_of.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>

namespace signorini::model {
namespace arc_test {

using namespace test;

constexpr contact::Adhesion film{0.1, 0.4};
constexpr double bar_length = 10;

/// A column adhering to a rigid plane, pulled at its top: too soft to follow the decreasing adhesive traction.
Scene<2> bar(const solid::Material& material) {
  Scene<2> scene;
  scene.bodies.push_back(
      {"bar", make_body(nurbs::rectangle(2, bar_length, Eigen::Vector2d(0, 0)), {2, 2}, "N2", "south", material)});
  scene.supports = {
      {"walls", {face_points(scene, 0, "west"), face_points(scene, 0, "east")}, {Constraint::fixed, Constraint::free}},
      {"top", {face_points(scene, 0, "north")}, {Constraint::free, Constraint::driven}}};
  scene.obstacles = {contact::make_plane<2>({0, -contact::equilibrium_distance(film)}, {0, 1})};
  scene.contacts = {{"film", {0, nurbs::side_of("south", 2)}, ObstacleReference{0}, contact::adhesive(film), 3}};
  return scene;
}

/// Distance from the plane at the bar's end.
double distance(const Model<2>& model) {
  return contact::equilibrium_distance(film) + body_displacement(model, 0)(1, 0);
}

/// Left half of a shallow clamped arch of thickness 0.3 and rise 1.5 over a span of about 12, in a given unit of
/// length, loaded from above.
Scene<2> arch(double unit = 1, int elements = 8) {
  constexpr double half_angle = 28;
  const double radius = 12.5 * unit;
  const Eigen::Vector2d center(0, 0);
  Scene<2> scene;
  const nurbs::Patch patch = nurbs::ruled(nurbs::arc(center, radius, 90 + half_angle, 90),
                                          nurbs::arc(center, radius + 0.3 * unit, 90 + half_angle, 90));
  scene.bodies.push_back({"arch", make_body(patch, {elements, 1}, "N3", "north", solid::neo_hookean(1000, 0.3), 2)});
  scene.supports = {{"wall", {face_points(scene, 0, "west")}, {Constraint::fixed, Constraint::fixed}},
                    {"middle", {face_points(scene, 0, "east")}, {Constraint::fixed, Constraint::free}}};
  scene.loads = {{"snow", {{0, nurbs::side_of("north", 2)}}, LoadKind::traction, {0, 0}}};
  return scene;
}

/// A strip whose east end rotates with free translation.
Scene<2> strip() {
  Scene<2> scene;
  scene.bodies.push_back({"strip", make_body(nurbs::rectangle(6, 1, Eigen::Vector2d(0, 0)), {6, 1}, "N2", "south",
                                             solid::neo_hookean(2, 0.3), 2)});
  Support<2> east{"east", {face_points(scene, 0, "east")}, {Constraint::free, Constraint::free}};
  east.rotates = true;
  east.center = face_centroid(*scene.bodies[0].body, nurbs::side_of("east", 2));
  scene.supports = {{"west", {face_points(scene, 0, "west")}, {Constraint::fixed, Constraint::fixed}}, east};
  return scene;
}

/// A model on a path of one target of its first drive, and the parts to compute the path's tangent with dense algebra.
struct Walk {
  Model<2> model;
  Bench<2> bench;
  Drives<2> drives;
  int component;
  double sense;    ///< of the target's change at the start
  VectorX weights; ///< of the path's norm
  VectorX targets, last_increment;

  Walk(const Scene<2>& scene, int component_, double sense_)
      : model(scene), bench(scene), drives(bench.system.scene, bench.unknowns), component(component_), sense(sense_),
        weights(path_weights(bench.system.scene, bench.unknowns)), targets(drives.start()) {}
  double norm(const VectorX& u) const { return std::sqrt(weights.dot(u.cwiseAbs2())); }
  double target() const { return accepted_target(model, 0, component); }

  /// Unit tangent of the solution curve at the accepted state, in the sense of the last step:
  ///   K δ = −(K_p ∂u_p − ∂f_ext) for a unit of the target.
  VectorX tangent() {
    const VectorX unit = VectorX::Unit(targets.size(), component);
    targets(component) = target();
    const VectorX rate = drives.rate(targets, unit);
    bench.residual(model.present.displacement, &rate);
    const VectorX change = bench.unknowns.gather(bench.assembly.product() - drives.force(unit));
    const VectorX t = rate + bench.unknowns.spread(dense::solve(bench.tangent(), -change));
    const double along = last_increment.size() > 0 ? t.dot(weights.cwiseProduct(last_increment)) : sense;
    return std::copysign(1 / norm(t), along) * t;
  }
  /// Solves and accepts one increment; checks its length along the tangent and the equilibrium at its end.
  void arc(double length) {
    const double from = target();
    const VectorX before = model.present.displacement, t = tangent();
    set_target(model, 0, component, from + sense);
    const ArcReport report = solve_arc(model, {}, length);
    ASSERT_EQ(report.outcome, solve::Outcome::converged) << text_of(report.messages);
    const double fraction = report.fraction;
    accept(model);
    last_increment = model.present.displacement - before;
    EXPECT_NEAR(t.dot(weights.cwiseProduct(last_increment)), length, 1e-9 * length);
    EXPECT_NEAR(target(), from + fraction * sense, 1e-14 * (1 + std::abs(from)));
    EXPECT_NEAR(last_length(model), norm(last_increment), 1e-14);
    targets(component) = target();
    const VectorX residual = bench.residual(model.present.displacement) - drives.force(targets);
    EXPECT_LT(bench.unknowns.gather(residual).norm(), 1e-9 * bench.unknowns.constrained_norm(residual));
  }
};

/// Number of turning points of the targets.
int turns(const std::vector<double>& values) {
  int count = 0;
  for (std::size_t i = 2; i < values.size(); ++i)
    count += (values[i] - values[i - 1]) * (values[i - 1] - values[i - 2]) < 0;
  return count;
}

/// A uniform bar: σ = −T(r), so the displacement of its top is u = r − r_eq − L T(r)/(λ + 2μ), which decreases where
/// the adhesive traction decreases faster than the bar unloads.
TEST(Arc, FollowsAnAdhesiveBarThroughItsSnapBack) {
  const solid::LinearElastic material = solid::linear_elastic(2, 0.2);
  const double modulus = material.lambda + 2 * material.mu, nearest = contact::equilibrium_distance(film);
  const auto exact = [&](double r) { return r - nearest - bar_length * contact::traction(film, r) / modulus; };
  double highest = 0, lowest = 1; // up to r = 0.75, beyond which u increases monotonically
  for (double r = nearest; r < 0.75; r += 1e-5) {
    highest = std::max(highest, exact(r));
    if (r > 0.4) lowest = std::min(lowest, exact(r));
  }
  ASSERT_GT(highest, 1.2 * lowest);

  Walk walk(bar(material), 0, 1);
  std::vector<double> tops;
  while (distance(walk.model) < 0.75 && !HasFailure()) {
    walk.arc(0.006);
    tops.push_back(walk.target());
    EXPECT_NEAR(tops.back(), exact(distance(walk.model)), 1e-9);
    EXPECT_NEAR(reaction(walk.model, 1)(1), -2 * contact::traction(film, distance(walk.model)), 1e-9);
  }
  ASSERT_GT(tops.size(), 50u); // fewer: an increment failed
  EXPECT_EQ(turns(tops), 2);
  EXPECT_NEAR(*std::max_element(tops.begin(), tops.end()), highest, 0.01 * highest);
  const auto falling = std::adjacent_find(tops.begin(), tops.end(), std::greater<>()); // the first turning point
  EXPECT_NEAR(*std::min_element(falling, tops.end()), lowest, 0.01 * lowest);

  // Displacement control cannot reach the states between: the bar snaps off, or Newton's method fails.
  Model<2> driven(bar(material));
  for (double top = 0.02;; top += 0.02) {
    set_target(driven, 0, 0, top);
    const bool converged = solve_step(driven, {}).outcome == solve::Outcome::converged;
    const bool leaps = !converged || distance(driven) > 0.5;
    EXPECT_EQ(leaps, top > highest) << top;
    if (leaps) break;
    accept(driven);
  }
  rollback(driven);
  EXPECT_LT(distance(driven), 0.33);
}

TEST(Arc, FollowsAnArchThroughItsLimitLoad) {
  Walk walk(arch(), 1, -1);
  const int crown = walk.model.system.scene.supports[1].on[0].functions[0];
  const auto sag = [crown](const Model<2>& model) { return -body_displacement(model, 0)(1, crown); };
  std::vector<double> loads, sags;
  int confirmed = 0;
  for (int step = 0; step < 45 && !HasFailure(); ++step) {
    walk.arc(0.06);
    loads.push_back(-walk.target());
    sags.push_back(sag(walk.model));
    if (step % 3 > 0) continue;
    // Two load-controlled steps, away and back, must return to the same state.
    const Snapshot<2> here = snapshot(walk.model);
    bool there_and_back = true;
    for (double factor : {0.999, 1.0}) {
      set_target(walk.model, 0, 1, -factor * loads.back());
      there_and_back = there_and_back && solve_step(walk.model, {}).outcome == solve::Outcome::converged;
      accept(walk.model);
    }
    confirmed += there_and_back;
    if (there_and_back) {
      EXPECT_NEAR((walk.model.present.displacement - here.state.displacement).norm(), 0,
                  1e-9 * here.state.displacement.norm())
          << step;
    }
    restore(walk.model, here);
  }
  ASSERT_EQ(loads.size(), 45u); // fewer: an increment failed
  EXPECT_EQ(confirmed, 15);
  EXPECT_EQ(turns(loads), 2);
  const auto limit = std::max_element(loads.begin(), loads.begin() + 10);
  EXPECT_LT(*std::min_element(limit, loads.end()), 0.3 * *limit);
  for (std::size_t i = 1; i < sags.size(); ++i) EXPECT_GT(sags[i], sags[i - 1]);

  // Load control snaps through past the descending branch, or Newton's method fails.
  Model<2> loaded(arch());
  for (double load = 0.01;; load += 0.01) {
    set_target(loaded, 0, 1, -load);
    const bool converged = solve_step(loaded, {}).outcome == solve::Outcome::converged;
    const bool leaps = !converged || sag(loaded) > 2;
    EXPECT_EQ(leaps, load > *limit) << load;
    if (leaps) break;
    accept(loaded);
  }
  rollback(loaded);
  EXPECT_LT(sag(loaded), 0.3);
}

/// Without turning points increments end in the same states as steps to the same targets; rotation of a face is a
/// nonlinear motion.
TEST(Arc, AgreesWithStepsToTheSameAngles) {
  Walk walk(strip(), 0, 1);
  Model<2> stepped(strip());
  for (int k = 0; k < 12 && !HasFailure(); ++k) {
    walk.arc(0.35);
    set_target(stepped, 0, 0, walk.target());
    ASSERT_EQ(solve_step(stepped, {}).outcome, solve::Outcome::converged);
    accept(stepped);
    EXPECT_NEAR((stepped.present.displacement - walk.model.present.displacement).norm(), 0,
                1e-9 * stepped.present.displacement.norm());
    EXPECT_NEAR(moment(walk.model, 1), moment(stepped, 1), 1e-9 * moment(stepped, 1));
  }
  EXPECT_GT(walk.target(), 60);
}

TEST(Arc, RollbackReturnsToTheAcceptedState) {
  Walk walk(arch(), 1, -1);
  walk.arc(0.06);
  walk.arc(0.06);
  Model<2>& model = walk.model;
  const VectorX accepted = model.present.displacement;
  const double target = walk.target();
  const Vec<2> force = reaction(model, 0), load = load_resultant(model, 0);
  const auto unchanged = [&] {
    EXPECT_EQ(model.present.displacement, accepted);
    EXPECT_EQ(walk.target(), target);
    EXPECT_EQ(reaction(model, 0), force);
    EXPECT_EQ(load_resultant(model, 0), load);
  };
  StepOptions cut;
  cut.newton.iterations = 1;
  set_target(model, 0, 1, target - 1);
  EXPECT_EQ(solve_arc(model, cut, 1).outcome, solve::Outcome::iteration_limit);
  rollback(model);
  unchanged();
  // An increment that converges but is not accepted; the direct solver factors every matrix, so the same one follows
  StepOptions direct;
  direct.linear = solve::LinearKind::umfpack;
  set_target(model, 0, 1, target - 1);
  ASSERT_EQ(solve_arc(model, direct, 0.06).outcome, solve::Outcome::converged);
  const VectorX first = model.present.displacement;
  EXPECT_GT(walk.norm(first - accepted), 0.059);
  rollback(model);
  unchanged();
  set_target(model, 0, 1, target - 1);
  ASSERT_EQ(solve_arc(model, direct, 0.06).outcome, solve::Outcome::converged);
  EXPECT_EQ(model.present.displacement, first);
}

/// ∫ |u|² dV / V of a rigid translation is |u|² for any mesh and unit.
TEST(Arc, TheNormIsTheRootMeanSquareOverTheBodies) {
  for (const Scene<2>& scene : {arch(), arch(1000), arch(1, 32), strip(), bar(solid::neo_hookean(1, 0.3))}) {
    const Unknowns<2> unknowns(scene);
    const VectorX weights = path_weights(scene, unknowns);
    const int obstacles = std::ssize(scene.obstacles);
    EXPECT_NEAR(weights.sum(), 2 + 2 * obstacles, 1e-12);
    EXPECT_GT(weights.minCoeff(), 0);
  }
}

TEST(Arc, IncrementsOfEqualLengthAreIndependentOfMeshAndUnit) {
  const auto loads = [](double unit, int elements) {
    Walk walk(arch(unit, elements), 1, -1);
    std::vector<double> values;
    for (int k = 0; k < 6; ++k) {
      walk.arc(0.1 * unit);
      values.push_back(walk.target());
    }
    return values;
  };
  const std::vector<double> once = loads(1, 8), finer = loads(1, 32), longer = loads(1000, 8);
  for (std::size_t k = 0; k < once.size(); ++k) {
    EXPECT_NEAR(finer[k] / once[k], 1, 0.02) << k;
    EXPECT_NEAR(longer[k] / once[k], 1, 1e-8) << k;
  }
}

TEST(Arc, ErrorsNameTheArgument) {
  Model<2> model(arch());
  EXPECT_ERROR(solve_arc(model, {}, 0.1), "model.arc.no_path");
  set_target(model, 0, 1, -1);
  EXPECT_ERROR(solve_arc(model, {}, 0), "model.arc.length: length = 0");
}

} // namespace arc_test
} // namespace signorini::model
