// All kernels that this machine supports compared with the formulas, term by term: for any number of functions, and
// without writing beyond the padding.
#include "solid/kernel.hpp"

#include "base/error.hpp"
#include "solid/bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace signorini::solid {
namespace kernel_test {

using namespace test;

/// Gauss points of an element that does not belong to a mesh.
template <int D> struct Element {
  int n, points;
  double lambda = 1.3, mu = 0.7;
  std::vector<double> local, gradients, weights, constant;

  Element(Random& random, int functions, int count) : n(functions), points(count) {
    const auto fill = [&](std::vector<double>& values, int size, double low, double high) {
      for (int i = 0; i < size; ++i) values.push_back(uniform(random, low, high));
    };
    fill(local, D * n, -0.1, 0.1);
    const double steep = 3 / std::sqrt(n); // strains near 0.1 for any n
    fill(gradients, points * D * n, -steep, steep);
    fill(weights, points, 0.5, 1.5);
    fill(constant, n * n, -1, 1);
    // Values in the padding must not affect results.
    gradients.resize(gradients.size() + vector_padding, 1e300);
    constant.resize(constant.size() + vector_padding, 1e300);
  }

  /// Force and blocks, evaluated directly from the formulas.
  std::vector<double> reference() const {
    std::vector<double> force(D * n, 0.0), blocks;
    std::vector<Mat<D>> inverses, stresses;
    std::vector<double> brackets;
    const auto gradient = [&](int q, int a) {
      Vec<D> g;
      for (int k = 0; k < D; ++k) g(k) = gradients[(q * D + k) * n + a];
      return g;
    };
    for (int q = 0; q < points; ++q) {
      Mat<D> f = Mat<D>::Identity();
      for (int a = 0; a < n; ++a)
        for (int i = 0; i < D; ++i) f.row(i) += local[i * n + a] * gradient(q, a).transpose();
      inverses.push_back(f.inverse());
      brackets.push_back(mu - lambda * std::log(f.determinant()));
      const Mat<D> stress = mu * f - brackets.back() * inverses.back().transpose();
      for (int a = 0; a < n; ++a)
        for (int i = 0; i < D; ++i) force[i * n + a] += weights[q] * stress.row(i).dot(gradient(q, a));
    }
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j)
        for (int a = 0; a < n; ++a)
          for (int b = 0; b < n; ++b) {
            double sum = i == j ? constant[a * n + b] : 0;
            for (int q = 0; q < points; ++q) {
              const Vec<D> ga = inverses[q].transpose() * gradient(q, a), gb = inverses[q].transpose() * gradient(q, b);
              sum += weights[q] * (brackets[q] * ga(j) * gb(i) + lambda * ga(i) * gb(j));
            }
            blocks.push_back(sum);
          }
    force.insert(force.end(), blocks.begin(), blocks.end());
    return force;
  }
};

template <int D> void kernels_follow_the_book(const std::vector<int>& functions) {
  Random random(2);
  for (int n : functions)
    for (int points : {1, 4, 27}) {
      const Element<D> element(random, n, points);
      const std::vector<double> expected = element.reference();
      const Eigen::Map<const VectorX> all(expected.data(), static_cast<int>(expected.size()));
      for (Kernel kernel : element_kernels<D>(n)) {
        constexpr double untouched = 123;
        const std::size_t size = D * (D + 1) / 2 * n * n + vector_padding;
        std::vector<double> force(D * n + 1, untouched), blocks(size + 1, untouched),
            factors(2 * points + 1, untouched), work(working_size(D, n, points) + 1, untouched);
        for (int with_tangent : {0, 1}) {
          const KernelResult result =
              kernel({n, points, element.lambda, element.mu, element.local.data(), element.gradients.data(),
                      element.weights.data(), nullptr, element.constant.data(), force.data(), work.data(),
                      factors.data(), with_tangent ? blocks.data() : nullptr});
          EXPECT_EQ(result.point, -1);
          const Eigen::Map<const VectorX> found(force.data(), D * n);
          // The formulas sum F in another order, and stress is a difference ten times smaller than its terms.
          EXPECT_LT((found - all.head(D * n)).norm(), 1e-13 * all.head(D * n).norm()) << n;
        }
        const Eigen::Map<const VectorX> found(blocks.data(), static_cast<int>(size - vector_padding));
        EXPECT_LT((found - all.tail(found.size())).norm(), 1e-13 * found.norm()) << n << " " << points;
        for (const auto* array : {&force, &blocks, &factors, &work}) EXPECT_EQ(array->back(), untouched) << n;
      }
    }
}

TEST(Kernel, InThePlaneAgreesWithTheFormulas) {
  kernels_follow_the_book<2>({4, 5, 6, 9, 11, 14, 25});
}
TEST(Kernel, InSpaceAgreesWithTheFormulas) {
  kernels_follow_the_book<3>({8, 9, 18, 25, 27, 31, 32, 33, 34, 50, 67});
}

TEST(Kernel, InversionIsReportedAtItsPoint) {
  Random random(3);
  for (double slope : {-1.5, std::numeric_limits<double>::quiet_NaN()}) {
    Element<3> element(random, 18, 5);
    // At the second-to-last point F becomes I + slope e₁⊗e₁.
    for (int k = 0; k < 3; ++k)
      for (int a = 0; a < 18; ++a) element.gradients[(3 * 3 + k) * 18 + a] = k == 0 && a == 17 ? 1 : 0;
    for (int i = 0; i < 3; ++i) element.local[i * 18 + 17] = 0;
    element.local[17] = slope;
    for (int q : {0, 1, 2})
      for (int k = 0; k < 3; ++k) element.gradients[(3 * q + k) * 18 + 17] = 0;
    for (Kernel kernel : element_kernels<3>(18)) {
      std::vector<double> force(54), factors(10), work(working_size(3, 18, 5));
      const KernelResult result = kernel({18, 5, element.lambda, element.mu, element.local.data(),
                                          element.gradients.data(), element.weights.data(), nullptr,
                                          element.constant.data(), force.data(), work.data(), factors.data(), nullptr});
      EXPECT_EQ(result.point, std::isnan(slope) ? 0 : 3);
      EXPECT_FALSE(result.jacobian > 0);
    }
  }
}

TEST(Kernel, EnvironmentVariableLimitsTheInstructions) {
  const auto message = [](const char* wanted) -> std::string {
    try {
      widest_instructions(wanted);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const Instructions widest = widest_instructions(nullptr);
  EXPECT_EQ(widest_instructions(""), widest);
  EXPECT_EQ(widest_instructions(instruction_names[0]), Instructions::baseline);
  for (int i = 0; i < 3; ++i) {
    const char* name = instruction_names[i];
    if (i <= static_cast<int>(widest))
      EXPECT_EQ(static_cast<int>(widest_instructions(name)), i);
    else
      EXPECT_NE(message(name).find(text("solid.kernel.lacking: name = ", name)), std::string::npos);
  }
  EXPECT_NE(message("AVX").find("solid.kernel.unknown: name = AVX"), std::string::npos);
}

} // namespace kernel_test
} // namespace signorini::solid
