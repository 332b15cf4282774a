#include "tessellation/tessellate.hpp"

#include "model/steps/load_step.hpp"
#include "nurbs/shapes.hpp"
#include "solid/neo_hookean.hpp"
#include "surfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace signorini::tessellation {
namespace tessellate_test {

using namespace model;
using signorini::test::length;
using signorini::test::volume;

const nurbs::Side west{0, false}, south{1, false}, front{2, false}, back{2, true};

Scene<3> one_body(const nurbs::Patch& patch, std::vector<int> elements, nurbs::Side contact) {
  nurbs::Plan plan;
  plan.elements = std::move(elements);
  plan.contact = {contact};
  plan.labels.assign(2, nurbs::parse_label("N2-N2.1"));
  plan.thickness_degree = 1;
  const auto space = std::make_shared<const nurbs::Discretization>(patch, plan);
  Scene<3> scene;
  scene.bodies.push_back({"body", std::make_shared<const solid::Body<3>>(space, solid::neo_hookean(1, 0.3))});
  return scene;
}

SupportedControlPoints face_points(const Scene<3>& scene, nurbs::Side side) {
  return {0, scene.bodies[0].body->space().face_functions(side)};
}

/// An undeformed hollow octant.
Scene<3> octant() {
  Scene<3> scene = one_body(nurbs::sphere_octant(0.5, 1, Eigen::Vector3d(0, 0, 0)), {2, 2, 2}, front);
  scene.supports.push_back(
      {"hold", {face_points(scene, back)}, {Constraint::fixed, Constraint::fixed, Constraint::fixed}});
  return scene;
}

/// A block 2 × 1 × 1 on smooth planes under a rigid obstacle.
Scene<3> pressed(const contact::Obstacle<3>& obstacle) {
  Scene<3> scene = one_body(nurbs::block({2, 1, 1}, Eigen::Vector3d(0, 0, 0)), {4, 2, 2}, back);
  scene.obstacles.push_back(obstacle);
  scene.supports.push_back(
      {"bed", {face_points(scene, front)}, {Constraint::free, Constraint::free, Constraint::fixed}});
  scene.supports.push_back(
      {"left", {face_points(scene, west)}, {Constraint::fixed, Constraint::free, Constraint::free}});
  scene.supports.push_back(
      {"near", {face_points(scene, south)}, {Constraint::free, Constraint::fixed, Constraint::free}});
  scene.supports.push_back({"tool", {}, {Constraint::fixed, Constraint::fixed, Constraint::driven}, {0}});
  scene.contacts.push_back({"touch", {0, back}, ObstacleReference{0}, contact::InterfaceLaw{50, 0, 0}, 5});
  return scene;
}

void press(Model<3>& model, double depth) {
  set_target(model, 0, 0, -depth);
  ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
  accept(model);
}

Sampling<3> evenly(const Model<3>& model, int divisions) {
  return even_sampling<3>(model.system.scene.bodies[0].body->space(), divisions);
}

TEST(Skin, EnclosesTheBodyWithExactNormals) {
  const Model<3> model(octant());
  const double exact = 4 * std::numbers::pi / 3 * (1 - 0.125) / 8;
  std::vector<double> errors;
  for (int divisions : {2, 4, 8}) {
    const Skin skin = tessellate(model, 0, &find_field<3>("von_mises"), evenly(model, divisions), true);
    errors.push_back(std::abs(volume(skin) - exact));
    EXPECT_TRUE(skin.values.allFinite()); // also at the pole, where ∂X/∂ξ is singular
    EXPECT_LT(skin.values.cwiseAbs().maxCoeff(), 1e-12);
    for (Eigen::Index i = 0; i < skin.points.cols(); ++i) {
      EXPECT_NEAR(skin.normals.col(i).norm(), 1, 1e-12);
      const Vec<3> x = skin.points.col(i), n = skin.normals.col(i);
      const double along = n.dot(x) / x.norm();
      // Outer sphere, inner sphere, or a plane through the center
      const bool spherical = std::abs(std::abs(along) - 1) < 1e-3;
      // On the axis the map is singular: the normal is that of a point slightly inside.
      const double tolerance = x.head<2>().norm() < 1e-9 ? 1e-4 : 1e-9;
      EXPECT_TRUE(spherical || std::abs(along) < tolerance) << along;
      if (spherical) {
        EXPECT_NEAR(x.norm(), along > 0 ? 1 : 0.5, 1e-12);
      }
    }
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.1);
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2, 0.1);
}

TEST(Skin, ContainsBordersOfElementsAndSides) {
  const Scene<3> scene = one_body(nurbs::block({2, 1, 3}, Eigen::Vector3d(0, 0, 0)), {4, 2, 3}, back);
  const Model<3> model(scene);
  const Skin skin = tessellate(model, 0, nullptr, evenly(model, 3), false);
  EXPECT_EQ(skin.values.size(), 0);
  EXPECT_NEAR(volume(skin), 6, 1e-12);
  EXPECT_NEAR(length(skin.rim), 2 * 4 * (2 + 1 + 3), 1e-12);
  // On each pair of sides: lines across × their length
  EXPECT_NEAR(length(skin.mesh_lines), 2 * (3 * 1 + 1 * 2 + 1 * 3 + 2 * 1 + 3 * 3 + 2 * 2), 1e-12);
  std::set<double> spacings;
  for (const SkinLine& line : skin.mesh_lines) spacings.insert(std::round(1e9 * line.spacing) / 1e9);
  EXPECT_EQ(spacings, (std::set<double>{0.5, 1}));
  EXPECT_EQ(surface_elements(scene.bodies[0].body->space()), 2 * (8 + 6 + 12));
}

TEST(Skin, ContainsFieldsAndContactPressure) {
  Model<3> model(pressed(contact::make_plane<3>({0, 0, 1}, {0, 0, -1})));
  press(model, 0.2);
  const int divisions = 3;
  const Field<3>& stress = find_field<3>("szz");
  const Skin skin = tessellate(model, 0, &stress, evenly(model, divisions), true);
  const VectorX pressure = face_values(model, model::FaceField::pressure, 0, evenly(model, divisions));
  ASSERT_EQ(pressure.size(), skin.points.cols());
  const double uniform = sample(model, 0, stress, Vec<3>(0.3, 0.6, 0.7));
  EXPECT_LT(uniform, -0.1);
  const double top = skin.points.row(2).maxCoeff();
  int touching = 0;
  for (Eigen::Index i = 0; i < skin.points.cols(); ++i) {
    EXPECT_NEAR(skin.values[i], uniform, 1e-8);
    const bool touches = skin.normals(2, i) > 0.9;
    if (touches) {
      EXPECT_NEAR(skin.points(2, i), top, 1e-9);
    }
    // p = −σ_zz, both per current area
    EXPECT_NEAR(pressure[i], touches ? -uniform : 0, 1e-8);
    touching += touches;
  }
  EXPECT_EQ(touching, 4 * 2 * 16);
}

TEST(Skin, HasOtherFieldsOfContactsOnTheirFacesOnly) {
  Scene<3> scene = pressed(contact::make_plane<3>({0, 0, 1}, {0, 0, -1}));
  scene.contacts[0].method.law.frictional = true;
  const Model<3> model(scene);
  const VectorX slip = face_values(model, model::FaceField::slip, 0, evenly(model, 2));
  const Eigen::Index on_slave = 8 * 9;
  EXPECT_TRUE(slip.head(slip.size() - on_slave).array().isNaN().all());
  EXPECT_TRUE(slip.tail(on_slave).isZero(0));
}

TEST(Skin, InterpolatesBetweenContactPoints) {
  Model<3> model(pressed(contact::make_ball<3>({0.75, 0.25, 1.6}, 0.6)));
  press(model, 0.1);
  // An odd number of contact points has one at the middle of every element, and so do two divisions.
  const VectorX pressure = face_values(model, model::FaceField::pressure, 0, evenly(model, 2));
  const auto& results = model.present.contacts[0].results;
  const Eigen::Index first = pressure.size() - 8 * 9; // the back is the last side
  double largest = 0;
  for (int e = 0; e < 8; ++e) {
    const double middle = results[25 * e + 12].pressure;
    EXPECT_NEAR(pressure[first + 9 * e + 4], middle, 1e-12);
    largest = std::max(largest, middle);
  }
  EXPECT_GT(largest, 0);
  EXPECT_EQ(pressure.head(first).cwiseAbs().maxCoeff(), 0);
  // Zero outside the contact's region
  Scene<3> scene = pressed(contact::make_ball<3>({0.75, 0.25, 1.6}, 0.6));
  scene.contacts[0].where = [](const Vec<3>& place) { return place(0) < 1; };
  Model<3> half(scene);
  press(half, 0.1);
  const VectorX partial = face_values(half, model::FaceField::pressure, 0, evenly(half, 2));
  for (int e = 0; e < 8; ++e)
    for (int i = 0; i < 9; ++i)
      if (e % 4 >= 2) {
        EXPECT_EQ(partial[first + 9 * e + i], 0);
      }
  EXPECT_GT(partial.maxCoeff(), 0);
}

TEST(Inside, SamplesTheElementsThatAPlaneIntersects) {
  Model<3> model(pressed(contact::make_ball<3>({1, 0.5, 1.6}, 0.6)));
  press(model, 0.1);
  const auto count = [&](const std::vector<CutPlane>& planes) {
    return crossed_elements(model, 0, nullptr, 2, false, planes).size();
  };
  EXPECT_EQ(count({{{0, 0, 0.25}, {0, 0, 7}}}), 8u);
  EXPECT_EQ(count({{{0, 0, 0.5}, {0, 0, 1}}}), 16u); // both sides of a border
  EXPECT_EQ(count({{{0, 0, 1}, {0, 0, 1}}}), 8u);
  EXPECT_EQ(count({{{0, 0, 1.1}, {0, 0, 1}}}), 0u);
  // Control points of an element may lie outside it, so neighbors may be included as well.
  EXPECT_GE(count({{{0.25, 0, 0}, {1, 0, 0}}, {{1.75, 0, 0}, {1, 0, 0}}}), 8u);
  EXPECT_LE(count({{{0.25, 0, 0}, {1, 0, 0}}, {{1.75, 0, 0}, {1, 0, 0}}}), 16u);

  const Field<3>& field = find_field<3>("uz");
  const auto all = crossed_elements(model, 0, &field, 2, true, {{{0, 0, 0.75}, {0, 0, 1}}});
  ASSERT_FALSE(all.empty());
  // The middle of the last element, and its last corner
  const Inside& last = all.back();
  const Vec<3> middle(0.875, 0.75, 0.75), corner(1, 1, 1);
  EXPECT_NEAR(last.values[13], sample(model, 0, field, middle), 1e-12);
  EXPECT_NEAR(last.values[26], sample(model, 0, field, corner), 1e-12);
  EXPECT_NEAR(last.points(2, 26), 1 + last.values[26], 1e-12);
}

/// An undeformed half annulus of radii 0.5 and 1 with two elements in hoop and one in thickness direction.
Model<2> annulus() {
  nurbs::Plan plan;
  plan.elements = {2, 1};
  plan.contact = {south};
  plan.labels.assign(1, nurbs::parse_label("N2"));
  plan.thickness_degree = 1;
  const auto space =
      std::make_shared<const nurbs::Discretization>(nurbs::half_annulus(0.5, 1, Eigen::Vector2d(0, 0)), plan);
  Scene<2> scene;
  scene.bodies.push_back({"ring", std::make_shared<const solid::Body<2>>(space, solid::neo_hookean(1, 0.3))});
  return Model<2>(scene);
}

/// Largest distance of the outline within a box from circles of radii 0.5 and 1, at points and midpoints of its pieces.
double departure(const Skin& drawn, const Vec<2>& low, const Vec<2>& high) {
  double largest = 0;
  for (Eigen::Index t = 0; t < drawn.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec<2> a = drawn.points.col(drawn.triangles(k, t)).head<2>(),
                   b = drawn.points.col(drawn.triangles((k + 1) % 3, t)).head<2>(), middle = 0.5 * (a + b);
      if ((middle.array() < low.array()).any() || (middle.array() > high.array()).any()) continue;
      for (double radius : {0.5, 1.0})
        if (std::abs(a.norm() - radius) < 1e-9 && std::abs(b.norm() - radius) < 1e-9)
          largest = std::max(largest, std::abs(middle.norm() - radius));
    }
  return largest;
}

TEST(Sampling, FollowsMagnifiedArcsWithinHalfAPixel) {
  const Model<2> model = annulus();
  const auto& stress = find_field<2>("sxx");
  const int divisions = 12;
  const Skin whole =
      tessellate(model, 0, &stress, even_sampling<2>(model.system.scene.bodies[0].body->space(), divisions), true);
  for (double side : {0.1, 0.02, 0.001}) {
    // Around the lowest quarter of the outer arc, for 1600 × 1000 pixels
    const Vec<2> middle(-std::sqrt(0.5), -std::sqrt(0.5)), half(0.5 * side, 0.3 * side);
    const Vec<2> low = middle - half, high = middle + half;
    const Window window =
        box_window(Mat<3>::Identity().topRows<2>(), {low[0], low[1], 0}, {high[0], high[1], 0}, {1600, 1000});
    const auto places = sampling(model, 0, divisions, true, {window});
    const Skin fine = tessellate(model, 0, &stress, places, true);
    const double pixel = side / 1600;
    EXPECT_LT(departure(fine, low, high), 0.5 * pixel) << side;
    EXPECT_GT(departure(whole, middle.array() - 0.2, middle.array() + 0.2), 10 * pixel) << side;
    // At most about as many quadrilaterals as in the picture of a fine mesh
    EXPECT_LT(fine.triangles.cols(), 20000) << side;
    EXPECT_EQ(fine.values.size(), fine.points.cols());
  }
}

} // namespace tessellate_test
} // namespace signorini::tessellation
