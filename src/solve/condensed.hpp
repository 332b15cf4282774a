#pragma once
// Static condensation for a constant matrix plus a changing contact block [theory 10.5].

#include "solve/linear.hpp"
#include "solve/schur.hpp"

namespace signorini::solve {

/// A matrix K₀ + C in which only C changes from one factor() to the next.
struct Condensation {
  std::vector<double> constant; ///< K₀, symmetric, in the order of the pattern
  std::vector<int> contact;     ///< unknowns of the rows and columns in which C is nonzero, increasing
};

/// Solves (K₀ + C) x = b for the symmetric K₀ = `condensation.constant`, factored once by `solver`, and any C that is
/// nonzero only between the unknowns `condensation.contact`: exact static condensation to these. factor() reads only
/// the entries between contact unknowns; the caller guarantees that all others are those of K₀. Throws Error if the
/// condensation does not fit the pattern or K₀ is not symmetric.
std::unique_ptr<LinearSolver> make_condensed(const Pattern& pattern, const Condensation& condensation,
                                             std::unique_ptr<SchurSolver> solver);

} // namespace signorini::solve
