#include "solid/internal.hpp"

#include <limits>

namespace signorini::solid {

namespace {

template <int D> void gather(const Body<D>& body, int e, const double* displacement, double* local) {
  const auto functions = body.functions_of(e);
  const std::size_t n = functions.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t i = 0; i < D; ++i) local[i * n + a] = displacement[D * functions[a] + static_cast<int>(i)];
}

/// Calls visit(e, q, F, u) at all Gauss points, u the displacements of the element's functions.
template <int D, class Visit>
void each_deformation(const Body<D>& body, const double* displacement, const Visit& visit) {
  std::vector<double> local(static_cast<std::size_t>(D * body.most_functions()));
  for (int e = 0; e < body.elements(); ++e) {
    const ElementTable& table = body.element(e);
    const int n = table.functions;
    gather(body, e, displacement, local.data());
    const Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic, Eigen::RowMajor>> u(local.data(), D, n);
    for (int q = 0; q < table.points; ++q) {
      // F = I + Σ_A u_A ⊗ ∇R_A
      const Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic, Eigen::RowMajor>> gradients(
          body.gradients_of(e) + q * D * n, D, n);
      visit(e, q, Mat<D>(Mat<D>::Identity() + u.lazyProduct(gradients.transpose())), u);
    }
  }
}

} // namespace

template <int D> ElementArrays<D>::ElementArrays(const Body<D>& body) {
  const std::size_t n = static_cast<std::size_t>(body.most_functions());
  const std::size_t points = static_cast<std::size_t>(body.most_points());
  force.resize(D * n);
  blocks.resize(D * (D + 1) / 2 * n * n + vector_room);
  local.resize(D * n);
  work.resize(working_size(D, n, points));
  factors.resize(2 * points);
}

template <int D> std::size_t ElementArrays<D>::memory() const {
  return sizeof(double) * (force.size() + blocks.size() + local.size() + work.size() + factors.size());
}

template <int D>
std::optional<Inversion> internal_force(const Body<D>& body, int e, const double* displacement,
                                        ElementArrays<D>& arrays, bool tangent) {
  const ElementTable& table = body.element(e);
  const ElasticConstants& law = constants(body.material());
  gather(body, e, displacement, arrays.local.data());
  const KernelResult result =
      table.kernel({table.functions, table.points, law.lambda, law.mu, arrays.local.data(), body.gradients_of(e),
                    body.weights_of(e), body.hoops_of(e), body.constant_of(e), arrays.force.data(), arrays.work.data(),
                    arrays.factors.data(), tangent ? arrays.blocks.data() : nullptr});
  if (result.point < 0) return std::nullopt;
  return Inversion{e, body.reference_point(e, result.point), result.jacobian};
}

template <int D> std::optional<Inversion> worst_inversion(const Body<D>& body, const double* displacement) {
  std::optional<Inversion> worst;
  each_deformation(body, displacement, [&](int e, int q, const Mat<D>& f, const auto&) {
    const double jacobian = f.determinant();
    if (jacobian <= 0 && (!worst || jacobian < worst->jacobian))
      worst = Inversion{e, body.reference_point(e, q), jacobian};
  });
  return worst;
}

template <int D> double stored_energy(const Body<D>& body, const double* displacement) {
  double sum = 0;
  each_deformation(body, displacement, [&](int e, int q, const Mat<D>& f, const auto& u) {
    const auto density = [&]() -> double {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      if (!body.linear() && !(f.determinant() > 0)) return infinity;
      if (body.kind() != Kind::axisymmetric) return energy<D>(body.material(), f);
      // r/R = 1 + Σ_A u_rA R_A/R
      const Eigen::Index n = u.cols();
      const double stretch = 1 + u.row(0).dot(Eigen::Map<const Eigen::RowVectorXd>(body.hoops_of(e) + q * n, n));
      if (!body.linear() && !(stretch > 0)) return infinity;
      return energy<3>(body.material(), in_space(f.template topLeftCorner<2, 2>(), stretch));
    };
    sum += body.weights_of(e)[q] * density();
  });
  return sum;
}

template struct ElementArrays<2>;
template struct ElementArrays<3>;
template std::optional<Inversion> internal_force<2>(const Body<2>&, int, const double*, ElementArrays<2>&, bool);
template std::optional<Inversion> internal_force<3>(const Body<3>&, int, const double*, ElementArrays<3>&, bool);
template std::optional<Inversion> worst_inversion<2>(const Body<2>&, const double*);
template std::optional<Inversion> worst_inversion<3>(const Body<3>&, const double*);
template double stored_energy<2>(const Body<2>&, const double*);
template double stored_energy<3>(const Body<3>&, const double*);

} // namespace signorini::solid
