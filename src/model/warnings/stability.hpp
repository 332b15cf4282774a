#pragma once
// Stability of a state of equilibrium.

#include "model/steps/model.hpp"

namespace signorini::model {

/// Appends a warning if the accepted state is an unstable equilibrium: if a motion u of negative second-order work uᵀ K
/// u exists (R. Hill, J. Mech. Phys. Solids 6, 1958), where K is the tangent of the displacements that closed contacts,
/// ties and supports admit. Touching points count as closed, and points with friction stick, so that nothing is softer
/// than it is. An unsymmetric K has no potential: there the warning needs a negative eigenvalue, K u = κ u, with which
/// motions grow, and without it nothing is said. Neither is it said of states from which bonds or materials soften only
/// in one direction, nor of motions without stiffness, which are neutral. Does not change the model's state, in which
/// no step may be pending.
template <int D> void warn_of_instability(Model<D>& model, std::vector<Message>& warnings);

} // namespace signorini::model
