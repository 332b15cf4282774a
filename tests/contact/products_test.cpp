// The products of many contact points against the sum of their terms.
#include "contact/face/products.hpp"

#include "nurbs/random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::contact {
namespace products_test {

using nurbs::test::Random;
using nurbs::test::uniform;

TEST(Products, SumTheTermsOfAllPoints) {
  Random random(1);
  Products products;
  for (int round = 0; round < 6; ++round) {
    const int master = 2 + round, nodes = master + 3 + 2 * round, columns = 7 + 45 * round, points = round * 40;
    std::vector<double> block(static_cast<std::size_t>(3 * nodes * columns), 0.5), expected = block;
    products.start(nodes, master, columns, block.data());
    const auto value = [](double* values, int i) -> double& { return values[i]; };
    for (int p = 0; p < points; ++p) {
      const Products::Factors factors = products.add();
      const auto fill = [&](double* values, int count) {
        for (int i = 0; i < count; ++i) values[i] = uniform(random, -1, 1);
      };
      fill(factors.left, nodes);
      fill(factors.traction, 3 * columns);
      fill(factors.rates, 6 * master);
      fill(factors.shift, 2 * columns);
      for (int a = 0; a < nodes; ++a)
        for (int i = 0; i < 3; ++i)
          for (int c = 0; c < columns; ++c) {
            double& sum = value(expected.data(), (3 * a + i) * columns + c);
            sum += factors.left[a] * factors.traction[i * columns + c];
            const int m = a - (nodes - master);
            for (int k = 0; k < 2 && m >= 0; ++k)
              sum += factors.rates[3 * (k * master + m) + i] * factors.shift[k * columns + c];
          }
    }
    products.finish();
    for (std::size_t i = 0; i < block.size(); ++i) EXPECT_NEAR(block[i], expected[i], 1e-13 * (points + 1));
  }
}

} // namespace products_test
} // namespace signorini::contact
