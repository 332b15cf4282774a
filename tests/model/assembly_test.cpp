// The assembled tangent against finite differences of the residual, in states of the ironing problem.
#include "model/bench.hpp"
#include "model/scenes.hpp"

namespace signorini::model {
namespace assembly_test {

using namespace test;

struct Seen {
  int open = 0, stick = 0, slip = 0, elsewhere = 0;
};

Seen states(const Bench<2>& bench) {
  Seen result;
  for (const auto& point : bench.present.contacts[0].results)
    ++(point.state == contact::ContactState::open    ? result.open
       : point.state == contact::ContactState::stick ? result.stick
                                                     : result.slip);
  for (const auto& block : bench.system.contacts[0]->blocks()) result.elsewhere += block.slip_element >= 0;
  return result;
}

TEST(Assembly, TangentIsTheResidualsDerivativeInEveryState) {
  nurbs::test::Random random(2);
  for (const char* label : {"N2", "N2-N2.2"}) {
    Bench bench(ironing(label));
    VectorX u = VectorX::Zero(bench.unknowns.dofs());
    const auto move_die = [&](double x, double y) {
      for (int i = 0; i < bench.unknowns.offset(1); i += 2) u.segment<2>(i) += Eigen::Vector2d(x, y);
    };
    const auto shaken = [&](double size) {
      VectorX moved = u;
      for (int i = 0; i < moved.size(); ++i) moved(i) += nurbs::test::uniform(random, -size, size);
      return moved;
    };
    Seen seen;
    int compared = 0;
    const auto check = [&](double size) {
      for (int trial = 0; trial < 3; ++trial)
        if (compare(bench, shaken(size))) {
          ++compared;
          const Seen now = states(bench);
          seen.open += now.open;
          seen.stick += now.stick;
          seen.slip += now.slip;
          seen.elsewhere += now.elsewhere;
        }
    };
    bench.residual(u);
    bench.accept();
    move_die(0, -0.05);
    check(2e-3);
    bench.residual(u);
    bench.accept();
    move_die(2e-3, 0);
    check(2e-4);
    move_die(0.03, 0);
    check(1e-3);
    move_die(0.4, 0); // slip points remain in other elements
    check(1e-3);
    EXPECT_GE(compared, 8) << label;
    EXPECT_GT(seen.open, 50) << label;
    EXPECT_GT(seen.stick, 10) << label;
    EXPECT_GT(seen.slip, 50) << label;
    EXPECT_GT(seen.elsewhere, 1) << label;
  }
}

TEST(Assembly, ResidualWithoutTangentIsBitwiseTheSame) {
  nurbs::test::Random random(5);
  Bench bench(ironing("N2-N2.2")), alone(ironing("N2-N2.2"));
  VectorX u = VectorX::Zero(bench.unknowns.dofs());
  for (int i = 1; i < bench.unknowns.offset(1); i += 2) u(i) = -0.05;
  for (int i = 0; i < u.size(); ++i) u(i) += nurbs::test::uniform(random, -1e-3, 1e-3);
  const VectorX whole = bench.residual(u);
  ASSERT_GT(resultant(bench.present.contacts[0]).active, 0);
  EXPECT_FALSE(alone.assemble(u, nullptr, false));
  EXPECT_TRUE((alone.present.force.array() == whole.array()).all());
}

TEST(Assembly, PatternStaysWhileTheSameElementsTouch) {
  Bench bench(ironing("N2"));
  VectorX u = VectorX::Zero(bench.unknowns.dofs());
  for (int i = 1; i < bench.unknowns.offset(1); i += 2) u(i) = -0.05;
  bench.residual(u);
  const int version = bench.assembly.tangent().version;
  for (int i = 0; i < bench.unknowns.offset(1); i += 2) u(i) = 0.01;
  bench.residual(u);
  EXPECT_EQ(bench.assembly.tangent().version, version);
  for (int i = 0; i < bench.unknowns.offset(1); i += 2) u(i) = 1.2;
  bench.residual(u);
  EXPECT_GT(bench.assembly.tangent().version, version);
}

/// A contact that moves on meets patterns that hold its blocks in part: the tangent is that of an assembly whose
/// pattern was made for it.
TEST(Assembly, TangentDoesNotDependOnEarlierContacts) {
  nurbs::test::Random random(7);
  for (const char* label : {"N2", "N2-N2.2"}) {
    // Soft against slip, so that points stick to elements that are far behind.
    Scene<2> scene = ironing(label);
    scene.contacts[0].method.law.tangential = 1;
    Bench bench(scene), fresh(scene);
    const int die = bench.unknowns.offset(1);
    VectorX u = VectorX::Zero(bench.unknowns.dofs());
    for (int state = 0; state < 60; ++state) {
      const double x = nurbs::test::uniform(random, -0.5, 1.2), y = nurbs::test::uniform(random, -0.05, 0.005);
      for (int i = 0; i < die; i += 2) u.segment<2>(i) << x, y;
      for (int i = die; i < u.size(); ++i) u(i) = nurbs::test::uniform(random, -2e-3, 2e-3);
      bench.residual(u);
      fresh.system.assembly.forget_contacts();
      fresh.residual(u);
      const MatrixX expected = fresh.tangent();
      EXPECT_LT((bench.tangent() - expected).norm(), 1e-12 * expected.norm()) << label << " " << state;
      if (state % 2 == 0) continue;
      bench.accept();
      fresh.accept();
    }
  }
}

TEST(Assembly, InvertedElementNamesItsBody) {
  Bench bench(ironing("N2"));
  VectorX u = VectorX::Zero(bench.unknowns.dofs());
  const auto& slab = *bench.system.scene.bodies[1].body;
  for (int a : slab.space().face_functions(nurbs::side_of("south", 2))) u(bench.unknowns.offset(1) + 2 * a + 1) = 0.9;
  const auto inverted = bench.assemble(u);
  ASSERT_TRUE(inverted);
  EXPECT_EQ(inverted->body, 1);
  EXPECT_LT(inverted->inversion.point(1), 1.0 / 3);
}

} // namespace assembly_test
} // namespace signorini::model
