// Rows with different spaces: exact geometry, partition of unity, gradients, continuity, faces, errors.
#include "nurbs/discretization.hpp"

#include "nurbs/basis_grid.hpp"
#include "nurbs/plan.hpp"
#include "nurbs/random_patch.hpp"
#include "nurbs/shapes.hpp"

#include <gtest/gtest.h>

#include <set>

namespace signorini::nurbs {
namespace discretization_test {

/// A random label for a direction of the geometry's degree, with or without a layer.
Label random_label(test::Random& random, int degree, bool layered, int rows) {
  const int bulk = degree + test::integer(random, 0, 1);
  if (!layered) return parse_label(text("N", bulk, ".", test::integer(random, 0, 2)));
  const int layer = bulk + test::integer(random, 0, 2);
  return parse_label(text("N", bulk, "-N", layer, ".", test::integer(random, 0, 2), "x", rows));
}

/// Layers on any face or on two opposite ones, 1 to 3 rows deep if there are enough rows.
Plan random_plan(test::Random& random, const Patch& patch) {
  const int dimensions = patch.parametric_dimension();
  Plan plan;
  const int through = test::integer(random, 0, dimensions - 1);
  const int faces = test::integer(random, 1, 2);
  const bool at_end = test::integer(random, 0, 1) == 1;
  plan.contact.push_back({through, at_end});
  if (faces == 2) plan.contact.push_back({through, !at_end});
  plan.thickness_degree = patch.direction(through).degree() + test::integer(random, 0, 1);
  const bool layered = test::integer(random, 0, 4) > 0;
  for (int d = 0; d < dimensions; ++d)
    plan.elements.push_back(patch.direction(d).elements() + test::integer(random, 0, 3));
  const int most = std::min(3, plan.elements[through] + *plan.thickness_degree);
  const int rows = test::integer(random, 1, most);
  for (int d = 0; d < dimensions; ++d)
    if (d != through) plan.labels.push_back(random_label(random, patch.direction(d).degree(), layered, rows));
  return plan;
}

VectorX position(const Discretization& space, const ElementBasis& basis) {
  const MatrixX points = space.points();
  VectorX x = VectorX::Zero(space.dimension());
  for (std::size_t a = 0; a < basis.functions.size(); ++a)
    x += basis.values(static_cast<int>(a)) * points.col(basis.functions[a]);
  return x;
}

TEST(BasisGrid, ReturnsTheFunctionsOfTheDiscretizationBitByBit) {
  test::Random random(8);
  for (int trial = 0; trial < 40; ++trial) {
    const int dimensions = trial % 3 == 2 ? 3 : 2;
    const Patch patch = test::random_patch(random, dimensions, dimensions, 2);
    const Discretization space(patch, random_plan(random, patch));
    BasisGrid grid(space);
    ElementBasis found;
    for (int e = 0; e < space.elements(); ++e) {
      // Rows of a layer have more points along the face, so that tables of several numbers of points are needed.
      std::vector<std::vector<double>> points;
      for (int d = 0; d < dimensions; ++d) {
        const auto [from, to] = space.interval(e, d);
        const int count = space.degree(e, d) + 1;
        points.emplace_back();
        for (int q = 0; q < count; ++q) points.back().push_back(from + (to - from) * (q + 0.3) / count);
      }
      grid.choose(e, points);
      for (int n = 0; n < 4; ++n) {
        std::array<int, 3> point{};
        VectorX xi(dimensions);
        for (int d = 0; d < dimensions; ++d) {
          point[d] = test::integer(random, 0, static_cast<int>(points[d].size()) - 1);
          xi(d) = points[d][point[d]];
        }
        const ElementBasis expected = space.basis(e, xi);
        grid.evaluate(point, found);
        ASSERT_EQ(found.functions, expected.functions);
        EXPECT_EQ(found.values, expected.values);
        EXPECT_EQ(found.gradients, expected.gradients);
      }
    }
  }
}

TEST(Discretization, RandomLayersPreserveGeometryPartitionAndSign) {
  test::Random random(5);
  for (int trial = 0; trial < 120; ++trial) {
    const int dimensions = trial % 4 == 3 ? 3 : 2;
    const Patch patch = test::random_patch(random, dimensions, dimensions, dimensions == 3 ? 2 : 3);
    const Discretization space(patch, random_plan(random, patch));
    for (int n = 0; n < 12; ++n) {
      const VectorX xi = test::random_parameter(random, patch);
      const ElementBasis basis = space.basis(space.find_element(xi), xi);
      EXPECT_NEAR(basis.values.sum(), 1, 1e-14);
      EXPECT_GE(basis.values.minCoeff(), 0);
      EXPECT_NEAR((position(space, basis) - evaluate(patch, xi)).norm(), 0, 1e-13) << "trial " << trial;
      EXPECT_NEAR(basis.gradients.rowwise().sum().norm(), 0, 1e-11);
      const std::set<int> distinct(basis.functions.begin(), basis.functions.end());
      EXPECT_EQ(distinct.size(), basis.functions.size());
    }
  }
}

TEST(Discretization, GradientsMatchFiniteDifferences) {
  test::Random random(6);
  for (int trial = 0; trial < 40; ++trial) {
    const int dimensions = trial % 4 == 3 ? 3 : 2;
    const Patch patch = test::random_patch(random, dimensions, dimensions, dimensions == 3 ? 2 : 3);
    const Discretization space(patch, random_plan(random, patch));
    for (int n = 0; n < 4; ++n) {
      const int e = test::integer(random, 0, space.elements() - 1);
      VectorX xi(dimensions);
      for (int d = 0; d < dimensions; ++d) {
        const auto [a, b] = space.interval(e, d);
        xi(d) = a + (b - a) * test::uniform(random, 0.2, 0.8);
      }
      const ElementBasis basis = space.basis(e, xi);
      EXPECT_EQ(space.find_element(xi), e);
      for (int d = 0; d < dimensions; ++d) {
        const auto [a, b] = space.interval(e, d);
        const double h = 1e-3 * (b - a);
        const auto value = [&](double step) {
          VectorX moved = xi;
          moved(d) += step;
          return space.basis(e, moved).values;
        };
        // Central differences, with the h² and h⁴ terms eliminated by extrapolation
        const auto central = [&](double step) { return VectorX((value(step) - value(-step)) / (2 * step)); };
        const VectorX once = (4 * central(h / 2) - central(h)) / 3, twice = (4 * central(h) - central(2 * h)) / 3;
        const VectorX slope = (16 * once - twice) / 15;
        EXPECT_NEAR((slope - basis.gradients.row(d).transpose()).norm(), 0, 1e-9 * (1 + basis.gradients.norm()));
      }
    }
  }
}

/// Existing knots keep their continuity: k-refinement and elevation raise multiplicities with the degree; inserted
/// knots have multiplicity 1+s.
TEST(Discretization, ContinuityAtExistingAndInsertedKnots) {
  test::Random random(7);
  for (int trial = 0; trial < 60; ++trial) {
    const Patch patch = test::random_patch(random, 2, 2, 3);
    const Plan plan = random_plan(random, patch);
    const Discretization space(patch, plan);
    const int along = 1 - space.through(), own = patch.direction(along).degree();
    const Label& label = plan.labels.front();
    const int count = space.stack().functions();
    for (int j = 0; j < count; ++j) {
      bool in_layer = false;
      for (const Side& side : plan.contact) in_layer |= (side.at_end ? count - 1 - j : j) < label.rows;
      const Space wanted = label.layer && in_layer ? *label.layer : label.bulk;
      const KnotVector& row = *space.rows()[j].direction(0).knots();
      EXPECT_EQ(row.degree(), wanted.full_degree());
      EXPECT_EQ(row.breaks(), space.rows().front().direction(0).breaks());
      for (std::size_t k = 1; k + 1 < row.breaks().size(); ++k) {
        const double knot = row.breaks()[k];
        const int before = patch.direction(along).multiplicity(knot);
        EXPECT_EQ(row.multiplicity(knot), before > 0 ? before + wanted.full_degree() - own : 1 + wanted.elevations);
      }
    }
    EXPECT_EQ(space.stack().degree(), *plan.thickness_degree);
    EXPECT_EQ(space.elements(0), plan.elements[0]);
    EXPECT_EQ(space.elements(1), plan.elements[1]);
  }
}

/// Direct evaluation of thesis (5.1), (5.2): the k-refined bulk patch with the functions of its first row replaced by
/// those of the face's curve on the layer's knots, B-splines by the Cox–de Boor recursion, one common weight function.
TEST(Discretization, AgreesWithTheThesisOnADie) {
  test::Random random(8);
  const Patch die = half_annulus(0.3, 0.5, Eigen::Vector2d(0.75, 1.5));
  const Discretization space(die, test::plan_of({6, 2}, "south", "N2-N2.2", 1));

  const std::vector<double> inserted{1.0 / 6, 1.0 / 3, 2.0 / 3, 5.0 / 6};
  const Patch bulk = k_refine(k_refine(die, 0, 2, inserted), 1, 1, {0.5});
  const Patch layer = elevate(k_refine(face(die, side_of("south", 2)), 0, 2, inserted), 0, 2);
  const int n = layer.functions(), width = bulk.direction(0).functions();
  ASSERT_EQ(space.functions(), n + 2 * width);
  for (int trial = 0; trial < 200; ++trial) {
    const VectorX xi = test::random_parameter(random, die);
    VectorX values(space.functions());
    for (int i = 0; i < n; ++i)
      values(i) = layer.weights()(i) * test::cox_de_boor(layer.direction(0), i, 4, xi(0)) *
                  test::cox_de_boor(bulk.direction(1), 0, 1, xi(1));
    for (int j = 1; j < 3; ++j)
      for (int i = 0; i < width; ++i)
        values(n + (j - 1) * width + i) = bulk.weights()(j * width + i) *
                                          test::cox_de_boor(bulk.direction(0), i, 2, xi(0)) *
                                          test::cox_de_boor(bulk.direction(1), j, 1, xi(1));
    values /= values.sum();
    const ElementBasis basis = space.basis(space.find_element(xi), xi);
    for (std::size_t a = 0; a < basis.functions.size(); ++a) {
      EXPECT_NEAR(basis.values(static_cast<int>(a)), values(basis.functions[a]), 1e-13);
      values(basis.functions[a]) = 0;
    }
    EXPECT_NEAR(values.norm(), 0, 1e-15) << "functions left out";
  }
  EXPECT_NEAR((space.points().leftCols(n) - layer.points()).norm(), 0, 1e-13);
}

TEST(Discretization, LayerOfAllRowsIsTheUniformlyElevatedSpace) {
  test::Random random(9);
  const Patch patch = quarter_annulus(0.5, 1, Eigen::Vector2d(0, 0), 20);
  const auto make = [&](const char* label) { return Discretization(patch, test::plan_of({5, 3}, "south", label, 1)); };
  const Discretization layered = make("N2-N2.1x4"), uniform = make("N2.1");
  ASSERT_EQ(layered.functions(), uniform.functions());
  EXPECT_NEAR((layered.homogeneous() - uniform.homogeneous()).norm(), 0, 1e-14);
  for (int n = 0; n < 50; ++n) {
    const VectorX xi = test::random_parameter(random, patch);
    const int e = layered.find_element(xi);
    EXPECT_EQ(layered.basis(e, xi).functions, uniform.basis(e, xi).functions);
    EXPECT_NEAR((layered.basis(e, xi).values - uniform.basis(e, xi).values).norm(), 0, 1e-14);
    EXPECT_EQ(layered.degree(e, 0), 3);
  }
}

TEST(Discretization, ElementDegreesRiseOnlyInTheLayer) {
  const Discretization space(rectangle(2, 1, Eigen::Vector2d(0, 0)), test::plan_of({4, 5}, "north", "N2-N4.1x2", 1));
  // Two layer rows of linear functions in the thickness direction: their support is the last two element rows.
  for (int e = 0; e < space.elements(); ++e) {
    EXPECT_EQ(space.degree(e, 0), e / 4 >= 3 ? 5 : 2) << "element " << e;
    EXPECT_EQ(space.degree(e, 1), 1);
  }
}

/// The functions of a side are those that do not vanish on it, and its patch is the body's map there.
TEST(Discretization, FacesAreTheBoundaryOfTheBody) {
  test::Random random(10);
  for (int trial = 0; trial < 40; ++trial) {
    const int dimensions = trial % 2 == 0 ? 2 : 3;
    const Patch patch = test::random_patch(random, dimensions, dimensions, 2);
    Plan plan = random_plan(random, patch);
    for (Label& label : plan.labels) label.layer.reset();
    const Discretization space(patch, plan);
    for (int d = 0; d < dimensions; ++d)
      for (bool at_end : {false, true}) {
        const Side side{d, at_end};
        const Patch border = test::patch_of(space.face(side));
        const std::vector<int> functions = space.face_functions(side);
        ASSERT_EQ(border.functions(), static_cast<int>(functions.size()));
        for (int n = 0; n < 3; ++n) {
          VectorX xi = test::random_parameter(random, patch);
          xi(d) = at_end ? patch.direction(d).last() : patch.direction(d).first();
          VectorX on_face(dimensions - 1);
          for (int k = 0, i = 0; k < dimensions; ++k)
            if (k != d) on_face(i++) = xi(k);
          EXPECT_NEAR((evaluate(border, on_face) - evaluate(patch, xi)).norm(), 0, 1e-13);
          // The body's functions on the side equal the face's, one by one.
          VectorX expected = VectorX::Zero(space.functions());
          for (const BasisValue& basis : rational_basis(border, on_face))
            expected(functions[basis.function]) = basis.value;
          VectorX found = VectorX::Zero(space.functions());
          const ElementBasis basis = space.basis(space.find_element(xi), xi);
          for (std::size_t a = 0; a < basis.functions.size(); ++a)
            found(basis.functions[a]) = basis.values(static_cast<int>(a));
          EXPECT_NEAR((found - expected).norm(), 0, 1e-13) << name_of(side) << " trial " << trial;
        }
      }
  }
}

TEST(Discretization, WithoutContactFaceLabelsApplyPerDirection) {
  Plan plan;
  plan.elements = {3, 2};
  plan.labels = {parse_label("N2"), parse_label("N3.1")};
  const Discretization space(rectangle(3, 1, Eigen::Vector2d(0, 0)), plan);
  // N2 has 3+2 functions; N3.1 has degree 4 and one double knot: 2·4+1−2
  EXPECT_EQ(space.functions(), 5 * 7);
  EXPECT_EQ(space.face(side_of("east", 2)).functions(), 7);
  EXPECT_EQ(space.face(side_of("north", 2)).functions(), 5);
}

/// Unless set, the degree in the thickness direction is that of the bulk, as without a contact face.
TEST(Discretization, ThicknessDirectionHasTheBulkDegree) {
  const auto through = [](const Patch& patch, const std::vector<std::string>& labels, const char* contact) {
    Plan plan;
    plan.elements.assign(patch.parametric_dimension(), 3);
    plan.contact = {side_of(contact, patch.parametric_dimension())};
    for (const std::string& label : labels) plan.labels.push_back(parse_label(label));
    const Space1D stack = Discretization(patch, plan).stack();
    return std::array{stack.degree(), stack.functions()};
  };
  using Pair = std::array<int, 2>; // degree, functions
  const Patch slab = rectangle(3, 1, Eigen::Vector2d(0, 0)), ring = half_annulus(0.3, 0.5, Eigen::Vector2d(0, 0));
  EXPECT_EQ(through(slab, {"N1"}, "north"), (Pair{1, 4}));
  EXPECT_EQ(through(slab, {"N2"}, "north"), (Pair{2, 5}));
  EXPECT_EQ(through(slab, {"N2-N4"}, "north"), (Pair{2, 5}));
  EXPECT_EQ(through(slab, {"N2-N2.2"}, "north"), (Pair{2, 5}));
  EXPECT_EQ(through(slab, {"N2.1"}, "north"), (Pair{3, 8})); // two double knots
  EXPECT_EQ(through(slab, {"L2"}, "north"), (Pair{2, 7}));
  EXPECT_EQ(through(block({1, 1, 1}, Eigen::Vector3d(0, 0, 0)), {"N2", "N3-N4"}, "back"), (Pair{3, 6}));
  EXPECT_EQ(through(ring, {"N1"}, "west")[0], 2); // of the geometry
}

TEST(Discretization, SideAcrossALayerIsNotAPatchInSpace) {
  const Discretization space(block({1, 1, 1}, Eigen::Vector3d(0, 0, 0)), test::plan_of({2, 2, 2}, "back", "N2-N4", 1));
  EXPECT_ERROR(space.face(side_of("west", 3)), "nurbs.body.face_across_layer: face = west, contact = back");
  // Supports need its functions nevertheless: 4 control points in each of two rows, 6 in the layer's.
  EXPECT_EQ(space.face_functions(side_of("west", 3)).size(), 4u + 4u + 6u);
}

TEST(Discretization, ErrorsNameTheArgument) {
  const Patch slab = rectangle(3, 1, Eigen::Vector2d(0, 0));
  const auto plan = [](std::vector<int> elements, std::vector<std::string> labels, std::vector<std::string> contact) {
    Plan result;
    result.elements = std::move(elements);
    for (const auto& label : labels) result.labels.push_back(parse_label(label));
    for (const auto& face : contact) result.contact.push_back(side_of(face, 2));
    result.thickness_degree = 1;
    return result;
  };
  const auto build = [&](const Plan& wanted) { Discretization(slab, wanted); };
  EXPECT_ERROR(build(plan({3}, {"N2"}, {"north"})), "nurbs.body.elements: expected = 2, count = 1");
  EXPECT_ERROR(build(plan({0, 1}, {"N2"}, {"north"})), "nurbs.grading.elements: elements = 0, least = 1");
  EXPECT_ERROR(build(plan({3, 1}, {"N2"}, {"north", "west"})),
               "nurbs.body.contact_meets: first = north, second = west");
  EXPECT_ERROR(build(plan({3, 1}, {"N2"}, {"north", "north"})), "nurbs.body.contact_twice: face = north");
  EXPECT_ERROR(build(plan({3, 1}, {"N2"}, {"north", "south", "north"})), "nurbs.body.contact_count: count = 3");
  EXPECT_ERROR(build(plan({3, 1}, {"N2", "N2"}, {"north"})), "nurbs.body.labels: expected = 1, count = 2");
  EXPECT_ERROR(build(plan({3, 1}, {"N2"}, {})), "nurbs.body.labels: expected = 2, count = 1");
  EXPECT_ERROR(build(plan({3, 1}, {"N2", "L2"}, {})), "nurbs.body.mixed_labels: first = N2, second = L2");
  EXPECT_ERROR(build(plan({3, 1}, {"N2-N4", "N2-N4"}, {})), "nurbs.body.layer_nowhere: label = N2-N4");
  EXPECT_ERROR(build(plan({3, 2}, {"N2-N4x4"}, {"north"})),
               "nurbs.body.layer_too_deep: label = N2-N4x4, rows = 4, available = 3");
  Plan graded = plan({3, 1}, {"N2"}, {"north"});
  graded.grading.resize(1);
  EXPECT_ERROR(build(graded), "nurbs.body.grading: expected = 2, count = 1");
  Plan lowered = plan({3, 1}, {"N2"}, {"north"});
  lowered.thickness_degree = 0;
  EXPECT_ERROR(build(lowered), "nurbs.body.thickness_degree: degree = 0, lowest = 1");
  EXPECT_ERROR(Discretization(half_annulus(0.3, 0.5, Eigen::Vector2d(0, 0)), plan({6, 2}, {"N1"}, {"south"})),
               "nurbs.body.degree: label = N1, degree = 1, lowest = 2");
  const Patch arc = face(half_annulus(0.3, 0.5, Eigen::Vector2d(0, 0)), side_of("south", 2));
  EXPECT_ERROR(Discretization(arc, plan({6}, {"N2"}, {})), "nurbs.body.surface: directions = 1");
  const Discretization space(slab, plan({3, 2}, {"N2"}, {"north"}));
  EXPECT_ERROR(space.find_element(Eigen::Vector2d(0.5, 1.5)), "1.5");
}

} // namespace discretization_test
} // namespace signorini::nurbs
