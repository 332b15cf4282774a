// Scenes of linear elastic bodies, whose stiffness is assembled once: force, energy and tangent against those of the
// elements and finite differences, also after contacts and loads have changed.
#include "model/bench.hpp"
#include "model/scenes.hpp"

#include "nurbs/plan.hpp"
#include "os/parallel.hpp"

namespace signorini::model {
namespace linear_bodies_test {

using namespace test;

const solid::Material soft = solid::linear_elastic(1, 0.3);

/// A block on a rigid plane, with a prescribed top and a rotating side whose control points share unknowns.
Scene<2> pressed_block(solid::Kind kind, solid::Volumetric volumetric = solid::Volumetric::pointwise) {
  Scene<2> scene;
  scene.kind = kind;
  const auto shape =
      make_body(nurbs::rectangle(2, 1, Eigen::Vector2d(0.5, 0)), {8, 4}, "N2-N2.1", "south", soft, std::nullopt, kind);
  scene.bodies.push_back(
      {"block", std::make_shared<const solid::Body<2>>(shape->shared_space(), soft, kind, volumetric)});
  scene.supports.push_back({"grip", {face_points(scene, 0, "north")}, {Constraint::driven, Constraint::driven}});
  scene.obstacles = {contact::make_plane<2>({0, 0}, {0, 1})};
  scene.contacts = {{"floor", {0, nurbs::side_of("south", 2)}, ObstacleReference{0}, contact::InterfaceLaw{20}, 9}};
  return scene;
}

/// A strip with a rotating end.
Scene<2> turned_strip() {
  Scene<2> scene;
  scene.bodies.push_back(
      {"strip", make_body(nurbs::rectangle(2, 1, Eigen::Vector2d(0, 0)), {4, 3}, "N2", "north", soft)});
  scene.supports.push_back({"wall", {face_points(scene, 0, "west")}, {Constraint::fixed, Constraint::fixed}});
  scene.supports.push_back(
      {"edge", {face_points(scene, 0, "east")}, {Constraint::free, Constraint::free}, {}, true, {2, 0.5}});
  return scene;
}

/// Two joined blocks below a third one.
Scene<2> joined_blocks() {
  Scene<2> scene;
  const auto add = [&](const char* name, const nurbs::Patch& patch, std::vector<int> elements, const char* face) {
    scene.bodies.push_back({name, make_body(patch, std::move(elements), "N2", face, soft, 2)});
  };
  add("left", nurbs::rectangle(1, 1, Eigen::Vector2d(0, 0)), {2, 2}, "north");
  add("right", nurbs::rectangle(1, 1, Eigen::Vector2d(1, 0)), {3, 2}, "north");
  add("upper", nurbs::rectangle(1, 1, Eigen::Vector2d(0.45, 1)), {3, 2}, "south");
  scene.supports = {
      {"bed", {face_points(scene, 0, "south"), face_points(scene, 1, "south")}, {Constraint::fixed, Constraint::fixed}},
      {"lid", {face_points(scene, 2, "north")}, {Constraint::driven, Constraint::driven}}};
  scene.joins = {{"seam", {0, nurbs::Side{0, true}}, {1, nurbs::Side{0, false}}}};
  scene.contacts.push_back({"touch",
                            {2, nurbs::Side{1, false}},
                            Faces{{0, nurbs::Side{1, true}}, {1, nurbs::Side{1, true}}},
                            contact::InterfaceLaw{20, 20, 0.3},
                            5});
  return scene;
}

/// A solid with a rotating back.
Scene<3> turned_solid() {
  Scene<3> scene;
  const auto space = std::make_shared<const nurbs::Discretization>(nurbs::block({3, 2, 1}, Eigen::Vector3d(0, 0, 0)),
                                                                   nurbs::test::plan_of({3, 2, 2}, "front", "N2"));
  scene.bodies.push_back({"solid", std::make_shared<const solid::Body<3>>(space, soft)});
  Support<3> grip{"grip",
                  {{0, space->face_functions(nurbs::side_of("back", 3))}},
                  {Constraint::free, Constraint::driven, Constraint::free}};
  grip.rotates = true;
  grip.center = {1.5, 1, 1};
  grip.axis = {0, 0, 1};
  scene.supports.push_back(grip);
  scene.supports.push_back({"bed",
                            {{0, space->face_functions(nurbs::side_of("front", 3))}},
                            {Constraint::fixed, Constraint::fixed, Constraint::free}});
  return scene;
}

template <int D> VectorX any_displacement(const Unknowns<D>& unknowns, double size, nurbs::test::Random& random) {
  return VectorX::NullaryExpr(unknowns.dofs(), [&] { return nurbs::test::uniform(random, -size, size); });
}

/// Σ_e f_e of the bodies' elements.
template <int D> VectorX elements_force(const System<D>& system, const VectorX& u) {
  VectorX sum = VectorX::Zero(u.size());
  for (std::size_t b = 0; b < system.scene.bodies.size(); ++b) {
    const solid::Body<D>& body = *system.scene.bodies[b].body;
    const int offset = system.unknowns.offset(static_cast<int>(b));
    solid::ElementArrays<D> arrays(body);
    for (int m = 0; m < body.macro_elements(); ++m) {
      internal_force(body, m, u.data() + offset, arrays, false);
      const auto functions = body.functions_of_macro(m);
      for (std::size_t a = 0; a < functions.size(); ++a)
        for (std::size_t i = 0; i < D; ++i)
          sum(offset + D * functions[a] + static_cast<int>(i)) += arrays.force[i * functions.size() + a];
    }
  }
  return sum;
}

template <int D> void expect_forces_of_elements(const Scene<D>& scene, const std::string& what) {
  nurbs::test::Random random(3);
  Bench<D> bench(scene);
  for (int state = 0; state < 3; ++state) {
    VectorX u = any_displacement(bench.unknowns, 0.01, random);
    // Bodies are lifted beyond the reach of contacts, by different heights.
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
      for (int k = 0; k < scene.bodies[b].body->functions(); ++k)
        u(bench.unknowns.offset(static_cast<int>(b)) + D * k + D - 1) += 0.5 * (1 + static_cast<double>(b));
    const VectorX expected = elements_force(bench.system, u);
    for (bool tangent : {true, false}) {
      EXPECT_FALSE(bench.assemble(u, nullptr, tangent));
      EXPECT_LT((bench.present.force - expected).norm(), 1e-12 * expected.norm()) << what << " " << state;
    }
    double energy = 0;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
      energy += solid::account(*scene.bodies[b].body, u.data() + bench.unknowns.offset(static_cast<int>(b))).stored;
    EXPECT_NEAR(bench.system.assembly.bulk().account(u, bench.accepted.internal).stored, energy, 1e-11 * energy)
        << what;
    EXPECT_TRUE(compare(bench, u)) << what << " " << state;
  }
}

TEST(LinearBodies, ForceAndEnergyAreThoseOfTheElements) {
  expect_forces_of_elements(pressed_block(solid::Kind::plane_strain), "plane strain");
  expect_forces_of_elements(pressed_block(solid::Kind::plane_stress), "plane stress");
  expect_forces_of_elements(pressed_block(solid::Kind::axisymmetric), "axisymmetric");
  expect_forces_of_elements(pressed_block(solid::Kind::plane_strain, solid::Volumetric::projected), "projected");
  expect_forces_of_elements(turned_strip(), "turned");
  expect_forces_of_elements(joined_blocks(), "joined");
  expect_forces_of_elements(turned_solid(), "solid");
}

/// A path on which contacts close, move on and open, springs act, and a pressure that follows the deformation comes and
/// goes: what is kept from earlier states must not appear in the tangent.
TEST(LinearBodies, TangentDoesNotDependOnEarlierContactsAndLoads) {
  for (bool joined : {false, true}) {
    Scene<2> scene = joined ? joined_blocks() : pressed_block(solid::Kind::plane_strain);
    const int mover = joined ? 2 : 0;
    scene.loads = {{"wind", {{mover, nurbs::side_of("west", 2)}}, LoadKind::follower_pressure, {0}}};
    Support<2> bedding{"bedding", {}, {Constraint::free, Constraint::free}};
    bedding.spring = {0.3, 0.2};
    bedding.spring_faces = {{mover, nurbs::side_of("east", 2)}};
    scene.supports.push_back(bedding);
    Bench bench(scene);
    const auto& target = bench.system.followers.parts().front().target;
    nurbs::test::Random random(11);
    int compared = 0, closed = 0, open = 0;
    for (int state = 0; state < 40; ++state) {
      VectorX u = any_displacement(bench.unknowns, 1e-3, random);
      const double x = nurbs::test::uniform(random, -0.4, 0.4), y = nurbs::test::uniform(random, -0.03, 0.02);
      const int first = bench.unknowns.offset(mover);
      for (int k = 0; k < scene.bodies[mover].body->functions(); ++k) u.segment<2>(first + 2 * k) += Vec<2>(x, y);
      bench.loads(target) = state % 3 == 0 ? 0.2 : 0;
      bench.residual(u);
      (resultant(bench.present.contacts[0]).active > 0 ? closed : open)++;
      const MatrixX kept = bench.tangent();
      Bench<2> fresh(scene);
      fresh.accepted = bench.accepted;
      fresh.loads = bench.loads;
      fresh.residual(u);
      EXPECT_LT((kept - fresh.tangent()).norm(), 1e-12 * kept.norm()) << joined << " " << state;
      // Finite differences of the internal and contact forces
      if (state % 3 != 0 && state % 4 == 1) compared += compare(bench, u);
    }
    EXPECT_GT(compared, 2) << joined;
    EXPECT_GT(closed, 10) << joined;
    EXPECT_GT(open, 5) << joined;
  }
}

TEST(LinearBodies, ThreadsGiveTheSameBits) {
  nurbs::test::Random random(4);
  Bench one(joined_blocks()), two(joined_blocks());
  const VectorX u = any_displacement(one.unknowns, 0.01, random), direction = any_displacement(one.unknowns, 1, random);
  one.residual(u, &direction);
  set_worker_threads(2);
  two.residual(u, &direction);
  set_worker_threads(1);
  EXPECT_TRUE((one.present.force.array() == two.present.force.array()).all());
  EXPECT_TRUE((one.assembly.product().array() == two.assembly.product().array()).all());
  EXPECT_EQ(one.assembly.tangent().values, two.assembly.tangent().values);
}

} // namespace linear_bodies_test
} // namespace signorini::model
