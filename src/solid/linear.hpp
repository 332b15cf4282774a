#pragma once
// Small strains: the stiffness of an element, computed once, and the kernel that applies it.

#include "solid/kernel.hpp"
#include "solid/material.hpp"

namespace signorini::solid {

/// Adds one Gauss point's part of an element's stiffness to `blocks` (laid out as in KernelArguments, n functions).
/// `gradients`: D rows of n values ∂R_A/∂X_k; `hoop`: n values R_A/R for a body of revolution (D = 2), else null.
template <int D>
void add_stiffness(const ElasticConstants& constants, double weight, int n, const double* gradients, const double* hoop,
                   double* blocks);

/// f = K u, and K itself. No state is inverted.
template <int D> KernelResult linear_kernel(const KernelArguments& arguments);

} // namespace signorini::solid
