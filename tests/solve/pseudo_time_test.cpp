// Pseudo-transient continuation past a limit point of a force law with one unknown, known roots and known motion.
#include "solve/pseudo_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace signorini::solve {
namespace pseudo_time_test {

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// r(u) = u³ − 3u − λ: limit points at u = ∓1, λ = ±2.
double force(double u, double load) {
  return u * u * u - 3 * u - load;
}

/// The equilibrium to which (K + α) Δu = −r leads from u; NaN if there is none. States below `wall` are invalid.
double rest(double u, double load, double wall = -std::numeric_limits<double>::infinity()) {
  PseudoTime time;
  for (int move = 0; move < 400; ++move) {
    const double residual = force(u, load);
    if (std::abs(residual) < 1e-12) return u;
    const double step = -residual / (3 * u * u - 3 + time.damping());
    double error = std::numeric_limits<double>::infinity();
    if (std::isfinite(step) && u + step > wall)
      error = std::abs((force(u + step, load) + time.damping() * step) / residual);
    if (time.accept(error)) u += step;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(PseudoTime, PassesALimitPointToTheOnlyRoot) {
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    // The load is just above the limit point at u = −1; the root is beyond u = 2.
    const double load = 2 + uniform(random, 1e-6, 1), u = -1 + uniform(random, -0.1, 0.1), root = rest(u, load);
    EXPECT_GT(root, 2) << "from " << u << " under " << load;
    EXPECT_LT(std::abs(force(root, load)), 1e-12);
  }
}

TEST(PseudoTime, IsNewtonsMethodIfThatConverges) {
  PseudoTime time;
  for (const double error : {0.2, 0.05, 1e-3, 1e-6}) {
    EXPECT_TRUE(time.accept(error));
    EXPECT_EQ(time.damping(), 0);
  }
}

TEST(PseudoTime, StaysInValidStates) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const double u = uniform(random, -1.5, -1.05), load = 2 + uniform(random, 0.01, 1);
    EXPECT_GT(rest(u, load, -1.6), 2);
  }
}

TEST(PseudoTime, PassesAJump) {
  // A residual that no move reduces: moves become ten times shorter than those of the diagonal, then they are accepted.
  PseudoTime time;
  int trials = 1;
  while (!time.accept(60) && trials < 100) ++trials;
  EXPECT_LT(trials, 20);
  EXPECT_FALSE(time.accept(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(time.accept(std::numeric_limits<double>::quiet_NaN()));
}

} // namespace pseudo_time_test
} // namespace signorini::solve
