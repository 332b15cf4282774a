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
    // v = x̄ᵐ − xᵐ(ξ̄ of the accepted state),  δv = δx̄ᵐ + τ_α δξ̄^α − δxᵐ
    LocalBlock<D> slip = LocalBlock<D>::Zero();
    slip.template middleCols<D>(Force::master_column).setIdentity();
    slip.template middleCols<D>(Force::slip_column).diagonal().setConstant(-1);
    for (int a = 0; a < D - 1; ++a) slip.noalias() += geometry.master->tangent[a] * shift.row(a);
    rows.template middleRows<D>(Rows::slip) = area * slip;
    rows.template middleRows<D>(Rows::slip).noalias() += (geometry.master->position - slip_point->position) * area_row;
  }
  if constexpr (D == 3) {
    auto along = rows.template middleRows<D>(Rows::along);
    along.template middleCols<D>(Force::slave_tangent_column).diagonal().setConstant(area);
    along.noalias() += geometry.slave_tangent[0] * area_row;
  }
  return rows;
}

template <int D>
MultiplierRows<D>::MultiplierRows(const Surface<D>& slave, const Master<D>& master,
                                  const MultiplierFunctions<D>& functions)
    : slave_(slave), master_(master), functions_(functions),
      base_(PointRows<D>::most * D * (slave.most_functions() + 2 * master.most_functions())) {}

template <int D> void MultiplierRows<D>::clear() {
  std::move(strips_.begin(), strips_.end(), std::back_inserter(spare_));
  strips_.clear();
}

template <int D> Strip& MultiplierRows<D>::find(int slave_element, int master_element, int slip_element, int count) {
  for (auto strip = strips_.rbegin(); strip != strips_.rend() && strip->slave_element == slave_element; ++strip)
    if (strip->master_element == master_element && strip->slip_element == slip_element) return *strip;
  if (spare_.empty()) {
    strips_.emplace_back();
  } else {
    strips_.push_back(std::move(spare_.back()));
    spare_.pop_back();
  }
  Strip& strip = strips_.back();
  const int nodes = slave_.functions_on(slave_element) + master_.functions_on(master_element);
  const int multipliers = std::ssize(functions_.on(slave_element));
  strip.slave_element = slave_element;
  strip.master_element = master_element;
  strip.slip_element = slip_element;
  strip.columns = D * (nodes + (slip_element >= 0 ? master_.functions_on(slip_element) : 0));
  strip.rows.assign(multipliers * count * strip.columns, 0.0);
  strip.shares.assign(multipliers * nodes, 0.0);
  return strip;
}

/// The chain rule from the local variables to the nodes' displacements.
template <int D>
void MultiplierRows<D>::expand(const Strip& strip, const double* r, const FacePoint<D>& master,
                               const FacePoint<D>* slip_point, const LocalRows<D>& local, int count) {
  using Force = LocalForce<D>;
  const int ns = slave_.functions_on(strip.slave_element), nm = master_.functions_on(strip.master_element);
  const bool own_columns = strip.slip_element >= 0;
  const int nl = own_columns ? master_.functions_on(strip.slip_element) : 0;
  double* out = base_.data();
  for (int i = 0; i < count; ++i) {
    const auto row = local.row(i);
    for (int b = 0; b < ns; ++b)
      for (int c = 0; c < D; ++c) {
        double sum = row(c) * r[b];
        for (int k = 0; k < D - 1; ++k) sum += row(Force::slave_tangent_column + k * D + c) * r[(k + 1) * ns + b];
        *out++ = sum;
      }
    for (int b = 0; b < nm; ++b)
      for (int c = 0; c < D; ++c) {
        double sum = row(Force::master_column + c) * master.value[b];
        for (int k = 0; k < D - 1; ++k) sum += row(Force::tangent_column + k * D + c) * master.derivative[k][b];
        if (slip_point && !own_columns) sum += row(Force::slip_column + c) * slip_point->value[b];
        *out++ = sum;
      }
    for (int b = 0; b < nl; ++b)
      for (int c = 0; c < D; ++c) *out++ = row(Force::slip_column + c) * slip_point->value[b];
  }
}

template <int D>
void MultiplierRows<D>::add(const ContactPoints<D>& points, std::size_t i, const FacePoint<D>& master,
                            const FacePoint<D>* slip_point, const LocalRows<D>& local, int count, double area,
                            const double* weights) {
  const bool rigid = master_.rigid(); // the same nodes for all elements
  const bool own_columns = slip_point && !rigid && slip_point->element != master.element;
  Strip& strip =
      find(points.list[i].element, rigid ? 0 : master.element, own_columns ? slip_point->element : -1, count);
  const double* r = points.functions(i);
  expand(strip, r, master, slip_point, local, count);
  const int ns = slave_.functions_on(strip.slave_element), nm = master_.functions_on(strip.master_element);
  const int multipliers = std::ssize(functions_.on(strip.slave_element)), size = count * strip.columns;
  const double* __restrict base = base_.data();
  for (int a = 0; a < multipliers; ++a) {
    if (weights[a] == 0) continue;
    double* __restrict rows = strip.rows.data() + a * size;
    for (int c = 0; c < size; ++c) rows[c] += weights[a] * base[c];
    double* shares = strip.shares.data() + a * (ns + nm);
    for (int b = 0; b < ns; ++b) shares[b] -= area * weights[a] * r[b];
    for (int b = 0; b < nm; ++b) shares[ns + b] += area * weights[a] * master.value[b];
  }
}

namespace {

/// Collects master elements and nodes of the strips of a group's support.
template <int D>
void collect_nodes(const MultiplierGroup& group, const Master<D>& master,
                   const std::vector<std::vector<const Strip*>>& strips, Block& block) {
  block.slave_nodes = group.nodes;
  block.master_elements.clear();
  block.master_nodes.clear();
  for (const int element : group.support)
    for (const Strip* strip : strips[element]) {
      block.master_elements.push_back(strip->master_element);
      if (strip->slip_element >= 0) block.master_elements.push_back(strip->slip_element);
    }
  sort_once(block.master_elements);
  if (master.rigid()) {
    for (int node = 0; node < master.functions_on(0); ++node) block.master_nodes.push_back(node);
    return;
  }
  const Surface<D>& face = *master.surface();
  for (const int element : block.master_elements)
    block.master_nodes.insert(block.master_nodes.end(), face.nodes(element),
                              face.nodes(element) + face.functions_on(element));
  sort_once(block.master_nodes);
}

/// Numbers of the nodes in the block, by face-local index.
void number(const std::vector<int>& nodes, int first, int functions, std::vector<int>& numbers) {
  numbers.resize(functions);
  for (const int node : nodes) numbers[node] = first++;
}

/// Adds a multiplier's rows and shares in a strip to those of the block.
template <int D>
void add_strip(const Strip& strip, int own, int count, const Surface<D>& slave, const Master<D>& master,
               CouplingSpace& space) {
  const int ns = slave.functions_on(strip.slave_element), nm = master.functions_on(strip.master_element);
  const double* rows = strip.rows.data() + own * count * strip.columns;
  const double* shares = strip.shares.data() + own * (ns + nm);
  for (int b = 0, nodes = strip.columns / D; b < nodes; ++b) {
    int node;
    if (b < ns) {
      node = space.slave_column[slave.nodes(strip.slave_element)[b]];
    } else if (master.rigid()) {
      node = space.master_column[b - ns];
    } else {
      const int* list = master.surface()->nodes(b < ns + nm ? strip.master_element : strip.slip_element);
      node = space.master_column[list[b < ns + nm ? b - ns : b - ns - nm]];
    }
    for (int i = 0; i < count; ++i)
      for (int c = 0; c < D; ++c) space.rows(i, D * node + c) += rows[i * strip.columns + D * b + c];
    if (b < ns + nm) space.shares(node) += shares[b];
  }
}

/// Writes the rows ∂f/∂z_A, ∂f/∂t_A to the left, δz_A, δt_A to the right, from those collected of one multiplier.
template <int D>
void add_factors(const MultiplierSums<D>& sums, const MultiplierTangent<D>& tangent, bool frictional, int row,
                 CouplingSpace& space) {
  using Rows = PointRows<D>;
  const auto& x = space.rows;
  // ḡ = G/a, V = S/a:  δḡ = (δG − ḡ δa)/a,  δV = (δS − V δa)/a
  const double gap = sums.gap / sums.area;
  using Row = Eigen::Matrix<double, 1, Eigen::Dynamic>;
  const Row gap_row = (x.row(Rows::gap) + x.row(Rows::gap_area) - gap * x.row(Rows::area)) / sums.area;
  // ∂f/∂z_A = −Σ w M_A J δg
  space.left.row(row) = -x.row(Rows::gap).head(space.left.cols());
  space.right.row(row) = tangent.pressure * gap_row;
  if (!frictional) return;
  const Vec<D> slip = sums.slip / sums.area;
  auto directions = space.right.template middleRows<D>(row + 1);
  directions.noalias() = tangent.of_gap * gap_row;
  directions.noalias() += tangent.of_normal * x.template middleRows<D>(Rows::normal);
  directions.noalias() +=
      (tangent.of_slip / sums.area) * (x.template middleRows<D>(Rows::slip) - slip * x.row(Rows::area));
  if constexpr (D == 3) directions.noalias() += tangent.of_along * x.template middleRows<D>(Rows::along);
  // f contains −t_A Σ w M_A J (−R, R̄)
  auto shares = space.left.template middleRows<D>(row + 1);
  shares.setZero();
  for (Eigen::Index b = 0; b < space.left.cols() / D; ++b)
    for (int c = 0; c < D; ++c) shares(c, D * b + c) = -space.shares(b);
}

} // namespace

template <int D>
void couple(const MultiplierGroup& group, const MultiplierFunctions<D>& functions,
            const std::vector<MultiplierSums<D>>& sums, const std::vector<MultiplierTangent<D>>& tangents,
            const Surface<D>& slave, const Master<D>& master, const std::vector<std::vector<const Strip*>>& strips,
            int count, Pass pass, CouplingSpace& space, Block& block) {
  collect_nodes(group, master, strips, block);
  const int ns = std::ssize(block.slave_nodes), nm = std::ssize(block.master_nodes);
  number(block.slave_nodes, 0, slave.functions(), space.slave_column);
  number(block.master_nodes, ns, master.rigid() ? master.functions_on(0) : master.surface()->functions(),
         space.master_column);
  const int size = block.columns = D * (ns + nm);
  block.rows = pass == Pass::half ? D * ns : size;
  const bool frictional = count > PointRows<D>::count(false);
  const int factors = frictional ? 1 + D : 1; // per multiplier
  space.active.clear();
  for (const int a : group.members)
    if (tangents[a].pressure != 0) space.active.push_back(a);
  const int all = factors * static_cast<int>(space.active.size());
  space.left.resize(all, block.rows);
  space.right.resize(all, size);
  int row = 0;
  for (const int a : space.active) {
    space.rows.setZero(count, size);
    space.shares.setZero(ns + nm);
    for (const int element : functions.support(a)) {
      const auto on = functions.on(element);
      const int own = static_cast<int>(std::find(on.begin(), on.end(), a) - on.begin());
      for (const Strip* strip : strips[element]) add_strip<D>(*strip, own, count, slave, master, space);
    }
    add_factors(sums[a], tangents[a], frictional, row, space);
    row += factors;
  }
  block.force.assign(block.rows, 0.0);
  block.matrix.resize(block.rows * size);
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> matrix(block.matrix.data(),
                                                                                            block.rows, size);
  matrix.noalias() = space.left.transpose() * space.right;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template LocalRows<D> point_rows(const LocalGeometry<D>&, const GapRows<D>&, const LocalShift<D>&, double,           \
                                   const LocalRow<D>&, const FacePoint<D>*, bool);                                     \
  template class MultiplierRows<D>;                                                                                    \
  template void couple(const MultiplierGroup&, const MultiplierFunctions<D>&, const std::vector<MultiplierSums<D>>&,   \
                       const std::vector<MultiplierTangent<D>>&, const Surface<D>&, const Master<D>&,                  \
                       const std::vector<std::vector<const Strip*>>&, int, Pass, CouplingSpace&, Block&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
