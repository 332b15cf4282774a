#include "symbolic/graph.hpp"

#include "symbolic/run.hpp"

#include <cmath>
#include <utility>

namespace signorini::symbolic {

Graph::Graph(std::vector<std::string> variables) : variables_(std::move(variables)) {
  for (int i = 0; i < std::ssize(variables_); ++i) insert({Operation::variable, 0, i, -1});
}

int Graph::insert(const Node& node) {
  const auto [place, added] = known_.try_emplace(node.key(), size());
  if (added) nodes_.push_back(node);
  return place->second;
}

int Graph::restore(const Node& node) {
  const bool function = node.operation >= Operation::log && node.operation <= Operation::sign;
  const bool two = node.operation == Operation::add || node.operation == Operation::multiply ||
                   node.operation == Operation::general_power;
  const bool one = two || function || node.operation == Operation::power;
  const auto fits = [&](int operand, bool needed) { return needed ? operand >= 0 && operand < size() : operand == -1; };
  if (!(one || node.operation == Operation::constant) || !fits(node.a, one) || !fits(node.b, two)) return -1;
  // Only constants may be nan, which breaks the order of keys.
  if (node.operation == Operation::constant) return constant(node.value);
  return std::isnan(node.value) ? -1 : insert(node);
}

int Graph::constant(double value) {
  // nan is not equal to itself: it would be a new key each time, and breaks the order of keys. −0 equals 0.
  if (std::isnan(value)) {
    nodes_.push_back({Operation::constant, value, -1, -1});
    return size() - 1;
  }
  return insert({Operation::constant, value == 0 ? 0 : value, -1, -1});
}

/// c and x of c x.
std::pair<double, int> Graph::factor_and_rest(int node) const {
  const Node& product = (*this)[node];
  if (product.operation == Operation::multiply && is_constant(product.a)) return {(*this)[product.a].value, product.b};
  return {1, node};
}

/// e and x of x^e.
std::pair<double, int> Graph::exponent_and_base(int node) const {
  const Node& power = (*this)[node];
  if (power.operation == Operation::power) return {power.value, power.a};
  return {1, node};
}

// A constant is the first of two operands, otherwise the older node.

int Graph::add(int a, int b) {
  if (is_constant(b) || (!is_constant(a) && b < a)) std::swap(a, b);
  if (is_constant(a) && is_constant(b)) return constant((*this)[a].value + (*this)[b].value);
  if (is_constant(a, 0)) return b;
  if (is_constant(a) && (*this)[b].operation == Operation::add && is_constant((*this)[b].a))
    return add(add(a, (*this)[b].a), (*this)[b].b);
  const auto [first, x] = factor_and_rest(a);
  const auto [second, y] = factor_and_rest(b);
  if (x == y) return multiply(constant(first + second), x);
  return insert({Operation::add, 0, a, b});
}

int Graph::subtract(int a, int b) {
  return add(a, multiply(constant(-1), b));
}

int Graph::multiply(int a, int b) {
  if (is_constant(b) || (!is_constant(a) && b < a)) std::swap(a, b);
  if (is_constant(a) && is_constant(b)) return constant((*this)[a].value * (*this)[b].value);
  if (is_constant(a, 0)) return a;
  if (is_constant(a, 1)) return b;
  const auto [first, x] = factor_and_rest(a);
  const auto [second, y] = factor_and_rest(b);
  if (is_constant(a)) {
    if (second == 1) return insert({Operation::multiply, 0, a, b});
    return multiply(constant((*this)[a].value * second), y);
  }
  if (first != 1 || second != 1) return multiply(constant(first * second), multiply(x, y));
  const auto [m, base] = exponent_and_base(a);
  const auto [n, other] = exponent_and_base(b);
  if (base == other) return power(base, m + n);
  return insert({Operation::multiply, 0, a, b});
}

int Graph::divide(int a, int b) {
  if (is_constant(a) && is_constant(b)) return constant((*this)[a].value / (*this)[b].value);
  return multiply(a, power(b, -1.0));
}

int Graph::power(int a, double exponent) {
  if (exponent == 0) return constant(1);
  if (exponent == 1) return a;
  if (is_constant(a)) return constant(std::pow((*this)[a].value, exponent));
  const auto [inner, base] = exponent_and_base(a);
  // (x²)^0.5 is |x|, not x.
  if (inner != 1 && exponent == std::round(exponent)) return power(base, inner * exponent);
  if (std::isnan(exponent)) return constant(exponent);
  return insert({Operation::power, exponent, a, -1});
}

int Graph::power(int a, int b) {
  if (is_constant(b)) return power(a, (*this)[b].value);
  return insert({Operation::general_power, 0, a, b});
}

int Graph::apply(Operation function, int a) {
  if (is_constant(a)) return constant(value_of(function, (*this)[a].value));
  if (function == Operation::log && (*this)[a].operation == Operation::exp) return (*this)[a].a;
  return insert({function, 0, a, -1});
}

const char* name_of(Operation function) {
  constexpr const char* names[] = {"log", "exp", "sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "abs", "sign"};
  return names[static_cast<int>(function) - static_cast<int>(Operation::log)];
}

std::vector<int> needed_for(const Graph& graph, const std::vector<int>& nodes) {
  std::vector<char> needed(static_cast<std::size_t>(graph.size()));
  for (int node : nodes) needed[node] = 1;
  std::vector<int> list;
  for (int node = graph.size() - 1; node >= 0; --node) {
    if (!needed[node]) continue;
    list.push_back(node);
    if (graph[node].operation == Operation::variable) continue;
    for (int operand : {graph[node].a, graph[node].b})
      if (operand >= 0) needed[operand] = 1;
  }
  return {list.rbegin(), list.rend()};
}

std::pair<Graph, int> reduced(const Graph& graph, int node) {
  Graph smaller(graph.variables());
  std::map<int, int> places;
  for (int n : needed_for(graph, {node})) {
    Node moved = graph[n];
    if (moved.operation == Operation::variable) {
      places[n] = moved.a;
      continue;
    }
    for (int* operand : {&moved.a, &moved.b})
      if (*operand >= 0) *operand = places.at(*operand);
    places[n] = smaller.restore(moved);
  }
  return {std::move(smaller), places.at(node)};
}

double value_of(Operation function, double x) {
  double value = 0;
  run_function(function, &x, &value, 1);
  return value;
}

} // namespace signorini::symbolic
