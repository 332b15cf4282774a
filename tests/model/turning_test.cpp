// Rigid obstacles that turn and move freely: derivatives over generated states, and equilibrium.
#include "model/scene/turning.hpp"
#include "model/scenes.hpp"
#include "model/steps/equilibrium.hpp"

#include "differences.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace signorini::model {
namespace turning_test {

using namespace test;
using contact::Enforcement;
using contact::Method;
using contact::MultiplierSpace;
using nurbs::test::Random;
using nurbs::test::uniform;

constexpr Constraint fixed = Constraint::fixed, driven = Constraint::driven, unlisted = Constraint::free;

template <int D> std::shared_ptr<const solid::Body<D>> block() {
  nurbs::Plan plan;
  plan.thickness_degree = 1;
  nurbs::Patch patch = nurbs::rectangle(2, 1, Eigen::Vector2d(-1, -1));
  if constexpr (D == 2) {
    plan.elements = {6, 2};
    plan.contact = {nurbs::Side{1, true}};
    plan.labels = {nurbs::parse_label("N2")};
  } else {
    patch = nurbs::block({2, 2, 1}, Eigen::Vector3d(-1, -1, -1));
    plan.elements = {3, 3, 1};
    plan.contact = {nurbs::Side{2, true}};
    plan.labels.assign(2, nurbs::parse_label("N2"));
  }
  return std::make_shared<const solid::Body<D>>(std::make_shared<const nurbs::Discretization>(patch, plan),
                                                solid::neo_hookean(1, 0.3));
}

/// A clamped block under a tool that turns about a point next to its center and is free to move downwards.
template <int D> Scene<D> pressed(const contact::Obstacle<D>& tool, const Method& method, bool free_angle) {
  Scene<D> scene;
  scene.bodies.push_back({"block", block<D>()});
  const nurbs::Side bottom{D - 1, false}, top{D - 1, true};
  std::array<Constraint, D> clamped, moved;
  clamped.fill(fixed);
  moved.fill(driven);
  moved.back() = unlisted;
  scene.supports.push_back({"bed", {{0, scene.bodies[0].body->space().face_functions(bottom)}}, clamped});
  Support<D> support{"tool", {}, moved, {0}};
  support.freed.back() = support.rotates = true;
  support.free_angle = free_angle;
  support.center = 0.5 * Vec<D>::Unit(D - 1) + 0.1 * Vec<D>::Unit(0);
  if constexpr (D == 3) support.axis = Vec<3>(0.2, 1, 0.1).normalized();
  scene.supports.push_back(support);
  scene.obstacles = {tool};
  scene.contacts = {{"press", {0, top}, ObstacleReference{0}, method, 6}};
  return scene;
}

/// Discrete state, which finite differences must not change.
template <int D> std::vector<int> signature(const Model<D>& model) {
  std::vector<int> result;
  for (const auto& point : model.present.contacts[0].results) result.push_back(static_cast<int>(point.state));
  for (const auto& multiplier : model.present.contacts[0].multiplier_results)
    result.push_back(static_cast<int>(multiplier.state));
  return result;
}

template <int D> VectorX unbalanced(Model<D>& model, const VectorX& u, bool tangent = false) {
  model.present.displacement = u;
  Message why;
  EXPECT_EQ(evaluate(model, {tangent}, why), solve::Outcome::converged);
  return model.unbalanced;
}

template <int D> MatrixX tangent_of(const Model<D>& model) {
  const solve::Pattern& pattern = model.system.assembly.tangent().pattern;
  MatrixX full = MatrixX::Zero(pattern.size, pattern.size);
  for (int j = 0; j < pattern.size; ++j)
    for (int k = pattern.starts[j]; k < pattern.starts[j + 1]; ++k)
      full(pattern.rows[k], j) = model.system.assembly.tangent().values[k];
  return full;
}

/// A deformed state with the tool moved, turned by `angle` and accepted, then moved on by up to `slip`.
template <int D> VectorX state(Model<D>& model, double angle, double depth, double slip, Random& random) {
  const Unknowns<D>& unknowns = model.system.unknowns;
  const auto shake = [&](VectorX& u, double size) {
    for (int dof = 0; dof < unknowns.dofs(); ++dof)
      if (unknowns.unknown(dof) >= 0) u(dof) += uniform(random, -size, size);
  };
  VectorX u = VectorX::Zero(unknowns.dofs());
  u(unknowns.obstacle_offset(0) + D - 1) = -depth;
  for (const FreeAngle<D>& free : unknowns.free_angles()) u(free.dof) = free.arm * angle;
  if (unknowns.free_angles().empty()) set_target(model, 0, D - 1, angle * 180 / std::numbers::pi);
  u += model.system.drives.displacement(model.targets);
  shake(u, 0.003);
  unbalanced(model, u);
  model.system.commit(model.present, model.accepted);
  model.accepted = model.present;
  shake(u, slip);
  return u;
}

/// Compares the tangent with differences of the residual; false if a difference changes the discrete state.
template <int D> bool tangent_holds(Model<D>& model, const VectorX& u) {
  unbalanced(model, u, true);
  const MatrixX tangent = tangent_of(model);
  const std::vector<int> before = signature(model);
  bool same = true;
  MatrixX slopes(tangent.rows(), tangent.cols());
  for (int i = 0; i < tangent.cols() && same; ++i) {
    const VectorX direction = model.system.unknowns.spread(VectorX::Unit(tangent.cols(), i));
    slopes.col(i) = signorini::test::derivative<VectorX>(
        [&](double h) {
          const VectorX force = unbalanced(model, u + h * direction);
          same = same && signature(model) == before;
          return force;
        },
        2e-6);
  }
  if (!same) return false;
  EXPECT_LT((slopes - tangent).norm(), 1e-8 * tangent.norm());
  return true;
}

template <int D> std::vector<Method> methods() {
  std::vector<Method> all;
  for (double mu : {0.0, 0.4}) {
    const contact::InterfaceLaw law{20, 20, mu};
    contact::InterfaceLaw multipliers = law;
    multipliers.enforcement = Enforcement::multipliers;
    all.insert(all.end(), {law, Method{law, MultiplierSpace::equal}, Method{multipliers, MultiplierSpace::equal}});
  }
  return all;
}

template <int D> std::vector<contact::Obstacle<D>> tools() {
  if constexpr (D == 2)
    return {contact::make_ball<2>({0, 0.5}, 0.5), contact::make_plane<2>({0, 0}, {0, -1}),
            nurbs::arc(Eigen::Vector2d(0, 0.6), 0.6, 200, 340)};
  else
    return {contact::make_ball<3>({0, 0, 0.6}, 0.6), contact::make_cylinder({0, 0, 0.5}, {0, 1, 0}, 0.5)};
}

template <int D> void expect_tangents(int least) {
  Random random(1);
  int compared = 0, touching = 0, slipping = 0;
  for (const contact::Obstacle<D>& tool : tools<D>())
    for (const Method& method : methods<D>()) {
      Model<D> model(pressed<D>(tool, method, true));
      for (double angle : {0.0, std::holds_alternative<contact::Ball<D>>(tool) ? 7.0 : 0.2}) {
        const VectorX u = state(model, angle, 0.12, 0.004, random);
        compared += tangent_holds(model, u);
        touching += resultant(model.present.contacts[0]).active;
        slipping += resultant(model.present.contacts[0]).slipping;
      }
    }
  EXPECT_GE(compared, least);
  EXPECT_GT(touching, 100);
  EXPECT_GT(slipping, 20);
}

TEST(Turning, TangentOfFreeTranslationAndAngleIn2D) {
  expect_tangents<2>(30);
}

TEST(Turning, TangentOfFreeTranslationAndAngleIn3D) {
  expect_tangents<3>(18);
}

/// The tangent times the rate of a driven angle is the derivative of the residual.
template <int D> void expect_product(const contact::Obstacle<D>& tool) {
  Random random(2);
  for (const Method& method : methods<D>()) {
    Model<D> model(pressed<D>(tool, method, false));
    const VectorX u = state(model, 0.3, 0.12, 0.004, random), targets = model.targets;
    const VectorX along = VectorX::Unit(targets.size(), D - 1) * 40;
    const VectorX rate = model.system.drives.rate(targets, along);
    const VectorX others = u - model.system.drives.displacement(targets);
    model.present.displacement = u;
    Message why;
    evaluate(model, {true, &rate}, why);
    const VectorX product = model.system.unknowns.gather(model.system.assembly.product());
    const std::vector<int> before = signature(model);
    bool same = true;
    const VectorX slope = signorini::test::derivative<VectorX>(
        [&](double h) {
          const VectorX force = unbalanced(model, others + model.system.drives.displacement(targets + h * along));
          same = same && signature(model) == before;
          return force;
        },
        2e-6);
    EXPECT_TRUE(same);
    EXPECT_LT((slope - product).norm(), 1e-7 * product.norm());
  }
}

TEST(Turning, ProductWithADrivenAngle) {
  expect_product<2>(contact::make_ball<2>({0, 0.5}, 0.5));
  expect_product<3>(contact::make_cylinder({0, 0, 0.5}, {0, 1, 0}, 0.5));
}

} // namespace turning_test
} // namespace signorini::model
