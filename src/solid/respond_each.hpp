#pragma once
// The response of any elastic law at many points, one after the other, and that under plane stress.

#include "solid/kernel.hpp"
#include "solid/law.hpp"

namespace signorini::solid {

/// F of a point of a block, with F₁₃, F₂₃, F₃₁, F₃₂ zero in the plane.
template <int D> Mat<3> deformation_at(const PointBlock& block, int q) {
  Mat<3> f = Mat<3>::Zero();
  for (int e = 0; e < entries_in(D); ++e) {
    const int entry = component<D>(e);
    f(entry / 3, entry % 3) = block.f[e * block.stride + q];
  }
  return f;
}

/// Writes stress(q, F) and, if they are wanted, moduli(q, F) of all points q of a block.
template <int D, class Stress, class Tangent>
void respond_by(const Stress& stress, const Tangent& moduli, const PointBlock& block) {
  constexpr int entries = entries_in(D);
  for (int q = 0; q < block.points; ++q) {
    const Mat<3> f = deformation_at<D>(block, q), p = stress(q, f);
    for (int e = 0; e < entries; ++e) block.stress[e * block.stride + q] = p(component<D>(e) / 3, component<D>(e) % 3);
    if (!block.moduli) continue;
    const Moduli all = moduli(q, f);
    for (int e = 0; e < entries; ++e)
      for (int o = e; o < entries; ++o)
        block.moduli[packed(entries, e, o) * block.stride + q] = all(component<D>(e), component<D>(o));
  }
}

template <ElasticResponse T, int D> void respond_each(const void* given, const PointBlock& block) {
  const T& law = *static_cast<const T*>(given);
  respond_by<D>([&](int, const Mat<3>& f) { return law.stress(f); },
                [&](int, const Mat<3>& f) { return law.moduli(f); }, block);
}

/// The law's own response at many points if it has one.
template <ElasticResponse T, int D> constexpr Respond response() {
  if constexpr (requires { T::template respond<D>; })
    return T::template respond<D>;
  else
    return respond_each<T, D>;
}

/// F₃₃ with P₃₃ = 0 by Newton's method at each point, then the stress in the plane and its moduli at P₃₃ = 0. F₃₃ is 0
/// where there is none. `poissons_ratio` gives the start.
void respond_in_plane_stress(Respond respond, const void* law, double poissons_ratio, const PointBlock& block);

template <ElasticResponse T> void plane_stress_response(const void* law, const PointBlock& block) {
  const ElasticConstants& constants = *static_cast<const T*>(law);
  respond_in_plane_stress(response<T, 2>(), law, constants.poissons_ratio, block);
}

/// F₃₃ with P₃₃ = 0 for F in the plane with positive determinant, or 0 if there is none.
double thickness_stretch(Respond respond, const void* law, double poissons_ratio, const Mat<2>& f);

/// The kernels of a law that gives stress and moduli at many points at once, for any kind.
template <ElasticResponse T, int D> Kernels moduli_kernels_of(Kind kind) {
  const Respond respond = kind == Kind::plane_stress ? plane_stress_response<T> : response<T, D>();
  return {moduli_kernels<D>().back(), nullptr, 0, respond};
}

} // namespace signorini::solid
