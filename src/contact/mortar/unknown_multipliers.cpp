#include "contact/mortar/unknown_multipliers.hpp"

namespace signorini::contact {

template <int D>
UnknownMultipliers<D>::UnknownMultipliers(double scale, bool frictional, const MultiplierFunctions<D>& functions,
                                          const ContactPoints<D>& points)
    : scale_(scale), frictional_(frictional), functions_(functions), whole_(functions.areas(points)),
      conditions_(functions.count()) {}

template <int D> MultiplierUnknowns<D> UnknownMultipliers<D>::unknowns(const double* all, int multiplier) const {
  const double* own = all + multiplier * each();
  MultiplierUnknowns<D> unknowns{own[0]};
  if (frictional_) unknowns.tangential = Eigen::Map<const Vec<D>>(own + 1);
  return unknowns;
}

template <int D> void UnknownMultipliers<D>::number_unknowns(int multiplier, std::vector<int>& numbers) const {
  for (int i = 0; i < each(); ++i) numbers.push_back(multiplier * each() + i);
}

template <int D> void UnknownMultipliers<D>::fill_conditions(int multiplier, bool tangent, Block& block) const {
  const ConditionRows<D>& conditions = conditions_[multiplier];
  const int size = each();
  block.slave_element = block.master_element = block.slip_element = -1;
  block.group = multiplier;
  block.slave_nodes.clear();
  block.master_nodes.clear();
  block.master_elements.clear();
  block.extra.clear();
  number_unknowns(multiplier, block.extra);
  block.rows = block.columns = size;
  block.force.assign(conditions.residual.data(), conditions.residual.data() + size);
  block.matrix.resize(tangent ? size * size : 0);
  if (tangent)
    Eigen::Map<RowMajorX>(block.matrix.data(), size, size) = conditions.of_unknowns.topLeftCorner(size, size);
}

template <int D> void UnknownMultipliers<D>::fill_coupling(const Strip& strip, Block& block) const {
  using Rows = PointRows<D>;
  using Row = Eigen::Matrix<double, 1, Eigen::Dynamic>;
  const auto on = functions_.on(strip.slave_element);
  const int width = D * strip.nodes, behind = strip.columns - width;
  block.slave_element = strip.slave_element;
  block.master_element = strip.master_element;
  block.slip_element = strip.slip_element;
  block.group = -1;
  block.extra.clear();
  for (const int a : on) number_unknowns(a, block.extra);
  block.rows = width + static_cast<int>(block.extra.size());
  block.columns = block.rows + behind;
  block.force.assign(block.rows, 0.0);
  block.matrix.assign(block.rows * block.columns, 0.0);
  Eigen::Map<RowMajorX> matrix(block.matrix.data(), block.rows, block.columns);
  for (int k = 0; k < std::ssize(on); ++k) {
    const ConditionRows<D>& condition = conditions_[on[k]];
    const int first = width + k * each();
    const auto x = strip.rows_of(k);
    // ∂f/∂χ_N = −s Σ w M_A ω δg,  and f contains −s χ_T Σ w M_A ω (−R, R̄)
    matrix.col(first).head(width) = -scale_ * x.row(Rows::gap).head(width).transpose();
    for (int b = 0; b < strip.nodes && frictional_; ++b)
      for (int c = 0; c < D; ++c) matrix(D * b + c, first + 1 + c) = -scale_ * strip.shares_of(k)(b);
    const Row gap = x.row(Rows::gap) + x.row(Rows::gap_area);
    const auto add = [&](int i, const Row& row) {
      matrix.row(first + i).head(width) += row.head(width);
      matrix.row(first + i).tail(behind) += row.tail(behind);
    };
    for (int i = 0; i < each(); ++i) {
      add(i, condition.of_gap(i) * gap);
      if (i == 0) continue;
      add(i, condition.of_area(i) * x.row(Rows::area) +
                 condition.of_normal.row(i) * x.template middleRows<D>(Rows::normal) +
                 condition.of_slip.row(i) * x.template middleRows<D>(Rows::slip));
    }
  }
}

template class UnknownMultipliers<2>;
template class UnknownMultipliers<3>;

} // namespace signorini::contact
