// Layers on solids: every face, two opposite ones, one label per direction along them, several rows deep.
#include "nurbs/discretization.hpp"

#include "nurbs/random_patch.hpp"
#include "nurbs/shapes.hpp"

#include <gtest/gtest.h>

namespace signorini::nurbs {
namespace solid_layers_test {

/// Functions of Np.s on `elements` equal spans, refined from a single span: p+s+1, and 1+s more at each inner knot.
int functions(const Space& space, int elements) {
  return space.full_degree() + 1 + (elements - 1) * (1 + space.elevations);
}

/// A volume of one span per direction, degrees 1 or 2, with random weights, bent but not folded.
Patch random_solid(test::Random& random) {
  std::vector<KnotVector> directions;
  for (int d = 0; d < 3; ++d) directions.push_back(KnotVector::single(test::integer(random, 1, 2)));
  const int n0 = directions[0].functions(), n1 = directions[1].functions(), n2 = directions[2].functions();
  MatrixX points(3, n0 * n1 * n2);
  VectorX weights(points.cols());
  for (int n = 0; n < points.cols(); ++n) {
    const Vec<3> place(n % n0 / (n0 - 1.0), n / n0 % n1 / (n1 - 1.0), n / n0 / n1 / (n2 - 1.0));
    points.col(n) = place + Vec<3>::NullaryExpr([&] { return test::uniform(random, -0.1, 0.1); });
    weights(n) = test::uniform(random, 0.7, 1.4);
  }
  return make_patch(std::move(directions), points, weights);
}

const char* const labels[] = {"N2", "N3", "N2.1", "N2-N4", "N2-N2.1", "N2-N2.2", "N2-N3.2"};

Label label_of(const std::string& name, int rows) {
  return parse_label(name.find('-') == std::string::npos ? name : text(name, "x", rows));
}

/// Definition of a body: everything but the faces is random.
struct Case {
  Patch patch;
  Plan plan;
  int rows;
};

Case random_case(test::Random& random, const std::vector<Side>& contact) {
  Case result{random_solid(random), {}, test::integer(random, 1, 3)};
  for (int d = 0; d < 3; ++d) result.plan.elements.push_back(test::integer(random, 1, 4));
  const int through = contact.front().direction;
  result.plan.elements[through] = test::integer(random, 3, 5);
  result.plan.contact = contact;
  result.plan.thickness_degree = result.patch.direction(through).degree();
  for (int a = 0; a < 2; ++a) result.plan.labels.push_back(label_of(labels[test::integer(random, 0, 6)], result.rows));
  return result;
}

TEST(SolidLayers, CountsGeometryAndSignOnEveryFace) {
  test::Random random(61);
  for (int trial = 0; trial < 120; ++trial) {
    const Side side{trial % 3, trial / 3 % 2 == 1};
    std::vector<Side> contact{side};
    if (trial % 4 == 3) contact.push_back({side.direction, !side.at_end});
    const auto [patch, plan, depth] = random_case(random, contact);
    const Discretization space(patch, plan);
    SCOPED_TRACE(
        text("trial ", trial, ", layer on ", name_of(side), ", ", plan.labels[0].text, ", ", plan.labels[1].text));

    const int count = patch.direction(side.direction).degree() + plan.elements[side.direction];
    ASSERT_EQ(static_cast<int>(space.rows().size()), count);
    int total = 0;
    for (int j = 0; j < count; ++j) {
      const bool near = j < depth, far = count - 1 - j < depth;
      const bool in_layer = contact.size() == 2 ? near || far : side.at_end ? far : near;
      int row = 1;
      for (int a = 0; a < 2; ++a) {
        const Label& label = plan.labels[a];
        const int d = a < side.direction ? a : a + 1;
        row *= functions(in_layer && label.layer ? *label.layer : label.bulk, plan.elements[d]);
      }
      EXPECT_EQ(space.rows()[j].functions(), row) << "row " << j;
      total += row;
    }
    EXPECT_EQ(space.functions(), total);
    EXPECT_EQ(space.face_functions(side).size(), space.rows()[side.at_end ? count - 1 : 0].functions());
    EXPECT_GT(space.homogeneous().bottomRows(1).minCoeff(), 0);

    const MatrixX points = space.points();
    for (int n = 0; n < 10; ++n) {
      const VectorX xi = test::random_parameter(random, patch);
      const ElementBasis basis = space.basis(space.find_element(xi), xi);
      VectorX x = VectorX::Zero(3);
      for (std::size_t a = 0; a < basis.functions.size(); ++a)
        x += basis.values(static_cast<int>(a)) * points.col(basis.functions[a]);
      EXPECT_LT((x - evaluate(patch, xi)).norm(), 1e-14);
      EXPECT_NEAR(basis.values.sum(), 1, 1e-14);
      EXPECT_GE(basis.values.minCoeff(), 0);
    }
  }
}

/// Direct evaluation of thesis (5.5): the bulk volume with the functions of its row on the face replaced by those of
/// the face's surface on the layer's knots, B-splines by the Cox–de Boor recursion, one common weight function.
TEST(SolidLayers, AgreesWithTheThesisOnAShell) {
  test::Random random(62);
  const Patch shell = half_cylinder_shell(0.4, 0.5, 0.6, Vec<3>(0, 0, 0));
  Plan plan;
  plan.elements = {4, 3, 2};
  plan.contact = {side_of("front", 3)};
  plan.labels = {parse_label("N2-N2.2"), parse_label("N2-N4")};
  plan.thickness_degree = 1;
  const Discretization space(shell, plan);

  const std::vector<double> around{0.25, 0.75}, along{1 / 3.0, 2 / 3.0};
  const Patch bulk = k_refine(k_refine(k_refine(shell, 0, 2, around), 1, 2, along), 2, 1, {0.5});
  const Patch outer = face(shell, plan.contact.front());
  const Patch layer = k_refine(elevate(k_refine(outer, 0, 2, around), 0, 2), 1, 4, along);
  const auto product = [&](const Patch& patch, int i, int j, const VectorX& xi) {
    const KnotVector &u = patch.direction(0), &v = patch.direction(1);
    return test::cox_de_boor(u, i, u.degree(), xi(0)) * test::cox_de_boor(v, j, v.degree(), xi(1));
  };
  const int n0 = layer.direction(0).functions(), m0 = bulk.direction(0).functions(), m1 = bulk.direction(1).functions();
  ASSERT_EQ(space.functions(), layer.functions() + 2 * m0 * m1);
  for (int trial = 0; trial < 60; ++trial) {
    const VectorX xi = test::random_parameter(random, shell);
    VectorX values(space.functions());
    for (int n = 0; n < layer.functions(); ++n)
      values(n) =
          layer.weights()(n) * product(layer, n % n0, n / n0, xi) * test::cox_de_boor(bulk.direction(2), 0, 1, xi(2));
    for (int n = m0 * m1; n < 3 * m0 * m1; ++n)
      values(layer.functions() + n - m0 * m1) = bulk.weights()(n) * product(bulk, n % m0, n / m0 % m1, xi) *
                                                test::cox_de_boor(bulk.direction(2), n / m0 / m1, 1, xi(2));
    values /= values.sum();
    const ElementBasis basis = space.basis(space.find_element(xi), xi);
    for (std::size_t a = 0; a < basis.functions.size(); ++a) {
      EXPECT_NEAR(basis.values(static_cast<int>(a)), values(basis.functions[a]), 1e-13);
      values(basis.functions[a]) = 0;
    }
    EXPECT_NEAR(values.norm(), 0, 1e-15) << "functions left out";
  }
  EXPECT_LT((space.points().leftCols(layer.functions()) - layer.points()).norm(), 1e-13);
}

TEST(SolidLayers, ElementDegreesRiseOnlyAlongTheLayerAndInsideIt) {
  Plan plan;
  plan.elements = {3, 2, 4};
  plan.contact = {side_of("back", 3)};
  plan.labels = {parse_label("N2-N2.2"), parse_label("N3")};
  plan.thickness_degree = 1;
  const Discretization space(block({1, 1, 1}, Vec<3>(0, 0, 0)), plan);
  for (int e = 0; e < space.elements(); ++e) {
    EXPECT_EQ(space.degree(e, 0), e / 6 == 3 ? 4 : 2) << "element " << e;
    EXPECT_EQ(space.degree(e, 1), 3);
    EXPECT_EQ(space.degree(e, 2), 1);
  }
}

TEST(SolidLayers, LayerDepthsOfTwoDirectionsMustAgree) {
  const auto build = [](const char* first, const char* second) {
    Plan plan;
    plan.elements = {2, 2, 3};
    plan.contact = {side_of("front", 3)};
    plan.labels = {parse_label(first), parse_label(second)};
    plan.thickness_degree = 1;
    return Discretization(block({1, 1, 1}, Vec<3>(0, 0, 0)), plan).functions();
  };
  // 4 + 1 functions of N2-N2.1 against 3 + 1 of N2 in one direction, on 2 of 4 rows
  EXPECT_EQ(build("N2", "N2-N2.1x2"), 2 * 4 * 6 + 2 * 4 * 4);
  EXPECT_EQ(build("N2-N2.1x2", "N2"), 2 * 6 * 4 + 2 * 4 * 4);
  EXPECT_ERROR(build("N2-N4", "N2-N4x2"), "nurbs.body.layer_depths: label = N2-N4x2, other = N2-N4");
  EXPECT_ERROR(build("N2", "N2-N4x5"), "nurbs.body.layer_too_deep: label = N2-N4x5, rows = 5, available = 4");
  EXPECT_ERROR(build("N2", "L2"), "nurbs.body.mixed_labels: first = N2, second = L2");
}

} // namespace solid_layers_test
} // namespace signorini::nurbs
