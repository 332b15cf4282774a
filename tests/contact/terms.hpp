#pragma once
// Formulas that are written like numbers.

#include "symbolic/graph.hpp"

#include <memory>

namespace signorini::contact::test {

/// A formula that is written like a number.
struct Term {
  std::shared_ptr<symbolic::Graph> graph;
  int node;
  Term constant(double value) const { return {graph, graph->constant(value)}; }
};
inline Term operator+(const Term& a, const Term& b) {
  return {a.graph, a.graph->add(a.node, b.node)};
}
inline Term operator-(const Term& a, const Term& b) {
  return {a.graph, a.graph->subtract(a.node, b.node)};
}
inline Term operator*(const Term& a, const Term& b) {
  return {a.graph, a.graph->multiply(a.node, b.node)};
}
inline Term operator+(const Term& a, double b) {
  return a + a.constant(b);
}
inline Term operator-(const Term& a, double b) {
  return a - a.constant(b);
}
inline Term operator*(double a, const Term& b) {
  return b.constant(a) * b;
}
inline Term power(const Term& a, double exponent) {
  return {a.graph, a.graph->power(a.node, exponent)};
}
inline Term absolute(const Term& a) {
  return {a.graph, a.graph->apply(symbolic::Operation::abs, a.node)};
}
inline Term cosine(const Term& a) {
  return {a.graph, a.graph->apply(symbolic::Operation::cos, a.node)};
}

} // namespace signorini::contact::test
