#include "contact/law/cohesion_formula.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace signorini::contact {

namespace {

constexpr int sampled_openings = 200, sampled_mixtures = 20, bisections = 60, most_halvings = 200,
              most_newton_steps = 8;
/// Rounding error of a formula, relative to its largest value.
constexpr double cohesion_rounding = 1e-9;
/// Opening, relative to the length of a law, below which its secant follows from slopes.
constexpr double small_opening = 1e-3;
/// Error of an energy per area, relative to the stiffness times the square of the length.
constexpr double integral_tolerance = 1e-14;
constexpr double far_opening = 1e8, least_fall = 1e-6, nearly_infinite = 1e-12;
/// Rounding error of a fraction that is left, relative to it.
constexpr double root_rounding = 1e-15;
/// An opening at which the slope is its limit u → 0: at u = 0 itself max and min take the mean of both sides.
constexpr double first_opening = 1e-200;
/// Damage that is rounding error.
constexpr double least_damage = 1e-12;

/// T, T_u and T_m, or the first of them.
std::array<double, 3> values(const symbolic::Tape& tape, double opening, double mix, int outputs = 3) {
  thread_local std::vector<double> registers;
  if (std::ssize(registers) < tape.registers) registers.resize(tape.registers);
  registers[0] = opening;
  registers[1] = mix;
  symbolic::evaluate(tape, registers.data(), 1, 1, outputs);
  std::array<double, 3> found{};
  for (std::size_t k = 0; k < 3; ++k)
    if (static_cast<int>(k) < outputs && tape.outputs[k] >= 0) found[k] = registers[tape.outputs[k]];
  return found;
}

/// T_u for u → 0.
double first_slope(const symbolic::Tape& tape, double mix) {
  return values(tape, first_opening, mix)[1];
}

/// ∫ f dx from a to b by Gauss–Lobatto's rule with 8 points, whose ends see every kink, in halves until two of them
/// agree with the whole.
template <class Function> double integrate(const Function& f, double a, double b, double tolerance, int depth = 30) {
  const auto sum = [&](double from, double to) {
    constexpr double nodes[] = {0.2092992179024789, 0.5917001814331423, 0.8717401485096066, 1};
    constexpr double weights[] = {0.4124587946587039, 0.3411226924835044, 0.2107042271435060, 0.0357142857142857};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double result = 0;
    for (std::size_t k = 0; k < std::size(nodes); ++k)
      result += half * weights[k] * (f(middle - half * nodes[k]) + f(middle + half * nodes[k]));
    return result;
  };
  const double middle = 0.5 * (a + b), whole = sum(a, b), halves = sum(a, middle) + sum(middle, b);
  if (depth == 0 || std::abs(halves - whole) <= std::max(tolerance, root_rounding * std::abs(halves))) return halves;
  return integrate(f, a, middle, tolerance, depth - 1) + integrate(f, middle, b, tolerance, depth - 1);
}

/// The opening at which the fraction that is left falls to a value: by Newton's method from a guess or, where that does
/// not end, doubled and halved from the law's length, then bisected.
double opening_at(const CohesionFormula& law, double left, double mix, double guess, double length) {
  for (int k = 0; k < most_newton_steps && guess > 0 && std::isfinite(guess); ++k) {
    const CohesionFormula::Left now = law.left(guess, mix);
    if (std::abs(now.value - left) <= root_rounding * left) return guess;
    guess -= (now.value - left) / now.of_opening;
  }
  const auto above = [&](double opening) { return law.left(opening, mix).value > left; };
  double high = length;
  for (int k = 0; k < most_halvings && above(high); ++k) high *= 2;
  double low = high;
  for (int k = 0; k < most_halvings && !above(low); ++k) high = std::exchange(low, 0.5 * low);
  for (int k = 0; k < bisections; ++k) {
    const double middle = 0.5 * (low + high);
    (above(middle) ? low : high) = middle;
  }
  return high;
}

double tolerance(const CohesionFormula& law) {
  return integral_tolerance * law.stiffness * law.length * law.length;
}

void check_at(const CohesionFormula& law, double mix) {
  const auto [start, rate, by_mix] = values(law.tape, 0, mix);
  require(std::isfinite(start) && std::isfinite(rate) && std::isfinite(by_mix), "contact.cohesion.finite",
          {{"opening", 0.0}, {"mix", mix}, {"value", start}});
  const double slope = first_slope(law.tape, mix);
  require(std::abs(slope - law.stiffness) <= cohesion_rounding * law.stiffness, "contact.cohesion.mixed_slope",
          {{"mix", mix}, {"value", slope}, {"first", law.stiffness}});
  const double scale = law.stiffness * law.length;
  require(std::abs(start) <= cohesion_rounding * scale, "contact.cohesion.start", {{"mix", mix}, {"value", start}});
  double before = 1;
  for (int k = 0; k <= sampled_openings; ++k) {
    const double opening = law.length * std::pow(10, -4 + 8.0 * k / sampled_openings);
    const auto [traction, rate, of_mix] = values(law.tape, opening, mix);
    require(std::isfinite(traction) && std::isfinite(rate) && std::isfinite(of_mix), "contact.cohesion.finite",
            {{"opening", opening}, {"mix", mix}, {"value", traction}});
    require(traction >= -cohesion_rounding * scale, "contact.cohesion.negative",
            {{"opening", opening}, {"mix", mix}, {"value", traction}});
    const double left = law.left(opening, mix).value;
    require(left <= before + cohesion_rounding, "contact.cohesion.secant",
            {{"opening", opening}, {"mix", mix}, {"value", left * law.stiffness}, {"before", before * law.stiffness}});
    before = left;
  }
  // Tails that fall more slowly than 1/u^1.75 count as those of an infinite area.
  const double far = far_opening * law.length, tail = law.traction(far, mix);
  require(tail * far <= least_fall * law.length * scale && std::isfinite(law.rest(0, mix)), "contact.cohesion.area",
          {{"opening", far}, {"mix", mix}, {"value", tail}});
}

} // namespace

std::vector<std::string> cohesion_variables() {
  return {"u", "m"};
}

std::string text_of(const CohesionFormula& law) {
  return symbolic::text_of(law.formula.graph, law.formula.node);
}

double CohesionFormula::traction(double opening, double mix) const {
  return values(tape, opening, mix, 1)[0];
}

CohesionFormula::Left CohesionFormula::left(double opening, double mix) const {
  if (opening == 0) return {1, 0, 0};
  const auto [traction, slope, by_mix] = values(tape, opening, mix);
  double value = traction / (stiffness * opening);
  // T/(K u) = ∫₀¹ T_u(s u) ds/K, by Simpson's rule: without cancellation in formulas that subtract
  if (opening < small_opening * length)
    value = (stiffness + 4 * values(tape, 0.5 * opening, mix)[1] + slope) / (6 * stiffness);
  if (std::abs(1 - value) < least_damage) return {1, 0, 0};
  return {std::max(0.0, value), (slope / stiffness - value) / opening, by_mix / (stiffness * opening)};
}

double CohesionFormula::rest(double opening, double mix) const {
  // u = u₀ + L x/(1 − x)
  const auto f = [&](double x) {
    const double rest = std::max(1 - x, nearly_infinite);
    return traction(opening + length * (1 - rest) / rest, mix) * length / (rest * rest);
  };
  double sum = 0.5 * traction(opening, mix) * opening;
  for (int panel = 0; panel < 8; ++panel) sum += integrate(f, panel / 8.0, (panel + 1) / 8.0, tolerance(*this));
  return sum;
}

CohesionFormula::Loss CohesionFormula::loss(double before, double after, double mix, double near_first,
                                            double near_last) const {
  const double first = before < 1 ? opening_at(*this, before, mix, near_first, length) : 0;
  if (after == 0) return {rest(first, mix), 0};
  const double last = opening_at(*this, after, mix, near_last, length);
  // ∫ T du − ½ Δ(T u)
  const auto f = [&](double opening) { return traction(opening, mix); };
  const double dissipated =
      std::max(0.0, integrate(f, first, last, tolerance(*this)) + 0.5 * (f(first) * first - f(last) * last));
  const double left = rest(last, mix);
  return {dissipated, dissipated + left > 0 ? left / (dissipated + left) : 0};
}

CohesionFormula::Peak CohesionFormula::peak(double mix) const {
  const auto at = [&](double opening) { return traction(opening, mix); };
  const auto opening = [&](int k) { return length * std::pow(10, -3 + 6.0 * k / sampled_openings); };
  int best = 0;
  for (int k = 1; k <= sampled_openings; ++k)
    if (at(opening(k)) > at(opening(best))) best = k;
  double low = opening(best - 1), high = opening(best + 1);
  for (int k = 0; k < 2 * bisections; ++k) {
    const double third = (high - low) / 3;
    if (at(low + third) < at(high - third))
      low += third;
    else
      high -= third;
  }
  return {at(low), low};
}

std::shared_ptr<const CohesionFormula> make_cohesion_formula(symbolic::Formula formula, double shear) {
  auto made = std::make_shared<CohesionFormula>(CohesionFormula{std::move(formula), shear, {}, false, 0, 0});
  auto& [graph, node] = made->formula;
  const int by_opening = symbolic::derivative(graph, node, 0), by_mix = symbolic::derivative(graph, node, 1);
  made->mixed = !graph.is_constant(by_mix, 0);
  made->tape = symbolic::compile(graph, {node, by_opening, by_mix}, false);
  require(std::isfinite(shear) && shear > 0, "contact.cohesion.shear", {{"value", shear}});
  const double start = made->traction(0, 0), rate = values(made->tape, 0, 0)[1];
  made->stiffness = first_slope(made->tape, 0);
  const bool rises = std::isfinite(rate) && std::isfinite(made->stiffness) && made->stiffness > 0;
  require(rises || start == 0, "contact.cohesion.start", {{"mix", 0.0}, {"value", start}});
  require(rises, "contact.cohesion.slope", {{"value", std::isfinite(rate) ? made->stiffness : rate}});
  const double far = made->length = opening_at(*made, 0.5, 0, 0, 1);
  const bool falls = made->left(far, 0).value <= 0.5 + cohesion_rounding;
  require(falls || start == 0, "contact.cohesion.start", {{"mix", 0.0}, {"value", start}});
  require(falls, "contact.cohesion.area", {{"opening", far}, {"mix", 0.0}, {"value", made->traction(far, 0)}});
  for (int k = 0; k <= (made->mixed ? sampled_mixtures : 0); ++k)
    check_at(*made, static_cast<double>(k) / sampled_mixtures);
  return made;
}

} // namespace signorini::contact
