#include "solve/supernodes.hpp"

#include "os/parallel.hpp"
#include "solve/constants.hpp"

#include <algorithm>

namespace signorini::solve {

namespace {

template <class Real> using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
template <class Real> using Panel = Eigen::Map<const Matrix<Real>>;

/// Calls body(first, count) for equal shares of `size` rows or columns of a supernode's panel; for a large one, if
/// `shared`, as tasks.
template <class Supernode, class Body> void in_shares(const Supernode& node, int size, bool shared, const Body& body) {
  const double entries = static_cast<double>(node.columns) * node.height;
  const int shares = shared ? std::clamp(static_cast<int>(entries / entries_per_share), 1, most_shares) : 1;
  if (shares == 1) return body(0, size);
  parallel(shares, [&](int k) {
    const int first = size * k / shares;
    body(first, size * (k + 1) / shares - first);
  });
}

} // namespace

template <class Real> void Supernodes<Real>::analyze(const cholmod_factor& factor, int interior) {
  const int *first = static_cast<int*>(factor.super), *rows_from = static_cast<int*>(factor.pi),
            *values_from = static_cast<int*>(factor.px), *rows = static_cast<int*>(factor.s);
  supernodes_.clear();
  rows_.clear();
  int tallest = 0;
  for (int s = 0; s < static_cast<int>(factor.nsuper) && first[s] < interior; ++s) {
    const int columns = std::min(first[s + 1], interior) - first[s], height = rows_from[s + 1] - rows_from[s];
    supernodes_.push_back({first[s], columns, height, values_from[s], static_cast<std::ptrdiff_t>(rows_.size())});
    rows_.insert(rows_.end(), rows + rows_from[s] + columns, rows + rows_from[s + 1]);
    tallest = std::max(tallest, height);
  }
  work_.resize(tallest);
  build_subtrees(static_cast<int>(factor.n));
}

/// Cuts the elimination tree: the largest subtree is replaced by those below its root until all are small.
template <class Real> void Supernodes<Real>::build_subtrees(int size) {
  const int count = std::ssize(supernodes_);
  std::vector<int> owner(size, -1), parent(count, -1);
  std::vector<std::vector<int>> children(count);
  std::vector<double> weight(count, 0); // entries of the subtree
  for (int s = 0; s < count; ++s) std::fill_n(owner.begin() + supernodes_[s].column, supernodes_[s].columns, s);
  double all = 0;
  std::vector<int> roots;
  for (int s = 0; s < count; ++s) {
    const Supernode& node = supernodes_[s];
    const double own = static_cast<double>(node.columns) * node.height;
    all += own;
    weight[s] += own;
    if (node.columns < node.height) parent[s] = owner[rows_[node.rows]];
    if (parent[s] < 0) {
      roots.push_back(s);
    } else {
      children[parent[s]].push_back(s);
      weight[parent[s]] += weight[s];
    }
  }
  std::vector<int> tree(count, -1); // the subtree that a supernode belongs to
  subtrees_.clear();
  top_.clear();
  if (all >= 2 * entries_per_share) {
    const auto lighter = [&](int left, int right) { return weight[left] < weight[right]; };
    std::make_heap(roots.begin(), roots.end(), lighter);
    while (!roots.empty() && weight[roots.front()] > all / most_shares) {
      std::pop_heap(roots.begin(), roots.end(), lighter);
      const int root = roots.back();
      roots.pop_back();
      for (int child : children[root]) {
        roots.push_back(child);
        std::push_heap(roots.begin(), roots.end(), lighter);
      }
    }
    std::sort(roots.begin(), roots.end(), [&](int left, int right) { return lighter(right, left); });
    for (int root : roots)
      if (weight[root] * 4 * most_shares > all) {
        tree[root] = std::ssize(subtrees_);
        const Supernode& node = supernodes_[root];
        subtrees_.push_back({{}, node.column + node.columns, Vector::Zero(size), Vector(work_.size())});
      }
  }
  for (int s = count - 1; s >= 0; --s) {
    int& own = tree[s];
    if (own < 0 && parent[s] >= 0) own = tree[parent[s]];
    (own < 0 ? top_ : subtrees_[own].supernodes).push_back(s);
  }
  std::reverse(top_.begin(), top_.end());
  for (Subtree& subtree : subtrees_) std::reverse(subtree.supernodes.begin(), subtree.supernodes.end());
}

template <class Real>
void Supernodes<Real>::solve_lower(const Real* values, const Supernode& node, Vector& x, int end, bool shared,
                                   Vector& above, Vector& work) const {
  const Panel<Real> panel(values + node.values, node.height, node.columns);
  auto own = x.segment(node.column, node.columns);
  panel.topRows(node.columns).template triangularView<Eigen::Lower>().solveInPlace(own);
  in_shares(node, node.height - node.columns, shared, [&](int first, int count) {
    auto update = work.segment(first, count);
    update.noalias() = panel.middleRows(node.columns + first, count) * own;
    const int* const rows = rows_.data() + node.rows + first;
    int k = 0;
    for (; k < count && rows[k] < end; ++k) x(rows[k]) -= update(k);
    for (; k < count; ++k) above(rows[k]) -= update(k);
  });
}

template <class Real>
void Supernodes<Real>::solve_upper(const Real* values, const Supernode& node, Vector& x, bool shared,
                                   Vector& work) const {
  const Panel<Real> panel(values + node.values, node.height, node.columns);
  auto own = x.segment(node.column, node.columns);
  const int below = node.height - node.columns;
  const int* const rows = rows_.data() + node.rows;
  for (int k = 0; k < below; ++k) work(k) = x(rows[k]);
  in_shares(node, node.columns, shared, [&](int first, int count) {
    own.segment(first, count).noalias() -=
        panel.block(node.columns, first, below, count).transpose() * work.head(below);
  });
  panel.topRows(node.columns).transpose().template triangularView<Eigen::Upper>().solveInPlace(own);
}

template <class Real> void Supernodes<Real>::solve_lower(const Real* values, Vector& x) {
  parallel(std::ssize(subtrees_), [&](int t) {
    Subtree& subtree = subtrees_[t];
    subtree.above.setZero();
    for (int s : subtree.supernodes)
      solve_lower(values, supernodes_[s], x, subtree.end, false, subtree.above, subtree.work);
  });
  for (const Subtree& subtree : subtrees_) x += subtree.above;
  for (int s : top_) solve_lower(values, supernodes_[s], x, static_cast<int>(x.size()), true, x, work_);
}

template <class Real> void Supernodes<Real>::solve_upper(const Real* values, Vector& x) {
  for (auto s = top_.rbegin(); s != top_.rend(); ++s) solve_upper(values, supernodes_[*s], x, true, work_);
  parallel(std::ssize(subtrees_), [&](int t) {
    Subtree& subtree = subtrees_[t];
    const std::vector<int>& list = subtree.supernodes;
    for (auto s = list.rbegin(); s != list.rend(); ++s) solve_upper(values, supernodes_[*s], x, false, subtree.work);
  });
}

template class Supernodes<float>;
template class Supernodes<double>;

} // namespace signorini::solve
