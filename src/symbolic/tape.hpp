#pragma once
// Formulas compiled to a flat list of operations on registers.

#include "symbolic/graph.hpp"
#include "symbolic/instruction.hpp"

namespace signorini::symbolic {

/// The first registers hold the variables, which the caller fills in; the values of outputs are never overwritten.
struct Tape {
  std::vector<Instruction> code;
  int registers = 0;
  std::vector<int> outputs; ///< registers of the values in the order of the formulas; −1: zero everywhere
  std::vector<int> ends;    ///< per formula the number of instructions after which it and all before it are known
};

/// Compiles formulas of one graph, one after the other. `positive`: the variables are; then powers of a variable whose
/// exponents differ by integers share one evaluation.
Tape compile(const Graph& graph, const std::vector<int>& formulas, bool positive);

/// The values of the outputs at one point.
std::vector<double> evaluate(const Tape& tape, const std::vector<double>& variables);

/// Runs a tape on registers, which are rows of `stride` values, one per point; the first rows hold the variables. Only
/// the first `outputs` formulas, at least one, are evaluated.
void evaluate(const Tape& tape, double* registers, int stride, int points, int outputs);

} // namespace signorini::symbolic
