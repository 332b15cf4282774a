#include "model/warnings/stiff_bending.hpp"

#include "model/checks/constants.hpp"
#include "nurbs/basis_grid.hpp"

#include <array>

namespace signorini::model {

namespace {

/// Small-strain constants in the directions of a body's kind.
struct ElasticModuli {
  double shear, lame;
};

template <int D> ElasticModuli moduli_of(const solid::Body<D>& body) {
  const auto [youngs_modulus, nu] =
      std::pair(body.material().constants().youngs_modulus, body.material().constants().poissons_ratio);
  const double shear = youngs_modulus / (2 * (1 + nu)), lame = 2 * shear * nu / (1 - 2 * nu);
  // Under plane stress σ_zz = 0; a projected volume change does not vary within an element.
  if (body.kind() == solid::Kind::plane_stress) return {shear, 2 * shear * lame / (lame + 2 * shear)};
  return {shear, body.volumetric() == solid::Volumetric::projected ? 0 : lame};
}

/// A point of an element: its volume, strain energy, and tractions on the planes ξ_d = const, with their normals.
template <int D> struct BentPoint {
  double volume, energy;
  std::array<Vec<D>, D> normal, traction;
};

/// Σ_A c_A ⊗ ∂R_A/∂ξ.
template <int D> Mat<D> derivatives(const MatrixX& values, const nurbs::ElementBasis& basis) {
  Mat<D> sum = Mat<D>::Zero();
  for (Eigen::Index a = 0; a < basis.values.size(); ++a)
    sum += values.block<D, 1>(0, basis.functions[a]) * basis.gradients.block<D, 1>(0, a).transpose();
  return sum;
}

/// `volume`: of the point; with the circumference in a body of revolution.
template <int D>
BentPoint<D> bent_point(const solid::Body<D>& body, const nurbs::ElementBasis& basis, double volume,
                        const MatrixX& points, const MatrixX& displacements, const ElasticModuli& moduli) {
  const Mat<D> inverse = derivatives<D>(points, basis).inverse();
  const Mat<D> gradient = derivatives<D>(displacements, basis) * inverse;
  Mat<D> strain = (gradient + gradient.transpose()) / 2;
  if (!body.small_strains()) strain += gradient.transpose() * gradient / 2;
  double hoop = 0;
  BentPoint<D> point{volume, 0, {}, {}};
  if (body.kind() == solid::Kind::axisymmetric) {
    hoop = basis.combine(displacements)(0) / basis.combine(points)(0);
    if (!body.small_strains()) hoop += hoop * hoop / 2;
  }
  const double trace = strain.trace() + hoop;
  const Mat<D> stress = moduli.lame * trace * Mat<D>::Identity() + 2 * moduli.shear * strain;
  point.energy = moduli.lame * trace * trace / 2 + moduli.shear * (strain.squaredNorm() + hoop * hoop);
  for (int d = 0; d < D; ++d) {
    point.normal[d] = inverse.row(d).normalized();
    point.traction[d] = stress * point.normal[d];
  }
  return point;
}

} // namespace

template <int D> double locked_part(const solid::Body<D>& body, const MatrixX& displacements) {
  const nurbs::Discretization& space = body.space();
  const MatrixX points = space.points();
  const ElasticModuli moduli = moduli_of(body);
  double locked = 0, energy = 0, volume = 0;
  std::vector<BentPoint<D>> bent;
  nurbs::BasisGrid grid(space);
  nurbs::ElementBasis basis;
  std::vector<std::vector<double>> places(D);
  for (int e = 0; e < space.elements(); ++e) {
    // Two points along directions of degree 1, where strains vary linearly
    for (int d = 0; d < D; ++d) {
      const auto [from, to] = space.interval(e, d);
      places[d] = solid::gauss_legendre(space.degree(e, d) + 1, from, to).points;
    }
    grid.choose(e, places);
    bent.clear();
    for (int q = 0; q < body.tables().element(e).points; ++q) {
      std::array<int, 3> index{};
      for (int d = 0, rest = q; d < D; rest /= static_cast<int>(places[d++].size()))
        index[d] = rest % static_cast<int>(places[d].size());
      grid.evaluate(index, basis);
      bent.push_back(bent_point(body, basis, body.tables().weights_of(e)[q], points, displacements, moduli));
      energy += bent.back().volume * bent.back().energy;
      volume += bent.back().volume;
    }
    std::size_t stride = 1;
    for (int d = 0; d < D; ++d) {
      const int count = space.degree(e, d) + 1;
      for (std::size_t q = 0; count == 2 && q < bent.size(); ++q) {
        if (q / stride % 2 != 0) continue;
        const BentPoint<D>&a = bent[q], &b = bent[q + stride];
        const Vec<D> varies = (b.traction[d] - a.traction[d]) / 2;
        const double across = varies.dot((a.normal[d] + b.normal[d]).normalized());
        locked += (a.volume + b.volume) *
                  (across * across / (moduli.lame + 2 * moduli.shear) +
                   (varies.squaredNorm() - across * across) / moduli.shear) /
                  2;
      }
      stride *= count;
    }
  }
  return energy > unstrained * unstrained * moduli.shear * volume ? locked / energy : 0;
}

template <int D> void warn_of_stiff_bending(const Model<D>& model, std::vector<Message>& warnings) {
  const System<D>& system = model.system;
  for (std::size_t b = 0; b < system.scene.bodies.size(); ++b) {
    const NamedBody<D>& named = system.scene.bodies[b];
    const nurbs::Discretization& space = named.body->space();
    bool linear = false;
    for (int e = 0; e < space.elements() && !linear; ++e)
      for (int d = 0; d < D; ++d) linear = linear || space.degree(e, d) == 1;
    if (!linear) continue;
    const MatrixX displacements = system.unknowns.of_body(static_cast<int>(b), model.accepted.displacement);
    if (const double part = locked_part(*named.body, displacements); part > most_locked)
      warnings.push_back(Message("model.warning.stiff_bending", {{"body", named.name}, {"percent", 100 * part}}));
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template double locked_part(const solid::Body<D>&, const MatrixX&);                                                  \
  template void warn_of_stiff_bending(const Model<D>&, std::vector<Message>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
