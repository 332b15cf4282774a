#include "nurbs/element_grid.hpp"

namespace signorini::nurbs {

int ElementGrid::elements() const {
  int product = 1;
  for (int d = 0; d < parametric_dimension(); ++d) product *= elements(d);
  return product;
}

int ElementGrid::element_index(int e, int d) const {
  for (int k = 0; k < d; ++k) e /= elements(k);
  return e % elements(d);
}

int ElementGrid::element_behind(Side side, int f) const {
  int before = 1; // elements in the directions below the side's
  for (int d = 0; d < side.direction; ++d) before *= elements(d);
  const int layer = side.at_end ? elements(side.direction) - 1 : 0;
  return f % before + before * (layer + elements(side.direction) * (f / before));
}

VectorX ElementGrid::parameter(int e, const VectorX& fractions) const {
  VectorX xi(fractions.size());
  for (int d = 0; d < xi.size(); ++d) {
    const auto [from, to] = interval(e, d);
    xi(d) = from + (to - from) * fractions(d);
  }
  return xi;
}

int ElementGrid::find_element(const VectorX& xi) const {
  int e = 0;
  for (int d = parametric_dimension() - 1; d >= 0; --d) e = e * elements(d) + nurbs::find_element(breaks_[d], xi(d));
  return e;
}

} // namespace signorini::nurbs
