#include "contact/law/pressure_formula.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace signorini::contact {

namespace {

/// Nodes and weights of Gauss–Legendre's rule with 8 points on (0, 1).
constexpr double gauss_nodes[] = {0.0198550717512319, 0.1016667612931866, 0.2372337950418355, 0.4082826787521751,
                                  0.5917173212478249, 0.7627662049581645, 0.8983332387068134, 0.9801449282487681};
constexpr double gauss_weights[] = {0.0506142681451881, 0.1111905172266872, 0.1568533229389436, 0.1813418916891810,
                                    0.1813418916891810, 0.1568533229389436, 0.1111905172266872, 0.0506142681451881};

/// The values of the first `outputs` formulas at a gap.
struct Values {
  const PressureFormula& law;
  const Vec<3>& place;

  std::array<double, 2> operator()(double gap, int outputs) const {
    const symbolic::Tape& tape = law.tape;
    thread_local std::vector<double> registers;
    if (std::ssize(registers) < tape.registers) registers.resize(tape.registers);
    registers[0] = gap;
    std::copy_n(place.data(), 3, registers.begin() + 1);
    symbolic::evaluate(tape, registers.data(), 1, 1, outputs);
    std::array<double, 2> found{};
    for (std::size_t k = 0; k < 2; ++k)
      if (static_cast<int>(k) < outputs && tape.outputs[k] >= 0) found[k] = registers[tape.outputs[k]];
    return found;
  }
};

} // namespace

std::vector<std::string> pressure_variables() {
  return {"g", "X", "Y", "Z"};
}

std::string text_of(const PressureFormula& law) {
  return symbolic::text_of(law.formula.graph, law.formula.node);
}

GapResponse PressureFormula::operator()(double gap, const Vec<3>& place) const {
  const auto [pressure, rate] = Values{*this, place}(gap, 2);
  return {pressure, rate};
}

double PressureFormula::energy(double gap, const Vec<3>& place) const {
  const Values value{*this, place};
  const auto [pressure, rate] = value(gap, 2);
  // Up to an infinite clearance by s = g + L x/(1 − x), L a length of the law itself
  const bool bounded = std::isfinite(clearance);
  const double length = bounded ? clearance - gap : std::max(std::abs(gap), std::abs(pressure / rate));
  const int panels = bounded ? 2 : 6;
  double energy = 0;
  for (int panel = 0; panel < panels && length > 0 && std::isfinite(length); ++panel)
    for (std::size_t k = 0; k < std::size(gauss_nodes); ++k) {
      const double x = (panel + gauss_nodes[k]) / panels, rest = 1 - x;
      const double there = bounded ? gap + length * x : gap + length * x / rest;
      energy += gauss_weights[k] / panels * length * value(there, 1)[0] / (bounded ? 1 : rest * rest);
    }
  return energy;
}

std::shared_ptr<const PressureFormula> make_pressure_formula(symbolic::Formula formula, double clearance) {
  auto made = std::make_shared<PressureFormula>(PressureFormula{std::move(formula), clearance, {}});
  auto& [graph, node] = made->formula;
  const int rate = symbolic::derivative(graph, node, 0);
  made->tape = symbolic::compile(graph, {node, rate}, false);
  return made;
}

} // namespace signorini::contact
