#pragma once
// Definition of a material law. A new law is a struct with these members in a separate file, a row in archive.cpp for
// files, and a function in bind/scene/material.cpp for scripts.

#include "base/eigen.hpp"

#include <concepts>
#include <span>
#include <vector>

namespace signorini::solid {

/// Young's modulus and Poisson's ratio of an isotropic law at zero strain, and Lamé's constants that follow from them.
struct ElasticConstants {
  double youngs_modulus; ///< E > 0, force per area
  double poissons_ratio; ///< −1 < ν < 0.5
  double lambda;         ///< λ = 2μν/(1 − 2ν)
  double mu;             ///< μ = E/(2(1 + ν))
};

/// Throws Error unless E > 0 and −1 < ν < 0.5.
ElasticConstants elastic_constants(double youngs_modulus, double poissons_ratio);

/// ∂P/∂F: row 3i + k and column 3j + l hold ∂P_ik/∂F_jl. Symmetric because stress derives from an energy.
using Moduli = Mat<9>;

/// The moduli with ∂P_ik/∂F_jl = entry(i, k, j, l).
template <class Entry> Moduli moduli_of(const Entry& entry) {
  return Moduli::NullaryExpr([&](Eigen::Index row, Eigen::Index column) -> double {
    const int r = static_cast<int>(row), c = static_cast<int>(column);
    return entry(r / 3, r % 3, c / 3, c % 3);
  });
}

/// Internal variables in a step, of a point or of a body: those at its start, those at its end, which the response
/// writes and which are committed if the step is accepted, and its duration; infinite: until nothing changes any more.
struct Memory {
  std::span<const double> committed = {};
  std::span<double> trial = {};
  double duration = 0;
};

/// Energy W per reference volume, first Piola–Kirchhoff stress P = ∂W/∂F and its moduli at F.
template <class T>
concept ElasticResponse = requires(const T& law, const Mat<3>& f) {
  { law.energy(f) } -> std::same_as<double>;
  { law.stress(f) } -> std::same_as<Mat<3>>;
  { law.moduli(f) } -> std::same_as<Moduli>;
};

/// Energy per reference volume of a law with internal variables.
struct Account {
  double stored = 0;
  double viscous = 0; ///< work of the stresses that relax, from the start of the path on
};

/// A response with internal variables: `initial_values()` are those of one unstrained point of a body in 2 or 3
/// dimensions. `stress` writes the trial values at F, `moduli` differentiates it at fixed committed values. The energy
/// is that of the step, ∂W/∂F = P; `account` is that of a state with given values.
template <class T>
concept InelasticResponse = requires(const T& law, const Mat<3>& f, const Memory& memory, int dimensions) {
  { law.initial_values(dimensions) } -> std::same_as<std::vector<double>>;
  { law.energy(f, memory) } -> std::same_as<double>;
  { law.stress(f, memory) } -> std::same_as<Mat<3>>;
  { law.moduli(f, memory) } -> std::same_as<Moduli>;
  { law.account(f, memory.committed) } -> std::same_as<Account>;
};

/// A law has: its parameters, which define elastic constants for estimates (derive from ElasticConstants, or convert to
/// it); a display name; whether it is linear, that is, P is proportional to F − I, so that the tangent is constant,
/// states cannot be inverted and all stress measures are equal; and its response to F, which is always 3×3, with F₃₃ =
/// 1 in plane strain and in the directions (r, z, θ) for a body of revolution. A law that computes many points at once
/// does so in `template <int D> static void respond(const void* law, const PointBlock&)`; a linear one, and one with
/// faster element kernels, returns these from `template <int D> static Kernels kernels(Kind, int functions)`.
template <class T>
concept Law = std::copy_constructible<T> && std::convertible_to<T, ElasticConstants> &&
    std::convertible_to<decltype(T::name), const char*> && std::same_as<decltype(T::linear), const bool> &&
    (ElasticResponse<T> || (InelasticResponse<T> && !T::linear));

} // namespace signorini::solid
