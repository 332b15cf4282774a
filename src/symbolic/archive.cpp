#include "symbolic/archive.hpp"

namespace signorini::symbolic {

constexpr Operation last_value(std::type_identity<Operation>) {
  return Operation::sign;
}

void write(ArchiveWriter& to, const Formula& formula) {
  const Graph& graph = formula.graph;
  to.put(graph.size(), formula.node);
  for (int n = std::ssize(graph.variables()); n < graph.size(); ++n)
    to.put(graph[n].operation, graph[n].value, graph[n].a, graph[n].b);
}

Formula read_formula(ArchiveReader& from, std::vector<std::string> variables) {
  Graph graph(std::move(variables));
  const int size = from.get<int>(), node = from.get<int>();
  for (int n = graph.size(); n < size; ++n) {
    Node next{};
    from.into(next.operation, next.value, next.a, next.b);
    require(graph.restore(next) == n, "symbolic.archive.formula", {{"node", n}});
  }
  require(node >= 0 && node < graph.size(), "symbolic.archive.formula", {{"node", node}});
  return {std::move(graph), node};
}

} // namespace signorini::symbolic
