#include "contact/mortar/multiplier_rows.hpp"

#include <algorithm>
#include <utility>

namespace signorini::contact {

template <int D>
LocalRows<D> point_rows(const LocalGeometry<D>& geometry, const GapRows<D>& gap, const LocalShift<D>& shift,
                        double area, const LocalRow<D>& area_row, const FacePoint<D>* slip_point, bool frictional) {
  using Rows = PointRows<D>;
  using Force = LocalForce<D>;
  LocalRows<D> rows = LocalRows<D>::Zero();
  rows.row(Rows::gap) = area * gap.gap;
  rows.row(Rows::gap_area) = (geometry.gap - geometry.offset) * area_row;
  rows.row(Rows::area) = area_row;
  if (!frictional) return rows;
  rows.template middleRows<D>(Rows::normal) = area * gap.normal + geometry.normal * area_row;
  if (slip_point) {
    rows.template middleRows<D>(Rows::slip) = area * slip_rows(geometry, gap, shift);
    rows.template middleRows<D>(Rows::slip).noalias() += (geometry.master->position - slip_point->position) * area_row;
  }
  if constexpr (D == 3) {
    auto along = rows.template middleRows<D>(Rows::along);
    for (int a = 0; a < D - 1; ++a)
      along.template middleCols<D>(Force::slave_tangent_column + D * a).diagonal().setConstant(area * geometry.axis(a));
    along.noalias() += direction_of<D>(geometry.axis, geometry.slave_tangent) * area_row;
  }
  return rows;
}

template <int D>
MultiplierRows<D>::MultiplierRows(const Faces<D>& faces, const MultiplierFunctions<D>& functions)
    : faces_(faces), functions_(functions),
      base_(PointRows<D>::most * D * (faces.slave.most_functions() + 2 * faces.master.most_functions()) + 1) {}

template <int D> void MultiplierRows<D>::clear() {
  std::move(strips_.begin(), strips_.end(), std::back_inserter(spare_));
  strips_.clear();
}

template <int D> Strip& MultiplierRows<D>::find(int slave_element, int master_element, int slip_element, int count) {
  for (auto strip = strips_.rbegin(); strip != strips_.rend() && strip->slave_element == slave_element; ++strip)
    if (strip->master_element == master_element && strip->slip_element == slip_element) return *strip;
  const auto& [slave, master, accepted, travel] = faces_;
  Strip& strip = reuse(spare_, strips_);
  strip.slave_element = slave_element;
  strip.master_element = master_element;
  strip.slip_element = slip_element;
  strip.count = count;
  strip.nodes = slave.functions_on(slave_element) + master.functions_on(master_element);
  strip.columns = D * (strip.nodes + (slip_element >= 0 ? master.functions_on(slip_element) : 0));
  const int multipliers = std::ssize(functions_.on(slave_element));
  strip.rows.assign(multipliers * count * strip.columns, 0.0);
  strip.shares.assign(multipliers * strip.nodes, 0.0);
  return strip;
}

template <int D>
void MultiplierRows<D>::add(const ContactPoints<D>& points, std::size_t i, const FacePoint<D>& foot,
                            const FacePoint<D>* slip_point, const LocalRows<D>& local, int count, double area,
                            const std::vector<double>& weights) {
  const auto& [slave, master, accepted, travel] = faces_;
  const bool rigid = master.rigid(); // the same nodes for all elements
  const bool own_columns = slip_point && !rigid && slip_point->element != foot.element;
  Strip& strip = find(points.list[i].element, rigid ? 0 : foot.element, own_columns ? slip_point->element : -1, count);
  const double* r = points.functions(i);
  const int ns = slave.functions_on(strip.slave_element), nm = strip.nodes - ns;
  const ColumnNodes<D> nodes(r, ns, foot, nm, slip_point, strip.columns / D - strip.nodes);
  for (int k = 0; k < count; ++k) nodes.expand(local.row(k), 1, base_.data() + k * strip.columns);
  const Eigen::Map<const RowMajorX> base(base_.data(), count, strip.columns);
  const Eigen::Map<const VectorX> own(r, ns), opposite(foot.value.data(), nm);
  for (int a = 0; a < std::ssize(weights); ++a) {
    if (weights[a] == 0) continue;
    strip.rows_of(a) += weights[a] * base;
    strip.shares_of(a).head(ns) -= (area * weights[a]) * own;
    strip.shares_of(a).tail(nm) += (area * weights[a]) * opposite;
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template LocalRows<D> point_rows(const LocalGeometry<D>&, const GapRows<D>&, const LocalShift<D>&, double,           \
                                   const LocalRow<D>&, const FacePoint<D>*, bool);                                     \
  template class MultiplierRows<D>;
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
