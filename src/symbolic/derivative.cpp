#include "symbolic/graph.hpp"

namespace signorini::symbolic {

namespace {

/// The derivative of a function of x with respect to x.
int slope(Graph& graph, Operation function, int x, int value) {
  const auto one_plus = [&](double factor) { // 1 + factor value²
    return graph.add(graph.constant(1), graph.multiply(graph.constant(factor), graph.power(value, 2.0)));
  };
  switch (function) {
  case Operation::log:
    return graph.power(x, -1.0);
  case Operation::exp:
    return value;
  case Operation::sin:
    return graph.apply(Operation::cos, x);
  case Operation::cos:
    return graph.multiply(graph.constant(-1), graph.apply(Operation::sin, x));
  case Operation::tan:
    return one_plus(1);
  case Operation::atan:
    return graph.power(graph.add(graph.constant(1), graph.power(x, 2.0)), -1.0);
  case Operation::sinh:
    return graph.apply(Operation::cosh, x);
  case Operation::cosh:
    return graph.apply(Operation::sinh, x);
  case Operation::tanh:
    return one_plus(-1);
  case Operation::abs:
    return graph.apply(Operation::sign, x);
  default:
    return graph.constant(0); // sign
  }
}

} // namespace

int derivative(Graph& graph, int node, int variable) {
  std::map<int, int> slopes;
  for (int n : needed_for(graph, {node})) {
    const Node here = graph[n]; // a copy, as the graph grows
    const auto of = [&](int operand) { return slopes.at(operand); };
    switch (here.operation) {
    case Operation::constant:
      slopes[n] = graph.constant(0);
      break;
    case Operation::variable:
      slopes[n] = graph.constant(here.a == variable);
      break;
    case Operation::add:
      slopes[n] = graph.add(of(here.a), of(here.b));
      break;
    case Operation::multiply:
      slopes[n] = graph.add(graph.multiply(of(here.a), here.b), graph.multiply(here.a, of(here.b)));
      break;
    case Operation::power:
      slopes[n] =
          graph.multiply(graph.multiply(graph.constant(here.value), graph.power(here.a, here.value - 1)), of(here.a));
      break;
    case Operation::general_power: {
      // (a^b)' = b a^(b−1) a' + a^b ln a b'
      const int along = graph.multiply(here.b, graph.power(here.a, graph.add(graph.constant(-1), here.b)));
      const int up = graph.multiply(n, graph.apply(Operation::log, here.a));
      slopes[n] = graph.add(graph.multiply(along, of(here.a)), graph.multiply(up, of(here.b)));
      break;
    }
    default:
      slopes[n] = graph.multiply(slope(graph, here.operation, here.a, n), of(here.a));
    }
  }
  return slopes.at(node);
}

} // namespace signorini::symbolic
