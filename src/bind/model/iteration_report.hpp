#pragma once
// Reports of Newton iterations as they come, for verbose = true (lua/signorini/run/verbose.lua prints them).

#include "bind/model/model.hpp"

namespace signorini::bind {

/// What an iteration changes.
struct IterationMarks {
  std::size_t residuals = 0, parts = 0;
  int iterations = 0, factorizations = 0, gmres = 0;
  std::vector<contact::ContactState> states; ///< of all contact points or multipliers
};

template <int D> class IterationPrinter {
public:
  /// `goal`: tolerance of the residual.
  IterationPrinter(const model::Model<D>& model, double goal);
  /// Prints the last iteration of the model: its residual, the correction, contact states, and what changed since the
  /// last call, or since construction.
  void print(lua_State* L, const model::Model<D>& model);

private:
  double goal_;
  IterationMarks before_;
};

} // namespace signorini::bind
