// Faces that match point by point, in all relative orientations, and what keeps others from matching.
#include "nurbs/matching.hpp"

#include "nurbs/directions.hpp"
#include "nurbs/orientation.hpp"
#include "nurbs/refine.hpp"
#include "nurbs/shapes.hpp"
#include "nurbs/transform.hpp"

#include <gtest/gtest.h>

#include <set>

namespace signorini::nurbs {
namespace matching_test {

Discretization of(const Patch& patch, std::vector<int> elements, const std::string& label = "N2",
                  std::vector<Side> contact = {}) {
  Plan plan;
  plan.elements = std::move(elements);
  plan.contact = std::move(contact);
  plan.labels.assign(plan.elements.size() - (plan.contact.empty() ? 0 : 1), parse_label(label));
  return {patch, plan};
}

constexpr Side west{0, false}, east{0, true}, north{1, true}, back{2, true};

/// The pairs are one to one and have the same control points.
void expect_pairs(const FaceMatch& match, const Discretization& a, const Discretization& b, std::size_t count) {
  ASSERT_EQ(match.mismatch, Mismatch::none);
  ASSERT_EQ(match.pairs.size(), count);
  const MatrixX here = a.points(), there = b.points();
  std::set<int> partners;
  for (const auto& [i, j] : match.pairs) {
    partners.insert(j);
    EXPECT_LT((here.col(i) - there.col(j)).norm(), 1e-14);
  }
  EXPECT_EQ(partners.size(), count);
}

TEST(Matching, FindsPairsInTheEightOrientationsOfAFace) {
  // A face without symmetry: two lengths, and knots that are not in the middle
  const Patch cube = insert_knots(insert_knots(block({1, 2, 1}, Vec<3>::Zero()), 0, {0.25}), 1, {0.2, 0.6});
  const Discretization first = of(cube, {4, 5, 2});
  for (const Orientation& way : orientations(2)) {
    Patch other = cube;
    std::vector<int> elements{first.elements(0), first.elements(1), 2};
    if (way.to[0] == 1) {
      other = swap_directions(other, 0, 1);
      std::swap(elements[0], elements[1]);
    }
    for (std::size_t k = 0; k < 2; ++k)
      if (way.flip[k]) other = reverse(other, static_cast<int>(way.to[k]));
    const Discretization second = of(other, elements);
    const FaceMatch match = match_faces(first, back, second, back);
    expect_pairs(match, first, second, first.face_functions(back).size());
    EXPECT_EQ(match.facing, way.mirrors()); // opposite sides of one surface, if the copy is left-handed
  }
}

TEST(Matching, FindsPairsOfCurvesInBothDirections) {
  const Patch annulus = quarter_annulus(1, 2, Vec<2>::Zero(), 0);
  const Discretization first = of(annulus, {3, 2}), second = of(reverse(reverse(annulus, 0), 1), {3, 2});
  expect_pairs(match_faces(first, north, second, {1, false}), first, second, first.face_functions(north).size());
  expect_pairs(match_faces(first, north, first, north), first, first, first.face_functions(north).size());
}

TEST(Matching, AConstantFactorOfTheWeightsDoesNotMatter) {
  const Patch annulus = quarter_annulus(1, 2, Vec<2>::Zero(), 0);
  const Patch scaled(annulus.directions(), 3 * annulus.homogeneous());
  const Discretization first = of(annulus, {3, 2}), second = of(scaled, {3, 2});
  expect_pairs(match_faces(first, north, second, north), first, second, first.face_functions(north).size());
}

TEST(Matching, NamesTheFirstDifference) {
  const Patch left = rectangle(1, 1, Vec<2>(0, 0)), right = rectangle(1, 1, Vec<2>(1, 0));
  const auto difference = [](const Patch& patch, std::vector<int> elements, const std::string& label = "N2") {
    return match_faces(of(rectangle(1, 1, Vec<2>(0, 0)), {2, 4}), east, of(patch, std::move(elements), label), west)
        .mismatch;
  };
  EXPECT_TRUE(match_faces(of(left, {2, 4}), east, of(right, {2, 4}), west).facing);
  EXPECT_FALSE(match_faces(of(left, {2, 4}), east, of(reverse(right, 0), {2, 4}), east).facing);
  EXPECT_EQ(difference(right, {3, 4}), Mismatch::none); // elements along the normal do not matter
  EXPECT_EQ(difference(rectangle(1, 1.001, Vec<2>(1, 0)), {2, 4}), Mismatch::corners);
  EXPECT_EQ(difference(translate(right, Vec<2>(1e-3, 0)), {2, 4}), Mismatch::corners);
  EXPECT_EQ(difference(right, {2, 3}), Mismatch::elements);
  EXPECT_EQ(difference(insert_knots(right, 1, {0.4}), {2, 4}), Mismatch::borders);
  EXPECT_EQ(difference(right, {2, 4}, "N3"), Mismatch::functions);
  // Another parametrization of the same straight face
  MatrixX homogeneous = elevate(right, 1, 1).homogeneous();
  homogeneous(1, 2) += 0.1;
  EXPECT_EQ(difference(Patch(elevate(right, 1, 1).directions(), homogeneous), {2, 4}), Mismatch::points);
}

} // namespace matching_test
} // namespace signorini::nurbs
