#pragma once
// Formulas as graphs: each subexpression is stored once and simplified when it is built, so that a common subexpression
// is one node and derivatives stay short.

#include "symbolic/operation.hpp"

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace signorini::symbolic {

struct Node {
  Operation operation;
  double value; ///< of a constant; the exponent of a power
  int a, b;     ///< operands, which precede the node; a: the number of a variable; −1: none
  auto key() const { return std::tuple(operation, value, a, b); }
};

/// The nodes of formulas in some variables. Functions return the index of a node. Products of powers of one base are
/// merged, so that x^0.5 x^0.5 is x also for negative x.
class Graph {
public:
  explicit Graph(std::vector<std::string> variables);

  int constant(double value);
  /// Variables are the first nodes, in their order.
  int variable(int number) const { return number; }
  int add(int a, int b);
  int subtract(int a, int b);
  int multiply(int a, int b);
  int divide(int a, int b);
  int power(int a, int b);
  int power(int a, double exponent);
  /// One of the functions from log on.
  int apply(Operation function, int a);

  /// Adds a node of another graph with the same indices, for files. Returns −1 unless its operands are nodes.
  int restore(const Node& node);

  const Node& operator[](int node) const { return nodes_[node]; }
  int size() const { return std::ssize(nodes_); }
  const std::vector<std::string>& variables() const { return variables_; }
  bool is_constant(int node) const { return (*this)[node].operation == Operation::constant; }
  bool is_constant(int node, double value) const { return is_constant(node) && (*this)[node].value == value; }

private:
  int insert(const Node& node);
  std::pair<double, int> factor_and_rest(int node) const;
  std::pair<double, int> exponent_and_base(int node) const;

  std::vector<std::string> variables_;
  std::vector<Node> nodes_;
  std::map<decltype(Node().key()), int> known_;
};

/// The name of a function ("log").
const char* name_of(Operation function);

/// The value of a function of one argument.
double value_of(Operation function, double x);

/// A graph of the variables and of what a node needs, and the node in it.
std::pair<Graph, int> reduced(const Graph& graph, int node);

/// ∂node/∂variable, as a node of the same graph.
int derivative(Graph& graph, int node, int variable);

/// The formula as Lua text, "2*(I1 - 3) + log(J)^2"; if that is very long, the number of its operations.
std::string text_of(const Graph& graph, int node);

/// The nodes on which some nodes depend, and these, in ascending order.
std::vector<int> needed_for(const Graph& graph, const std::vector<int>& nodes);

} // namespace signorini::symbolic
