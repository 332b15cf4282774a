#include "contact/gauss/block_sums.hpp"

#include <algorithm>
#include <utility>

namespace signorini::contact {

namespace {

/// Writes the sums Σ_k f_k,B A_k over functions f_0, f_1 … of nodes B and row vectors A_k of D components to D columns
/// per node. In 3D one more value is written.
template <int D, std::size_t Count>
void combine(int nodes, const std::array<const double*, Count>& functions,
             const std::array<Eigen::Matrix<double, 1, D>, Count>& vectors, double* __restrict out) {
  using Lanes = Eigen::Matrix<double, D == 2 ? 2 : 4, 1>;
  std::array<Lanes, Count> rows;
  for (std::size_t k = 0; k < Count; ++k) {
    rows[k].setZero();
    rows[k].template head<D>() = vectors[k].transpose();
  }
  for (int b = 0; b < nodes; ++b, out += D) {
    Lanes sum = functions[0][b] * rows[0];
    for (std::size_t k = 1; k < Count; ++k) sum += functions[k][b] * rows[k];
    Eigen::Map<Lanes, Eigen::Unaligned> to(out);
    to = sum;
  }
}

} // namespace

template <int D>
ColumnNodes<D>::ColumnNodes(const double* own, int own_nodes, const FacePoint<D>& foot, int foot_nodes,
                            const FacePoint<D>* slip_point, int slip_point_nodes)
    : slip(slip_point ? slip_point->value.data() : nullptr), slave_nodes(own_nodes), master_nodes(foot_nodes),
      slip_nodes(slip_point_nodes) {
  for (int k = 0; k < D; ++k) {
    slave[k] = own + k * own_nodes;
    master[k] = k == 0 ? foot.value.data() : foot.derivative[k - 1].data();
  }
}

template <int D> void ColumnNodes<D>::expand(const LocalRow<D>& row, double weight, double* out) const {
  using Vector = Eigen::Matrix<double, 1, D>;
  const auto segment = [&](int column) -> Vector { return weight * row.template segment<D>(column); };
  std::array<Vector, D> vectors;
  for (int k = 0; k < D; ++k) vectors[k] = segment(k * D);
  combine<D>(slave_nodes, slave, vectors, out);
  out += D * slave_nodes;
  for (int k = 0; k < D; ++k) vectors[k] = segment(LocalForce<D>::master_column + k * D);
  if (!slip || slip_nodes > 0) {
    combine<D>(master_nodes, master, vectors, out);
    if (slip) combine<D, 1>(slip_nodes, {slip}, {segment(LocalForce<D>::slip_column)}, out + D * master_nodes);
  } else {
    std::array<const double*, D + 1> functions;
    std::array<Vector, D + 1> all;
    std::copy_n(master.begin(), D, functions.begin());
    std::copy_n(vectors.begin(), D, all.begin());
    functions[D] = slip;
    all[D] = segment(LocalForce<D>::slip_column);
    combine<D>(master_nodes, functions, all, out);
  }
}

template <int D> void ColumnNodes<D>::expand_shift(const LocalRow<D>& row, double weight, double* out) const {
  using Vector = Eigen::Matrix<double, 1, D>;
  std::array<Vector, D> vectors;
  combine<D, 1>(slave_nodes, {slave[0]}, {Vector(weight * row.template segment<D>(0))}, out);
  out += D * slave_nodes;
  for (int k = 0; k < D; ++k) vectors[k] = weight * row.template segment<D>(LocalForce<D>::master_column + k * D);
  combine<D>(master_nodes, master, vectors, out);
  std::fill_n(out + D * master_nodes, D * slip_nodes, 0.0);
}

template <int D>
BlockSums<D>::BlockSums(const Surface<D>& slave, const Master<D>& master, Pass pass)
    : slave_(slave), master_(master), pass_(pass),
      columns_(D == 2 ? D * (slave.most_functions() + 2 * master.most_functions()) * (2 * D - 1) : 0) {}

/// Index of the block with these elements, which is created if necessary.
template <int D> std::size_t BlockSums<D>::find(int slave_element, int master_element, int slip_element, bool tangent) {
  // Points are added element by element, so only the last blocks need to be searched.
  for (std::size_t index = blocks_.size(); index-- > first_;)
    if (blocks_[index].master_element == master_element && blocks_[index].slip_element == slip_element) return index;
  Block& result = reuse(spare_, blocks_);
  const int ns = slave_.functions_on(slave_element), nm = master_.functions_on(master_element);
  result.slave_element = slave_element;
  result.master_element = master_element;
  result.slip_element = slip_element;
  result.rows = D * (ns + master_rows(nm));
  result.columns = D * (ns + nm + (slip_element >= 0 ? master_.functions_on(slip_element) : 0));
  result.force.assign(result.rows, 0.0);
  result.matrix.assign(tangent ? result.rows * result.columns : 0, 0.0);
  if constexpr (D == 3) {
    const std::size_t own = blocks_.size() - 1 - first_;
    if (products_.size() <= own) products_.emplace_back();
    products_[own].start(ns + master_rows(nm), master_rows(nm), result.columns, result.matrix.data());
  }
  return blocks_.size() - 1;
}

template <int D>
void BlockSums<D>::add(const ContactPoints<D>& points, std::size_t point, const FacePoint<D>& master,
                       const FacePoint<D>* slip_point, const LocalForce<D>& force, bool tangent) {
  const bool rigid = master_.rigid(); // the same nodes for all elements
  const bool own_columns = slip_point && !rigid && slip_point->element != master.element;
  const std::size_t index =
      find(points.list[point].element, rigid ? 0 : master.element, own_columns ? slip_point->element : -1, tangent);
  Block& block = blocks_[index];
  const int ns = slave_.functions_on(block.slave_element), nm = master_.functions_on(block.master_element);
  const int width = block.columns, rows = master_rows(nm);
  const double* r = points.functions(point);
  const double w = points.list[point].weight;
  const ColumnNodes<D> nodes(r, ns, master, nm, slip_point, own_columns ? master_.functions_on(block.slip_element) : 0);
  // ∂T/∂x_B and ∂ξ̄/∂x_B of every column node B times the point's weight
  const auto fill = [&](double* dt, double* dxi) {
    for (int i = 0; i < D; ++i) nodes.expand(force.tangent.row(i), w, dt + i * width);
    for (int k = 0; k < D - 1; ++k) nodes.expand_shift(force.shift.row(k), w, dxi + k * width);
  };

  // f_A = −R_A T on the slave, +R̄_A(ξ̄) T on the master [theory 5.8]
  double* out = block.force.data();
  for (int a = 0; a < ns; ++a)
    for (int i = 0; i < D; ++i) *out++ -= w * r[a] * force.force(i);
  for (int a = 0; a < rows; ++a)
    for (int i = 0; i < D; ++i) *out++ += w * master.value[a] * force.force(i);
  if (!tangent) return;

  // ∂f_A = −R_A ∂T on the slave, R̄_A ∂T + T R̄_A,α ∂ξ̄^α on the master [theory 5.13]
  if constexpr (D == 3) {
    const Products::Factors factors = products_[index - first_].add();
    fill(factors.traction, factors.shift);
    for (int a = 0; a < ns; ++a) factors.left[a] = -r[a];
    std::copy_n(master.value.data(), rows, factors.left + ns);
    double* rates = factors.rates;
    for (std::size_t k = 0; k < 2 && rows > 0; ++k)
      for (int a = 0; a < rows; ++a)
        for (int i = 0; i < 3; ++i) *rates++ = force.force(i) * master.derivative[k][a];
  } else {
    double* const dt = columns_.data();
    double* const dxi = dt + D * width;
    fill(dt, dxi);
    double* __restrict matrix = block.matrix.data();
    for (int a = 0; a < ns; ++a)
      for (int i = 0; i < D; ++i, matrix += width) {
        const double factor = r[a];
        const double* row = dt + i * width;
        for (int c = 0; c < width; ++c) matrix[c] -= factor * row[c];
      }
    for (int a = 0; a < rows; ++a) {
      const std::size_t m = a;
      for (int i = 0; i < D; ++i, matrix += width) {
        const double factor = master.value[m];
        const double* row = dt + i * width;
        double turn[D - 1];
        for (std::size_t k = 0; k < D - 1; ++k) turn[k] = master.derivative[k][m] * force.force(i);
        for (int c = 0; c < width; ++c) {
          double sum = factor * row[c];
          for (int k = 0; k < D - 1; ++k) sum += turn[k] * dxi[k * width + c];
          matrix[c] += sum;
        }
      }
    }
  }
}

template <int D> void BlockSums<D>::close_element(bool tangent) {
  if constexpr (D == 3)
    for (std::size_t g = first_; g < blocks_.size() && tangent; ++g) products_[g - first_].finish();
  first_ = blocks_.size();
}

template <int D> void BlockSums<D>::hand_over(std::vector<Block>& to) {
  handed_over_ = std::ssize(blocks_);
  for (Block& block : blocks_) to.push_back(std::move(block));
  blocks_.clear();
  first_ = 0;
}

template <int D> void BlockSums<D>::take_back(std::vector<Block>::iterator& first) {
  for (; handed_over_ > 0; --handed_over_) spare_.push_back(std::move(*first++));
}

template <int D> double BlockSums<D>::memory() const {
  const auto bytes = [](const auto& list) { return static_cast<double>(list.capacity() * sizeof(list[0])); };
  return bytes(spare_) + bytes(columns_) + bytes(products_);
}

template <int D> std::vector<SumPart<D>> parts_of(const Faces<D>& faces, const ContactPoints<D>& points, Pass pass) {
  std::vector<SumPart<D>> parts;
  for (const auto& [first, last] : pieces(points))
    parts.push_back({first, last, BlockSums<D>(faces.slave, faces.master, pass)});
  return parts;
}

template <int D> void hand_over(std::vector<SumPart<D>>& parts, std::vector<Block>& blocks, double& search_seconds) {
  for (SumPart<D>& part : parts) {
    part.sums.hand_over(blocks);
    search_seconds += std::exchange(part.search_seconds, 0);
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template struct ColumnNodes<D>;                                                                                      \
  template class BlockSums<D>;                                                                                         \
  template std::vector<SumPart<D>> parts_of(const Faces<D>&, const ContactPoints<D>&, Pass);                           \
  template void hand_over(std::vector<SumPart<D>>&, std::vector<Block>&, double&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
