#include "solid/projected.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::solid {

// With c = (Pθ − θ)/3, T = ∂θ/∂F = F⁻ᵀ (at small strains I), P̄ = ∂W/∂F̄, the mean Kirchhoff stress τ = P̄:F̄/3 and its
// projection π = Pτ (P is self-adjoint) the first variation of ∫ W(F̄) dV is
//   ∫ P*:δF dV, P* = eᶜ P̄ + (π − τ) T.
// With the moduli A at F̄, u = A:F̄, h = eᶜ (u + P̄), b = F̄:u/9 + τ/3 the second one is
//   ∫ δF:M:∂F + δF:v P∂θ + ∂F:v Pδθ + b Pδθ P∂θ dV,
//   M = e²ᶜ A − (h⊗T + T⊗h)/3 + b T⊗T − (π − τ) X, X_ik,jl = T_il T_jk, v = h/3 − b T.
// At small strains eᶜ is 1 and, as F̄ is linear in u, the terms with P̄, τ and π vanish from it.

namespace {

/// Rows of a PointBlock for the Gauss points of a macro-element, up to whole vectors.
Eigen::Index stride_of(const MacroElement& macro) {
  constexpr auto lanes = static_cast<Eigen::Index>(vector_padding);
  return (macro.modes.rows() + lanes - 1) / lanes * lanes;
}

/// F at the Gauss points of a macro-element, entries of response.hpp in columns, and θ.
template <int D> struct Deformations {
  static constexpr int entries = entries_in(D);
  using Entries = Eigen::Matrix<double, entries, 1>;
  using Rows =
      Eigen::Matrix<double, Eigen::Dynamic, entries>; ///< one row per point; its columns are the rows of a PointBlock
  Rows f, directions;                                 ///< F and T
  VectorX dilation;
  std::optional<Inversion> inversion;
};

/// 3i + k of an entry of F, and the entry of 3i + k (−1: none).
template <int D> constexpr int component(int entry) {
  return D == 3 ? entry : plane_entries[entry];
}
template <int D> constexpr int entry_at(int i, int k) {
  if (D == 3) return 3 * i + k;
  return i < 2 && k < 2 ? 2 * i + k : i == 2 && k == 2 ? 4 : -1;
}

template <int D> Mat<3> matrix_of(const typename Deformations<D>::Entries& entries) {
  Mat<3> f = Mat<3>::Zero();
  for (int e = 0; e < entries_in(D); ++e) f(component<D>(e) / 3, component<D>(e) % 3) = entries(e);
  return f;
}

template <int D> StrainRows<D> strain_rows(const Body<D>& body, int e, int q) {
  const int n = body.element(e).functions;
  const double* hoops = body.hoops_of(e);
  return {n, body.gradients_of(e) + q * D * n, hoops ? hoops + q * n : nullptr};
}

/// The first inverted point ends the loop; with small strains there is none.
template <int D> Deformations<D> deformations(const Body<D>& body, int m, const double* displacement) {
  const MacroElement& macro = body.macro(m);
  const Eigen::Index points = macro.modes.rows();
  Deformations<D> result{{stride_of(macro), entries_in(D)}, {points, entries_in(D)}, VectorX(points), {}};
  Eigen::Index point = 0;
  for (int e : macro.elements) {
    const auto functions = body.functions_of(e);
    for (int q = 0; q < body.element(e).points; ++q, ++point) {
      const StrainRows<D> rows = strain_rows(body, e, q);
      Mat<3> strain = Mat<3>::Zero();
      for (int i = 0; i < D; ++i)
        for (int r = 0; r < rows.count(i); ++r) {
          double& sum = strain(rows.entry(i, r) / 3, rows.entry(i, r) % 3);
          for (std::size_t a = 0; a < functions.size(); ++a) sum += displacement[D * functions[a] + i] * rows.row(r)[a];
        }
      const Mat<3> f = strain + Mat<3>::Identity();
      Mat<3> direction = Mat<3>::Identity();
      if (body.linear()) {
        result.dilation(point) = strain.trace();
      } else {
        const double plane = f.template topLeftCorner<D, D>().determinant(), across = D == 2 ? f(2, 2) : 1;
        for (double j : {plane, across})
          if (!(j > 0)) {
            result.inversion = Inversion{e, body.reference_point(e, q), j};
            return result;
          }
        result.dilation(point) = std::log(plane * across);
        direction = f.inverse().transpose();
      }
      for (int k = 0; k < entries_in(D); ++k) {
        const int place = component<D>(k);
        result.f(point, k) = f(place / 3, place % 3);
        result.directions(point, k) = direction(place / 3, place % 3);
      }
    }
  }
  return result;
}

/// Weights of all points of a macro-element.
template <int D> VectorX weights_in(const Body<D>& body, const MacroElement& macro) {
  VectorX weights(macro.modes.rows());
  Eigen::Index point = 0;
  for (int e : macro.elements) {
    const int points = body.element(e).points;
    weights.segment(point, points) = Eigen::Map<const VectorX>(body.weights_of(e), points);
    point += points;
  }
  return weights;
}

/// Coefficients of the modes for the projection of values at the points.
VectorX coefficients(const MacroElement& macro, const VectorX& weights, const VectorX& values) {
  return macro.modes.transpose() * weights.cwiseProduct(values);
}

/// Replaces F by F̄; returns c.
template <int D>
VectorX project(const Body<D>& body, const MacroElement& macro, const VectorX& weights, Deformations<D>& at) {
  const VectorX c = (macro.modes * coefficients(macro, weights, at.dilation) - at.dilation) / 3;
  for (int k = 0; k < entries_in(D); ++k) {
    auto f = at.f.col(k).head(c.size());
    if (!body.linear())
      f.array() *= c.array().exp();
    else if (component<D>(k) % 4 == 0)
      f += c;
    at.f.col(k).tail(at.f.rows() - c.size()).setConstant(f(c.size() - 1));
  }
  return c;
}

/// Stress and moduli given at the points of an element, for the kernels of response.hpp.
struct GivenResponse {
  const double *stress, *moduli; ///< rows of `stride` values
  Eigen::Index stride;
  int entries;
};
void respond_as_given(const void* law, const PointBlock& block) {
  const GivenResponse& given = *static_cast<const GivenResponse*>(law);
  const auto copy = [&](const double* from, double* to, int rows) {
    for (int row = 0; row < rows; ++row) std::copy_n(from + row * given.stride, block.points, to + row * block.stride);
  };
  copy(given.stress, block.stress, given.entries);
  if (block.moduli) copy(given.moduli, block.moduli, packed_size(given.entries));
}

/// Stress and moduli of a law with internal variables.
template <int D>
void respond_with_variables(const Body<D>& body, const MacroElement& macro, const PointBlock& block,
                            std::span<const double> committed, std::span<double> trial) {
  const std::size_t variables = at(body.internal_variables());
  const auto entry = [](int e) { return component<D>(e); };
  int point = 0;
  for (int e : macro.elements)
    for (int q = 0; q < body.element(e).points; ++q, ++point) {
      const std::size_t first = (body.element(e).point + at(q)) * variables;
      const auto begun = committed.subspan(first, variables);
      const Mat<3> f = deformation_at<D>(block, point);
      const Mat<3> p = body.material().stress(f, begun, trial.subspan(first, variables));
      for (int k = 0; k < entries_in(D); ++k) block.stress[k * block.stride + point] = p(entry(k) / 3, entry(k) % 3);
      if (!block.moduli) continue;
      const Moduli moduli = body.material().moduli(f, begun);
      for (int k = 0; k < entries_in(D); ++k)
        for (int o = k; o < entries_in(D); ++o)
          block.moduli[packed(entries_in(D), k, o) * block.stride + point] = moduli(entry(k), entry(o));
    }
}

/// Σ_q w φ_m `values`:∂F/∂u: one column per mode, D rows of values for each of the macro-element's functions.
template <int D>
MatrixX modes_of(const Body<D>& body, const MacroElement& macro, const VectorX& weights,
                 const typename Deformations<D>::Rows& values) {
  const Eigen::Index n = std::ssize(macro.functions), modes = macro.modes.cols();
  MatrixX sum = MatrixX::Zero(D * n, modes);
  Eigen::Index point = 0;
  for (std::size_t cell = 0; cell < macro.elements.size(); ++cell) {
    const int e = macro.elements[cell], points = body.element(e).points, functions = body.element(e).functions;
    MatrixX strains = MatrixX::Zero(D * functions, points);
    for (int q = 0; q < points; ++q) {
      const StrainRows<D> rows = strain_rows(body, e, q);
      for (int i = 0; i < D; ++i)
        for (int r = 0; r < rows.count(i); ++r) {
          const int place = rows.entry(i, r);
          const double factor = weights(point + q) * values(point + q, entry_at<D>(place / 3, place % 3));
          strains.block(i * functions, q, functions, 1) += factor * Eigen::Map<const VectorX>(rows.row(r), functions);
        }
    }
    const MatrixX own = strains * macro.modes.middleRows(point, points);
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < functions; ++a) sum.row(i * n + macro.places[cell][at(a)]) += own.row(i * functions + a);
    point += points;
  }
  return sum;
}

/// K^{ij} += B_i Ãᵀ_j + Ã_i Bᵀ_j for i ≤ j.
template <int D> void add_modes(const MatrixX& b, const MatrixX& a, double* blocks) {
  const Eigen::Index n = b.rows() / D;
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j, blocks += n * n) {
      Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> block(blocks, n, n);
      block.noalias() += b.middleRows(i * n, n) * a.middleRows(j * n, n).transpose();
      block.noalias() += a.middleRows(i * n, n) * b.middleRows(j * n, n).transpose();
    }
}

/// Runs an element's kernel with its stress and moduli and adds the results to those of the macro-element.
template <int D>
void add_cell(const Body<D>& body, const MacroElement& macro, std::size_t cell, const GivenResponse& given,
              const double* displacement, ElementArrays<D>& arrays, bool tangent) {
  const int e = macro.elements[cell];
  const std::size_t own = at(body.element(e).functions), n = macro.functions.size();
  const auto functions = body.functions_of(e);
  // Linear laws have no inversion, which the kernel would find.
  for (std::size_t a = 0; a < own; ++a)
    for (std::size_t i = 0; i < D; ++i)
      arrays.local[i * own + a] = body.linear() ? 0 : displacement[D * functions[a] + static_cast<int>(i)];
  KernelArguments arguments = body.arguments(e);
  arguments.local = arrays.local.data();
  arguments.force = arrays.cell_force.data();
  arguments.work = arrays.work.data();
  arguments.factors = arrays.factors.data();
  arguments.blocks = tangent ? arrays.cell_blocks.data() : nullptr;
  arguments.law = &given;
  body.element(e).kernels.element(arguments);
  const std::vector<int>& places = macro.places[cell];
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t a = 0; a < own; ++a) arrays.force[i * n + at(places[a])] += arrays.cell_force[i * own + a];
  if (!tangent) return;
  const double* from = arrays.cell_blocks.data();
  double* block = arrays.blocks.data();
  for (int pair = 0; pair < D * (D + 1) / 2; ++pair, block += n * n)
    for (std::size_t a = 0; a < own; ++a)
      for (std::size_t b = 0; b < own; ++b) block[at(places[a]) * n + at(places[b])] += *from++;
}

} // namespace

template <int D> Kernels projected_kernels() {
  return {moduli_kernels<D>().back(), nullptr, 0, respond_as_given};
}

template <int D>
std::optional<Inversion> projected_force(const Body<D>& body, int m, const double* displacement,
                                         ElementArrays<D>& arrays, bool tangent, std::span<const double> committed,
                                         std::span<double> trial) {
  using Entries = typename Deformations<D>::Entries;
  constexpr int entries = entries_in(D);
  const MacroElement& macro = body.macro(m);
  Deformations<D> state = deformations(body, m, displacement);
  if (state.inversion) return state.inversion;
  const VectorX weights = weights_in(body, macro), c = project(body, macro, weights, state);
  const Eigen::Index points = weights.size();

  typename Deformations<D>::Rows stress(stride_of(macro), entries);
  MatrixX moduli(stride_of(macro), tangent ? packed_size(entries) : 0);
  const PointBlock block{static_cast<int>(points), static_cast<int>(stress.rows()), state.f.data(), stress.data(),
                         tangent ? moduli.data() : nullptr};
  if (body.internal_variables() == 0)
    body.material().template respond<D>()(body.material().law(), block);
  else
    respond_with_variables(body, macro, block, committed, trial);

  const bool finite = !body.linear();
  VectorX mean = VectorX::Zero(points); // τ
  for (int k = 0; k < entries; ++k) {
    if (finite)
      mean += stress.col(k).head(points).cwiseProduct(state.f.col(k).head(points)) / 3;
    else if (component<D>(k) % 4 == 0)
      mean += stress.col(k).head(points) / 3;
  }
  const VectorX excess = macro.modes * coefficients(macro, weights, mean) - mean; // π − τ
  typename Deformations<D>::Rows coupling(tangent ? points : 0, entries);         // v
  VectorX square(tangent ? points : 0);                                           // b
  for (Eigen::Index q = 0; q < points; ++q) {
    const double scale = finite ? std::exp(c(q)) : 1;
    const Entries p = stress.row(q), t = state.directions.row(q), f = finite ? Entries(state.f.row(q)) : t;
    stress.row(q) = scale * p + excess(q) * t;
    if (!tangent) continue;
    Entries u = Entries::Zero();
    for (int e = 0; e < entries; ++e)
      for (int o = 0; o < entries; ++o) u(e) += moduli(q, packed(entries, std::min(e, o), std::max(e, o))) * f(o);
    const Entries h = finite ? Entries(scale * (u + p)) : u;
    const double b = f.dot(u) / 9 + (finite ? mean(q) / 3 : 0);
    const Mat<3> turn = matrix_of<D>(t);
    for (int e = 0; e < entries; ++e)
      for (int o = e; o < entries; ++o) {
        double& value = moduli(q, packed(entries, e, o));
        value = scale * scale * value - (h(e) * t(o) + t(e) * h(o)) / 3 + b * t(e) * t(o);
        const int ik = component<D>(e), jl = component<D>(o);
        if (finite) value -= excess(q) * turn(ik / 3, jl % 3) * turn(jl / 3, ik % 3);
      }
    coupling.row(q) = h / 3 - b * t;
    square(q) = b;
  }

  const std::size_t n = macro.functions.size();
  std::fill_n(arrays.force.data(), D * n, 0.0);
  if (tangent) std::fill_n(arrays.blocks.data(), D * (D + 1) / 2 * n * n, 0.0);
  Eigen::Index first = 0;
  for (std::size_t cell = 0; cell < macro.elements.size(); ++cell) {
    const GivenResponse given{&stress(first, 0), tangent ? &moduli(first, 0) : nullptr, stress.rows(), entries};
    add_cell(body, macro, cell, given, displacement, arrays, tangent);
    first += body.element(macro.elements[cell]).points;
  }
  if (!tangent) return std::nullopt;
  const MatrixX dilation = modes_of(body, macro, weights, state.directions);
  MatrixX other = modes_of(body, macro, weights, coupling);
  const MatrixX inner = macro.modes.transpose() * weights.cwiseProduct(square).asDiagonal() * macro.modes;
  other += 0.5 * dilation * inner;
  add_modes<D>(dilation, other, arrays.blocks.data());
  return std::nullopt;
}

template <int D>
double projected_energy(const Body<D>& body, int m, const double* displacement, std::span<const double> committed) {
  const MacroElement& macro = body.macro(m);
  Deformations<D> state = deformations(body, m, displacement);
  if (state.inversion) return std::numeric_limits<double>::infinity();
  const VectorX weights = weights_in(body, macro);
  project(body, macro, weights, state);
  const std::size_t variables = committed.empty() ? 0 : at(body.internal_variables());
  double sum = 0;
  Eigen::Index point = 0;
  for (int e : macro.elements)
    for (int q = 0; q < body.element(e).points; ++q, ++point)
      sum += weights(point) *
             body.material().energy(matrix_of<D>(state.f.row(point)),
                                    committed.subspan((body.element(e).point + at(q)) * variables, variables));
  return sum;
}

template <int D>
double projected_change(const Body<D>& body, int e, const VectorX& xi, const Mat<3>& f, const double* displacement) {
  const int m = body.macro_of(e);
  const MacroElement& macro = body.macro(m);
  const Deformations<D> state = deformations(body, m, displacement);
  if (state.inversion) return 0;
  const VectorX values = coefficients(macro, weights_in(body, macro), state.dilation);
  const double own = body.linear() ? f.trace() - 3 : std::log(f.determinant());
  return (body.modes_at(m, xi).dot(values) - own) / 3;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template Kernels projected_kernels<D>();                                                                             \
  template std::optional<Inversion> projected_force(const Body<D>&, int, const double*, ElementArrays<D>&, bool,       \
                                                    std::span<const double>, std::span<double>);                       \
  template double projected_energy(const Body<D>&, int, const double*, std::span<const double>);                       \
  template double projected_change(const Body<D>&, int, const VectorX&, const Mat<3>&, const double*);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::solid
