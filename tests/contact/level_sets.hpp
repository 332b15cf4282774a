#pragma once
// Formulas of level sets.

#include "contact/rigid/obstacle.hpp"
#include "contact/terms.hpp"

namespace signorini::contact::test {

/// f(coordinates) in a box of half the side `size` about `center`.
template <int D, class F> LevelSet<D> level_set(const F& f, const Vec<D>& center, double size) {
  const auto graph = std::make_shared<symbolic::Graph>(level_set_variables<D>());
  std::vector<Term> x;
  for (int d = 0; d < D; ++d) x.push_back({graph, graph->variable(d)});
  const Term value = f(x);
  return make_level_set<D>({*graph, value.node}, Vec<D>(center.array() - size), Vec<D>(center.array() + size));
}

/// |x − c|² − R² of a ball that is not hollow.
template <int D> LevelSet<D> level_set_of(const Ball<D>& ball, double size) {
  const auto f = [&](const std::vector<Term>& x) {
    Term sum = x[0].constant(-ball.radius * ball.radius);
    for (int d = 0; d < D; ++d) sum = sum + power(x[d] - ball.center(d), 2);
    return sum;
  };
  return level_set<D>(f, ball.center, size);
}

/// n·(x − p).
template <int D> LevelSet<D> level_set_of(const Plane<D>& plane, double size) {
  const auto f = [&](const std::vector<Term>& x) {
    Term sum = x[0].constant(0);
    for (int d = 0; d < D; ++d) sum = sum + plane.normal(d) * (x[d] - plane.point(d));
    return sum;
  };
  return level_set<D>(f, plane.point, size);
}

/// (ρ − R)² + h² − r², with h the height along the axis.
inline LevelSet<3> level_set_of(const Torus& torus, double size) {
  const auto f = [&](const std::vector<Term>& x) {
    Term height = x[0].constant(0), square = x[0].constant(0);
    for (int d = 0; d < 3; ++d) {
      height = height + torus.axis(d) * (x[d] - torus.center(d));
      square = square + power(x[d] - torus.center(d), 2);
    }
    const Term radius = power(square - power(height, 2), 0.5);
    return power(radius - torus.ring, 2) + power(height, 2) - torus.radius * torus.radius;
  };
  return level_set<3>(f, torus.center + Vec<3>(1e-3, 2e-3, 3e-3), size); // the lattice has no node on the axis
}

} // namespace signorini::contact::test
