#include "solid/internal.hpp"

#include "base/error.hpp"
#include "solid/predicted_volume.hpp"
#include "solid/projected.hpp"

#include <limits>

namespace signorini::solid {

namespace {

/// Calls visit(e, q, F, u) at all Gauss points, with the displacements u of the element's functions.
template <int D, class Visit>
void each_deformation(const Body<D>& body, const double* displacement, const Visit& visit) {
  std::vector<double> local(D * body.tables().most_functions());
  for (int e = 0; e < body.elements(); ++e) {
    const ElementTable& table = body.tables().element(e);
    const int n = table.functions;
    gather(body, e, displacement, local.data());
    const Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic, Eigen::RowMajor>> u(local.data(), D, n);
    for (int q = 0; q < table.points; ++q) {
      // F = I + Σ_A u_A ⊗ ∇R_A
      const Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic, Eigen::RowMajor>> gradients(
          body.tables().gradients_of(e) + q * D * n, D, n);
      visit(e, q, Mat<D>(Mat<D>::Identity() + u.lazyProduct(gradients.transpose())), u);
    }
  }
}

/// r/R = 1 + Σ_A u_rA R_A/R at a Gauss point of an axisymmetric body, otherwise 1.
template <int D, class Displacements> double hoop_stretch(const Body<D>& body, int e, int q, const Displacements& u) {
  if (body.kind() != Kind::axisymmetric) return 1;
  const Eigen::Index n = u.cols();
  return 1 + u.row(0).dot(Eigen::Map<const Eigen::RowVectorXd>(body.tables().hoops_of(e) + q * n, n));
}

} // namespace

template <int D> void gather(const Body<D>& body, int e, const double* displacement, double* local) {
  const auto functions = body.tables().functions_of(e);
  const std::size_t n = functions.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t i = 0; i < D; ++i) local[i * n + a] = displacement[D * functions[a] + static_cast<int>(i)];
}

template <int D> ElementArrays<D>::ElementArrays(const Body<D>& body) {
  const bool projected = body.volumetric() == Volumetric::projected;
  const std::size_t n = body.tables().most_functions(), points = body.tables().most_points();
  const std::size_t all = projected ? body.macros().most_functions() : body.tables().most_functions();
  force.resize(D * all);
  blocks.resize(D * (D + 1) / 2 * all * all + vector_padding);
  if (projected) {
    macro.force.resize(D * n);
    macro.blocks.resize(D * (D + 1) / 2 * n * n + vector_padding);
  }
  local.resize(D * n);
  moves.resize(2 * D * n);
  predicted.resize(points);
  const bool moduli = body.elements() > 0 && body.tables().element(0).kernels.respond;
  work.resize(moduli ? moduli_working_size(D, n, points) : working_size(D, n, points));
  factors.resize(2 * points);
}

template <int D> std::size_t ElementArrays<D>::memory() const {
  return sizeof(double) * (force.size() + blocks.size() + local.size() + moves.size() + predicted.size() + work.size() +
                           factors.size()) +
         macro.memory();
}

template <int D>
KernelArguments ElementArrays<D>::arguments(const Body<D>& body, int e, double* to_force, double* to_blocks) {
  KernelArguments arguments = body.tables().arguments(e, body.material());
  arguments.local = local.data();
  arguments.force = to_force;
  arguments.work = work.data();
  arguments.factors = factors.data();
  arguments.blocks = to_blocks;
  return arguments;
}

template <int D> std::vector<double> initial_values(const Body<D>& body) {
  const std::vector<double>& point = body.material().initial_values(D);
  std::vector<double> values;
  values.reserve(body.tables().points() * point.size());
  for (std::size_t q = 0; q < body.tables().points(); ++q) values.insert(values.end(), point.begin(), point.end());
  return values;
}

template <int D>
std::vector<double> values_at(const Body<D>& body, int e, const VectorX& xi, std::span<const double> values) {
  const std::size_t variables = body.internal_variables(), first = body.tables().element(e).point * variables;
  if (variables == 0) return {};
  std::vector<double> all(&values[first], &values[first] + body.tables().element(e).points * variables);
  // One direction after the other, the first one fastest: Σ_i L_i(ξ) of the rows of points.
  for (int d = 0; d < D; ++d) {
    const auto [from, to] = body.space().interval(e, d);
    const std::vector<double> points = gauss_legendre(body.space().degree(e, d) + 1, from, to).points;
    const std::size_t count = points.size(), rows = all.size() / (count * variables);
    std::vector<double> sums(rows * variables, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
      double factor = 1;
      for (std::size_t k = 0; k < count; ++k)
        if (k != i) factor *= (xi(d) - points[k]) / (points[i] - points[k]);
      for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t v = 0; v < variables; ++v)
          sums[row * variables + v] += factor * all[(row * count + i) * variables + v];
    }
    all = std::move(sums);
  }
  return all;
}

template <int D> PointMemory element_memory(const Body<D>& body, int e, const Memory& memory) {
  if (memory.committed.empty()) return {};
  const int variables = body.internal_variables();
  const std::size_t first = body.tables().element(e).point * variables;
  return {memory.committed.data() + first, memory.trial.empty() ? nullptr : memory.trial.data() + first, variables,
          memory.duration};
}

template <int D>
std::optional<Inversion> internal_force(const Body<D>& body, int m, const double* displacement,
                                        ElementArrays<D>& arrays, bool tangent, const Memory& memory,
                                        const double* before) {
  const std::size_t values = body.internal_variables() * body.tables().points();
  require(memory.committed.size() == values && memory.trial.size() == values, "solid.body.internal_variables",
          {{"material", body.material().name()},
           {"expected", values},
           {"committed", memory.committed.size()},
           {"trial", memory.trial.size()}});
  if (!tangent || !predicts_volume(body)) before = nullptr;
  if (body.volumetric() == Volumetric::projected)
    return projected_force(body, m, displacement, arrays, tangent, memory, before);
  gather(body, m, displacement, arrays.local.data());
  KernelArguments arguments = arrays.arguments(body, m, arrays.force.data(), tangent ? arrays.blocks.data() : nullptr);
  if (before) {
    write_predicted(body, m, displacement, before, arrays.moves, arrays.predicted.data());
    arguments.predicted = arrays.predicted.data();
  }
  arguments.memory = element_memory(body, m, memory);
  const KernelResult result = body.tables().element(m).kernels.element(arguments);
  if (result.point < 0) return std::nullopt;
  return Inversion{m, reference_point(body, m, result.point), result.jacobian};
}

template <int D> std::vector<MeanDeformation<D>> mean_deformations(const Body<D>& body, const double* displacement) {
  std::vector<MeanDeformation<D>> means(body.elements());
  std::vector<double> volumes(means.size(), 0.0);
  each_deformation(body, displacement, [&](int e, int q, const Mat<D>& f, const auto& u) {
    const double weight = body.tables().weights_of(e)[q];
    means[e].gradient += weight * f;
    means[e].hoop += weight * hoop_stretch(body, e, q, u);
    volumes[e] += weight;
  });
  for (std::size_t e = 0; e < means.size(); ++e) {
    means[e].gradient /= volumes[e];
    means[e].hoop /= volumes[e];
  }
  return means;
}

namespace {

/// Σ_e ½ u·f_e of a body whose forces are linear in displacements.
template <int D> double quadratic_energy(const Body<D>& body, const double* displacement) {
  ElementArrays<D> arrays(body);
  double sum = 0;
  for (int e = 0; e < body.elements(); ++e) {
    internal_force(body, e, displacement, arrays, false);
    const auto size = static_cast<Eigen::Index>(D * body.tables().functions_of(e).size());
    sum +=
        Eigen::Map<const VectorX>(arrays.local.data(), size).dot(Eigen::Map<const VectorX>(arrays.force.data(), size));
  }
  return 0.5 * sum;
}

} // namespace

template <int D>
bool visit_points(const Body<D>& body, const double* displacement, const Memory& memory, const VisitPoint& visit) {
  if (body.volumetric() == Volumetric::projected) {
    for (int m = 0; m < body.macro_elements(); ++m)
      if (!visit_projected(body, m, displacement, visit)) return false;
    return true;
  }
  const std::size_t variables = memory.committed.empty() ? 0 : body.internal_variables();
  bool inverted = false;
  each_deformation(body, displacement, [&](int e, int q, const Mat<D>& f, const auto& u) {
    if (inverted) return;
    const std::size_t point = body.tables().element(e).point + q;
    double across = hoop_stretch(body, e, q, u);
    if constexpr (D == 2)
      if (body.kind() == Kind::plane_stress)
        across = body.material().thickness_stretch(
            f, {memory.committed.subspan(point * variables, variables), {}, memory.duration});
    inverted = !body.small_strains() && !(f.determinant() > 0 && across > 0);
    if (!inverted) visit(point, body.tables().weights_of(e)[q], in_space<D>(f, across));
  });
  return !inverted;
}

template <int D> Account account(const Body<D>& body, const double* displacement, std::span<const double> values) {
  if (body.linear() && body.volumetric() == Volumetric::pointwise) return {quadratic_energy(body, displacement), 0};
  const std::size_t variables = values.empty() ? 0 : body.internal_variables();
  Account sum;
  const auto add = [&](std::size_t point, double weight, const Mat<3>& f) {
    const Account own = body.material().account(f, values.subspan(point * variables, variables));
    sum.stored += weight * own.stored;
    sum.viscous += weight * own.viscous;
  };
  if (!visit_points(body, displacement, {values, {}, 0}, add)) sum.stored = std::numeric_limits<double>::infinity();
  return sum;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template struct ElementArrays<D>;                                                                                    \
  template void gather(const Body<D>&, int, const double*, double*);                                                   \
  template std::vector<double> initial_values(const Body<D>&);                                                         \
  template std::optional<Inversion> internal_force(const Body<D>&, int, const double*, ElementArrays<D>&, bool,        \
                                                   const Memory&, const double*);                                      \
  template std::vector<double> values_at(const Body<D>&, int, const VectorX&, std::span<const double>);                \
  template PointMemory element_memory(const Body<D>&, int, const Memory&);                                             \
  template std::vector<MeanDeformation<D>> mean_deformations(const Body<D>&, const double*);                           \
  template bool visit_points(const Body<D>&, const double*, const Memory&, const VisitPoint&);                         \
  template Account account(const Body<D>&, const double*, std::span<const double>);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::solid
