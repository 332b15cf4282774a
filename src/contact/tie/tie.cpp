#include "contact/tie/tie.hpp"

#include "nurbs/bezier.hpp"
#include "nurbs/tensor.hpp"

#include <map>
#include <utility>

namespace signorini::contact {

namespace {

/// Multipliers with a smaller part of their support opposite the master are left out: they would be tied to almost no
/// area, and their equations would be small compared with those of the others.
constexpr double least_support = 1e-6;

/// The multiplier functions on the slave face.
template <int D> class SeamFunctions {
public:
  SeamFunctions(const Surface<D>& slave, MultiplierSpace kind) : face_(slave, kind) {}
  int count() const { return face_.count; }
  /// Calls visit(function, value) for those that do not vanish on the element; a function of several products is
  /// visited for each of them.
  template <class Visit> void at_point(int element, const FaceCoordinates<D>& xi, Visit visit) const {
    nurbs::ElementFunctions functions;
    std::array<VectorX, 2> values{VectorX::Ones(1), VectorX::Ones(1)};
    for (int d = 0; d < D - 1; ++d) {
      const nurbs::Space1D& space = face_.along[d];
      const int across = face_.along.front().elements(), own = d == 0 ? element % across : element / across;
      const auto [from, to] = space.interval(own);
      const int degree = space.degree(own);
      VectorX bernsteins(degree + 1);
      nurbs::bernstein(degree, (xi(d) - from) / (to - from), 1, 0, bernsteins.data());
      values[d] = space.extraction(own) * bernsteins;
      functions.along[d] = space.functions_on(own);
      functions.stride[d] = d == 0 ? 1 : face_.along.front().functions();
    }
    functions.each([&](int product, const std::array<int, 3>& a) {
      visit(face_.number[product], values[0](a[0]) * values[1](a[1]));
    });
  }

private:
  FaceMultipliers<D> face_;
};

/// ∫ M_A R dA as full blocks, by pair of elements: rows of the multiplier functions on the slave element, columns of a
/// face's functions.
template <int D> class CouplingBlocks {
public:
  void add(int slave_element, const std::vector<double>& multipliers, const Surface<D>& face, const FacePoint<D>& at) {
    MatrixX& block = blocks_[{slave_element, at.element}];
    const int n = face.functions_on(at.element), m = std::ssize(multipliers);
    if (block.size() == 0) block = MatrixX::Zero(m, n);
    for (int b = 0; b < n; ++b)
      for (int a = 0; a < m; ++a) block(a, b) += multipliers[a] * at.value[b];
  }
  /// Sums of each multiplier by function of the body; `on`: multipliers of each slave element.
  std::vector<std::map<int, double>> sums(const std::vector<std::vector<int>>& on, int count,
                                          const Surface<D>& face) const {
    std::vector<std::map<int, double>> rows(count);
    for (const auto& [elements, block] : blocks_)
      for (int a = 0; a < block.rows(); ++a)
        for (int b = 0; b < block.cols(); ++b)
          rows[on[elements.first][a]][face.body_function(face.nodes(elements.second)[b])] += block(a, b);
    return rows;
  }

private:
  std::map<std::pair<int, int>, MatrixX> blocks_;
};

template <class Entry> std::vector<Entry> listed(const std::map<int, double>& row) {
  std::vector<Entry> list;
  list.reserve(row.size());
  for (const auto& [function, value] : row) list.push_back({function, value});
  return list;
}

} // namespace

template <int D>
Tie<D>::Tie(const Surface<D>& slave, const Surface<D>& master, Seam<D> seam, MultiplierSpace kind)
    : slave_(slave), master_(master), seam_(std::move(seam)) {
  const SeamFunctions<D> functions(slave_, kind);
  std::vector<std::vector<int>> on(slave_.elements());
  std::vector<double> area(functions.count(), 0.0);
  CouplingBlocks<D> slave_blocks, master_blocks;
  FacePoint<D> own, foot;
  for (const SeamPoint<D>& point : seam_.points) {
    std::vector<int>& numbers = on[point.slave_element];
    numbers.clear();
    std::vector<double> weighted;
    first_.push_back(row_at_.size());
    functions.at_point(point.slave_element, point.slave_xi, [&](int function, double value) {
      numbers.push_back(function);
      weighted.push_back(point.area * value);
      area[function] += weighted.back();
      row_at_.push_back(function);
      value_at_.push_back(value);
    });
    const auto add = [&](CouplingBlocks<D>& blocks, const Surface<D>& face, int element, const FaceCoordinates<D>& xi,
                         FacePoint<D>& at) {
      face.locate(element, xi, 0, at);
      at.element = element;
      at.xi = xi;
      face.functions(at, 0);
      blocks.add(point.slave_element, weighted, face, at);
    };
    add(slave_blocks, slave_, point.slave_element, point.slave_xi, own);
    add(master_blocks, master_, point.master_element, point.master_xi, foot);
  }
  first_.push_back(row_at_.size());

  // Rows of functions with support, and their numbers at the points
  const double mean = seam_.area / functions.count();
  const auto slave_sums = slave_blocks.sums(on, functions.count(), slave_);
  const auto master_sums = master_blocks.sums(on, functions.count(), master_);
  std::vector<int> row_of(area.size(), -1);
  for (std::size_t a = 0; a < area.size(); ++a) {
    if (area[a] <= least_support * mean) continue;
    row_of[a] = std::ssize(rows_);
    rows_.push_back({area[a], listed<Entry>(slave_sums[a]), listed<Entry>(master_sums[a])});
  }
  for (int& number : row_at_) number = row_of[number];
}

template <int D> Vec<D> Tie<D>::combine(std::size_t point, const double* values) const {
  Vec<D> sum = Vec<D>::Zero();
  for (std::size_t k = first_[point]; k < first_[point + 1]; ++k)
    if (row_at_[k] >= 0) sum += value_at_[k] * Eigen::Map<const Vec<D>>(values + D * row_at_[k]);
  return sum;
}

template <int D> double Tie<D>::memory() const {
  const auto bytes = [](const auto& list) { return static_cast<double>(list.capacity() * sizeof(list[0])); };
  double sum = bytes(seam_.points) + bytes(rows_) + bytes(first_) + bytes(row_at_) + bytes(value_at_);
  for (const Row& row : rows_) sum += bytes(row.slave) + bytes(row.master);
  return sum;
}

template class Tie<2>;
template class Tie<3>;

} // namespace signorini::contact
