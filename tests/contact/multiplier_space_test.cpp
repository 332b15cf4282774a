// Multiplier spaces: degree, continuity and number of functions, partition of unity, non-negative functions.
#include "base/dense.hpp"
#include "contact/faces.hpp"
#include "contact/mortar/multiplier_functions.hpp"

#include "nurbs/bezier.hpp"
#include "nurbs/joins.hpp"
#include "nurbs/multi_degree.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace signorini::contact {
namespace multiplier_space_test {

using namespace test;

nurbs::Space1D trace_of(const std::string& label, int elements) {
  const auto body = discretize(nurbs::rectangle(2, 1, Eigen::Vector2d(0, 0)), {elements, 2}, label, "north");
  return body.face(nurbs::side_of("north", 2)).direction(0);
}

TEST(MultiplierSpace, EqualIsTheTracesOwn) {
  for (const char* label : {"N1", "N2", "N4", "N2-N2.2", "L2"})
    EXPECT_EQ(multiplier_space(trace_of(label, 5), MultiplierSpace::equal), trace_of(label, 5)) << label;
}

/// Largest jump of a function across an interior breakpoint.
double largest_jump(const nurbs::Space1D& space) {
  double largest = 0;
  for (int e = 1; e < space.elements(); ++e) {
    VectorX jump = VectorX::Zero(space.functions());
    const auto left = space.functions_on(e - 1), right = space.functions_on(e);
    for (std::size_t a = 0; a < left.size(); ++a)
      jump(left[a]) += space.extraction(e - 1)(static_cast<int>(a), space.degree(e - 1));
    for (std::size_t a = 0; a < right.size(); ++a) jump(right[a]) -= space.extraction(e)(static_cast<int>(a), 0);
    largest = std::max(largest, jump.cwiseAbs().maxCoeff());
  }
  return largest;
}

TEST(MultiplierSpace, ReducedHasDegreeAndContinuityLessTwo) {
  struct Case {
    const char* label;
    int degree, functions;
    bool continuous;
  };
  // Functions: n − 2 of a trace of n that is C¹ or smoother; degree − 1 per element of a C⁰ trace
  for (const auto& [label, degree, functions, continuous] : {Case{"N2", 0, 5, false},
                                                             {"N3", 1, 6, true},
                                                             {"N4", 2, 7, true},
                                                             {"N2-N2.1", 1, 10, false},
                                                             {"N2-N2.2", 2, 15, false},
                                                             {"N2-N4", 2, 7, true},
                                                             {"L2", 0, 5, false},
                                                             {"L3", 1, 10, false}}) {
    const nurbs::Space1D space = multiplier_space(trace_of(label, 5), MultiplierSpace::reduced);
    EXPECT_EQ(space.degree(), degree) << label;
    EXPECT_EQ(space.functions(), functions) << label;
    EXPECT_EQ(space.breaks(), trace_of(label, 5).breaks()) << label;
    EXPECT_EQ(largest_jump(space) < 1e-14, continuous) << label;
    for (int e = 0; e < space.elements(); ++e) EXPECT_GE(space.extraction(e).minCoeff(), 0) << label;
  }
}

/// The second derivatives of the trace's splines are the reduced space: n − 2 of them are independent.
TEST(MultiplierSpace, ReducedContainsTheSecondDerivativesOfTheTrace) {
  Random random(2);
  for (int trial = 0; trial < 10; ++trial) {
    const int degree = integer(random, 2, 5);
    const nurbs::Space1D trace = nurbs::spline_space(nurbs::test::random_knots(random, degree, 6));
    const nurbs::Space1D space = multiplier_space(trace, MultiplierSpace::reduced);
    const int samples = degree + 1;
    MatrixX second(samples * trace.elements(), trace.functions()), own(samples * trace.elements(), space.functions());
    second.setZero();
    own.setZero();
    std::vector<double> bernsteins(3 * (degree + 1));
    const auto fill = [&](const nurbs::Space1D& of, int e, int order, double t, int row, MatrixX& out) {
      const auto [from, to] = of.interval(e);
      const int p = of.degree(e);
      nurbs::bernstein(p, t, to - from, order, bernsteins.data());
      const auto functions = of.functions_on(e);
      for (std::size_t a = 0; a < functions.size(); ++a)
        for (int k = 0; k <= p; ++k)
          out(row, functions[a]) +=
              of.extraction(e)(static_cast<int>(a), k) * bernsteins[order * (p + 1) + k] * (to - from) * (to - from);
    };
    for (int e = 0; e < trace.elements(); ++e)
      for (int s = 0; s < samples; ++s) {
        const double t = (s + 0.5) / samples;
        fill(trace, e, 2, t, e * samples + s, second);
        fill(space, e, 0, t, e * samples + s, own);
      }
    const MatrixX fit = own * dense::least_squares(own, second);
    EXPECT_LE((fit - second).norm(), 1e-11 * second.norm()) << "degree " << degree;
    if (std::all_of(trace.smoothness().begin() + 1, trace.smoothness().end() - 1, [](int k) { return k > 0; })) {
      EXPECT_EQ(space.functions(), trace.functions() - 2);
    }
  }
}

TEST(MultiplierSpace, FollowsElementsOfSeveralDegrees) {
  const nurbs::Space1D trace = nurbs::test::joined({2, 4, 3, 2});
  EXPECT_EQ(multiplier_space(trace, MultiplierSpace::equal), trace);
  const nurbs::Space1D space = multiplier_space(trace, MultiplierSpace::reduced);
  EXPECT_EQ(space.functions(), 1 + 3 + 2 + 1);
  for (int e = 0; e < 4; ++e) EXPECT_EQ(space.degree(e), trace.degree(e) - 2);
}

/// Degrees that join with C² or more: the multipliers are continuous, and the second derivatives of the trace are among
/// them.
TEST(MultiplierSpace, FollowsSmoothJoinsOfSeveralDegrees) {
  const nurbs::Space1D trace = nurbs::multi_degree_space({0, 1, 2, 4, 5}, {3, 5, 5, 3}, {-1, 2, 3, 2, -1});
  const nurbs::Space1D space = multiplier_space(trace, MultiplierSpace::reduced);
  EXPECT_EQ(space.functions(), trace.functions() - 2);
  EXPECT_EQ(space.smoothness(), (std::vector{-1, 0, 1, 0, -1}));
  EXPECT_LT(largest_jump(space), 1e-14);
  for (int e = 0; e < 4; ++e) {
    EXPECT_EQ(space.degree(e), trace.degree(e) - 2);
    EXPECT_GE(space.extraction(e).minCoeff(), 0);
  }
}

TEST(MultiplierSpace, ErrorsNameTheDegree) {
  EXPECT_ERROR(multiplier_space(trace_of("N1", 4), MultiplierSpace::reduced),
               "contact.mortar.reduced_degree: degree = 1");
  EXPECT_ERROR(multiplier_space(nurbs::test::joined({2, 1}), MultiplierSpace::reduced),
               "contact.mortar.reduced_degree: degree = 1");
}

/// The functions at the points of a face sum to 1, and the sums over a multiplier's support contain all its points.
template <int D> void expect_partition_of_unity(const Surface<D>& face, MultiplierSpace kind) {
  const int per_direction = 3;
  const ContactPoints<D> points(face, per_direction, false, {});
  const MultiplierFunctions<D> functions(face, points, per_direction, kind);
  VectorX areas = VectorX::Zero(functions.count());
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ContactPoint& point = points.list[i];
    const double weight = point.weight * point.reference_area;
    double sum = 0;
    const auto on = functions.on(point.element);
    for (std::size_t a = 0; a < on.size(); ++a) {
      const double value = functions.at_point(i)[a];
      EXPECT_GE(value, 0);
      sum += value;
      areas(on[a]) += weight * value;
      const auto support = functions.support(on[a]);
      EXPECT_TRUE(std::find(support.begin(), support.end(), point.element) != support.end());
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    area += weight;
  }
  EXPECT_GT(areas.minCoeff(), 0);
  EXPECT_NEAR(areas.sum(), area, 1e-13 * area);
}

TEST(MultiplierFunctions, SumToOneAtEveryContactPoint) {
  for (const MultiplierSpace kind : {MultiplierSpace::equal, MultiplierSpace::reduced}) {
    for (const char* label : {"N2", "N3", "N2-N2.2"}) {
      const auto body = discretize(nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(0, 0)), {5, 2}, label, "south");
      expect_partition_of_unity(Surface<2>(body, nurbs::side_of("south", 2)), kind);
      const auto block = discretize(nurbs::block({2, 1, 1}, Eigen::Vector3d(0, 0, 0)), {3, 2, 1}, label, "back");
      expect_partition_of_unity(Surface<3>(block, nurbs::side_of("back", 3)), kind);
    }
    expect_partition_of_unity(Surface<2>(nurbs::test::strip(2, {2, 4, 3, 2}), nurbs::side_of("north", 2)), kind);
  }
}

/// At a seam the first and the last function are one, at a pole all of those on the border.
TEST(MultiplierFunctions, AreOneWhereControlPointsShareUnknowns) {
  const auto surface = [](const auto& body, const char* side) {
    constexpr int dimension = 3;
    return Surface<3>(body, nurbs::side_of(side, dimension), 0, shared_numbers(body, nurbs::side_of(side, dimension)));
  };
  for (const MultiplierSpace kind : {MultiplierSpace::equal, MultiplierSpace::reduced})
    for (const char* label : {"N2", "N3", "N2-N2.2"}) {
      const bool equal = kind == MultiplierSpace::equal;
      const auto ring = discretize(nurbs::ring(0.3, 0.5, Eigen::Vector2d(0, 0)), {8, 2}, label, "south");
      const auto side = nurbs::side_of("south", 2);
      const Surface<2> circle(ring, side, 0, shared_numbers(ring, side));
      expect_partition_of_unity(circle, kind);
      const MultiplierFunctions<2> functions(circle, ContactPoints<2>(circle, 3, false, {}), 3, kind);
      const int products = multiplier_space(circle.direction(0), kind).functions();
      EXPECT_EQ(functions.count(), products - (equal ? 1 : 0));
      const auto support = functions.support(0);
      EXPECT_EQ(support.back(), equal ? circle.elements() - 1 : 0) << label;

      const auto pipe = discretize(nurbs::tube(0.3, 0.5, 1, Eigen::Vector3d(0, 0, 0)), {4, 2, 1}, label, "front");
      expect_partition_of_unity(surface(pipe, "front"), kind);
    }
  const auto ball = discretize(nurbs::polar_ball(1, Eigen::Vector3d(0, 0, 0)), {4, 4, 1}, "N2", "front");
  const Surface<3> sphere = surface(ball, "front");
  expect_partition_of_unity(sphere, MultiplierSpace::equal);
  const MultiplierFunctions<3> functions(sphere, ContactPoints<3>(sphere, 3, false, {}), 3, MultiplierSpace::equal);
  EXPECT_EQ(functions.count(), (sphere.direction(0).functions() - 1) * (sphere.direction(1).functions() - 2) + 2);
}

} // namespace multiplier_space_test
} // namespace signorini::contact
