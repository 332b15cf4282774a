#pragma once
// The signs of the eigenvalues of a tangent under its constraints.

#include "model/stability/displacement_stiffness.hpp"
#include "model/system/system.hpp"
#include "solve/linear.hpp"

#include <optional>

namespace signorini::model {

/// displacement_stiffness() of a system; `values` in the order of its tangent's pattern.
template <int D>
Stiffness displacement_stiffness(const System<D>& system, const solve::Pattern& pattern,
                                 const std::vector<double>& values);

/// By CHOLMOD, or by MUMPS if the tangents of the path are too large for one process.
bool is_definite(const Stiffness& k, solve::LinearKind kind);
/// The number of negative eigenvalues of a symmetric matrix by one of both; nothing if it is uncertain.
std::optional<int> negative_eigenvalues(const Stiffness& k, solve::LinearKind kind);

} // namespace signorini::model
