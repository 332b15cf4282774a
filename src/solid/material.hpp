#pragma once
// The material of a body: any law as one type.

#include "solid/respond_each.hpp"

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
  /// True if strains are small by definition: F may be any, all stress measures are equal.
  bool small_strains() const { return small_strains_; }
  /// Internal variables of an unstrained point in 2 or 3 dimensions; empty for most laws.
  const std::vector<double>& initial_values(int dimensions) const { return initial_[dimensions - 2]; }
  /// The law, for the kernels.
  const void* law() const { return law_.get(); }
  /// Kernels for elements of n functions in bodies of D dimensions.
  template <int D> Kernels kernels(Kind kind, int functions) const { return kernels_[D - 2](kind, functions); }

  /// Energy of the step per reference volume, ∂W/∂F = P: of an elastic law that stored. `f` is F, with positive
  /// determinant unless strains are small; `memory`: internal variables of the point, without committed ones the
  /// initial ones.
  double energy(const Mat<3>& f, const Memory& memory = {}) const;
  /// First Piola–Kirchhoff stress; writes the trial values if there are any.
  Mat<3> stress(const Mat<3>& f, const Memory& memory = {}) const;
  /// ∂P/∂F at fixed committed values.
  Moduli moduli(const Mat<3>& f, const Memory& memory = {}) const;
  /// Energies of a state with these internal variables, empty: the initial ones.
  Account account(const Mat<3>& f, std::span<const double> values = {}) const;
  /// Cauchy stress. In plane strain σ₃₃ is the out-of-plane stress.
  Mat<3> cauchy_stress(const Mat<3>& f, const Memory& memory = {}) const;
  /// F₃₃ with P₃₃ = 0 for F in the plane; 1 if there is none.
  double thickness_stretch(const Mat<2>& f, const Memory& memory = {}) const;
  /// Stress and moduli at many points in D dimensions.
  template <int D> Respond respond() const { return respond_[D - 2]; }

private:
  const char* name_;
  bool linear_, small_strains_;
  std::shared_ptr<const void> law_;
  ElasticConstants constants_;
  std::vector<double> initial_[2]; ///< in 2 and 3 dimensions, as below
  /// The law's functions at one point.
  struct AtPoint {
    double (*energy)(const void* law, const Mat<3>& f, const Memory& memory);
    Mat<3> (*stress)(const void* law, const Mat<3>& f, const Memory& memory);
    Moduli (*moduli)(const void* law, const Mat<3>& f, const Memory& memory);
    Account (*account)(const void* law, const Mat<3>& f, std::span<const double> values);
  } at_point_;
  Respond respond_[2];
  Kernels (*kernels_[2])(Kind kind, int functions);
};

template <class T>
requires(!std::same_as<T, Material> && Law<T>) Material::Material(T law)
    : name_(T::name), linear_(T::linear), small_strains_(T::linear), law_(std::make_shared<const T>(law)),
      constants_(law), respond_{response<T, 2>(), response<T, 3>()}, kernels_{law_kernels<T, 2>, law_kernels<T, 3>} {
  if constexpr (requires { law.small_strains(); }) small_strains_ = law.small_strains();
  if constexpr (InelasticResponse<T>) {
    for (int d : {2, 3}) initial_[d - 2] = law.initial_values(d);
    at_point_.energy = [](const void* of, const Mat<3>& f, const Memory& m) {
      return static_cast<const T*>(of)->energy(f, m);
    };
    at_point_.stress = [](const void* of, const Mat<3>& f, const Memory& m) {
      return static_cast<const T*>(of)->stress(f, m);
    };
    at_point_.moduli = [](const void* of, const Mat<3>& f, const Memory& m) {
      return static_cast<const T*>(of)->moduli(f, m);
    };
    at_point_.account = [](const void* of, const Mat<3>& f, std::span<const double> values) {
      return static_cast<const T*>(of)->account(f, values);
    };
  } else {
    at_point_.energy = [](const void* of, const Mat<3>& f, const Memory&) {
      return static_cast<const T*>(of)->energy(f);
    };
    at_point_.stress = [](const void* of, const Mat<3>& f, const Memory&) {
      return static_cast<const T*>(of)->stress(f);
    };
    at_point_.moduli = [](const void* of, const Mat<3>& f, const Memory&) {
      return static_cast<const T*>(of)->moduli(f);
    };
    at_point_.account = [](const void* of, const Mat<3>& f, std::span<const double>) {
      return Account{static_cast<const T*>(of)->energy(f), 0};
    };
  }
}

} // namespace signorini::solid
