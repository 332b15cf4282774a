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
BlockSums<D>::BlockSums(const Surface<D>& slave, const Master<D>& master, Pass pass)
    : slave_(slave), master_(master), pass_(pass),
      columns_(D == 2 ? D * (slave.most_functions() + 2 * master.most_functions()) * (2 * D - 1) : 0) {}

/// Index of the block with these elements, which is created if necessary.
template <int D> std::size_t BlockSums<D>::find(int slave_element, int master_element, int slip_element, bool tangent) {
  // Points are added element by element, so only the last blocks need to be searched.
  for (std::size_t index = blocks_.size(); index-- > first_;)
    if (blocks_[index].master_element == master_element && blocks_[index].slip_element == slip_element) return index;
  if (spare_.empty()) {
    blocks_.emplace_back();
  } else {
    blocks_.push_back(std::move(spare_.back()));
    spare_.pop_back();
  }
  Block& result = blocks_.back();
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

/// ∂T/∂x_B and ∂ξ̄/∂x_B of every column node B times the point's weight, by the chain rule from the local variables. In
/// 3D each array has room for one more value.
template <int D>
void BlockSums<D>::fill_columns(const Block& block, const double* r, double w, const FacePoint<D>& master,
                                const FacePoint<D>* slip_point, const LocalForce<D>& force, double* dt,
                                double* dxi) const {
  using Force = LocalForce<D>;
  const int ns = slave_.functions_on(block.slave_element), nm = master_.functions_on(block.master_element);
  const bool own_columns = block.slip_element >= 0;
  const int nl = own_columns ? master_.functions_on(block.slip_element) : 0, width = block.columns;
  std::array<const double*, D> of_slave, of_master;
  for (int k = 0; k < D; ++k) {
    of_slave[k] = r + k * ns;
    of_master[k] = k == 0 ? master.value.data() : master.derivative[k - 1].data();
  }
  const auto segment = [&](const auto& rows, int i, int column) -> Eigen::Matrix<double, 1, D> {
    return w * rows.template block<1, D>(i, column);
  };
  std::array<Eigen::Matrix<double, 1, D>, D> vectors;
  for (int i = 0; i < D; ++i, dt += width) {
    for (int k = 0; k < D; ++k) vectors[k] = segment(force.tangent, i, k * D);
    combine<D>(ns, of_slave, vectors, dt);
    for (int k = 0; k < D; ++k) vectors[k] = segment(force.tangent, i, Force::master_column + k * D);
    double* to = dt + D * ns;
    if (slip_point) {
      const Eigen::Matrix<double, 1, D> slip = segment(force.tangent, i, Force::slip_column);
      if (own_columns) {
        combine<D>(nm, of_master, vectors, to);
        combine<D, 1>(nl, {slip_point->value.data()}, {slip}, to + D * nm);
      } else {
        std::array<const double*, D + 1> functions;
        std::array<Eigen::Matrix<double, 1, D>, D + 1> all;
        std::copy_n(of_master.begin(), D, functions.begin());
        std::copy_n(vectors.begin(), D, all.begin());
        functions[D] = slip_point->value.data();
        all[D] = slip;
        combine<D>(nm, functions, all, to);
      }
    } else {
      combine<D>(nm, of_master, vectors, to);
    }
  }
  for (int k = 0; k < D - 1; ++k, dxi += width) {
    combine<D, 1>(ns, {r}, {segment(force.shift, k, 0)}, dxi);
    for (int l = 0; l < D; ++l) vectors[l] = segment(force.shift, k, Force::master_column + l * D);
    combine<D>(nm, of_master, vectors, dxi + D * ns);
    std::fill_n(dxi + D * (ns + nm), D * nl, 0.0);
  }
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

  // f_A = −R_A T on the slave, +R̄_A(ξ̄) T on the master
  double* out = block.force.data();
  for (int a = 0; a < ns; ++a)
    for (int i = 0; i < D; ++i) *out++ -= w * r[a] * force.force(i);
  for (int a = 0; a < rows; ++a)
    for (int i = 0; i < D; ++i) *out++ += w * master.value[a] * force.force(i);
  if (!tangent) return;

  // ∂f_A = −R_A ∂T on the slave, R̄_A ∂T + T R̄_A,α ∂ξ̄^α on the master
  if constexpr (D == 3) {
    const Products::Factors factors = products_[index - first_].add();
    fill_columns(block, r, w, master, slip_point, force, factors.traction, factors.shift);
    for (int a = 0; a < ns; ++a) factors.left[a] = -r[a];
    std::copy_n(master.value.data(), rows, factors.left + ns);
    double* rates = factors.rates;
    for (std::size_t k = 0; k < 2 && rows > 0; ++k)
      for (int a = 0; a < rows; ++a)
        for (int i = 0; i < 3; ++i) *rates++ = force.force(i) * master.derivative[k][a];
  } else {
    double* const dt = columns_.data();
    double* const dxi = dt + D * width;
    fill_columns(block, r, w, master, slip_point, force, dt, dxi);
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

template <int D> std::size_t BlockSums<D>::hand_over(std::vector<Block>& to) {
  const std::size_t count = blocks_.size();
  for (Block& block : blocks_) to.push_back(std::move(block));
  blocks_.clear();
  first_ = 0;
  return count;
}

template <int D> double BlockSums<D>::memory() const {
  const auto bytes = [](const auto& list) { return static_cast<double>(list.capacity() * sizeof(list[0])); };
  return bytes(spare_) + bytes(columns_) + bytes(products_);
}

template class BlockSums<2>;
template class BlockSums<3>;

} // namespace signorini::contact
