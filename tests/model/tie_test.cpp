// Ties in a model: tangent, seams at supports, unconstrained bodies, factorization with a border, faces that do not
// fit.
#include "model/scenes.hpp"

#include "model/bench.hpp"
#include "model/diagnosis/weak_directions.hpp"
#include "model/results/tie_results.hpp"
#include "model/scene/ties.hpp"
#include "model/steps/linear_solution.hpp"
#include "model/system/tie_terms.hpp"
#include "text_of.hpp"

namespace signorini::model {
namespace tie_test {

using namespace test;
using contact::MultiplierSpace;

enum Supports { floor, lid };

/// Two stacked blocks, 2 × 1 and `width` × 1, with free sides; all that happens comes through the seam.
Scene<2> stacked(const solid::Material& material, MultiplierSpace kind, double width = 2, double height = 1,
                 solid::Kind scene_kind = solid::Kind::plane_strain) {
  Scene<2> scene;
  scene.kind = scene_kind;
  const auto add = [&](const char* name, double w, double y, int elements, const char* face) {
    scene.bodies.push_back({name, make_body(nurbs::rectangle(w, 1, Eigen::Vector2d(0, y)), {elements, 2}, "N2", face,
                                            material, 2, scene_kind)});
  };
  add("lower", 2, 0, 3, "north");
  add("upper", width, height, 5, "south");
  scene.supports = {{"floor", {face_points(scene, 0, "south")}, {Constraint::fixed, Constraint::fixed}},
                    {"lid", {face_points(scene, 1, "north")}, {Constraint::driven, Constraint::driven}}};
  scene.ties = {{"seam", {0, nurbs::side_of("north", 2)}, {1, nurbs::side_of("south", 2)}, kind}};
  return scene;
}

/// The proximal term, which is in the tangent alone, is below the tolerance of the comparison.
TEST(Ties, TangentIsTheResidualsDerivative) {
  nurbs::test::Random random(5);
  for (const MultiplierSpace kind : {MultiplierSpace::equal, MultiplierSpace::reduced})
    for (const double width : {2.0, 1.3})
      for (const solid::Kind plane : {solid::Kind::plane_strain, solid::Kind::axisymmetric}) {
        Bench bench(stacked(solid::neo_hookean(1, 0.3), kind, width, 1, plane));
        for (int trial = 0; trial < 3; ++trial) {
          VectorX u(bench.unknowns.dofs());
          for (int i = 0; i < u.size(); ++i) u(i) = nurbs::test::uniform(random, -0.02, 0.02);
          EXPECT_TRUE(compare(bench, u));
        }
      }
}

TEST(Ties, TwoBlocksDeformAsOneAndDoNoWork) {
  for (const MultiplierSpace kind : {MultiplierSpace::equal, MultiplierSpace::reduced}) {
    Model<2> model(stacked(solid::neo_hookean(1, 0.3), kind));
    for (int step = 1; step <= 20; ++step) {
      set_target(model, 0, 0, 0.02 * step);
      set_target(model, 0, 1, -0.01 * step);
      const auto report = solve_step(model, {});
      ASSERT_EQ(report.outcome, solve::Outcome::converged) << text_of(report.messages);
      EXPECT_LE(report.iterations, 5);
      accept(model);
      const auto through = tie_resultant(model, 0);
      EXPECT_LT((through.force - reaction(model, lid)).norm(), 1e-10);
      EXPECT_LT((reaction(model, floor) + reaction(model, lid)).norm(), 1e-10);
    }
    const Energies energy = energies(model);
    EXPECT_NEAR(energy.work, energy.stored, 1e-3 * energy.stored); // trapezoidal rule
    const TieProfile profile = tie_profile(model, 0);
    double x = 0, y = 0;
    for (std::size_t i = 0; i < profile.area.size(); ++i) {
      x += profile.area[i] * profile.traction[0][i];
      y += profile.area[i] * profile.traction[1][i];
    }
    EXPECT_LT((Vec<2>(x, y) - tie_resultant(model, 0).force).norm(), 1e-12);
  }
}

/// The ends of the seam lie on a clamped face of both bodies, so that the end multipliers act on no unknown.
TEST(Ties, SeamMayEndOnAClampedFace) {
  for (const MultiplierSpace kind : {MultiplierSpace::equal, MultiplierSpace::reduced})
    for (const auto linear : {solve::LinearKind::klu, solve::LinearKind::umfpack, solve::LinearKind::reuse}) {
      Scene<2> scene = stacked(solid::neo_hookean(1, 0.3), kind);
      scene.supports = {{"wall",
                         {face_points(scene, 0, "west"), face_points(scene, 1, "west")},
                         {Constraint::fixed, Constraint::fixed}},
                        {"grip",
                         {face_points(scene, 0, "east"), face_points(scene, 1, "east")},
                         {Constraint::driven, Constraint::driven}}};
      Model<2> model(std::move(scene));
      set_target(model, 0, 0, 0.1);
      set_target(model, 0, 1, 0.2);
      StepOptions options;
      options.linear = linear;
      const auto report = solve_step(model, options);
      ASSERT_EQ(report.outcome, solve::Outcome::converged) << text_of(report.messages);
      EXPECT_LE(report.iterations, 7);
      accept(model);
      // The force agrees with that of one body, up to the discretization error.
      Scene<2> whole;
      whole.bodies = {{"whole", make_body(nurbs::rectangle(2, 2, Eigen::Vector2d(0, 0)), {5, 4}, "N2", "north",
                                          solid::neo_hookean(1, 0.3), 2)}};
      whole.supports = {{"wall", {face_points(whole, 0, "west")}, {Constraint::fixed, Constraint::fixed}},
                        {"grip", {face_points(whole, 0, "east")}, {Constraint::driven, Constraint::driven}}};
      Model<2> reference(std::move(whole));
      set_target(reference, 0, 0, 0.1);
      set_target(reference, 0, 1, 0.2);
      ASSERT_EQ(solve_step(reference, {}).outcome, solve::Outcome::converged);
      const Vec<2> force = reaction(model, 1), expected = reaction(reference, 1);
      EXPECT_LT((force - expected).norm(), 0.02 * expected.norm());
    }
}

TEST(Ties, TiedBodiesAreUnconstrainedTogether) {
  Scene<2> scene = stacked(solid::neo_hookean(1, 0.3), MultiplierSpace::equal);
  scene.supports.pop_back(); // the lower block alone is held
  EXPECT_TRUE(System<2>(scene).unconstrained().empty());
  scene.supports[0].constraint = {Constraint::free, Constraint::fixed};
  System<2> slides(scene);
  const auto& motions = slides.unconstrained(); // translation along x of each block
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions[0].body, 0);
  EXPECT_EQ(motions[1].body, 1);
  scene.ties.clear();
  EXPECT_EQ(System<2>(scene).unconstrained().size(), 4u); // and all motions of the upper one
}

TEST(Ties, BorderLeavesAPositiveDefiniteInterior) {
  const auto size = [](Scene<2> scene) {
    const System<2> system(std::move(scene));
    return static_cast<int>(tie_border(system.scene, system.unknowns, system.ties).size()) -
           system.ties[0].multipliers();
  };
  Scene<2> scene = stacked(solid::linear_elastic(1, 0.3), MultiplierSpace::equal);
  EXPECT_EQ(size(scene), 0); // both are held
  scene.supports.pop_back();
  EXPECT_EQ(size(scene), 2 * 7); // the face of the upper one
}

/// The lowest eigenvalue belongs to displacements that the tie admits, although the tangent has negative ones.
TEST(Ties, MultipliersAreNotSoftDirections) {
  Bench bench(stacked(solid::linear_elastic(1, 0.3), MultiplierSpace::equal));
  bench.residual(VectorX::Zero(bench.unknowns.dofs()));
  const int free = bench.unknowns.free_displacements();
  const WeakDirection weak = softest_direction(bench.assembly.tangent().pattern, bench.assembly.tangent().values, free);
  EXPECT_GT(weak.stiffness, 0);
  EXPECT_EQ(weak.direction.tail(weak.direction.size() - free).norm(), 0);
  const VectorX product = bench.tangent() * weak.direction;
  EXPECT_LT(product.tail(product.size() - free).norm(), 1e-6 * product.head(free).norm()); // B u = 0
}

TEST(Ties, FacesThatDoNotFitAreErrors) {
  const auto tied = [](double width, double height) {
    return [=] { System<2>(stacked(solid::linear_elastic(1, 0.3), MultiplierSpace::equal, width, height)); };
  };
  EXPECT_NO_THROW(tied(2, 1.05)());
  EXPECT_ERROR(tied(2, 1.1)(), "model.tie.distance");
  Scene<2> scene = stacked(solid::linear_elastic(1, 0.3), MultiplierSpace::equal);
  const auto error_with = [&](auto change) {
    Scene<2> changed = scene;
    change(changed);
    System<2>{std::move(changed)};
  };
  EXPECT_ERROR(error_with([](auto& s) { s.ties[0].master = s.ties[0].slave; }), "model.tie.own_face");
  EXPECT_ERROR(error_with([](auto& s) {
                 s.ties.push_back({"again", s.ties[0].master, s.ties[0].slave, {}});
               }),
               "model.tie.twice");
  EXPECT_ERROR(error_with([](auto& s) {
                 s.contacts = {{"touch", s.ties[0].master, s.ties[0].slave, contact::InterfaceLaw{1}, 3}};
               }),
               "model.tie.in_contact");
  EXPECT_ERROR(error_with([](auto& s) {
                 s.bodies[1].body = make_body(nurbs::rectangle(2, 1, Eigen::Vector2d(5, 1)), {5, 2}, "N2", "south",
                                              solid::linear_elastic(1, 0.3), 2);
               }),
               "model.tie.apart");
  EXPECT_ERROR(error_with([](auto& s) {
                 s.bodies[1].body = make_body(nurbs::rectangle(2, 1, Eigen::Vector2d(0, 0)), {5, 2}, "N2", "north",
                                              solid::linear_elastic(1, 0.3), 2);
                 s.ties[0].master[0].side = nurbs::side_of("north", 2);
               }),
               "model.tie.facing");
}

TEST(Ties, AFaceTiedInPartIsAWarning) {
  const auto codes = [](Scene<2> scene) {
    const Model<2> model(std::move(scene));
    return text_of(model.scene_warnings);
  };
  EXPECT_EQ(codes(stacked(solid::linear_elastic(1, 0.3), MultiplierSpace::equal)), "");
  EXPECT_EQ(codes(stacked(solid::linear_elastic(1, 0.3), MultiplierSpace::equal, 3)), ""); // a larger master
  const std::string part = codes(stacked(solid::linear_elastic(1, 0.3), MultiplierSpace::equal, 1));
  EXPECT_NE(part.find("model.warning.tied_part: tie = (model.tie.name: name = seam)"), std::string::npos) << part;
  EXPECT_NE(part.find("percent = 50"), std::string::npos) << part;
}

} // namespace tie_test
} // namespace signorini::model
