#pragma once
// Numerical derivatives, with which tests compare tangents.

namespace signorini::test {

/// Derivative of `f` (double → number or Eigen object) at 0: central differences with three steps, Richardson
/// extrapolation of the terms of order h² and h⁴.
template <class Value, class F> Value derivative(const F& f, double h) {
  const auto central = [&](double step) { return Value((f(step) - f(-step)) / (2 * step)); };
  const Value coarse = central(2 * h), middle = central(h), fine = central(h / 2);
  const Value once = (4 * fine - middle) / 3, twice = (4 * middle - coarse) / 3;
  return (16 * once - twice) / 15;
}

} // namespace signorini::test
