#pragma once
// Automatic choice of the linear solver for a scene.

#include "model/system/system.hpp"
#include "solve/linear.hpp"

namespace signorini::model {

/// Properties of a scene that decide the choice.
struct LinearFacts {
  bool constant_bulk; ///< all bodies are linear elastic, no load follows, and there are contacts or ties: only the
                      ///< contacts' part changes
  bool multipliers;   ///< contacts have Lagrange multipliers as unknowns
  bool potential;     ///< the tangent is symmetric: all contacts and loads have a potential
};

template <int D> LinearFacts linear_facts(const System<D>& system);

/// Whether the bodies' part of the tangent is constant; damping of unconstrained bodies changes it.
bool can_condense(const LinearFacts& facts, bool damps);

/// The first solver of a path; `automatic` means solve::make_automatic.
solve::LinearKind first_choice(const LinearFacts& facts, bool damps);

} // namespace signorini::model
