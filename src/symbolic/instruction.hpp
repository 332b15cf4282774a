#pragma once
// One operation of a tape, as plain data for the files that are compiled for wider vectors.

#include "symbolic/operation.hpp"

namespace signorini::symbolic {

enum class Code : unsigned char {
  constant,   ///< value
  add,        ///< a + b
  subtract,   ///< a − b
  multiply,   ///< a b
  shift,      ///< a + value
  scale,      ///< value a
  reciprocal, ///< 1/a
  root,       ///< √a
  power,      ///< a^value
  general_power,
  function, ///< one of the functions from Operation::log on
};

/// Registers are rows of one value per point.
struct Instruction {
  Code code;
  Operation function;
  int target, a, b;
  double value;
};

} // namespace signorini::symbolic
