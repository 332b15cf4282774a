#include "symbolic/tape.hpp"

#include "symbolic/run.hpp"

#include <algorithm>
#include <optional>

namespace signorini::symbolic {

namespace {

/// Emits instructions with one register per value.
class Compiler {
public:
  Compiler(const Graph& graph, bool positive)
      : graph_(graph), positive_(positive), next_(static_cast<int>(graph.variables().size())) {}

  int emit(int node);
  std::vector<Instruction> code;

private:
  int put(Code code, int a = 0, int b = 0, double value = 0, Operation function = Operation::log) {
    this->code.push_back({code, function, next_, a, b, value});
    return next_++;
  }
  int emit_new(int node);
  int power(int base, double exponent, bool shared);
  int new_power(int base, double exponent, bool shared);
  int new_sum(const Node& node);

  const Graph& graph_;
  bool positive_;
  int next_;
  std::map<int, int> emitted_;                   ///< registers by node
  std::map<std::pair<int, double>, int> powers_; ///< registers by base register and exponent
};

int Compiler::emit(int node) {
  if (graph_[node].operation == Operation::variable) return graph_[node].a;
  if (const auto known = emitted_.find(node); known != emitted_.end()) return known->second;
  return emitted_[node] = emit_new(node);
}

/// a + b, a − b where b is −1 times a value.
int Compiler::new_sum(const Node& node) {
  if (graph_.is_constant(node.a)) return put(Code::shift, emit(node.b), 0, graph_[node.a].value);
  const auto negated = [&](int term) -> std::optional<int> {
    const Node& product = graph_[term];
    if (product.operation == Operation::multiply && graph_.is_constant(product.a, -1)) return product.b;
    return std::nullopt;
  };
  for (const auto& [first, second] : {std::pair(node.a, node.b), std::pair(node.b, node.a)})
    if (const auto value = negated(second)) {
      const int a = emit(first), b = emit(*value);
      return put(Code::subtract, a, b);
    }
  const int a = emit(node.a), b = emit(node.b);
  return put(Code::add, a, b);
}

int Compiler::power(int base, double exponent, bool shared) {
  if (exponent == 1) return base;
  const auto key = std::pair(base, exponent);
  if (const auto known = powers_.find(key); known != powers_.end()) return known->second;
  const int made = new_power(base, exponent, shared);
  return powers_[key] = made;
}

int Compiler::new_power(int base, double exponent, bool shared) {
  constexpr double most_by_products = 32;
  if (exponent == 0) return put(Code::constant, 0, 0, 1); // only in graphs of files: others have no such node
  if (exponent == -1) return put(Code::reciprocal, base);
  if (exponent == 0.5) return put(Code::root, base);
  const bool whole = exponent == std::round(exponent) && std::abs(exponent) <= most_by_products;
  if (whole && exponent < 0) return power(power(base, -1, shared), -exponent, shared);
  if (whole) {
    const double half = std::floor(exponent / 2);
    const int root = power(base, half, shared), square = put(Code::multiply, root, root);
    return 2 * half == exponent ? square : put(Code::multiply, square, base);
  }
  if (shared)
    for (const auto& [key, value] : powers_) {
      const double between = exponent - key.second;
      if (key.first != base || key.second == std::round(key.second)) continue;
      if (std::abs(between - std::round(between)) > 1e-14 || std::abs(between) > 8) continue;
      const int start = value;
      if (std::round(between) == 0) return start;                // the same exponent up to rounding error
      const int rest = power(base, std::round(between), shared); // adds to powers_
      return put(Code::multiply, start, rest);
    }
  return put(Code::power, base, 0, exponent);
}

int Compiler::emit_new(int node) {
  const Node& here = graph_[node];
  switch (here.operation) {
  case Operation::constant:
    return put(Code::constant, 0, 0, here.value);
  case Operation::add:
    return new_sum(here);
  case Operation::multiply: {
    if (graph_.is_constant(here.a)) return put(Code::scale, emit(here.b), 0, graph_[here.a].value);
    const int a = emit(here.a), b = emit(here.b);
    return put(Code::multiply, a, b);
  }
  case Operation::power:
    return power(emit(here.a), here.value, positive_ && graph_[here.a].operation == Operation::variable);
  case Operation::general_power: {
    const int a = emit(here.a), b = emit(here.b);
    return put(Code::general_power, a, b);
  }
  default:
    return put(Code::function, emit(here.a), 0, 0, here.operation);
  }
}

bool reads_a(const Instruction& one) {
  return one.code != Code::constant;
}
bool reads_b(const Instruction& one) {
  return one.code == Code::add || one.code == Code::subtract || one.code == Code::multiply ||
         one.code == Code::general_power;
}

/// Uses registers again whose values are not read anymore; those of variables and outputs are kept.
void reuse_registers(Tape& tape, int variables) {
  std::vector<int> last(tape.registers, -1), place(tape.registers, -1), open;
  for (int i = 0; i < std::ssize(tape.code); ++i) {
    const Instruction& one = tape.code[i];
    if (reads_a(one)) last[one.a] = i;
    if (reads_b(one)) last[one.b] = i;
  }
  const int never = std::ssize(tape.code);
  for (int v = 0; v < variables; ++v) place[v] = v, last[v] = never;
  for (int output : tape.outputs)
    if (output >= 0) last[output] = never;
  int count = variables;
  for (int i = 0; i < std::ssize(tape.code); ++i) {
    Instruction& one = tape.code[i];
    const int a = one.a, b = one.b, target = one.target;
    one.a = reads_a(one) ? place[a] : 0;
    one.b = reads_b(one) ? place[b] : 0;
    // The target is taken first, as an instruction must not write to what it reads.
    if (open.empty()) open.push_back(count++);
    one.target = place[target] = open.back();
    open.pop_back();
    if (reads_a(one) && last[a] == i) open.push_back(place[a]);
    if (reads_b(one) && b != a && last[b] == i) open.push_back(place[b]);
  }
  for (int& output : tape.outputs)
    if (output >= 0) output = place[output];
  tape.registers = count;
}

} // namespace

Tape compile(const Graph& graph, const std::vector<int>& formulas, bool positive) {
  const int variables = std::ssize(graph.variables());
  Compiler compiler(graph, positive);
  Tape tape;
  for (int formula : formulas) {
    tape.outputs.push_back(graph.is_constant(formula, 0) ? -1 : compiler.emit(formula));
    tape.ends.push_back(static_cast<int>(compiler.code.size()));
  }
  tape.code = std::move(compiler.code);
  tape.registers = variables;
  for (const Instruction& one : tape.code) tape.registers = std::max(tape.registers, one.target + 1);
  reuse_registers(tape, variables);
  return tape;
}

void evaluate(const Tape& tape, double* registers, int stride, int points, int outputs) {
  run(tape.code.data(), tape.ends[outputs - 1], registers, stride, points);
}

std::vector<double> evaluate(const Tape& tape, const std::vector<double>& variables) {
  std::vector<double> registers(tape.registers), values;
  std::copy(variables.begin(), variables.end(), registers.begin());
  evaluate(tape, registers.data(), 1, 1, static_cast<int>(tape.outputs.size()));
  for (int output : tape.outputs) values.push_back(output < 0 ? 0 : registers[output]);
  return values;
}

} // namespace signorini::symbolic
