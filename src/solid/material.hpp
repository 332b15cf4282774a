#pragma once
// The material of a body: any law as one type.

#include "solid/kernel_generic.hpp"

#include <memory>

namespace signorini::solid {

/// F in space for a deformation in D dimensions; `across` is F₃₃ of a plane one: the hoop stretch in a body of
/// revolution (directions r, z, θ), 1 in plane strain.
template <int D> Mat<3> in_space(const Mat<D>& deformation, double across = 1) {
  if constexpr (D == 3) {
    return deformation;
  } else {
    Mat<3> f = Mat<3>::Zero();
    f.topLeftCorner<2, 2>() = deformation;
    f(2, 2) = across;
    return f;
  }
}

/// Shared ownership of an immutable law.
class Material {
public:
  template <class T>
  requires(!std::same_as<T, Material> && Law<T>) Material(T law);

  const char* name() const { return name_; }
  /// True if stress is linear in displacements: the tangent is constant.
  bool linear() const { return linear_; }
  const ElasticConstants& constants() const { return constants_; }
  /// Internal variables of an unstrained point; empty for most laws.
  const std::vector<double>& initial_values() const { return initial_; }
  /// The law, for the kernels.
  const void* law() const { return law_.get(); }
  /// Kernels for elements of n functions in bodies of D dimensions.
  template <int D> Kernels kernels(Kind kind, int functions) const { return kernels_[D - 2](kind, functions); }

  /// Stored energy per reference volume. `f` is F, with positive determinant unless the law is linear; `committed`:
  /// internal variables of the point, empty for the initial ones.
  double energy(const Mat<3>& f, std::span<const double> committed = {}) const;
  /// First Piola–Kirchhoff stress; arguments as for energy().
  Mat<3> stress(const Mat<3>& f, std::span<const double> committed = {}) const;
  /// Also writes the trial values of internal variables.
  Mat<3> stress(const Mat<3>& f, std::span<const double> committed, std::span<double> trial) const {
    return stress_(law(), f, committed, trial);
  }
  /// ∂P/∂F at fixed committed values.
  Moduli moduli(const Mat<3>& f, std::span<const double> committed) const { return moduli_(law(), f, committed); }
  /// Stress and moduli at many points in D dimensions; null for a law with internal variables.
  template <int D> Respond respond() const { return respond_[D - 2]; }
  /// Cauchy stress; arguments as for energy(). In plane strain σ₃₃ is the out-of-plane stress.
  Mat<3> cauchy_stress(const Mat<3>& f, std::span<const double> committed = {}) const;
  /// F₃₃ with P₃₃ = 0 for F in the plane; 1 if there is none, or if the law has internal variables.
  double thickness_stretch(const Mat<2>& f) const { return thickness_(law(), f); }

private:
  const char* name_;
  bool linear_;
  std::shared_ptr<const void> law_;
  ElasticConstants constants_;
  std::vector<double> initial_;
  double (*energy_)(const void* law, const Mat<3>& f, std::span<const double> committed);
  Mat<3> (*stress_)(const void* law, const Mat<3>& f, std::span<const double> committed, std::span<double> trial);
  Moduli (*moduli_)(const void* law, const Mat<3>& f, std::span<const double> committed);
  double (*thickness_)(const void* law, const Mat<2>& f);
  Respond respond_[2];                              ///< in 2 and 3 dimensions
  Kernels (*kernels_[2])(Kind kind, int functions); ///< in 2 and 3 dimensions
};

/// See Material::thickness_stretch().
template <Law T> double thickness_of(const void* given, const Mat<2>& f) {
  if constexpr (ElasticResponse<T>) {
    const T& law = *static_cast<const T*>(given);
    if constexpr (T::linear) {
      const Mat<3> strained = in_space<2>(f);
      return 1 - law.stress(strained)(2, 2) / law.moduli(strained)(8, 8);
    }
    const ElasticConstants& constants = law;
    const double stretch =
        f.determinant() > 0 ? thickness_stretch(response<T, 2>(), given, constants.poissons_ratio, f) : 0;
    return stretch > 0 ? stretch : 1;
  }
  return 1;
}

template <Law T, int D> constexpr Respond response_or_none() {
  if constexpr (ElasticResponse<T>) return response<T, D>();
  return nullptr;
}

template <class T>
requires(!std::same_as<T, Material> && Law<T>) Material::Material(T law)
    : name_(T::name), linear_(T::linear), law_(std::make_shared<const T>(law)), constants_(law),
      energy_([](const void* law, const Mat<3>& f, std::span<const double> committed) {
        return solid::energy(*static_cast<const T*>(law), f, committed);
      }),
      stress_([](const void* law, const Mat<3>& f, std::span<const double> committed, std::span<double> trial) {
        return solid::stress(*static_cast<const T*>(law), f, committed, trial);
      }),
      moduli_([](const void* law, const Mat<3>& f, std::span<const double> committed) {
        return solid::moduli(*static_cast<const T*>(law), f, committed);
      }),
      thickness_(thickness_of<T>), respond_{response_or_none<T, 2>(), response_or_none<T, 3>()},
      kernels_{law_kernels<T, 2>, law_kernels<T, 3>} {
  if constexpr (InelasticResponse<T>) initial_ = law.initial_values();
}

} // namespace signorini::solid
