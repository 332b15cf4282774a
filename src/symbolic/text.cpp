#include "base/text.hpp"
#include "symbolic/graph.hpp"

namespace signorini::symbolic {

namespace {

enum Binding { sum, product, power, atom };

/// A formula and how tightly its outermost operator binds.
struct Written {
  std::string words;
  Binding binding;
};

Written write(const Graph& graph, int node);

/// With parentheses if the operator binds less tightly than its place needs.
std::string inside(const Graph& graph, int node, Binding least) {
  const Written part = write(graph, node);
  return part.binding < least ? text("(", part.words, ")") : part.words;
}

Written of_product(const Graph& graph, const Node& node) {
  if (graph.is_constant(node.a, -1)) return {text("-", inside(graph, node.b, product)), sum};
  const bool negative = graph.is_constant(node.a) && graph[node.a].value < 0;
  const std::string left = negative ? text(graph[node.a].value) : inside(graph, node.a, product);
  const Node& second = graph[node.b];
  const bool quotient = second.operation == Operation::power && second.value == -1;
  const std::string right = inside(graph, quotient ? second.a : node.b, power);
  return {text(left, quotient ? "/" : "*", right), negative ? sum : product};
}

/// A constant term comes last, as in "I1 - 3".
Written of_sum(const Graph& graph, const Node& node) {
  const bool swap = graph.is_constant(node.a);
  const std::string first = inside(graph, swap ? node.b : node.a, sum),
                    second = inside(graph, swap ? node.a : node.b, sum);
  if (second.front() == '-') return {text(first, " - ", second.substr(1)), sum};
  return {text(first, " + ", second), sum};
}

Written write(const Graph& graph, int node) {
  const Node& here = graph[node];
  switch (here.operation) {
  case Operation::constant:
    return {text(here.value), here.value < 0 ? sum : atom};
  case Operation::variable:
    return {graph.variables()[here.a], atom};
  case Operation::add:
    return of_sum(graph, here);
  case Operation::multiply:
    return of_product(graph, here);
  case Operation::power: {
    if (here.value == -1) return {text("1/", inside(graph, here.a, power)), product};
    if (here.value == 0.5) return {text("sqrt(", write(graph, here.a).words, ")"), atom};
    const std::string exponent = text(here.value);
    return {text(inside(graph, here.a, atom), "^", here.value < 0 ? text("(", exponent, ")") : exponent), power};
  }
  case Operation::general_power:
    return {text(inside(graph, here.a, atom), "^", inside(graph, here.b, atom)), power};
  default:
    return {text(name_of(here.operation), "(", write(graph, here.a).words, ")"), atom};
  }
}

} // namespace

std::string text_of(const Graph& graph, int node) {
  constexpr double longest = 2000;
  // Shared nodes are written each time, so that the text may be far longer than the graph.
  std::map<int, double> sizes;
  for (int n : needed_for(graph, {node})) {
    sizes[n] = 8;
    if (graph[n].operation == Operation::variable) continue;
    for (int operand : {graph[n].a, graph[n].b})
      if (operand >= 0) sizes[n] += sizes.at(operand);
  }
  if (sizes.at(node) > longest) return text("a formula of ", sizes.size(), " operations");
  return write(graph, node).words;
}

} // namespace signorini::symbolic
