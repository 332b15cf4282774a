#pragma once
// Symbols in Lua: variables and formulas of them, with which functions of the user are called once.

#include "bind/lua/arguments.hpp"
#include "symbolic/graph.hpp"

namespace signorini::bind {

/// A formula, and the graph of all formulas in the same variables.
struct Symbol {
  std::shared_ptr<symbolic::Graph> graph;
  int node;
};

template <> struct Type<Symbol> { static constexpr auto name = "symbol"; };

/// Pushes a list of the variables of a new graph as symbols.
void push_variables(lua_State* L, std::vector<std::string> names);

} // namespace signorini::bind
