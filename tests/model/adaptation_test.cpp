// Bodies replaced by bodies with other rows in the middle of a path: nothing changes where the new rows contain the old
// ones, little where they do not, and the path continues.
#include "model/adapt/adaptation.hpp"

#include "model/files/checkpoint.hpp"
#include "model/scenes.hpp"
#include "model/steps/equilibrium.hpp"
#include "nurbs/shapes.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

namespace signorini::model {
namespace adaptation_test {

using namespace test;
using contact::Enforcement;
using contact::MultiplierSpace;
using contact::TractionArea;

void iron(Model<2>& model, int from, int to) {
  for (int step = from; step <= to; ++step) {
    const double press = std::min(step, 5) / 5.0, slide = std::max(step - 5, 0) / 40.0;
    const auto report = step_to(model, drive_of_grip, 1.5 * slide, -0.08 * press, {});
    ASSERT_EQ(report.outcome, solve::Outcome::converged) << step << ": " << text_of(report.messages);
    accept(model);
  }
}

Bodies<2> bodies_of(const std::string& label) {
  Bodies<2> bodies;
  for (const auto& named : ironing(label).bodies) bodies.push_back(named.body);
  return bodies;
}

Scene<2> scene_of(const std::string& label, const contact::Method& method) {
  Scene<2> scene = ironing(label);
  scene.contacts[0].method = method;
  scene.contacts[0].points = 9;
  return scene;
}

const std::vector<contact::Method> methods{
    contact::InterfaceLaw{100, 100, 0.2}, contact::Method{{100, 100, 0.2}, MultiplierSpace::equal},
    contact::Method{{0, 0, 0.2, TractionArea::reference, Enforcement::multipliers}, MultiplierSpace::equal},
    contact::Method{{100, 100, 0.2}, MultiplierSpace::reduced}};

/// N2-N2.2 contains N2: the same state in more unknowns has the same contact at Gauss points, forces and energies.
/// Mortar contact weighs gaps with other functions then.
TEST(OtherRows, GrowExactly) {
  Model<2> model(scene_of("N2", methods[0]));
  iron(model, 1, 9);
  const auto grown = with_bodies(model, bodies_of("N2-N2.2"));
  const auto accepted = resultant(model.present.contacts[0]);
  for (const int support : {bed, grip})
    EXPECT_LT((reaction(model, support) - reaction(*grown, support)).norm(), 1e-12 * model.path.force_scale);
  Message why;
  evaluate(model, {}, why); // with the slip points of the accepted state
  EXPECT_GT(grown->system.unknowns.size(), model.system.unknowns.size());
  const Energies before = energies(model), after = energies(*grown);
  EXPECT_NEAR(after.stored, before.stored, 1e-4 * before.stored); // more Gauss points
  EXPECT_NEAR(after.contact, before.contact, 1e-6 * before.contact);
  EXPECT_EQ(after.friction, before.friction);
  EXPECT_EQ(after.work, before.work);
  const auto old = resultant(model.present.contacts[0]), now = resultant(grown->present.contacts[0]);
  EXPECT_LT((old.force - now.force).norm(), 1e-9 * old.force.norm());
  EXPECT_EQ(accepted.active, now.active);
  EXPECT_EQ(accepted.slipping, now.slipping);
  iron(*grown, 10, 12);
}

/// There and back: the old state, up to rounding errors.
TEST(OtherRows, ReturnToTheSameState) {
  for (std::size_t m = 0; m < methods.size(); ++m) {
    Model<2> model(scene_of("N2", methods[m]));
    iron(model, 1, 9);
    const auto back = with_bodies(*with_bodies(model, bodies_of("N2-N2.2")), bodies_of("N2"));
    EXPECT_LT((back->present.displacement - model.present.displacement).norm(),
              1e-10 * model.present.displacement.norm())
        << m;
    EXPECT_LT((reaction(model, grip) - reaction(*back, grip)).norm(), 1e-12 * model.path.force_scale) << m;
    iron(*back, 10, 10);
    iron(model, 10, 10);
    EXPECT_LT((back->present.displacement - model.present.displacement).norm(),
              1e-6 * model.present.displacement.norm())
        << m;
  }
}

} // namespace adaptation_test
} // namespace signorini::model
