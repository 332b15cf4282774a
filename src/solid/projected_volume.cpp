#include "solid/projected_volume.hpp"

#include <cmath>

namespace signorini::solid {

namespace {

double dilation_of(bool linear, const Mat<3>& f) {
  return linear ? f.trace() - 3 : std::log(f.determinant());
}

} // namespace

template <int D>
std::optional<Inversion> write_deformations(const Body<D>& body, int m, const double* displacement,
                                            MacroArrays<D>& arrays) {
  const MacroElement& macro = body.macros().list[m];
  const Eigen::Index points = macro.modes.rows();
  constexpr auto lanes = static_cast<Eigen::Index>(vector_padding);
  arrays.f.resize((points + lanes - 1) / lanes * lanes, entries_in(D));
  arrays.directions.resize(points, entries_in(D));
  arrays.dilation.resize(points);
  arrays.local.resize(D * body.tables().most_functions());
  Eigen::Index point = 0;
  for (int e : macro.elements) {
    const int n = body.tables().element(e).functions, own = body.tables().element(e).points;
    gather(body, e, displacement, arrays.local.data());
    const Eigen::Map<const Eigen::Matrix<double, D, Eigen::Dynamic, Eigen::RowMajor>> u(arrays.local.data(), D, n);
    arrays.gradients = u.lazyProduct(Eigen::Map<const MatrixX>(body.tables().gradients_of(e), n, D * own));
    const double* hoops = body.tables().hoops_of(e);
    for (int q = 0; q < own; ++q, ++point) {
      // F = I + Σ_A u_A ⊗ ∇R_A, in a body of revolution r/R = 1 + Σ_A u_rA R_A/R
      const double across = 1 + (hoops ? u.row(0).dot(Eigen::Map<const Eigen::RowVectorXd>(hoops + q * n, n)) : 0);
      const Mat<3> f = in_space<D>(Mat<D>::Identity() + arrays.gradients.template block<D, D>(0, q * D), across);
      Mat<3> direction = Mat<3>::Identity();
      if (!body.small_strains()) {
        const double plane = f.template topLeftCorner<D, D>().determinant();
        for (double j : {plane, across})
          if (!(j > 0)) return Inversion{e, reference_point(body, e, q), j};
        direction = f.inverse().transpose();
      }
      arrays.dilation(point) = dilation_of(body.small_strains(), f);
      for (int k = 0; k < entries_in(D); ++k) {
        const int place = component<D>(k);
        arrays.f(point, k) = f(place / 3, place % 3);
        arrays.directions(point, k) = direction(place / 3, place % 3);
      }
    }
  }
  return std::nullopt;
}

template <int D>
void project(const MacroElement& macro, const VectorX& values, MacroArrays<D>& arrays, VectorX& projection) {
  arrays.weighted = macro.weights.cwiseProduct(values);
  arrays.coefficients.noalias() = macro.modes.transpose() * arrays.weighted;
  projection.noalias() = macro.modes * arrays.coefficients;
}

template <int D>
const VectorX& ProjectedVolume<D>::coefficients(const Body<D>& body, int m, const double* displacement) {
  const std::vector<int>& functions = body.macros().list[m].functions;
  displacement_.clear();
  for (int function : functions)
    displacement_.insert(displacement_.end(), displacement + D * function, displacement + D * (function + 1));
  kept_.resize(body.macro_elements());
  Kept& kept = kept_[m];
  if (kept.displacement == displacement_) return kept.coefficients;
  kept.displacement = displacement_;
  const bool inverted = write_deformations(body, m, displacement, arrays_).has_value();
  if (!inverted) project(body.macros().list[m], arrays_.dilation, arrays_, arrays_.change);
  kept.coefficients = inverted ? VectorX() : arrays_.coefficients;
  return kept.coefficients;
}

template <int D>
double ProjectedVolume<D>::change(const Body<D>& body, int e, const VectorX& xi, const Mat<3>& f,
                                  const double* displacement) {
  const int m = body.macros().containing(body.space(), e);
  const VectorX& values = coefficients(body, m, displacement);
  return values.size() == 0
             ? 0
             : (body.macros().list[m].modes_at(xi).dot(values) - dilation_of(body.small_strains(), f)) / 3;
}

template <int D>
double ProjectedVolume<D>::change_at(const Body<D>& body, int e, int q, const Mat<3>& f, const double* displacement) {
  const int m = body.macros().containing(body.space(), e);
  const MacroElement& macro = body.macros().list[m];
  const VectorX& values = coefficients(body, m, displacement);
  Eigen::Index point = q;
  for (std::size_t cell = 0; macro.elements[cell] != e; ++cell)
    point += body.tables().element(macro.elements[cell]).points;
  return values.size() == 0 ? 0 : (macro.modes.row(point).dot(values) - dilation_of(body.small_strains(), f)) / 3;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::optional<Inversion> write_deformations(const Body<D>&, int, const double*, MacroArrays<D>&);           \
  template void project(const MacroElement&, const VectorX&, MacroArrays<D>&, VectorX&);                               \
  template class ProjectedVolume<D>;
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::solid
