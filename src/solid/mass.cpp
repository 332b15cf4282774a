#include "solid/mass.hpp"

namespace signorini::solid {

template <int D> MatrixX element_mass(const Body<D>& body, int e) {
  const nurbs::Discretization& space = body.space();
  const ElementTable& table = body.tables().element(e);
  const double* weights = body.tables().weights_of(e);
  const MatrixX places = element_quadrature(space, e).points; // in the order of the tables
  MatrixX mass = MatrixX::Zero(table.functions, table.functions);
  for (int q = 0; q < table.points; ++q) {
    const VectorX values = space.basis(e, places.col(q)).values;
    mass += body.density() * weights[q] * values * values.transpose();
  }
  return mass;
}

template MatrixX element_mass(const Body<2>&, int);
template MatrixX element_mass(const Body<3>&, int);

} // namespace signorini::solid
