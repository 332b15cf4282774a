// Adhesive contacts, and contacts limited to a part of a face.
#include "contact/couple.hpp"

#include <cmath>

namespace signorini::contact {
namespace adhesive_pair_test {

using namespace test;

const Adhesion law{0.02, 0.05};

/// The lower side of a strip from x = 0 to 3.
nurbs::Discretization strip(const std::string& label) {
  return discretize(nurbs::rectangle(3, 0.5, Eigen::Vector2d(0, 0)), {6, 1}, label, "south");
}

TEST(AdhesivePair, TangentIsTheForcesDerivative) {
  Random random(1);
  Census census;
  for (int round = 0; round < 4; ++round) {
    std::vector<Couple> couples;
    couples.emplace_back("N2-N2.1", slab("N2"), adhesive(law), 1.3, 1.02);
    couples.emplace_back("N2", wavy(random, 3, 0.1, 3, 4), adhesive(law), 1.3, 0.1);
    couples.emplace_back("N2-N4", make_plane<2>({1.3, 0}, {0.1, 2}), adhesive(law), 1.3, 0.1);
    couples.emplace_back("N2", make_ball<2>({1.3, -2}, 2), adhesive(law), 1.3, 0.1);
    for (Couple& couple : couples) {
      couple.touch();
      couple.move_die(0, 0.03 * (round - 1)); // pushed in, touching, and drawn off
      couple.shake(random, 0.003);
      compare_with_differences(couple, census);
    }
  }
  census.expect({.states = 10, .open = 200, .adhesion = 50});
}

TEST(AdhesivePair, UniformGapActsOnTheReferenceLength) {
  for (double r : {0.02, 0.03, 0.038, 0.1}) {
    Couple couple(strip("N2"), "south", make_plane<2>({0, -r}, {0, 1}), adhesive(law), 4);
    // Stretching the strip along the substrate to twice its length leaves the resultant unchanged.
    const MatrixX points = couple.die.points();
    for (int a = 0; a < points.cols(); ++a) couple.u(2 * a) = points(0, a);
    couple.evaluate();
    const double total = 3 * traction(law, r);
    Vec<2> force = Vec<2>::Zero();
    for (const auto& point : couple.pair.results()) {
      force += point.force;
      EXPECT_NEAR(point.gap, r, 1e-15);
      EXPECT_EQ(point.state, r < strongest_distance(law) ? ContactState::adhesion : ContactState::open);
      EXPECT_NEAR(point.pressure, traction(law, point.gap) / 2, 1e-15 * std::abs(total)); // a Cauchy pressure
    }
    EXPECT_NEAR((force - Vec<2>(0, total)).norm(), 0, 1e-12 * std::abs(stiffness(law, 0)) * r);
    EXPECT_NEAR((couple.pair.resultant().force - force).norm(), 0, 1e-14 * std::abs(total));
    EXPECT_NEAR(couple.pair.area(), r < strongest_distance(law) ? 6 : 0, 1e-13);
    EXPECT_NEAR(couple.dense().force.tail<2>()(1), total, 1e-12 * std::abs(stiffness(law, 0)) * r);
  }
}

/// Adhesion has no history: after accepting or rolling back the same displacements give the same forces.
TEST(AdhesivePair, IsIndependentOfThePath) {
  Random random(2);
  Couple couple("N2", wavy(random, 3, 0.1, 3, 4), adhesive(law), 1.3, 0.1);
  couple.touch().move_die(0, 0.03).evaluate();
  const VectorX at = couple.u;
  const Dense before = couple.dense();
  for (int step = 0; step < 6; ++step) {
    couple.move_die(uniform(random, -0.2, 0.2), uniform(random, -0.02, 0.2)).evaluate();
    step % 2 == 0 ? couple.pair.accept() : couple.pair.rollback();
  }
  couple.evaluate(at);
  const Dense after = couple.dense();
  EXPECT_NEAR((after.force - before.force).norm(), 0, 1e-10 * before.force.norm());
  EXPECT_NEAR((after.tangent - before.tangent).norm(), 0, 1e-10 * before.tangent.norm());
}

/// Points outside the region are ignored; points inside act as without the others.
TEST(AdhesivePair, WhereLimitsTheContactToAPartOfTheFace) {
  const auto face = [&] { return Surface<2>(strip("N2"), nurbs::side_of("south", 2)); };
  const Region<2> left = [](const Vec<2>& x) { return x(0) <= 1.5; };
  Random random(3);
  for (const Law& any : {Law(adhesive(law)), Law(InterfaceLaw{100, 100, 0.3})}) {
    const Obstacle<2> plane = make_plane<2>({0, 0.01}, {0, 1});
    Pair<2> whole(face(), plane, any, 4), part(face(), plane, any, 4, false, left);
    VectorX u(2 * strip("N2").functions());
    for (int i = 0; i < u.size(); ++i) u(i) = uniform(random, -0.003, 0.003);
    const Vec<2> home = Vec<2>::Zero();
    whole.evaluate(u.data(), home.data());
    part.evaluate(u.data(), home.data());
    EXPECT_EQ(whole.results().size(), 24u);
    ASSERT_EQ(part.results().size(), 12u);
    ASSERT_EQ(part.reference_positions().size(), 12u);
    for (std::size_t i = 0; i < part.results().size(); ++i) {
      // The left ones of three elements; limits refer to reference positions, not to current ones.
      EXPECT_TRUE(left(part.reference_positions()[i]));
      EXPECT_EQ(part.reference_positions()[i], whole.reference_positions()[i]);
      EXPECT_EQ(part.results()[i].force, whole.results()[i].force);
    }
    for (const Block& block : part.blocks()) EXPECT_LT(block.slave_element, 3);
    EXPECT_GT(part.resultant().force.norm(), 0);
    EXPECT_EQ(part.gaps().size(), 12u);
  }
  const auto nowhere = [&] {
    return Pair<2>(face(), Obstacle<2>(make_plane<2>({0, 0}, {0, 1})), adhesive(law), 4, false,
                   [](const Vec<2>&) { return false; });
  };
  EXPECT_ERROR(nowhere(), "contact.points.none");
}

TEST(AdhesivePair, ErrorsNameTheArgument) {
  const auto build = [](const Law& any) { Couple("N2", make_plane<2>({0, 0}, {0, 1}), any, 1, 1); };
  EXPECT_ERROR(build(adhesive({-1, 1})), "contact.adhesion.hamaker: value = -1");
  EXPECT_ERROR(build(adhesive({1, -1})), "contact.adhesion.distance: value = -1");
}

} // namespace adhesive_pair_test
} // namespace signorini::contact
