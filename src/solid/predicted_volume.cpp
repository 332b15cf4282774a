#include "solid/predicted_volume.hpp"

#include <cmath>

namespace signorini::solid {

namespace {

/// Below this Poisson's ratio contact needs about as many iterations without the prediction, which takes a quarter of
/// the time of an element.
constexpr double nearly_incompressible = 0.4;

} // namespace

template <int D> bool predicts_volume(const Body<D>& body) {
  return !body.small_strains() && body.kind() != Kind::plane_stress &&
         body.material().constants().poissons_ratio > nearly_incompressible;
}

template <int D>
void write_predicted(const Body<D>& body, int e, const double* displacement, const double* before,
                     std::vector<double>& moves, double* predicted) {
  const auto functions = body.tables().functions_of(e);
  const int n = std::ssize(functions);
  // Per function D values of `before` and D of the correction, so that both sums below are one of vectors.
  Eigen::Map<Eigen::Matrix<double, 2 * D, Eigen::Dynamic>> both(moves.data(), 2 * D, n);
  for (int a = 0; a < n; ++a) {
    const Eigen::Map<const Vec<D>> u(displacement + D * functions[a]), u0(before + D * functions[a]);
    both.col(a) << u0, u - u0;
  }
  const double *gradients = body.tables().gradients_of(e), *hoop = body.tables().hoops_of(e);
  for (int q = 0; q < body.tables().element(e).points; ++q, gradients += D * n) {
    Eigen::Matrix<double, 2 * D, D> sums = Eigen::Matrix<double, 2 * D, D>::Zero();
    for (int k = 0; k < D; ++k)
      for (int a = 0; a < n; ++a) sums.col(k) += gradients[k * n + a] * both.col(a);
    const Mat<D> f0 = Mat<D>::Identity() + sums.template topRows<D>();
    const Mat<D> g = f0.inverse() * sums.template bottomRows<D>();
    double trace = g.trace(), growth = Mat<D>(Mat<D>::Identity() + g).determinant();
    if (hoop) {
      double stretch = 1, change = 0;
      for (int a = 0; a < n; ++a, ++hoop) {
        stretch += *hoop * both(0, a);
        change += *hoop * both(D, a);
      }
      trace += change / stretch;
      growth *= 1 + change / stretch;
    }
    predicted[q] = trace - std::log(growth);
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template bool predicts_volume(const Body<D>&);                                                                       \
  template void write_predicted(const Body<D>&, int, const double*, const double*, std::vector<double>&, double*);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::solid
