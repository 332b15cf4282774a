#pragma once
// Evaluation of a tape at many points, with the vector width for which the including file is compiled. Everything is
// local to these files and no inline functions of other files are called, so that the linker cannot select a copy that
// an older machine is unable to run.

#include "symbolic/instruction.hpp"

#include <cmath>

namespace signorini::symbolic {

namespace {

/// to_q = operation(q)
template <class Evaluate> inline void each_point(double* __restrict to, int points, const Evaluate& operation) {
#pragma GCC ivdep
  for (int q = 0; q < points; ++q) to[q] = operation(q);
}

inline void run_function(Operation function, const double* x, double* to, int points) {
  switch (function) {
  case Operation::log:
    return each_point(to, points, [=](int q) { return ::log(x[q]); });
  case Operation::exp:
    return each_point(to, points, [=](int q) { return ::exp(x[q]); });
  case Operation::sin:
    return each_point(to, points, [=](int q) { return ::sin(x[q]); });
  case Operation::cos:
    return each_point(to, points, [=](int q) { return ::cos(x[q]); });
  case Operation::tan:
    return each_point(to, points, [=](int q) { return ::tan(x[q]); });
  case Operation::atan:
    return each_point(to, points, [=](int q) { return ::atan(x[q]); });
  case Operation::sinh:
    return each_point(to, points, [=](int q) { return ::sinh(x[q]); });
  case Operation::cosh:
    return each_point(to, points, [=](int q) { return ::cosh(x[q]); });
  case Operation::tanh:
    return each_point(to, points, [=](int q) { return ::tanh(x[q]); });
  case Operation::abs:
    return each_point(to, points, [=](int q) { return ::fabs(x[q]); });
  default:
    return each_point(to, points, [=](int q) { return (x[q] > 0 ? 1.0 : 0.0) - (x[q] < 0 ? 1.0 : 0.0); });
  }
}

/// Runs the first `count` instructions on registers, which are rows of `stride` values.
inline void run(const Instruction* code, int count, double* registers, int stride, int points) {
  for (const Instruction* end = code + count; code != end; ++code) {
    const double *a = registers + code->a * stride, *b = registers + code->b * stride, value = code->value;
    double* to = registers + code->target * stride;
    switch (code->code) {
    case Code::constant:
      each_point(to, points, [=](int) { return value; });
      break;
    case Code::add:
      each_point(to, points, [=](int q) { return a[q] + b[q]; });
      break;
    case Code::subtract:
      each_point(to, points, [=](int q) { return a[q] - b[q]; });
      break;
    case Code::multiply:
      each_point(to, points, [=](int q) { return a[q] * b[q]; });
      break;
    case Code::shift:
      each_point(to, points, [=](int q) { return a[q] + value; });
      break;
    case Code::scale:
      each_point(to, points, [=](int q) { return value * a[q]; });
      break;
    case Code::reciprocal:
      each_point(to, points, [=](int q) { return 1 / a[q]; });
      break;
    case Code::root:
      each_point(to, points, [=](int q) { return ::sqrt(a[q]); });
      break;
    case Code::power:
      each_point(to, points, [=](int q) { return ::pow(a[q], value); });
      break;
    case Code::general_power:
      each_point(to, points, [=](int q) { return ::pow(a[q], b[q]); });
      break;
    case Code::function:
      run_function(code->function, a, to, points);
      break;
    }
  }
}

} // namespace

} // namespace signorini::symbolic
