// Linear elastic scenes solved with static condensation of the bulk, compared with the standard solution.
#include "model/bench.hpp"
#include "model/scenes.hpp"
#include "text_of.hpp"

#include <cmath>

namespace signorini::model {
namespace condensed_test {

using namespace test;

const solid::LinearElastic soft = solid::linear_elastic(1, 0.3);

/// A half ring, driven at its inner arc, above a rigid plane that it touches.
Scene<2> roller(const solid::Material& material, const contact::InterfaceLaw& law,
                const std::vector<int>& elements = {24, 3}) {
  Scene<2> scene;
  const nurbs::Patch arc = nurbs::half_annulus(0.3, 1, Eigen::Vector2d(0, 1));
  scene.bodies.push_back({"roller", make_body(arc, elements, "N2-N2.1", "south", material)});
  scene.supports = {{"hub", {face_points(scene, 0, "north")}, {Constraint::driven, Constraint::driven}}};
  scene.obstacles = {contact::make_plane<2>({0, 0}, {0, 1})};
  scene.contacts = {{"floor", {0, nurbs::side_of("south", 2)}, ObstacleReference{0}, law, 9}};
  return scene;
}

/// The ironing problem's two bodies, both linear elastic.
Scene<2> linear_ironing(double mu) {
  Scene<2> scene = ironing("N2");
  for (auto& named : scene.bodies)
    named.body = std::make_shared<const solid::Body<2>>(named.body->shared_space(),
                                                        solid::linear_elastic(named.name == "die" ? 1000 : 1, 0.3));
  scene.contacts[0].method = contact::InterfaceLaw{100, 100, mu};
  return scene;
}

/// Largest numbers of active and slipping points along a path, and number of steps with different iterations.
struct Seen {
  int active = 0, slipping = 0, other_iterations = 0;
};

/// Compares displacements and forces of both solvers along a path.
Seen compare_solvers(const Scene<2>& scene, const std::vector<Vec<2>>& path) {
  Model<2> condensed(scene), plain(scene);
  StepOptions by_condensed, by_plain;
  by_condensed.linear = solve::LinearKind::condensed;
  by_plain.linear = solve::LinearKind::umfpack;
  Seen seen;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const auto a = step_to(condensed, 0, path[k](0), path[k](1), by_condensed),
               b = step_to(plain, 0, path[k](0), path[k](1), by_plain);
    EXPECT_EQ(a.outcome, solve::Outcome::converged) << k << ": " << text_of(a.messages);
    EXPECT_EQ(b.outcome, solve::Outcome::converged) << k << ": " << text_of(b.messages);
    EXPECT_NEAR(a.iterations, b.iterations, 2) << k;
    seen.other_iterations += a.iterations != b.iterations;
    EXPECT_EQ(condensed.linear.kind(), solve::LinearKind::condensed);
    EXPECT_EQ(plain.linear.kind(), solve::LinearKind::umfpack);
    accept(condensed);
    accept(plain);
    EXPECT_NEAR((condensed.present.displacement - plain.present.displacement).norm(), 0,
                1e-9 * plain.present.displacement.norm())
        << k;
    const auto x = resultant(condensed.present.contacts[0]), y = resultant(plain.present.contacts[0]);
    EXPECT_NEAR((x.force - y.force).norm(), 0, 1e-9 * y.force.norm());
    EXPECT_EQ(x.active, y.active);
    EXPECT_EQ(x.slipping, y.slipping);
    seen.active = std::max(seen.active, y.active);
    seen.slipping = std::max(seen.slipping, y.slipping);
  }
  return seen;
}

std::vector<Vec<2>> press_and_drag(double depth, int presses, double way, int drags) {
  std::vector<Vec<2>> path;
  for (int k = 1; k <= presses; ++k) path.push_back({0, -depth * k / presses});
  for (int k = 1; k <= drags; ++k) path.push_back({way * k / drags, -depth});
  return path;
}

/// With friction a step starts with slipping points on Coulomb's cone, where rounding error decides which tangent the
/// first iteration uses: a few steps take one iteration more or less; without friction none do.
TEST(Condensed, LinearBodyOnARigidPlane) {
  for (double mu : {0.0, 0.3}) {
    const Seen seen = compare_solvers(roller(soft, {100, 100, mu}), press_and_drag(0.1, 8, 0.2, 8));
    EXPECT_GT(seen.active, 30);
    EXPECT_EQ(seen.slipping > 20, mu > 0);
    EXPECT_LE(seen.other_iterations, mu > 0 ? 3 : 0);
  }
}

TEST(Condensed, TwoLinearBodies) {
  for (double mu : {0.0, 0.2}) {
    const Seen seen = compare_solvers(linear_ironing(mu), press_and_drag(0.1, 10, 0.3, 12));
    EXPECT_GT(seen.active, 9);
    EXPECT_EQ(seen.slipping > 9, mu > 0);
    EXPECT_LE(seen.other_iterations, mu > 0 ? 4 : 0);
  }
}

/// One step from first contact to a wide contact area, far beyond the previous contact unknowns.
TEST(Condensed, ContactGrowsBeyondTheContactUnknowns) {
  const Seen seen =
      compare_solvers(roller(soft, {100, 100, 0.3}), {{0, -0.001}, {0, -0.15}, {0.3, -0.15}, {0, -0.002}});
  EXPECT_GT(seen.active, 50);

  Bench bench(roller(soft, {100}));
  VectorX u = VectorX::Zero(bench.unknowns.dofs());
  const auto sink = [&](double depth) {
    for (int i = 1; i < bench.unknowns.obstacle_offset(0); i += 2) u(i) = -depth;
    bench.residual(u);
    return std::pair(bench.assembly.contact().version(), bench.assembly.contact().unknowns().size());
  };
  const auto none = sink(-0.01);
  EXPECT_EQ(none.second, 0);
  const auto few = sink(0.001), more = sink(0.0012), many = sink(0.2);
  EXPECT_EQ(few.first, none.first + 1);
  EXPECT_EQ(more, few); // small steps stay within the margin
  EXPECT_EQ(many.first, none.first + 2);
  EXPECT_GT(many.second, 2 * few.second);
  // All unknowns on which contacts act are contact unknowns.
  const MatrixX with = bench.tangent();
  std::vector<char> watched(static_cast<std::size_t>(bench.unknowns.size()), false);
  for (int i : bench.assembly.contact().unknowns()) watched[i] = true;
  VectorX nowhere = u;
  for (int i = 1; i < bench.unknowns.obstacle_offset(0); i += 2) nowhere(i) = 1;
  bench.residual(nowhere);
  const MatrixX contact = with - bench.tangent();
  for (int i = 0; i < contact.rows(); ++i)
    for (int j = 0; j < contact.cols(); ++j)
      if (std::abs(contact(i, j)) > 1e-12) {
        EXPECT_TRUE(watched[i] && watched[j]);
      }
}

/// On a mesh with few unknowns on the face all of them are contact unknowns from the start, and a step from no contact
/// to a wide one has one factorization of the bodies.
TEST(Condensed, WholeFacesFromTheStart) {
  Model<2> model(roller(soft, {100}, {24, 16}));
  const Assembly<2>& assembly = model.system.assembly;
  const auto face = static_cast<std::size_t>(2 * model.system.contacts[0]->slave().functions());
  EXPECT_EQ(assembly.contact().unknowns().size(), face);
  const int version = assembly.contact().version();
  step_to(model, 0, 0, -0.15);
  EXPECT_GT(resultant(model.present.contacts[0]).active, 27); // more than three elements
  EXPECT_EQ(assembly.contact().version(), version);
  Model<2> other(roller(soft, {100}, {24, 16}));
  StepOptions options;
  options.linear = solve::LinearKind::umfpack;
  step_to(other, 0, 0, -0.15, options);
  EXPECT_NEAR((model.present.displacement - other.present.displacement).norm(), 0,
              1e-9 * other.present.displacement.norm());
}

/// A block supported only by contact with a plane, with friction also against sliding: the bulk's stiffness is
/// singular.
TEST(Condensed, BodySupportedByContactOnly) {
  const auto scene = [](double mu) {
    Scene<2> block = square({{"guide", "west", {mu > 0 ? Constraint::free : Constraint::fixed, Constraint::free}}},
                            solid::linear_elastic(100, 0.3));
    block.obstacles = {contact::make_plane<2>({0, 0.001}, {0, 1})};
    block.contacts = {
        {"floor", {0, nurbs::side_of("south", 2)}, ObstacleReference{0}, contact::InterfaceLaw{100, 100, mu}, 4}};
    block.loads = {{"weight", {{0, nurbs::side_of("north", 2)}}, LoadKind::traction, {0, -0.1}}};
    return block;
  };
  for (double mu : {0.0, 0.3}) {
    Model<2> condensed(scene(mu)), plain(scene(mu));
    for (double push : {0.0, 0.01}) {
      for (Model<2>* model : {&condensed, &plain}) {
        StepOptions options;
        options.linear = model == &condensed ? solve::LinearKind::condensed : solve::LinearKind::umfpack;
        model::set_target(*model, 0, 0, push);
        const auto report = model::solve_step(*model, options);
        ASSERT_EQ(report.outcome, solve::Outcome::converged) << mu << " " << text_of(report.messages);
        model::accept(*model);
        EXPECT_NEAR(resultant(model->present.contacts[0]).force(1), 0.1, 1e-9);
        EXPECT_NEAR(resultant(model->present.contacts[0]).force(0), mu > 0 ? -push : 0, 1e-9);
        EXPECT_NEAR(model::reaction(*model, 0)(0), mu > 0 ? 0 : -push, 1e-9);
      }
      EXPECT_NEAR((condensed.present.displacement - plain.present.displacement).norm(), 0,
                  1e-9 * plain.present.displacement.norm());
    }
  }
}

TEST(Condensed, NeedsLinearBodiesAndAContact) {
  StepOptions options;
  options.linear = solve::LinearKind::condensed;
  const auto step = [&](Scene<2> scene) {
    Model<2> model(std::move(scene));
    step_to(model, 0, 0, -0.01, options);
  };
  const std::string message = "model.linear.condensed";
  EXPECT_ERROR(step(roller(solid::neo_hookean(1, 0.3), {100})), message);
  EXPECT_ERROR(step(square({{"bed", "south", {Constraint::fixed, Constraint::fixed}},
                            {"top", "north", {Constraint::driven, Constraint::driven}}},
                           soft)),
               message);
  // The automatic choice is condensation where possible.
  Model<2> linear(roller(soft, {100})), other(roller(solid::neo_hookean(1, 0.3), {100}));
  step_to(linear, 0, 0, -0.01);
  step_to(other, 0, 0, -0.01);
  EXPECT_EQ(linear.linear.kind(), solve::LinearKind::condensed);
  EXPECT_NE(other.linear.kind(), solve::LinearKind::condensed);
}

} // namespace condensed_test
} // namespace signorini::model
