#include "contact/law/slip_formula.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::contact {

namespace {

enum Variable { p, v, slip_so_far, x, y, z, recent, cosine, variables };

} // namespace

std::vector<std::string> slip_variables() {
  return {"p", "v", "slip", "X", "Y", "Z", "recent", "cosine"};
}

bool is_finite(const Coefficient& coefficient) {
  const auto& [value, of_pressure, of_slip, of_cosine] = coefficient;
  return std::isfinite(value) && std::isfinite(of_pressure) && std::isfinite(of_slip) && std::isfinite(of_cosine);
}

Coefficient SlipFormula::operator()(double pressure, double slip, const Interface& at) const {
  const double per_time = at.duration > 0 ? 1 / at.duration : 0;
  thread_local std::vector<double> registers;
  if (std::ssize(registers) < tape.registers) registers.resize(tape.registers);
  const double values[variables] = {pressure,    slip * per_time, at.slipped + slip, at.place(0),
                                    at.place(1), at.place(2),     at.recent + slip,  at.cosine};
  std::copy_n(values, static_cast<int>(variables), registers.begin());
  symbolic::evaluate(tape, registers.data(), 1, 1, static_cast<int>(std::ssize(tape.outputs)));
  const auto output = [&](std::size_t k) { return tape.outputs[k] < 0 ? 0 : registers[tape.outputs[k]]; };
  // dμ/dΔγ = μ_v/Δt + μ_γ
  return {output(0), output(1), output(2) * per_time + output(3) + output(4), output(5)};
}

std::string text_of(const SlipFormula& law) {
  return symbolic::text_of(law.formula.graph, law.formula.node);
}

std::shared_ptr<const SlipFormula> make_slip_formula(symbolic::Formula formula) {
  auto made = std::make_shared<SlipFormula>(SlipFormula{std::move(formula), {}, false, false});
  auto& [graph, node] = made->formula;
  std::vector<int> outputs{node};
  for (const Variable by : {p, v, slip_so_far, recent, cosine})
    outputs.push_back(symbolic::derivative(graph, node, by));
  made->of_rate = !graph.is_constant(outputs[2], 0);
  made->of_cosine = !graph.is_constant(outputs[5], 0);
  made->tape = symbolic::compile(graph, outputs, false);
  return made;
}

} // namespace signorini::contact
