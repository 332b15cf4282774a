#pragma once
// Which linear solver suits a scene, where the user leaves the choice open.

#include "model/system.hpp"
#include "solve/linear.hpp"

namespace signorini::model {

/// What the choice of a linear solver asks of a scene.
struct LinearFacts {
  bool constant_bulk; ///< bodies that are all linear elastic, and a contact: only the contacts' part changes
  bool potential;     ///< the tangent is symmetric: all contacts have a potential
};

template <int D> LinearFacts linear_facts(const System<D>& system);

/// Whether the bodies' part of the tangent is factored once: not where loose bodies are damped, which changes it.
bool can_condense(const LinearFacts& facts, bool damps);

/// What a path begins with; `automatic` stands for solve::make_automatic.
solve::LinearKind first_choice(const LinearFacts& facts, bool damps);

} // namespace signorini::model
