#include "solid/projected.hpp"

#include "solid/predicted_volume.hpp"
#include "solid/projected_volume.hpp"
#include "solid/strain_rows.hpp"
#include "solid/volume_change.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::solid {

// With the mean Kirchhoff stress τ = P̄:F̄/3 and its projection π = Pτ (P is self-adjoint) the first variation of
// ∫ W(F̄) dV is ∫ P*:δF dV, and with M, v and b of change_volume() the second one is
//   ∫ δF:M:∂F + δF:v P∂θ + ∂F:v Pδθ + b Pδθ P∂θ dV.
// Newton's tangent replaces π by π + b PΔ, with Δ what was predicted for θ less θ [theory 2.10].

namespace {

/// Replaces F by F̄; writes c and eᶜ.
template <int D> void project_deformations(bool linear, const MacroElement& macro, MacroArrays<D>& at) {
  const Eigen::Index points = at.dilation.size();
  project(macro, at.dilation, at, at.change);
  at.change = (at.change - at.dilation) / 3;
  at.scale = at.change.array().exp();
  for (int k = 0; k < entries_in(D); ++k) {
    auto f = at.f.col(k);
    if (!linear)
      f.head(points).array() *= at.scale.array();
    else if (component<D>(k) % 4 == 0)
      f.head(points) += at.change;
    f.tail(f.size() - points).setConstant(f(points - 1));
  }
}

/// Writes PΔ.
template <int D>
void project_prediction(const Body<D>& body, const MacroElement& macro, const double* displacement,
                        const double* before, ElementArrays<D>& arrays) {
  VectorX& predicted = arrays.macro.predicted;
  predicted.resize(arrays.macro.dilation.size());
  double* of_element = predicted.data();
  for (int e : macro.elements) {
    write_predicted(body, e, displacement, before, arrays.moves, of_element);
    of_element += body.tables().element(e).points;
  }
  project(macro, predicted, arrays.macro, predicted);
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

/// Stress and moduli of the material at all points, with their internal variables in a row.
template <int D>
void respond(const Body<D>& body, const MacroElement& macro, PointBlock block, const Memory& memory,
             MacroArrays<D>& arrays) {
  const std::size_t variables = body.internal_variables();
  const auto each_element = [&](const auto& visit) {
    auto own = arrays.internal.begin();
    for (int e : macro.elements) {
      const ElementTable& table = body.tables().element(e);
      visit(table.point * variables, static_cast<std::ptrdiff_t>(table.points * variables), own);
      own += static_cast<std::ptrdiff_t>(table.points * variables);
    }
  };
  if (variables) {
    const std::size_t count = block.points * variables;
    arrays.internal.resize(2 * count); // trial values, then committed ones
    each_element([&](std::size_t first, auto own, auto to) { std::copy_n(&memory.committed[first], own, to); });
    double* const trial = arrays.internal.data();
    std::copy_n(trial, count, trial + count);
    block.memory = {trial + count, trial, static_cast<int>(variables), memory.duration};
  }
  body.material().template respond<D>()(body.material().law(), block);
  if (variables)
    each_element([&](std::size_t first, auto count, auto from) { std::copy_n(from, count, &memory.trial[first]); });
}

/// τ at the points.
template <int D> void write_mean_stress(bool linear, MacroArrays<D>& at) {
  const Eigen::Index points = at.dilation.size();
  at.mean.setZero(points);
  for (int k = 0; k < entries_in(D); ++k) {
    if (!linear)
      at.mean += at.stress.col(k).head(points).cwiseProduct(at.f.col(k).head(points)) / 3;
    else if (component<D>(k) % 4 == 0)
      at.mean += at.stress.col(k).head(points) / 3;
  }
}

/// Turns P̄ and A into P* and M; writes v and b.
template <int D> void write_projected_response(bool linear, bool tangent, MacroArrays<D>& at) {
  constexpr int entries = entries_in(D);
  const Eigen::Index points = at.dilation.size();
  if (tangent) {
    at.coupling.resize(points, entries);
    at.square.resize(points);
  }
  for (Eigen::Index q = 0; q < points; ++q) {
    Entries<D> p = at.stress.row(q);
    const Entries<D> t = at.directions.row(q), f = linear ? t : Entries<D>(at.f.row(q));
    const VolumeChange<D> change{
        linear, linear ? 1 : at.scale(q), at.mean(q), at.excess(q), f, t, at.predicted.size() ? at.predicted(q) : 0};
    const auto [coupling, square] =
        change_volume(change, p, tangent ? &at.moduli(q, 0) : nullptr, static_cast<int>(at.moduli.rows()));
    at.stress.row(q) = p;
    if (!tangent) continue;
    at.coupling.row(q) = coupling;
    at.square(q) = square;
  }
}

/// Up to this number plain loops are faster than Eigen's products of matrices.
constexpr Eigen::Index few_modes = 4;

/// Σ_q w φ_m `values`:∂F/∂u: one column per mode, D rows of values for each of the macro-element's functions.
template <int D>
void write_modes(const Body<D>& body, const MacroElement& macro, const typename MacroArrays<D>::Rows& values,
                 MacroArrays<D>& arrays, MatrixX& sum) {
  const Eigen::Index n = std::ssize(macro.functions), modes = macro.modes.cols();
  sum.setZero(D * n, modes);
  Eigen::Index point = 0;
  for (std::size_t cell = 0; cell < macro.elements.size(); ++cell) {
    const int e = macro.elements[cell], points = body.tables().element(e).points,
              functions = body.tables().element(e).functions;
    arrays.strains.setZero(D * functions, points);
    for (int q = 0; q < points; ++q) {
      const double* hoops = body.tables().hoops_of(e);
      const StrainRows<D> rows{functions, body.tables().gradients_of(e) + q * D * functions,
                               hoops ? hoops + q * functions : nullptr};
      for (int i = 0; i < D; ++i) {
        double* strains = &arrays.strains(i * functions, q);
        for (int r = 0; r < rows.count(i); ++r) {
          const double factor = macro.weights(point + q) * values(point + q, entry_of<D>(i, r));
          const double* row = rows.row(r);
          for (int a = 0; a < functions; ++a) strains[a] += factor * row[a];
        }
      }
    }
    const auto own_modes = macro.modes.middleRows(point, points);
    if (modes > few_modes)
      arrays.sums.noalias() = arrays.strains * own_modes;
    else
      arrays.sums = arrays.strains.lazyProduct(own_modes);
    for (Eigen::Index mode = 0; mode < modes; ++mode)
      for (int i = 0; i < D; ++i)
        for (int a = 0; a < functions; ++a)
          sum(i * n + macro.places[cell][a], mode) += arrays.sums(i * functions + a, mode);
    point += points;
  }
}

/// K^{ij} += B_i Ãᵀ_j + Ã_i Bᵀ_j for i ≤ j.
template <int D> void add_modes(const MatrixX& b, const MatrixX& a, double* blocks) {
  const Eigen::Index n = b.rows() / D, modes = b.cols();
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j, blocks += n * n) {
      if (modes > few_modes) {
        Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> block(blocks, n, n);
        block.noalias() += b.middleRows(i * n, n) * a.middleRows(j * n, n).transpose();
        block.noalias() += a.middleRows(i * n, n) * b.middleRows(j * n, n).transpose();
        continue;
      }
      for (Eigen::Index row = 0; row < n; ++row)
        for (Eigen::Index m = 0; m < modes; ++m) {
          const double of_b = b(i * n + row, m), of_a = a(i * n + row, m);
          const double *columns_b = &b(j * n, m), *columns_a = &a(j * n, m);
          double* block = blocks + row * n;
          for (Eigen::Index column = 0; column < n; ++column)
            block[column] += of_b * columns_a[column] + of_a * columns_b[column];
        }
    }
}

/// Runs an element's kernel with its stress and moduli and adds the results to those of the macro-element.
template <int D>
void add_cell(const Body<D>& body, const MacroElement& macro, std::size_t cell, const GivenResponse& given,
              ElementArrays<D>& arrays, bool tangent) {
  const int e = macro.elements[cell];
  const std::size_t own = body.tables().element(e).functions, n = macro.functions.size();
  MacroArrays<D>& of_element = arrays.macro;
  std::fill_n(arrays.local.data(), D * own, 0.0); // displacements: given stress and moduli depend on them already
  KernelArguments arguments =
      arrays.arguments(body, e, of_element.force.data(), tangent ? of_element.blocks.data() : nullptr);
  arguments.law = &given;
  body.tables().element(e).kernels.element(arguments);
  const std::vector<int>& places = macro.places[cell];
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t a = 0; a < own; ++a) arrays.force[i * n + places[a]] += of_element.force[i * own + a];
  if (!tangent) return;
  const double* from = of_element.blocks.data();
  double* block = arrays.blocks.data();
  for (int pair = 0; pair < D * (D + 1) / 2; ++pair, block += n * n)
    for (std::size_t a = 0; a < own; ++a)
      for (std::size_t b = 0; b < own; ++b) block[places[a] * n + places[b]] += *from++;
}

} // namespace

template <int D> Kernels projected_kernels() {
  return {moduli_kernels<D>().back(), nullptr, 0, respond_as_given};
}

template <int D>
std::optional<Inversion> projected_force(const Body<D>& body, int m, const double* displacement,
                                         ElementArrays<D>& arrays, bool tangent, const Memory& memory,
                                         const double* before) {
  constexpr int entries = entries_in(D);
  const MacroElement& macro = body.macros().list[m];
  MacroArrays<D>& state = arrays.macro;
  if (const auto inversion = write_deformations(body, m, displacement, state)) return inversion;
  project_deformations(body.small_strains(), macro, state);
  if (before)
    project_prediction(body, macro, displacement, before, arrays);
  else
    state.predicted.resize(0);

  state.stress.resize(state.f.rows(), entries);
  if (tangent) state.moduli.resize(state.f.rows(), packed_size(entries));
  const PointBlock block{static_cast<int>(state.dilation.size()), static_cast<int>(state.f.rows()), state.f.data(),
                         state.stress.data(), tangent ? state.moduli.data() : nullptr};
  respond(body, macro, block, memory, state);

  write_mean_stress(body.small_strains(), state);
  project(macro, state.mean, state, state.excess);
  state.excess -= state.mean;
  write_projected_response(body.small_strains(), tangent, state);

  const std::size_t n = macro.functions.size();
  std::fill_n(arrays.force.data(), D * n, 0.0);
  if (tangent) std::fill_n(arrays.blocks.data(), D * (D + 1) / 2 * n * n, 0.0);
  Eigen::Index first = 0;
  for (std::size_t cell = 0; cell < macro.elements.size(); ++cell) {
    const GivenResponse given{&state.stress(first, 0), tangent ? &state.moduli(first, 0) : nullptr, state.stress.rows(),
                              entries};
    add_cell(body, macro, cell, given, arrays, tangent);
    first += body.tables().element(macro.elements[cell]).points;
  }
  if (!tangent) return std::nullopt;
  write_modes(body, macro, state.directions, state, state.direction_modes);
  write_modes(body, macro, state.coupling, state, state.modes);
  state.weighted = macro.weights.cwiseProduct(state.square);
  state.inner.noalias() = macro.modes.transpose() * state.weighted.asDiagonal() * macro.modes;
  state.modes.noalias() += 0.5 * state.direction_modes * state.inner;
  add_modes<D>(state.direction_modes, state.modes, arrays.blocks.data());
  return std::nullopt;
}

template <int D> bool visit_projected(const Body<D>& body, int m, const double* displacement, const VisitPoint& visit) {
  const MacroElement& macro = body.macros().list[m];
  MacroArrays<D> state;
  if (write_deformations(body, m, displacement, state)) return false;
  project_deformations(body.small_strains(), macro, state);
  const PointBlock block{static_cast<int>(state.dilation.size()), static_cast<int>(state.f.rows()), state.f.data(),
                         nullptr, nullptr};
  int point = 0;
  for (int e : macro.elements)
    for (int q = 0; q < body.tables().element(e).points; ++q, ++point)
      visit(body.tables().element(e).point + q, macro.weights(point), deformation_at<D>(block, point));
  return true;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template Kernels projected_kernels<D>();                                                                             \
  template std::optional<Inversion> projected_force(const Body<D>&, int, const double*, ElementArrays<D>&, bool,       \
                                                    const Memory&, const double*);                                     \
  template bool visit_projected(const Body<D>&, int, const double*, const VisitPoint&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::solid
