#include "nurbs/refine.hpp"

#include "random_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::nurbs {
namespace refine_test {

using namespace test;

/// The largest distance of two patches' maps at random parameters, including the knots.
double distance(const Patch& a, const Patch& b, Random& random) {
  double worst = 0;
  for (int i = 0; i < 20; ++i) {
    VectorX xi = random_parameter(random, a);
    if (i % 4 == 0) {
      const auto& breaks = b.direction(0).breaks();
      xi(0) = breaks[static_cast<std::size_t>(i / 4) % breaks.size()];
    }
    worst = std::max(worst, (evaluate(a, xi) - evaluate(b, xi)).norm());
  }
  return worst;
}

std::vector<double> numbers(std::initializer_list<double> values) {
  return values;
}

void expect_near(const std::vector<double>& got, const std::vector<double>& expected) {
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], expected[i], 1e-14) << "knot " << i;
}

TEST(InsertKnots, PreservesTheMap) {
  Random random(11);
  for (int run = 0; run < 60; ++run) {
    const int parametric = 1 + run % 3, d = integer(random, 0, parametric - 1);
    const Patch patch = random_patch(random, parametric, 3);
    const KnotVector& old = patch.direction(d);
    // New knots with repetitions, and existing ones up to their full multiplicity.
    std::vector<double> knots;
    for (int i = integer(random, 0, 5); i > 0; --i)
      knots.insert(knots.end(), static_cast<std::size_t>(integer(random, 1, old.degree())), uniform(random, -1, 3));
    for (int e = 1; e < old.elements(); ++e) {
      const double knot = old.breaks()[e];
      knots.insert(knots.end(), static_cast<std::size_t>(old.degree() - old.multiplicity(knot)), knot);
    }
    const Patch refined = insert_knots(patch, d, knots);
    EXPECT_EQ(refined.direction(d).functions(), old.functions() + static_cast<int>(knots.size()));
    EXPECT_LT(distance(patch, refined, random), 1e-13);
  }
}

TEST(InsertKnots, ManyGradedKnotsOfHighDegreeStayAccurate) {
  Random random(12);
  const Patch patch = elevate(random_patch(random, 1, 2, 2), 0, 8);
  std::vector<double> knots;
  for (int i = 1; i < 60; ++i) knots.push_back(-1 + 4 * std::pow(i / 60.0, 4));
  const Patch refined = insert_knots(patch, 0, knots);
  EXPECT_LT(distance(patch, refined, random), 1e-13);
  // Control points after knot insertion are convex combinations.
  EXPECT_LE(refined.points().cwiseAbs().maxCoeff(), patch.points().cwiseAbs().maxCoeff() + 1e-14);
}

TEST(InsertKnots, InTheMiddleOfAParabola) {
  // Blossom of the control points 0, 1, 0 at (½, 0), (½, ½), (½, 1), computed by hand.
  MatrixX points(2, 3);
  points << 0, 1, 2, 0, 1, 0;
  const Patch patch = insert_knots(make_patch({KnotVector::single(2)}, points), 0, {0.5});
  EXPECT_EQ(patch.points(), (MatrixX(2, 4) << 0, 0.5, 1.5, 2, 0, 0.5, 0.5, 0).finished());
  EXPECT_EQ(patch.direction(0).knots(), numbers({0, 0, 0, 0.5, 1, 1, 1}));
}

TEST(InsertKnots, RejectsInvalidKnots) {
  Random random(13);
  const Patch patch = make_patch({KnotVector(2, {0, 0, 0, 0.5, 1, 1, 1})}, MatrixX::Random(2, 4));
  EXPECT_ERROR(insert_knots(patch, 1, {0.5}), "nurbs.patch.direction: direction = 1, count = 1");
  EXPECT_ERROR(insert_knots(patch, 0, {0.0}), "nurbs.insert.outside: knot = 0, first = 0, last = 1");
  EXPECT_ERROR(insert_knots(patch, 0, {1.5}), "nurbs.insert.outside: knot = 1.5, first = 0, last = 1");
  EXPECT_ERROR(insert_knots(patch, 0, {std::nan("")}), "nurbs.insert.outside");
  EXPECT_ERROR(insert_knots(patch, 0, {0.5, 0.5}),
               "nurbs.insert.multiplicity: knot = 0.5, count = 3, degree = 2, present = 1");
  EXPECT_ERROR(insert_knots(patch, 0, {0.25, 0.25, 0.25}),
               "nurbs.insert.multiplicity: knot = 0.25, count = 3, degree = 2, present = 0");
}

TEST(Elevate, PreservesMapAndContinuity) {
  Random random(14);
  for (int run = 0; run < 60; ++run) {
    const int parametric = 1 + run % 3, d = integer(random, 0, parametric - 1), times = integer(random, 0, 4);
    const Patch patch = random_patch(random, parametric, 3);
    const Patch elevated = elevate(patch, d, times);
    const KnotVector &old = patch.direction(d), &knots = elevated.direction(d);
    EXPECT_EQ(knots.degree(), old.degree() + times);
    EXPECT_EQ(knots.breaks(), old.breaks());
    for (double knot : old.breaks()) EXPECT_EQ(knots.multiplicity(knot), old.multiplicity(knot) + times);
    EXPECT_LT(distance(patch, elevated, random), 1e-13);
    for (int k = 0; k < parametric; ++k)
      if (k != d) {
        EXPECT_EQ(elevated.direction(k), patch.direction(k));
      }
  }
}

TEST(Elevate, ToTheHighestDegreeStaysAccurate) {
  Random random(15);
  std::vector<double> knots{0, 0};
  for (int i = 1; i < 12; ++i) knots.push_back(std::pow(i / 12.0, 3));
  knots.insert(knots.end(), {1, 1});
  const Patch patch = make_patch({KnotVector(1, knots)}, MatrixX::Random(2, 13));
  EXPECT_LT(distance(patch, elevate(patch, 0, max_degree - 1), random), 1e-13);
}

TEST(Elevate, OneParabolaToACubicByHand) {
  // Q_1 = (P_0 + 2 P_1)/3, Q_2 = (2 P_1 + P_2)/3
  MatrixX points(2, 3);
  points << 0, 3, 6, 0, 3, 0;
  const Patch cubic = elevate(make_patch({KnotVector::single(2)}, points), 0, 1);
  EXPECT_LT((cubic.points() - (MatrixX(2, 4) << 0, 2, 4, 6, 0, 2, 2, 0).finished()).norm(), 1e-15);
}

TEST(Elevate, RejectsInvalidDegrees) {
  const Patch patch = make_patch({KnotVector::single(2)}, MatrixX::Random(2, 3));
  EXPECT_ERROR(elevate(patch, 0, -1), "nurbs.elevate.times: times = -1");
  EXPECT_ERROR(elevate(patch, 0, 14), "nurbs.elevate.degree: degree = 2, times = 14, most = 15");
  EXPECT_ERROR(elevate(patch, 2, 1), "nurbs.patch.direction: direction = 2, count = 1");
  EXPECT_ERROR(k_refine(patch, 0, 1, {}), "nurbs.elevate.lowered: degree = 1, own = 2, direction = 0");
  EXPECT_ERROR(k_refine(patch, 0, 16, {}), "nurbs.elevate.highest: degree = 16, most = 15");
}

TEST(KRefine, ElevatesFirstSoThatNewKnotsAreSmooth) {
  Random random(16);
  const Patch patch = make_patch({KnotVector(2, {0, 0, 0, 0.5, 0.5, 1, 1, 1})}, MatrixX::Random(2, 5));
  const Patch refined = k_refine(patch, 0, 4, {0.25, 0.75});
  EXPECT_EQ(refined.direction(0).multiplicity(0.25), 1);
  EXPECT_EQ(refined.direction(0).multiplicity(0.5), 4); // still C⁰
  EXPECT_EQ(refined.direction(0).multiplicity(0.75), 1);
  EXPECT_LT(distance(patch, refined, random), 1e-13);
}

TEST(ElementKnots, AreUniformWithinExistingSpans) {
  expect_near(element_knots(KnotVector::single(2), 4), {0.25, 0.5, 0.75});
  expect_near(element_knots(KnotVector(1, {0, 0, 0.5, 1, 1}), 6), {1 / 6.0, 2 / 6.0, 4 / 6.0, 5 / 6.0});
  // Lengths 3 and 1 of 4, 6 elements: quotas 4.5 and 1.5; the first of equals gets the remaining element.
  expect_near(element_knots(KnotVector(1, {0, 0, 3, 4, 4}), 6), {0.6, 1.2, 1.8, 2.4});
  EXPECT_TRUE(element_knots(KnotVector(1, {0, 0, 3, 4, 4}), 2).empty());
}

TEST(ElementKnots, EverySpanGetsAtLeastOne) {
  const KnotVector knots(1, {0, 0, 0.01, 0.02, 1, 1});
  expect_near(element_knots(knots, 4), {0.51});
  EXPECT_EQ(element_knots(knots, 100).size(), 97u);
  EXPECT_ERROR(element_knots(knots, 2), "nurbs.grading.elements: elements = 2, least = 3");
  EXPECT_ERROR(element_knots(KnotVector::single(1), 0), "nurbs.grading.elements: elements = 0, least = 1");
}

TEST(ElementKnots, GradingIsTheImageOfUniformKnots) {
  // 80 % of 10 elements in the first tenth: 8 of length 0.0125, 2 of 0.45.
  const std::vector<double> start = element_knots(KnotVector::single(1), 10, Grading{0.8, 0.1, false});
  expect_near(start, {0.0125, 0.025, 0.0375, 0.05, 0.0625, 0.075, 0.0875, 0.1, 0.55});
  const std::vector<double> end = element_knots(KnotVector::single(1), 10, Grading{0.8, 0.1, true});
  for (std::size_t i = 0; i < end.size(); ++i) EXPECT_NEAR(end[i], 1 - start[start.size() - 1 - i], 1e-14);
}

TEST(ElementKnots, GradingDistributesElementsToExistingSpans) {
  // On [2, 4] with a knot at 3: half the elements in the first quarter; the existing knot is at 0.5 + 0.25/0.75·0.5 =
  // 2/3 of the uniform coordinate, so 9 elements split 6 to 3.
  const std::vector<double> knots = element_knots(KnotVector(1, {2, 2, 3, 4, 4}), 9, Grading{0.5, 0.25, false});
  ASSERT_EQ(knots.size(), 7u);
  EXPECT_LT(knots[4], 3);
  EXPECT_GT(knots[5], 3);
  const auto image = [](double s) { return 2 + 2 * (s <= 0.5 ? s / 2 : 0.25 + (s - 0.5) * 1.5); };
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(knots[i], image((i + 1) / 9.0), 1e-14);
  EXPECT_NEAR(knots[5], image(7 / 9.0), 1e-14);
}

TEST(ElementKnots, InvalidGradingIsRejected) {
  const KnotVector knots = KnotVector::single(1);
  EXPECT_ERROR(element_knots(knots, 4, Grading{0, 0.5, false}),
               "nurbs.grading.share: argument = elements, least = 1e-09, share = 0");
  EXPECT_ERROR(element_knots(knots, 4, Grading{0.5, 1, false}),
               "nurbs.grading.share: argument = length, least = 1e-09, share = 1");
  // Its inverse overflows.
  EXPECT_ERROR(element_knots(knots, 4, Grading{0.5, 5e-324, false}), "nurbs.grading.share: argument = length");
  EXPECT_ERROR(element_knots(knots, 4, Grading{std::nan(""), 0.5, false}), "nurbs.grading.share");
}

} // namespace refine_test
} // namespace signorini::nurbs
