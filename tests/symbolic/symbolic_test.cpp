#include "differences.hpp"
#include "symbolic/tape.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::symbolic {
namespace symbolic_test {

/// Formulas of x and y with all operations; values and derivatives are finite at positive x and y.
std::vector<int> formulas(Graph& g) {
  const int x = g.variable(0), y = g.variable(1);
  const auto c = [&](double value) { return g.constant(value); };
  std::vector<int> list{
      c(2.5),
      x,
      g.add(x, g.multiply(c(3), y)),
      g.subtract(g.multiply(x, y), g.divide(x, y)),
      g.power(x, -2.0 / 3),
      g.multiply(g.power(x, -2.0 / 3), g.power(y, 3.0)),
      g.power(g.add(x, y), 2.5),
      g.power(x, y),
      g.divide(c(1), g.add(c(1), g.power(x, 7.0))),
      g.power(g.add(x, c(1)), 0.5),
      g.power(x, 40.0),
  };
  for (int f = static_cast<int>(Operation::log); f <= static_cast<int>(Operation::sign); ++f)
    list.push_back(g.multiply(x, g.apply(static_cast<Operation>(f), g.multiply(x, y))));
  return list;
}

const std::vector<std::vector<double>> places{{0.7, 1.1}, {1.3, 0.4}, {0.5, 0.5}};

double value(const Graph& g, int formula, const std::vector<double>& at) {
  return evaluate(compile(g, {formula}, true), at).front();
}

TEST(Symbolic, ValuesAreThoseOfTheFormula) {
  Graph g({"x", "y"});
  const std::vector<int> all = formulas(g);
  for (const auto& at : places) {
    const double x = at[0], y = at[1];
    const std::vector<double> expected{2.5,
                                       x,
                                       x + 3 * y,
                                       x * y - x / y,
                                       std::pow(x, -2.0 / 3),
                                       std::pow(x, -2.0 / 3) * y * y * y,
                                       std::pow(x + y, 2.5),
                                       std::pow(x, y),
                                       1 / (1 + std::pow(x, 7)),
                                       std::sqrt(x + 1),
                                       std::pow(x, 40),
                                       x * std::log(x * y),
                                       x * std::exp(x * y),
                                       x * std::sin(x * y),
                                       x * std::cos(x * y),
                                       x * std::tan(x * y),
                                       x * std::atan(x * y),
                                       x * std::sinh(x * y),
                                       x * std::cosh(x * y),
                                       x * std::tanh(x * y),
                                       x * x * y,
                                       x};
    ASSERT_EQ(all.size(), expected.size());
    for (const bool positive : {false, true}) {
      const std::vector<double> together = evaluate(compile(g, all, positive), at);
      for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_NEAR(together[i], expected[i], 1e-14 * (1 + std::abs(expected[i]))) << text_of(g, all[i]);
    }
  }
}

TEST(Symbolic, DerivativesAreThoseOfFiniteDifferences) {
  Graph g({"x", "y"});
  for (int formula : formulas(g))
    for (int first : {0, 1}) {
      const int slope = derivative(g, formula, first);
      for (int second : {0, 1}) {
        const int curvature = derivative(g, slope, second);
        for (const auto& at : places) {
          const auto moved = [&](int variable, double h) {
            std::vector<double> place = at;
            place[variable] += h;
            return place;
          };
          const auto values = [&](double h) { return value(g, formula, moved(first, h)); };
          const auto slopes = [&](double h) { return value(g, slope, moved(second, h)); };
          const double s = value(g, slope, at), c = value(g, curvature, at);
          EXPECT_NEAR(test::derivative<double>(values, 1e-4), s, 1e-8 * (1 + std::abs(s))) << text_of(g, formula);
          EXPECT_NEAR(test::derivative<double>(slopes, 1e-4), c, 1e-8 * (1 + std::abs(c))) << text_of(g, formula);
        }
      }
    }
}

TEST(Symbolic, FormulasAreSimplified) {
  Graph g({"x", "y"});
  const int x = g.variable(0), y = g.variable(1), two = g.constant(2);
  EXPECT_EQ(g.add(x, y), g.add(y, x));
  EXPECT_EQ(g.subtract(x, x), g.constant(0));
  EXPECT_EQ(g.divide(x, x), g.constant(1));
  EXPECT_EQ(g.add(x, x), g.multiply(two, x));
  EXPECT_EQ(g.multiply(two, g.multiply(x, two)), g.multiply(g.constant(4), x));
  EXPECT_EQ(g.add(g.subtract(x, two), two), x);
  EXPECT_EQ(g.multiply(g.power(x, 2.0), g.power(x, -3.0)), g.power(x, -1.0));
  EXPECT_EQ(g.power(g.power(x, 2.0), 3.0), g.power(x, 6.0));
  EXPECT_NE(g.power(g.power(x, 2.0), 0.5), x); // |x|
  EXPECT_EQ(g.apply(Operation::log, g.apply(Operation::exp, x)), x);
  EXPECT_EQ(derivative(g, g.apply(Operation::sign, x), 0), g.constant(0));
  EXPECT_EQ(derivative(g, g.power(g.subtract(x, two), 2.0), 1), g.constant(0));
}

TEST(Symbolic, TextIsALuaExpression) {
  Graph g({"I1", "J"});
  const int i1 = g.variable(0), j = g.variable(1), log = g.apply(Operation::log, j);
  const auto c = [&](double value) { return g.constant(value); };
  EXPECT_EQ(text_of(g, g.multiply(c(2), g.subtract(i1, c(3)))), "2*(I1 - 3)");
  EXPECT_EQ(text_of(g, g.subtract(g.power(log, 2.0), g.multiply(c(0.5), log))), "log(J)^2 - 0.5*log(J)");
  EXPECT_EQ(text_of(g, g.subtract(i1, g.add(j, c(1)))), "I1 - (J + 1)");
  EXPECT_EQ(text_of(g, g.divide(i1, g.multiply(c(2), j))), "I1/(2*J)");
  EXPECT_EQ(text_of(g, g.power(j, -2.0)), "J^(-2)");
  EXPECT_EQ(text_of(g, g.power(g.power(j, 2.0), 0.5)), "sqrt(J^2)");
  EXPECT_EQ(text_of(g, g.power(g.add(j, i1), i1)), "(I1 + J)^I1");
}

TEST(Symbolic, VeryLongTextsAreNotWritten) {
  Graph g({"x"});
  int node = g.variable(0);
  for (int i = 0; i < 60; ++i) node = g.add(g.constant(1), g.multiply(node, g.apply(Operation::sin, node)));
  EXPECT_EQ(text_of(g, node), "a formula of 182 operations");
}

/// Powers of J with exponents that differ by integers take one call of pow.
TEST(Symbolic, TapesShareSubexpressionsAndRegisters) {
  Graph g({"J"});
  const int w = g.power(g.variable(0), -2.0 / 3), slope = derivative(g, w, 0), curvature = derivative(g, slope, 0);
  const auto powers = [](const Tape& tape) {
    return std::count_if(tape.code.begin(), tape.code.end(), [](const auto& one) { return one.code == Code::power; });
  };
  EXPECT_EQ(powers(compile(g, {w, slope, curvature}, true)), 1);
  EXPECT_EQ(powers(compile(g, {w, slope, curvature}, false)), 3);
  // Exponents that differ by rounding error only.
  const int same = g.power(g.variable(0), 1.0 / 3 - 1);
  EXPECT_NE(same, w);
  EXPECT_EQ(powers(compile(g, {w, same}, true)), 1);
  // A long chain needs few registers.
  int chain = g.variable(0);
  for (int i = 0; i < 50; ++i) chain = g.apply(Operation::sin, g.add(chain, g.constant(1)));
  EXPECT_LE(compile(g, {chain}, true).registers, 4);
  const Tape zero = compile(g, {g.constant(0), g.variable(0)}, true);
  EXPECT_EQ(zero.outputs, (std::vector<int>{-1, 0}));
  EXPECT_EQ(evaluate(zero, {3}), (std::vector<double>{0, 3}));
}

/// The value that is undefined at 0 must not spoil its square root's derivative there.
TEST(Symbolic, PowersOfVariablesThatMayBeZeroAreEvaluatedOneByOne) {
  Graph g({"x"});
  const int f = g.power(g.variable(0), 1.5), slope = derivative(g, f, 0);
  EXPECT_EQ(evaluate(compile(g, {f, slope}, false), {0}), (std::vector<double>{0, 0}));
}

} // namespace symbolic_test
} // namespace signorini::symbolic
