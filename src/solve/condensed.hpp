#pragma once
// A solver for a constant matrix of which only the contact block changes.

#include "solve/linear.hpp"

namespace signorini::solve {

/// Solves (K₀ + C) x = b with the symmetric K₀ = `condensation.constant`, factored here once, and any C that touches
/// the unknowns `condensation.contact` only: exact static condensation onto these. Throws Error when the condensation
/// does not fit the pattern or K₀ is not symmetric.
std::unique_ptr<LinearSolver> make_condensed(const Pattern& pattern, const Condensation& condensation);

} // namespace signorini::solve
