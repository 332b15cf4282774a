#include "model/partition.hpp"

#include "base/parallel.hpp"
#include "bench.hpp"
#include "scenes.hpp"

#include <set>

namespace signorini::model {
namespace {

using namespace test;

/// A strip whose east face rotates, so that its control points share unknowns.
Scene<2> strip(std::vector<int> elements, const std::string& label, const std::string& contact) {
  Scene<2> scene;
  scene.bodies.push_back({"strip", make_body(nurbs::rectangle(8, 1, Eigen::Vector2d(0, 0)), std::move(elements), label,
                                             contact, solid::neo_hookean(1, 0.3))});
  scene.supports.push_back({"wall", {held(scene, 0, "west")}, {Hold::fixed, Hold::fixed}});
  scene.supports.push_back({"edge", {held(scene, 0, "east")}, {Hold::free, Hold::free}, {}, true, {8, 0.5}});
  return scene;
}

/// Everything that an element adds to: its degrees of freedom, and its unknowns as negative numbers.
std::set<int> reach(const Scene<2>& scene, const Unknowns<2>& unknowns, int first, int last,
                    const std::vector<char>& in_rest) {
  std::set<int> all;
  for (int e = first; e < last; ++e)
    for (int function : scene.bodies[0].body->functions_of(e))
      for (int c = 0; c < 2 && !in_rest[static_cast<std::size_t>(e)]; ++c) {
        all.insert(2 * function + c);
        if (const int i = unknowns.unknown(2 * function + c); i >= 0) all.insert(-1 - i);
      }
  return all;
}

TEST(Partition, SharesMeetNoneOfTheirNeighboursAndHoldEveryElementOnce) {
  struct Case {
    std::vector<int> elements;
    const char *label, *contact;
  };
  for (const Case& c : {Case{{40, 8}, "N2", "south"}, Case{{80, 4}, "N2-N2.2", "south"}, Case{{300, 1}, "N4", "north"},
                        Case{{20, 16}, "N2-N4", "west"}}) {
    const Scene<2> scene = strip(c.elements, c.label, c.contact);
    const Unknowns<2> unknowns(scene);
    const Partition parts = partition(unknowns, *scene.bodies[0].body, 0);
    ASSERT_GT(parts.heads.size(), 1u) << c.label;
    std::vector<int> times(static_cast<std::size_t>(scene.bodies[0].body->elements()), 0);
    for (const auto* ranges : {&parts.heads, &parts.tails}) {
      std::set<int> taken;
      for (const ElementRange& range : *ranges) {
        const std::set<int> own = reach(scene, unknowns, range.first, range.last, parts.in_rest);
        for (int what : own) EXPECT_TRUE(taken.insert(what).second) << c.label;
        for (int e = range.first; e < range.last; ++e)
          times[static_cast<std::size_t>(e)] += parts.in_rest[static_cast<std::size_t>(e)] == 0;
      }
    }
    EXPECT_FALSE(parts.rest.empty()); // the face that rotates
    for (int e : parts.rest) ++times[static_cast<std::size_t>(e)];
    for (int n : times) ASSERT_EQ(n, 1) << c.label;
  }
}

TEST(Partition, AFewElementsStayTogether) {
  const Scene<2> scene = strip({8, 3}, "N2", "south");
  const Partition parts = partition(Unknowns<2>(scene), *scene.bodies[0].body, 0);
  ASSERT_EQ(parts.heads.size(), 1u);
  EXPECT_EQ(parts.heads[0].last, 24);
}

TEST(Partition, ResidualAndTangentAreTheSameBitsForAnyNumberOfThreads) {
  nurbs::test::Random random(5);
  std::vector<double> residual, values;
  VectorX u, direction;
  for (int threads : {1, 2, 3}) {
    set_worker_threads(threads);
    Bench bench(strip({40, 8}, "N2-N2.1", "south"));
    if (u.size() == 0) {
      u = VectorX::NullaryExpr(bench.unknowns.dofs(), [&] { return nurbs::test::uniform(random, -0.01, 0.01); });
      direction = VectorX::NullaryExpr(u.size(), [&] { return nurbs::test::uniform(random, -1, 1); });
    }
    const VectorX r = bench.residual(u, &direction);
    std::vector<double> now(r.begin(), r.end());
    now.insert(now.end(), bench.assembly.product().begin(), bench.assembly.product().end());
    const auto& all = bench.assembly.values();
    const std::vector<double> entries(all.begin(), all.begin() + bench.assembly.pattern().entries());
    if (threads == 1) {
      residual = now;
      values = entries;
    }
    EXPECT_TRUE(now == residual) << threads;
    EXPECT_TRUE(entries == values) << threads;
  }
  set_worker_threads(1);
}

} // namespace
} // namespace signorini::model
