#pragma once
// A solver for a constant matrix of which only the contact block changes.

#include "solve/linear.hpp"
#include "solve/schur.hpp"

namespace signorini::solve {

/// A matrix K₀ + C of which only C changes from one factor() to the next.
struct Condensation {
  std::vector<double> constant; ///< K₀, symmetric, in the order of the pattern
  std::vector<int> contact;     ///< the unknowns whose rows and columns C touches, increasing
};

/// Solves (K₀ + C) x = b with the symmetric K₀ = `condensation.constant`, factored here once by `solver`, and any C
/// that touches the unknowns `condensation.contact` only: exact static condensation onto these. factor() reads the
/// entries between contact unknowns only: that all other values are those of K₀ is the caller's word. Throws Error when
/// the condensation does not fit the pattern or K₀ is not symmetric.
std::unique_ptr<LinearSolver> make_condensed(const Pattern& pattern, const Condensation& condensation,
                                             std::unique_ptr<SchurSolver> solver);

} // namespace signorini::solve
