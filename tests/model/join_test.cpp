// Joined bodies: the tangent of contact with lists of faces, and unknowns that bodies share.
#include "model/scenes.hpp"

#include "model/bench.hpp"
#include "nurbs/directions.hpp"

namespace signorini::model {
namespace join_test {

using namespace test;

/// A block above the seam of two joined blocks, of which the right one has reversed directions.
Scene<2> across_a_seam(bool list_is_slave, const contact::Method<2>& method) {
  const nurbs::Side west{0, false}, east{0, true}, south{1, false}, north{1, true};
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

TEST(Joins, TangentOfContactWithAListOfFaces) {
  nurbs::test::Random random(7);
  for (const bool list_is_slave : {false, true})
    for (const contact::Method<2>& method :
         {contact::Method<2>(contact::PenaltyLaw{20, 20, 0.3}),
          contact::Method<2>(contact::MortarLaw{contact::PenaltyLaw{20, 20, 0.3, contact::TractionArea::reference}})}) {
      Bench bench(across_a_seam(list_is_slave, method));
      EXPECT_EQ(bench.unknowns.dofs() - bench.unknowns.size(), 2 * (3 + 5)); // three shared points, five driven ones
      int compared = 0;
      for (int trial = 0; trial < 6; ++trial) {
        VectorX u(bench.unknowns.dofs());
        for (int i = 0; i < u.size(); ++i) u(i) = nurbs::test::uniform(random, -0.01, 0.01);
        for (const auto& [a, b] : bench.system.scene.joins[0].pairs)
          u.segment<2>(bench.unknowns.offset(1) + 2 * b) = u.segment<2>(bench.unknowns.offset(0) + 2 * a);
        compared += compare(bench, u);
      }
      EXPECT_GE(compared, 3);
    }
}

} // namespace join_test
} // namespace signorini::model
