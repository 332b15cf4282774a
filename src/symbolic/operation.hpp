#pragma once
// The operations of formulas.

namespace signorini::symbolic {

enum class Operation : unsigned char {
  constant,
  variable,
  add,
  multiply,
  power,         ///< with a constant exponent: roots and reciprocals too
  general_power, ///< a^b for a > 0
  log,
  exp,
  sin,
  cos,
  tan,
  atan,
  sinh,
  cosh,
  tanh,
  abs,
  sign, ///< −1, 0 or 1: the derivative of abs
};

} // namespace signorini::symbolic
