// The cohesive law at one point: traction, its derivative, energies, and secant unloading.
#include "contact/law/cohesion.hpp"

#include "differences.hpp"
#include "nurbs/random_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace signorini::contact {
namespace cohesion_test {

const Cohesion laws[] = {{2, 0.3}, {0.5, 1.7}, {2, 0.3, Softening::bilinear, 40}, {0.5, 1.7, Softening::bilinear, 0.2}};

double traction(const Cohesion& law, double opening) {
  return separate(law, opening, 0).stiffness * opening;
}

TEST(Cohesion, TractionIsThePublishedFunction) {
  for (const Cohesion& law : laws) {
    const double peak = strongest_opening(law), last = 2 * law.energy / law.strength;
    for (double x = 0.05; x < 8; x *= 1.3) {
      const double opening = x * peak;
      const double linear =
          x < 1 ? law.stiffness * opening : std::max(0.0, law.strength * (last - opening) / (last - peak));
      const double smooth = std::numbers::e * law.strength * x * std::exp(-x);
      EXPECT_NEAR(traction(law, opening), law.softening == Softening::bilinear ? linear : smooth, 1e-14 * law.strength);
    }
    EXPECT_NEAR(traction(law, peak), law.strength, 1e-14 * law.strength);
  }
}

TEST(Cohesion, RatesAreDerivatives) {
  for (const Cohesion& law : laws)
    for (double x : {0.3, 0.8, 1.2, 2.0, 3.5, 5.0}) {
      const double peak = strongest_opening(law), opening = x * peak;
      const Separation at = separate(law, opening, 0);
      const auto slope = [&](auto value) {
        return signorini::test::derivative<double>([&](double h) { return value(separate(law, opening + h, 0)); },
                                                   1e-3 * peak);
      };
      EXPECT_NEAR(at.rate, slope([](const Separation& s) { return s.stiffness; }), 1e-8 * law.strength / (peak * peak));
      EXPECT_NEAR(at.damage_rate, slope([](const Separation& s) { return s.damage; }), 1e-8 / peak);
      // dissipated + ½ T δ is the work of the traction.
      const double work = signorini::test::derivative<double>(
          [&](double h) {
            return separate(law, opening + h, 0).dissipated + 0.5 * traction(law, opening + h) * (opening + h);
          },
          1e-3 * peak);
      EXPECT_NEAR(work, traction(law, opening), 1e-8 * law.strength);
    }
}

TEST(Cohesion, SeparationTakesTheEnergy) {
  for (const Cohesion& law : laws) {
    const Separation broken = separate(law, 41 * strongest_opening(law) + 2 * law.energy / law.strength, 0);
    EXPECT_EQ(broken.dissipated, law.energy);
    EXPECT_EQ(broken.damage, 1);
    EXPECT_EQ(broken.stiffness, 0);
    // Just before the tail is cut off, the energy is complete.
    const Separation late = separate(law, 39.9 * strongest_opening(law), 0);
    EXPECT_NEAR(late.dissipated, law.energy, law.softening == Softening::exponential ? 1e-13 * law.energy : 1e300);
  }
}

TEST(Cohesion, ClosesAlongTheSecant) {
  for (const Cohesion& law : laws) {
    const double peak = strongest_opening(law), most = 1.4 * peak;
    const Separation last = separate(law, most, 0);
    for (double part : {0.0, 0.3, 0.99}) {
      const Separation at = separate(law, part * most, most);
      EXPECT_EQ(at.stiffness, last.stiffness);
      EXPECT_EQ(at.rate, 0);
      EXPECT_EQ(at.damage_rate, 0);
      EXPECT_EQ(at.dissipated, last.dissipated);
    }
    EXPECT_LT(separate(law, most, most).rate, 0); // opens farther
  }
  // Below its strength a bilinear bond is elastic.
  EXPECT_EQ(separate(laws[2], 0.02, 0.04).damage, 0);
  EXPECT_EQ(separate(laws[2], 0.02, 0.04).stiffness, 40);
}

TEST(Cohesion, ErrorsNameTheArgument) {
  EXPECT_ERROR(check(Cohesion{0, 1}), "contact.cohesion.strength: value = 0");
  EXPECT_ERROR(check(Cohesion{1, -2}), "contact.cohesion.energy: value = -2");
  EXPECT_ERROR(check(Cohesion{1, std::nan("")}), "contact.cohesion.energy");
  EXPECT_ERROR(check(Cohesion{1, 1, Softening::bilinear, 0}), "contact.cohesion.stiffness: value = 0");
  EXPECT_ERROR(check(Cohesion{2, 1, Softening::bilinear, 2}), "contact.cohesion.snap_back: stiffness = 2, least = 2");
}

} // namespace cohesion_test
} // namespace signorini::contact
