#pragma once
// The neo-Hooke kernel of bodies of revolution that deform without twist: x = r, y = z, and the hoops' stretch.

#include "solid/kernel.hpp"

namespace signorini::solid {

/// `hoop` must be there, and the weights hold the circumference 2πR. Where the element is inverted the Jacobian is that
/// of the plane part or, when the point crossed the axis, the hoop's stretch r/R: whichever is not positive.
KernelResult axisymmetric_kernel(const KernelArguments& arguments);

} // namespace signorini::solid
