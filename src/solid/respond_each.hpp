#pragma once
// The response of any law at many points, one after the other, and that under plane stress.

#include "solid/kernel.hpp"
#include "solid/law.hpp"

#include <array>

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

/// Internal variables of point q of a block; `scratch` replaces trial values that are not wanted.
inline Memory memory_at(const PointMemory& memory, int q, std::vector<double>& scratch) {
  const auto count = static_cast<std::size_t>(memory.variables), first = q * count;
  if (!memory.trial) scratch.resize(count);
  return {{memory.committed + first, count},
          memory.trial ? std::span(memory.trial + first, count) : std::span(scratch),
          memory.duration};
}

template <Law T, int D> void respond_each(const void* given, const PointBlock& block) {
  const T& law = *static_cast<const T*>(given);
  if constexpr (InelasticResponse<T>) {
    std::vector<double> scratch;
    respond_by<D>([&](int q, const Mat<3>& f) { return law.stress(f, memory_at(block.memory, q, scratch)); },
                  [&](int q, const Mat<3>& f) { return law.moduli(f, memory_at(block.memory, q, scratch)); }, block);
  } else {
    respond_by<D>([&](int, const Mat<3>& f) { return law.stress(f); },
                  [&](int, const Mat<3>& f) { return law.moduli(f); }, block);
  }
}

/// The law's own response at many points if it has one.
template <Law T, int D> constexpr Respond response() {
  if constexpr (requires { T::template respond<D>; })
    return T::template respond<D>;
  else
    return respond_each<T, D>;
}

/// The response at one point of a body in D dimensions, in a block of whole vectors.
template <int D> struct PointResponse {
  PointResponse(Respond respond, const void* law, const Mat<3>& f, const Memory& memory, bool moduli) {
    for (int q = 0; q < stride; ++q)
      for (int e = 0; e < entries; ++e) deformation[e * stride + q] = f(component<D>(e) / 3, component<D>(e) % 3);
    const PointMemory own{memory.committed.data(), memory.trial.empty() ? nullptr : memory.trial.data(),
                          static_cast<int>(memory.committed.size()), memory.duration};
    respond(law, {1, stride, deformation.data(), p.data(), moduli ? a.data() : nullptr, own});
  }
  Mat<3> stress() const {
    Mat<3> all = Mat<3>::Zero();
    for (int e = 0; e < entries; ++e) all(component<D>(e) / 3, component<D>(e) % 3) = p[e * stride];
    return all;
  }
  Moduli moduli() const {
    Moduli all = Moduli::Zero();
    for (int e = 0; e < entries; ++e)
      for (int o = e; o < entries; ++o)
        all(component<D>(e), component<D>(o)) = all(component<D>(o), component<D>(e)) =
            a[packed(entries, e, o) * stride];
    return all;
  }
  static constexpr int stride = vector_padding, entries = entries_in(D);
  std::array<double, entries * stride> deformation, p;
  std::array<double, packed_size(entries) * stride> a;
};

/// F₃₃ with P₃₃ = 0 by Newton's method at each point, then the stress in the plane and its moduli at P₃₃ = 0. F₃₃ is 0
/// where there is none. `poissons_ratio` gives the start.
void respond_in_plane_stress(Respond respond, const void* law, double poissons_ratio, const PointBlock& block);

template <Law T> void plane_stress_response(const void* law, const PointBlock& block) {
  const ElasticConstants& constants = *static_cast<const T*>(law);
  respond_in_plane_stress(response<T, 2>(), law, constants.poissons_ratio, block);
}

/// F₃₃ with P₃₃ = 0 for F in the plane with positive determinant, or 0 if there is none.
double thickness_stretch(Respond respond, const void* law, double poissons_ratio, const Mat<2>& f,
                         const PointMemory& memory);

/// The kernels of a law that gives stress and moduli at many points at once, for any kind.
template <Law T, int D> Kernels moduli_kernels_of(Kind kind) {
  const Respond respond = kind == Kind::plane_stress ? plane_stress_response<T> : response<T, D>();
  return {moduli_kernels<D>().back(), nullptr, 0, respond};
}

/// The kernels of a law: its own if it defines them.
template <Law T, int D> Kernels law_kernels(Kind kind, int functions) {
  if constexpr (requires { T::template kernels<D>(kind, functions); }) {
    return T::template kernels<D>(kind, functions);
  } else {
    static_assert(!T::linear);
    return moduli_kernels_of<T, D>(kind);
  }
}

} // namespace signorini::solid
