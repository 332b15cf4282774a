#include "contact/mortar/coupling_sums.hpp"

#include "contact/mortar/multiplier_rows.hpp"

#include <utility>

namespace signorini::contact {

template <int D>
CouplingSums<D>::CouplingSums(const Faces<D>& faces, const MultiplierFunctions<D>& functions, int each, double scale)
    : faces_(faces), functions_(functions), each_(each), scale_(scale),
      base_(D * D * (faces.slave.most_functions() + 2 * faces.master.most_functions()) + 1) {}

template <int D> Block& CouplingSums<D>::find(int slave_element, int master_element, int slip_element) {
  for (auto block = blocks_.rbegin(); block != blocks_.rend() && block->slave_element == slave_element; ++block)
    if (block->master_element == master_element && block->slip_element == slip_element) return *block;
  Block& block = reuse(spare_, blocks_);
  block.slave_element = slave_element;
  block.master_element = master_element;
  block.slip_element = slip_element;
  block.group = -1;
  block.extra.clear();
  for (const int a : functions_.on(slave_element))
    for (int k = 0; k < each_; ++k) block.extra.push_back(a * each_ + k);
  block.rows = D * (faces_.slave.functions_on(slave_element) + faces_.master.functions_on(master_element)) +
               static_cast<int>(block.extra.size());
  block.columns = block.rows + (slip_element >= 0 ? D * faces_.master.functions_on(slip_element) : 0);
  block.force.assign(block.rows, 0.0);
  block.matrix.assign(block.rows * block.columns, 0.0);
  return block;
}

template <int D>
void CouplingSums<D>::add(const ContactPoints<D>& points, std::size_t i, const CoupledPoint<D>& point) {
  const auto& [slave, master, accepted, travel] = faces_;
  const bool rigid = master.rigid(); // the same nodes for all elements
  const int e = points.list[i].element;
  const bool own_columns = point.slip_point && !rigid && point.slip_point->element != point.foot->element;
  Block& block = find(e, rigid ? 0 : point.foot->element, own_columns ? point.slip_point->element : -1);
  const int ns = slave.functions_on(e), nm = master.functions_on(block.master_element), width = D * (ns + nm);
  const int behind = block.columns - block.rows, size = width + behind;
  const double w = points.list[i].weight;
  const double *r = points.functions(i), *values = functions_.at_point(i);
  const ColumnNodes<D> nodes(r, ns, *point.foot, nm, point.slip_point, behind / D);
  for (int k = 0; k < each_; ++k) nodes.expand(point.rows.row(k), w, base_.data() + k * size);
  const Eigen::Map<const RowMajorX> base(base_.data(), each_, size);
  Eigen::Map<RowMajorX> matrix(block.matrix.data(), block.rows, block.columns);
  const int count = std::ssize(functions_.on(e));
  for (int a = 0; a < count; ++a) {
    if (values[a] == 0) continue;
    const int first = width + a * each_;
    auto rows = matrix.middleRows(first, each_);
    rows.leftCols(width) += values[a] * base.leftCols(width);
    if (behind > 0) rows.rightCols(behind) += values[a] * base.rightCols(behind);
    // f = −R T on the slave, +R̄ T on the master
    const double factor = w * scale_ * values[a];
    for (int b = 0; b < ns + nm; ++b)
      matrix.block(D * b, first, D, each_) +=
          (factor * (b < ns ? -r[b] : point.foot->value[b - ns])) * point.direction.leftCols(each_);
  }
}

template <int D> void CouplingSums<D>::hand_over(std::vector<Block>& to) {
  handed_over_ = std::ssize(blocks_);
  for (Block& block : blocks_) to.push_back(std::move(block));
  blocks_.clear();
}

template <int D> void CouplingSums<D>::take_back(std::vector<Block>::iterator& first) {
  for (; handed_over_ > 0; --handed_over_) spare_.push_back(std::move(*first++));
}

template class CouplingSums<2>;
template class CouplingSums<3>;

} // namespace signorini::contact
