// Joined bodies: the tangent of contact with lists of faces, and unknowns that bodies share.
#include "model/scenes.hpp"

#include "model/bench.hpp"
#include "nurbs/directions.hpp"
#include "nurbs/plan.hpp"

namespace signorini::model {
namespace join_test {

using namespace test;

/// A block above the seam of two joined blocks, of which the right one has reversed directions.
Scene<2> across_a_seam(bool list_is_slave, const contact::Method& method) {
  const nurbs::Side east{0, true}, south{1, false}, north{1, true};
  Scene<2> scene;
  const auto add = [&](const char* name, const nurbs::Patch& patch, std::vector<int> elements, const char* face) {
    scene.bodies.push_back({name, make_body(patch, std::move(elements), "N2", face, solid::neo_hookean(1, 0.3), 2)});
  };
  add("left", nurbs::rectangle(1, 1, Eigen::Vector2d(0, 0)), {2, 1}, "north");
  add("right", nurbs::reverse(nurbs::reverse(nurbs::rectangle(1, 1, Eigen::Vector2d(1, 0)), 0), 1), {2, 1}, "south");
  add("upper", nurbs::rectangle(1, 1, Eigen::Vector2d(0.45, 0.98)), {3, 1}, "south");
  scene.supports = {{"lid", {face_points(scene, 2, "north")}, {Constraint::driven, Constraint::driven}}};
  scene.joins = {{"seam", {0, east}, {1, east}}};
  const Faces list{{1, south}, {0, north}}, block{2, south};
  if (list_is_slave)
    scene.contacts.push_back({"touch", list, block, method, 4});
  else
    scene.contacts.push_back({"touch", block, list, method, 4});
  return scene;
}

/// A block above the seam of two joined cubes, of which the right one is turned about z.
Scene<3> across_a_seam_in_space(bool list_is_slave) {
  const nurbs::Side east{0, true}, front{2, false}, back{2, true};
  Scene<3> scene;
  const auto add = [&](const char* name, const nurbs::Patch& patch) {
    scene.bodies.push_back({name, std::make_shared<const solid::Body<3>>(
                                      nurbs::Discretization(patch, nurbs::test::plan_of({1, 1, 1}, "", "N2")),
                                      solid::neo_hookean(1, 0.3))});
  };
  add("left", nurbs::block({1, 1, 1}, Vec<3>(0, 0, 0)));
  add("right", nurbs::reverse(nurbs::reverse(nurbs::block({1, 1, 1}, Vec<3>(1, 0, 0)), 0), 1));
  add("upper", nurbs::block({1, 0.8, 1}, Vec<3>(0.45, 0.1, 0.98)));
  scene.supports = {{"lid",
                     {{2, scene.bodies[2].body->space().face_functions(back)}},
                     {Constraint::driven, Constraint::driven, Constraint::driven}}};
  scene.joins = {{"seam", {0, east}, {1, east}}};
  const Faces list{{1, back}, {0, back}}, block{2, front};
  const contact::InterfaceLaw law{20, 20, 0.3};
  scene.contacts.push_back(
      {"touch", list_is_slave ? list : block, list_is_slave ? block : list, contact::Method(law), 3});
  return scene;
}

/// A random displacement, equal at the control points of the first join.
template <int D> VectorX random_state(nurbs::test::Random& random, const Bench<D>& bench) {
  VectorX u(bench.unknowns.dofs());
  for (int i = 0; i < u.size(); ++i) u(i) = nurbs::test::uniform(random, -0.01, 0.01);
  for (const auto& [a, b] : bench.system.scene.joins[0].pairs)
    u.segment<D>(bench.unknowns.offset(1) + D * b) = u.segment<D>(bench.unknowns.offset(0) + D * a);
  return u;
}

TEST(Joins, TangentOfContactWithAListOfFacesInSpace) {
  nurbs::test::Random random(11);
  for (const bool list_is_slave : {false, true}) {
    Bench bench(across_a_seam_in_space(list_is_slave));
    int compared = 0;
    for (int trial = 0; trial < 4; ++trial) compared += compare(bench, random_state(random, bench));
    EXPECT_GE(compared, 2);
  }
}

TEST(Joins, TangentOfContactWithAListOfFaces) {
  nurbs::test::Random random(7);
  for (const bool list_is_slave : {false, true})
    for (const contact::Method& method :
         {contact::Method(contact::InterfaceLaw{20, 20, 0.3}),
          contact::Method({20, 20, 0.3, contact::TractionArea::reference}, contact::MultiplierSpace::equal)}) {
      Bench bench(across_a_seam(list_is_slave, method));
      EXPECT_EQ(bench.unknowns.dofs() - bench.unknowns.size(), 2 * (3 + 5)); // three shared points, five driven ones
      int compared = 0;
      for (int trial = 0; trial < 6; ++trial) {
        compared += compare(bench, random_state(random, bench));
      }
      EXPECT_GE(compared, 3);
    }
}

} // namespace join_test
} // namespace signorini::model
