#include "contact/mortar/multiplier_blocks.hpp"

namespace signorini::contact {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void number_unknowns(int multiplier, int each, std::vector<int>& numbers) {
  for (int i = 0; i < each; ++i) numbers.push_back(multiplier * each + i);
}

} // namespace

template <int D> MultiplierUnknowns<D> unknowns_of(const double* all, int multiplier, bool frictional) {
  const double* own = all + multiplier * unknowns_per_multiplier<D>(frictional);
  MultiplierUnknowns<D> unknowns{own[0]};
  if (frictional) unknowns.tangential = Eigen::Map<const Vec<D>>(own + 1);
  return unknowns;
}

template <int D>
void fill_conditions(const ConditionRows<D>& conditions, int multiplier, bool frictional, bool tangent, Block& block) {
  const int size = unknowns_per_multiplier<D>(frictional);
  block.slave_element = block.master_element = block.slip_element = -1;
  block.group = multiplier;
  block.slave_nodes.clear();
  block.master_nodes.clear();
  block.master_elements.clear();
  block.extra.clear();
  number_unknowns(multiplier, size, block.extra);
  block.rows = block.columns = size;
  block.force.assign(conditions.residual.data(), conditions.residual.data() + size);
  block.matrix.resize(tangent ? size * size : 0);
  if (tangent) Eigen::Map<RowMajor>(block.matrix.data(), size, size) = conditions.of_unknowns.topLeftCorner(size, size);
}

template <int D>
void fill_coupling(const Strip& strip, const Surface<D>& slave, const Master<D>& master,
                   const MultiplierFunctions<D>& functions, const std::vector<ConditionRows<D>>& conditions,
                   double scale, bool frictional, Block& block) {
  using Rows = PointRows<D>;
  using Row = Eigen::Matrix<double, 1, Eigen::Dynamic>;
  const int nodes = slave.functions_on(strip.slave_element) + master.functions_on(strip.master_element);
  const int each = unknowns_per_multiplier<D>(frictional), count = Rows::count(frictional), width = D * nodes;
  const auto on = functions.on(strip.slave_element);
  const int extra = each * static_cast<int>(on.size()), behind = strip.columns - width;
  block.slave_element = strip.slave_element;
  block.master_element = strip.master_element;
  block.slip_element = strip.slip_element;
  block.group = -1;
  block.extra.clear();
  for (const int a : on) number_unknowns(a, each, block.extra);
  block.rows = width + extra;
  block.columns = block.rows + behind;
  block.force.assign(block.rows, 0.0);
  block.matrix.assign(block.rows * block.columns, 0.0);
  Eigen::Map<RowMajor> matrix(block.matrix.data(), block.rows, block.columns);
  for (std::size_t k = 0; k < on.size(); ++k) {
    const ConditionRows<D>& condition = conditions[on[k]];
    const int index = static_cast<int>(k), first = width + index * each;
    const Eigen::Map<const RowMajor> x(strip.rows.data() + index * count * strip.columns, count, strip.columns);
    const double* shares = strip.shares.data() + index * nodes;
    // ∂f/∂χ_N = −s Σ w M_A ω δg,  and f contains −s χ_T Σ w M_A ω (−R, R̄)
    matrix.col(first).head(width) = -scale * x.row(Rows::gap).head(width).transpose();
    for (int b = 0; b < nodes && frictional; ++b)
      for (int c = 0; c < D; ++c) matrix(D * b + c, first + 1 + c) = -scale * shares[b];
    const Row gap = x.row(Rows::gap) + x.row(Rows::gap_area);
    const auto add = [&](int i, const Row& row) {
      matrix.row(first + i).head(width) += row.head(width);
      matrix.row(first + i).tail(behind) += row.tail(behind);
    };
    for (int i = 0; i < each; ++i) {
      add(i, condition.of_gap(i) * gap);
      if (i == 0) continue;
      add(i, condition.of_area(i) * x.row(Rows::area) +
                 condition.of_normal.row(i) * x.template middleRows<D>(Rows::normal) +
                 condition.of_slip.row(i) * x.template middleRows<D>(Rows::slip));
    }
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template MultiplierUnknowns<D> unknowns_of(const double*, int, bool);                                                \
  template void fill_conditions(const ConditionRows<D>&, int, bool, bool, Block&);                                     \
  template void fill_coupling(const Strip&, const Surface<D>&, const Master<D>&, const MultiplierFunctions<D>&,        \
                              const std::vector<ConditionRows<D>>&, double, bool, Block&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
