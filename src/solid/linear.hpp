#pragma once
// Small strains: the stiffness of an element, computed once, and the kernel that applies it.

#include "solid/kernel.hpp"
#include "solid/material.hpp"

namespace signorini::solid {

/// An element's stiffness, which is neo-Hooke's tangent where nothing is strained yet; arguments as in KernelArguments.
template <int D>
void rest_stiffness(const ElasticConstants& constants, int n, int points, const double* gradients,
                    const double* weights, const double* constant, double* blocks);

/// Adds one Gauss point's part of the stiffness of an element of a body of revolution to `blocks` (laid out as in
/// KernelArguments, n functions). `gradients`: 2 rows of n values ∂R_A/∂X_k; `hoop`: n values R_A/R.
void add_stiffness_of_revolution(const ElasticConstants& constants, double weight, int n, const double* gradients,
                                 const double* hoop, double* blocks);

/// f = K u, and K itself. No state is inverted.
template <int D> KernelResult linear_kernel(const KernelArguments& arguments);

} // namespace signorini::solid
