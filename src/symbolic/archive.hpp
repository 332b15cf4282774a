#pragma once
// Formulas in files.

#include "os/archive.hpp"
#include "symbolic/graph.hpp"

namespace signorini::symbolic {

/// A graph and a node in it.
struct Formula {
  Graph graph;
  int node;
};

/// Writes the nodes that are not variables, in an order in which operands come first.
void write(ArchiveWriter& to, const Formula& formula);
/// Reads a formula of these variables. Throws Error if it is damaged.
Formula read_formula(ArchiveReader& from, std::vector<std::string> variables);

} // namespace signorini::symbolic
