// Layers in ranges of the contact face, and knots in the layer's rows only: counts, geometry, continuity, errors.
#include "nurbs/archive.hpp"
#include "nurbs/discretization.hpp"
#include "nurbs/random_patch.hpp"
#include "nurbs/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace signorini::nurbs {
namespace local_layers_test {

using Raised = std::vector<bool>;

/// The elements from … to − 1 of n.
Raised range(int n, int from, int to) {
  Raised result(n, false);
  std::fill(result.begin() + from, result.begin() + to, true);
  return result;
}

Plan plan_of(std::vector<int> elements, const std::string& label, std::vector<Side> contact) {
  Plan plan;
  plan.elements = std::move(elements);
  plan.labels.assign(plan.elements.size() - 1, parse_label(label));
  plan.contact = std::move(contact);
  plan.thickness_degree = 1;
  return plan;
}

/// The bulk row Np on n elements has p + n functions; each range adds q − p for its higher degree Nq, and s per
/// element for elevations; each cut adds one, s more if it is inside a range.
TEST(LocalLayers, CountsInThePlane) {
  const Patch slab = rectangle(3, 1, Eigen::Vector2d(0, 0));
  const int n = 12;
  for (const auto& [label, p, q, s] :
       {std::tuple{"N2-N2.2", 2, 2, 2}, {"N2-N4", 2, 4, 0}, {"N2-N3.1", 2, 3, 1}, {"N1-N2", 1, 2, 0}})
    for (const auto& [from, to] : {std::pair{0, 3}, {4, 9}, {11, 12}, {0, 12}, {5, 5}}) {
      Plan plan = plan_of({n, 2}, label, {{1, true}});
      plan.raised = {{range(n, from, to)}};
      const int ranges = to > from ? 1 : 0;
      const int row = p + n + ranges * (q - p) + (to - from) * s;
      EXPECT_EQ(Discretization(slab, plan).functions(), 2 * (p + n) + row) << label << " " << from << " " << to;
      plan.layer_knots = {{(4 + 1 / 3.0) / n, (4 + 2 / 3.0) / n, 11.5 / n}};
      const int inside = (from <= 4 && 4 < to ? 2 : 0) + (from <= 11 && 11 < to ? 1 : 0);
      const Discretization cut(slab, plan);
      EXPECT_EQ(cut.functions(), 2 * (p + n) + row + 3 + inside * s) << label << " " << from << " " << to;
      EXPECT_EQ(cut.elements(0), n + 3);
    }
  // Two ranges
  Plan plan = plan_of({n, 2}, "N2-N4", {{1, true}});
  plan.raised = {{Raised(n, false)}};
  for (int e : {1, 2, 7}) plan.raised[0][0][e] = true;
  EXPECT_EQ(Discretization(slab, plan).functions(), 2 * (2 + n) + 2 + n + 2 * 2);
  // Two faces, one of them raised everywhere
  plan = plan_of({n, 3}, "N2-N2.1", {{1, true}, {1, false}});
  plan.raised = {{range(n, 2, 5)}, {{}}};
  const Discretization two(slab, plan);
  EXPECT_EQ(two.rows().back().functions(), 2 + n + 3);
  EXPECT_EQ(two.rows().front().functions(), 2 + n + n);
  EXPECT_EQ(two.functions(), 4 * (2 + n) + 3 + n);
}

/// A row in space is the product of its two spaces: its degree is raised in the strips of both directions.
TEST(LocalLayers, CountsInSpace) {
  const Patch slab = block({10, 3, 2}, Eigen::Vector3d(0, 0, 0));
  const int n = 9, m = 6;
  Plan plan = plan_of({n, m, 2}, "N2-N2.2", {{2, true}});
  const auto strips = [](int count, int elements) { return 2 + count + 2 * elements; };
  plan.raised = {{range(n, 0, 9), range(m, 2, 4)}};
  EXPECT_EQ(Discretization(slab, plan).functions(), 2 * (2 + n) * (2 + m) + strips(n, 9) * strips(m, 2));
  plan.raised = {{range(n, 3, 5), range(m, 2, 4)}};
  plan.layer_knots = {{3.5 / n}, {}};
  const Discretization space(slab, plan);
  EXPECT_EQ(space.functions(), 2 * (2 + n) * (2 + m) + (strips(n, 2) + 1 + 2) * strips(m, 2));
  EXPECT_EQ(space.elements(0), n + 1);
  // Element 0 has the bulk's degree, 3 that of the layer in one direction, in the last element of the thickness.
  const auto degrees = [&](int i, int j, int k) {
    const int e = i + (n + 1) * (j + m * k);
    return std::array{space.degree(e, 0), space.degree(e, 1)};
  };
  EXPECT_EQ(degrees(0, 0, 1), (std::array{2, 2}));
  EXPECT_EQ(degrees(3, 0, 1), (std::array{4, 2}));
  EXPECT_EQ(degrees(4, 2, 1), (std::array{4, 4}));
  EXPECT_EQ(degrees(3, 2, 0), (std::array{2, 2}));
}

Plan random_plan(test::Random& random, const Patch& patch) {
  const int dimensions = patch.parametric_dimension();
  Plan plan;
  const int through = test::integer(random, 0, dimensions - 1);
  plan.contact.push_back({through, test::integer(random, 0, 1) == 1});
  if (test::integer(random, 0, 2) == 0) plan.contact.push_back({through, !plan.contact.front().at_end});
  plan.thickness_degree = patch.direction(through).degree() + test::integer(random, 0, 1);
  for (int d = 0; d < dimensions; ++d)
    plan.elements.push_back(patch.direction(d).elements() + test::integer(random, 0, 5));
  plan.raised.resize(plan.contact.size());
  for (int d = 0; d < dimensions; ++d) {
    if (d == through) continue;
    const int bulk = patch.direction(d).degree() + test::integer(random, 0, 1);
    plan.labels.push_back(
        parse_label(text("N", bulk, "-N", bulk + test::integer(random, 0, 2), ".", test::integer(random, 0, 2))));
    for (auto& face : plan.raised) {
      face.emplace_back();
      for (int e = 0; e < plan.elements[d]; ++e) face.back().push_back(test::integer(random, 0, 1) == 1);
    }
    const std::vector<double> breaks = element_breaks(patch, plan, d);
    plan.layer_knots.emplace_back();
    for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
      if (test::integer(random, 0, 3) == 0)
        plan.layer_knots.back().push_back(breaks[e] + test::uniform(random, 0.2, 0.8) * (breaks[e + 1] - breaks[e]));
  }
  return plan;
}

TEST(LocalLayers, GeometryPartitionSignAndFiles) {
  test::Random random(41);
  for (int trial = 0; trial < 100; ++trial) {
    const int dimensions = trial % 4 == 3 ? 3 : 2;
    const Patch patch = test::random_patch(random, dimensions, dimensions, dimensions == 3 ? 2 : 3);
    const Plan plan = random_plan(random, patch);
    const Discretization space(patch, plan);
    EXPECT_GT(space.homogeneous().bottomRows(1).minCoeff(), 0);
    const MatrixX points = space.points();
    for (int n = 0; n < 12; ++n) {
      const VectorX xi = test::random_parameter(random, patch);
      const ElementBasis basis = space.basis(space.find_element(xi), xi);
      EXPECT_NEAR(basis.values.sum(), 1, 1e-14);
      EXPECT_GE(basis.values.minCoeff(), 0);
      EXPECT_NEAR((basis.combine(points) - evaluate(patch, xi)).norm(), 0, 2e-13) << "trial " << trial;
    }
    ArchiveWriter to;
    to.put(space);
    ArchiveReader from(to.bytes());
    const auto read = from.get<Discretization>();
    EXPECT_EQ(read.homogeneous(), space.homogeneous());
    for (std::size_t j = 0; j < space.rows().size(); ++j)
      EXPECT_EQ(read.rows()[j].directions(), space.rows()[j].directions());
  }
}

/// A range that covers the face gives the layer's knots; without elements in it, the bulk's.
TEST(LocalLayers, WholeFaceAndNothing) {
  const Patch ring = quarter_annulus(0.5, 1, Eigen::Vector2d(0, 0), 20);
  Plan plan = plan_of({7, 2}, "N2-N2.2", {{1, false}}), bulk = plan_of({7, 2}, "N2", {{1, false}});
  const Discretization full(ring, plan), low(ring, bulk);
  plan.raised = {{range(7, 0, 7)}};
  EXPECT_EQ(Discretization(ring, plan).homogeneous(), full.homogeneous());
  EXPECT_EQ(Discretization(ring, plan).rows().front().direction(0), full.rows().front().direction(0));
  plan.raised = {{range(7, 3, 3)}};
  EXPECT_EQ(Discretization(ring, plan).homogeneous(), low.homogeneous());
}

/// Continuity is that of the lower degree at borders of a range, that of the label inside, infinite at cuts of the
/// other rows.
TEST(LocalLayers, Continuity) {
  Plan plan = plan_of({6, 2}, "N2-N4", {{1, true}});
  plan.raised = {{range(6, 1, 4)}};
  plan.layer_knots = {{1.5 / 6, 4.5 / 6}};
  const Discretization space(rectangle(3, 1, Eigen::Vector2d(0, 0)), plan);
  EXPECT_EQ(space.rows().back().direction(0).smoothness(), (std::vector{-1, 1, 3, 3, 3, 1, 1, 1, -1}));
  EXPECT_EQ(space.rows().front().direction(0).smoothness(), (std::vector{-1, 1, 2, 1, 1, 1, 2, 1, -1}));
  plan.labels = {parse_label("N2-N2.2")};
  const Discretization elevated(rectangle(3, 1, Eigen::Vector2d(0, 0)), plan);
  EXPECT_EQ(elevated.rows().back().direction(0).smoothness(), (std::vector{-1, 1, 1, 1, 1, 1, 1, 1, -1}));
  std::vector<int> degrees;
  for (int e = 0; e < 8; ++e) degrees.push_back(elevated.rows().back().direction(0).degree(e));
  EXPECT_EQ(degrees, (std::vector{2, 4, 4, 4, 4, 2, 2, 2}));
}

/// Knots of the contact row without a layer: B-splines of the same degree.
TEST(LocalLayers, KnotsAlone) {
  Plan plan = plan_of({4, 2}, "N2", {{1, true}});
  plan.layer_knots = {{0.1, 0.3, 0.9}};
  const Discretization space(rectangle(3, 1, Eigen::Vector2d(0, 0)), plan);
  EXPECT_EQ(space.functions(), 6 + 6 + 9);
  EXPECT_EQ(space.face({1, true}).direction(0), spline_space({2, {0, 0, 0, 0.1, 0.25, 0.3, 0.5, 0.75, 0.9, 1, 1, 1}}));
}

TEST(LocalLayers, ErrorsNameTheArgument) {
  const Patch slab = rectangle(3, 1, Eigen::Vector2d(0, 0));
  const auto fails = [&](const auto& change, const char* label, const std::string& message) {
    Plan plan = plan_of({4, 1}, label, {{1, true}});
    change(plan);
    EXPECT_ERROR(Discretization(slab, plan), message);
  };
  const auto raise = [](std::vector<std::vector<Raised>> raised) {
    return [raised](Plan& plan) { plan.raised = raised; };
  };
  fails(raise({{range(4, 1, 2)}}), "N2", "nurbs.body.raised_nowhere: label = N2");
  fails(raise({{range(4, 1, 2)}, {range(4, 1, 2)}}), "N2-N4", "nurbs.body.raised_faces: expected = 1, count = 2");
  fails(raise({{range(4, 1, 2), range(4, 1, 2)}}), "N2-N4", "nurbs.body.raised_directions: expected = 1, count = 2");
  fails(raise({{range(5, 1, 2)}}), "N2-N4", "nurbs.body.raised_elements: direction = 0, expected = 4, count = 5");
  const auto cut = [](std::vector<double> knots) { return [knots](Plan& plan) { plan.layer_knots = {knots}; }; };
  fails(cut({0.25}), "N2", "nurbs.body.layer_knot_present: knot = 0.25");
  fails(cut({0.3, 0.3}), "N2", "nurbs.body.layer_knot_twice: knot = 0.3");
  fails(cut({1}), "N2", "nurbs.body.layer_knot_outside: knot = 1, first = 0, last = 1");
  fails(cut({0.3}), "L2", "nurbs.body.layer_knots_lagrange: label = L2");
  fails([](Plan& plan) { plan.layer_knots = {{}, {}}; }, "N2", "nurbs.body.layer_knots: expected = 1, count = 2");
  fails([](Plan& plan) { plan.labels.assign(2, plan.labels[0]), plan.contact = {}, plan.layer_knots = {{0.3}}; }, "N2",
        "nurbs.body.layer_knots_nowhere");
}

} // namespace local_layers_test
} // namespace signorini::nurbs
