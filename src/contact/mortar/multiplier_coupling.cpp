#include "contact/mortar/multiplier_coupling.hpp"

#include <algorithm>

namespace signorini::contact {

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

/// Appends the numbers in the block of a strip's nodes, the slave's first.
template <int D>
void number_nodes(const Strip& strip, const Faces<D>& faces, const Block& block, std::vector<int>& numbers) {
  const auto append = [&](const Surface<D>& face, int element, const std::vector<int>& nodes, std::ptrdiff_t first) {
    for (int b = 0; b < face.functions_on(element); ++b)
      numbers.push_back(
          static_cast<int>(first + (std::ranges::lower_bound(nodes, face.nodes(element)[b]) - nodes.begin())));
  };
  const int ns = std::ssize(block.slave_nodes);
  append(faces.slave, strip.slave_element, block.slave_nodes, 0);
  for (const int element : {strip.master_element, strip.slip_element}) {
    if (element < 0) continue;
    if (faces.master.rigid())
      for (const int node : block.master_nodes) numbers.push_back(ns + node);
    else
      append(*faces.master.surface(), element, block.master_nodes, ns);
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
  const MatrixX slip_rows = x.template middleRows<D>(Rows::slip) - slip * x.row(Rows::area);
  auto directions = space.right.template middleRows<D>(row + 1);
  directions.noalias() = tangent.of_gap * gap_row;
  directions.noalias() += tangent.of_normal * x.template middleRows<D>(Rows::normal);
  directions.noalias() += (tangent.of_slip / sums.area) * slip_rows;
  if constexpr (D == 3) directions.noalias() += tangent.of_along * x.template middleRows<D>(Rows::along);
  if (const auto& worn = tangent.worn) {
    space.right.row(row).noalias() += worn->of_normal.transpose() * x.template middleRows<D>(Rows::normal);
    space.right.row(row).noalias() += (worn->of_slip.transpose() / sums.area) * slip_rows;
    if constexpr (D == 3)
      space.right.row(row).noalias() += worn->of_along.transpose() * x.template middleRows<D>(Rows::along);
  }
  // f contains −t_A Σ w M_A J (−R, R̄)
  auto shares = space.left.template middleRows<D>(row + 1);
  shares.setZero();
  for (Eigen::Index b = 0; b < space.left.cols() / D; ++b)
    for (int c = 0; c < D; ++c) shares(c, D * b + c) = -space.shares(b);
}

} // namespace

template <int D> void MultiplierCoupling<D>::collect(const std::vector<MultiplierRows<D>>& parts) {
  for (auto& list : strips_) list.clear();
  for (const MultiplierRows<D>& part : parts)
    for (const Strip& strip : part.strips()) strips_[strip.slave_element].push_back(&strip);
}

template <int D>
void MultiplierCoupling<D>::fill(const std::vector<WeightedMultiplier<D>>& multipliers, bool frictional, int thread,
                                 Block& block) {
  CouplingSpace& space = spaces_[thread];
  const MultiplierGroup& group = functions_.groups()[block.group];
  collect_nodes(group, faces_.master, strips_, block);
  const int ns = std::ssize(block.slave_nodes), nodes = ns + static_cast<int>(block.master_nodes.size());
  block.columns = D * nodes;
  block.rows = pass_ == Pass::half ? D * ns : block.columns;
  space.strips.clear();
  space.numbers.clear();
  for (const int element : group.support)
    for (const Strip* strip : strips_[element]) {
      space.strips.emplace_back(strip, space.numbers.size());
      number_nodes(*strip, faces_, block, space.numbers);
    }
  const auto is_open = [&](int a) { return multipliers[a].tangent.pressure == 0; };
  const int factors = frictional ? 1 + D : 1; // per multiplier
  const int closed = static_cast<int>(group.members.size() - std::ranges::count_if(group.members, is_open));
  space.left.resize(factors * closed, block.rows);
  space.right.resize(factors * closed, block.columns);
  int row = 0;
  for (const int a : group.members) {
    if (is_open(a)) continue;
    space.rows.setZero(PointRows<D>::count(frictional), block.columns);
    space.shares.setZero(nodes);
    for (const auto& [strip, first] : space.strips) {
      const int own = functions_.index_on(strip->slave_element, a);
      if (own == std::ssize(functions_.on(strip->slave_element))) continue;
      const auto rows = strip->rows_of(own);
      const auto shares = strip->shares_of(own);
      const int* numbers = space.numbers.data() + first;
      for (int b = 0; b < strip->columns / D; ++b)
        space.rows.template middleCols<D>(D * numbers[b]) += rows.template middleCols<D>(D * b);
      for (int b = 0; b < strip->nodes; ++b) space.shares(numbers[b]) += shares(b);
    }
    add_factors(multipliers[a].sums, multipliers[a].tangent, frictional, row, space);
    row += factors;
  }
  block.force.assign(block.rows, 0.0);
  block.matrix.resize(block.rows * block.columns);
  Eigen::Map<RowMajorX>(block.matrix.data(), block.rows, block.columns).noalias() =
      space.left.transpose() * space.right;
}

template class MultiplierCoupling<2>;
template class MultiplierCoupling<3>;

} // namespace signorini::contact
