#pragma once
// Law of an interface at one contact point: traction on the slave with the consistent tangent.

#include "contact/law/interface_law.hpp"
#include "contact/point/local.hpp"

namespace signorini::contact {

/// Evaluates the law [theory 5.3] [theory 7.1] [theory 9.2] at a point that it closes, or at one with a fixed state.
template <int D> void interface_force(const InterfaceLaw& law, const LocalGeometry<D>& geometry, LocalForce<D>& result);

} // namespace signorini::contact
