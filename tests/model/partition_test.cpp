#include "model/system/partition.hpp"

#include "bench.hpp"
#include "nurbs/plan.hpp"
#include "os/parallel.hpp"
#include "scenes.hpp"

#include <set>

namespace signorini::model {
namespace partition_test {

using namespace test;

/// A strip whose east face rotates, so that its control points share unknowns.
Scene<2> strip(std::vector<int> elements, const std::string& label, const std::string& contact) {
  Scene<2> scene;
  scene.bodies.push_back({"strip", make_body(nurbs::rectangle(8, 1, Eigen::Vector2d(0, 0)), std::move(elements), label,
                                             contact, solid::neo_hookean(1, 0.3))});
  scene.supports.push_back({"wall", {face_points(scene, 0, "west")}, {Constraint::fixed, Constraint::fixed}});
  scene.supports.push_back(
      {"edge", {face_points(scene, 0, "east")}, {Constraint::free, Constraint::free}, {}, true, {8, 0.5}});
  return scene;
}

/// A block whose back rotates about an axis that moves all its points.
Scene<3> block(std::vector<int> elements, const std::string& label, const std::string& contact) {
  Scene<3> scene;
  const auto space = std::make_shared<const nurbs::Discretization>(
      nurbs::block({3, 2, 1}, Eigen::Vector3d(0, 0, 0)), nurbs::test::plan_of(std::move(elements), contact, label, 1));
  scene.bodies.push_back({"block", std::make_shared<const solid::Body<3>>(space, solid::neo_hookean(1, 0.3))});
  Support<3> grip{"grip",
                  {{0, space->face_functions(nurbs::side_of("back", 3))}},
                  {Constraint::free, Constraint::free, Constraint::free}};
  grip.rotates = true;
  grip.center = {1.5, 1, 1};
  grip.axis = {0, 0, 1};
  scene.supports.push_back(grip);
  return scene;
}

/// Degrees of freedom of elements, and their unknowns as negative numbers.
template <int D>
std::set<int> reach(const Scene<D>& scene, const Unknowns<D>& unknowns, const std::vector<int>& elements) {
  std::set<int> all;
  for (int e : elements)
    for (int function : scene.bodies[0].body->tables().functions_of(e))
      for (int c = 0; c < D; ++c) {
        all.insert(D * function + c);
        if (const int i = unknowns.unknown(D * function + c); i >= 0) all.insert(-1 - i);
      }
  return all;
}

template <int D> void expect_apart_and_whole(const Scene<D>& scene, std::size_t shares, const std::string& what) {
  const Unknowns<D> unknowns(scene);
  const solid::Body<D>& body = *scene.bodies[0].body;
  const Partition parts = partition(unknowns, body, 0);
  EXPECT_EQ(parts.heads.size(), shares) << what;
  ASSERT_EQ(parts.heads.size(), parts.tails.size()) << what;
  std::vector<int> times(static_cast<std::size_t>(body.elements()), 0);
  for (const auto* lists : {&parts.heads, &parts.tails}) {
    std::set<int> taken;
    for (std::size_t share = 0; share < lists->size(); ++share) {
      const std::vector<int>& elements = (*lists)[share];
      for (int one : reach(scene, unknowns, elements)) EXPECT_TRUE(taken.insert(one).second) << what;
      for (int e : elements) {
        ++times[e];
        EXPECT_EQ(parts.share[e], static_cast<int>(share)) << what;
      }
    }
  }
  EXPECT_FALSE(parts.rest.empty()) << what; // at the rotating face
  for (int e : parts.rest) ++times[e];
  for (int n : times) ASSERT_EQ(n, 1) << what;
}

TEST(Partition, SharesAreDisjointAndContainEveryElementOnce) {
  expect_apart_and_whole(strip({40, 8}, "N2", "south"), 4, "40x8");
  expect_apart_and_whole(strip({80, 4}, "N2-N2.2", "south"), 4, "80x4");
  expect_apart_and_whole(strip({300, 1}, "N4", "north"), 4, "300x1");
  expect_apart_and_whole(strip({20, 16}, "N2-N4", "west"), 4, "20x16");
  expect_apart_and_whole(block({16, 6, 3}, "N2", "front"), 4, "16x6x3");
  expect_apart_and_whole(block({6, 16, 3}, "N2-N2.2", "front"), 4, "6x16x3");
  expect_apart_and_whole(block({7, 7, 6}, "N2-N4", "west"), 4, "7x7x6");
}

/// Time of two threads, in elements, if each free thread takes the next task.
int on_two(const std::vector<std::vector<int>>& tasks) {
  int busy[2] = {0, 0};
  for (const auto& task : tasks) busy[busy[0] <= busy[1] ? 0 : 1] += static_cast<int>(task.size());
  return std::max(busy[0], busy[1]);
}

TEST(Partition, TwoThreadsHalveTheTimeForAnyShape) {
  struct Case {
    std::vector<int> elements;
    const char* label;
  };
  for (const Case& c : {Case{{36, 12, 8}, "N2"}, Case{{12, 36, 4}, "N2-N2.2"}, Case{{20, 20, 2}, "N4"},
                        Case{{16, 16, 3}, "N2"}, Case{{8, 8, 16}, "N2-N2.2"}}) {
    Scene<3> scene = block(c.elements, c.label, "front");
    scene.supports[0].rotates = false;
    scene.supports[0].constraint = {Constraint::fixed, Constraint::fixed, Constraint::fixed};
    const Partition parts = partition(Unknowns<3>(scene), *scene.bodies[0].body, 0);
    EXPECT_TRUE(parts.rest.empty());
    const double elements = scene.bodies[0].body->elements();
    EXPECT_GE(elements / (on_two(parts.heads) + on_two(parts.tails)), 1.9)
        << c.elements[0] << "x" << c.elements[1] << "x" << c.elements[2] << " " << c.label;
  }
}

TEST(Partition, FewElementsAreNotDivided) {
  const Scene<2> scene = strip({8, 3}, "N2", "south");
  const Partition parts = partition(Unknowns<2>(scene), *scene.bodies[0].body, 0);
  ASSERT_EQ(parts.heads.size(), 1u);
  EXPECT_EQ(parts.heads[0].size(), 24u);
  EXPECT_TRUE(parts.tails[0].empty());
  EXPECT_TRUE(parts.rest.empty());
}

/// Residual, product and tangent of a state, on a number of threads.
template <int D> std::vector<double> added_up(const Scene<D>& scene, int threads) {
  set_worker_threads(threads);
  nurbs::test::Random random(5);
  System<D> system(scene);
  const Unknowns<D>& unknowns = system.unknowns;
  const auto any = [&](double size) {
    return VectorX(VectorX::NullaryExpr(unknowns.dofs(), [&] { return nurbs::test::uniform(random, -size, size); }));
  };
  State<D> state = system.start();
  state.displacement = any(0.005);
  const VectorX direction = any(1);
  Timings timings;
  EXPECT_FALSE(system.assembly.assemble({state, state, {}, state.targets}, &direction, true, timings));
  set_worker_threads(1);
  const Assembly<D>& assembly = system.assembly;
  std::vector<double> all(state.force.begin(), state.force.end());
  all.insert(all.end(), assembly.product().begin(), assembly.product().end());
  all.insert(all.end(), assembly.tangent().values.begin(),
             assembly.tangent().values.begin() + assembly.tangent().pattern.entries());
  return all;
}

TEST(Partition, ResidualAndTangentAreBitwiseEqualForAnyNumberOfThreads) {
  const Scene<2> plane = strip({40, 8}, "N2-N2.1", "south");
  const Scene<3> space = block({16, 6, 3}, "N2-N2.1", "front");
  const std::vector<double> in_plane = added_up(plane, 1), in_space = added_up(space, 1);
  for (int threads : {2, 3}) {
    EXPECT_TRUE(added_up(plane, threads) == in_plane) << threads;
    EXPECT_TRUE(added_up(space, threads) == in_space) << threads;
  }
}

} // namespace partition_test
} // namespace signorini::model
