#include "bind/scene/symbols.hpp"

#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::bind {

namespace {

using symbolic::Graph;
using symbolic::Operation;

/// Throws unless the operand at an index of the stack is a number or a symbol of the same variables.
int operand(lua_State* L, int index, const std::shared_ptr<Graph>& graph) {
  if (const auto* symbol = test_object<Symbol>(L, index)) {
    if (symbol->graph != graph)
      throw ArgumentError("a formula must not combine symbols of two functions: each symbol is valid only in the call "
                          "that received it. Hint: use the arguments of the function itself");
    return symbol->node;
  }
  if (lua_type(L, index) != LUA_TNUMBER)
    throw ArgumentError(text("a symbol can be combined with numbers and symbols, got ", describe(L, index)));
  return graph->constant(lua_tonumber(L, index));
}

/// An operator of which one operand at least is a symbol.
template <auto operation> int combine(lua_State* L) {
  const auto* first = test_object<Symbol>(L, 1);
  const std::shared_ptr<Graph> graph = first ? first->graph : test_object<Symbol>(L, 2)->graph;
  const int a = operand(L, 1, graph), b = operand(L, 2, graph);
  push(L, Symbol{graph, operation(*graph, a, b)});
  return 1;
}

int negative(lua_State* L) {
  const auto& symbol = self<Symbol>(L);
  push(L, Symbol{symbol.graph, symbol.graph->multiply(symbol.graph->constant(-1), symbol.node)});
  return 1;
}

int refuse_comparison(lua_State*) {
  throw ArgumentError(
      "a symbol has no value that could be compared: the function is called once, with symbols, to read "
      "its formula, which must hold everywhere. Hint: write one formula without if, and, or; sg.max(a, b) is the "
      "greater "
      "one of two, and with a corner of radius about r (a + b + sg.sqrt((a - b)^2 + r^2))/2");
}

std::string symbol_text(const Symbol& symbol) {
  return symbolic::text_of(*symbol.graph, symbol.node);
}

/// A function of a number, or of a symbol.
template <Operation function> int apply(lua_State* L) {
  if (const auto* symbol = test_object<Symbol>(L, 1))
    push(L, Symbol{symbol->graph, symbol->graph->apply(function, symbol->node)});
  else
    push(L, symbolic::value_of(function, lua_tonumber(L, 1)));
  return 1;
}

/// max, or min with sign −1: (a + b ± |a − b|)/2
template <int sign> int extreme(lua_State* L) {
  if (!test_object<Symbol>(L, 1) && !test_object<Symbol>(L, 2)) {
    const double a = lua_tonumber(L, 1), b = lua_tonumber(L, 2);
    push(L, sign > 0 ? std::max(a, b) : std::min(a, b));
    return 1;
  }
  return combine<[](Graph& graph, int a, int b) {
    const int apart = graph.apply(Operation::abs, graph.subtract(a, b));
    const int sum = graph.add(graph.add(a, b), graph.multiply(graph.constant(sign), apart));
    return graph.multiply(graph.constant(0.5), sum);
  }>(L);
}

int root(lua_State* L) {
  if (const auto* symbol = test_object<Symbol>(L, 1))
    push(L, Symbol{symbol->graph, symbol->graph->power(symbol->node, 0.5)});
  else
    push(L, std::sqrt(lua_tonumber(L, 1)));
  return 1;
}

constexpr Function symbol_entries[] = {
    {"__add", combine<[](Graph& graph, int a, int b) { return graph.add(a, b); }>},
    {"__sub", combine<[](Graph& graph, int a, int b) { return graph.subtract(a, b); }>},
    {"__mul", combine<[](Graph& graph, int a, int b) { return graph.multiply(a, b); }>},
    {"__div", combine<[](Graph& graph, int a, int b) { return graph.divide(a, b); }>},
    {"__pow", combine<[](Graph& graph, int a, int b) { return graph.power(a, b); }>},
    {"__unm", negative},
    {"__eq", refuse_comparison},
    {"__lt", refuse_comparison},
    {"__le", refuse_comparison},
    {"__tostring", call<symbol_text>},
};

/// core.symbols{"x", "y"}: variables of a new graph
int symbols(lua_State* L) {
  push_variables(L, to<std::vector<std::string>>(L, 1));
  return 1;
}

constexpr Function symbol_functions[] = {
    {"log", apply<Operation::log>},
    {"exp", apply<Operation::exp>},
    {"sqrt", root},
    {"sin", apply<Operation::sin>},
    {"cos", apply<Operation::cos>},
    {"tan", apply<Operation::tan>},
    {"atan", apply<Operation::atan>},
    {"sinh", apply<Operation::sinh>},
    {"cosh", apply<Operation::cosh>},
    {"tanh", apply<Operation::tanh>},
    {"abs", apply<Operation::abs>},
    {"max", extreme<1>},
    {"min", extreme<-1>},
};

} // namespace

void push_variables(lua_State* L, std::vector<std::string> names) {
  const int count = std::ssize(names);
  const auto graph = std::make_shared<Graph>(std::move(names));
  lua_createtable(L, count, 0);
  for (int i = 0; i < count; ++i) {
    push(L, Symbol{graph, i});
    lua_rawseti(L, -2, i + 1);
  }
}

void open_symbols(lua_State* L) {
  register_functions(L, "sg", symbol_functions);
  register_functions(L, "core", {{"symbols", symbols}});
  register_type<Symbol>(L, symbol_entries);
}

} // namespace signorini::bind
