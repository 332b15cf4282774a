#include "model/system/bulk_assembly.hpp"

#include "os/parallel.hpp"
#include "os/timer.hpp"

#include <algorithm>
#include <utility>

namespace signorini::model {

namespace {

/// Computes the stiffness of linear bodies. It depends on the bodies alone: not on supports, contacts or patterns.
template <int D> std::vector<solve::SymmetricBlocks<D>> stiffness_of(const Scene<D>& scene) {
  std::vector<solve::SymmetricBlocks<D>> stiffness;
  for (const auto& named : scene.bodies) {
    const solid::Body<D>& body = *named.body;
    std::vector<std::vector<int>> groups;
    for (int e = 0; e < body.macro_elements(); ++e) {
      const auto functions = body.functions_of_macro(e);
      groups.emplace_back(functions.begin(), functions.end());
    }
    stiffness.emplace_back(body.functions(), groups);
    const VectorX rest = VectorX::Zero(D * body.functions());
    solid::ElementArrays<D> arrays(body);
    for (int e = 0; e < body.macro_elements(); ++e) {
      internal_force(body, e, rest.data(), arrays);
      stiffness.back().add(body.functions_of_macro(e), arrays.blocks.data());
    }
  }
  return stiffness;
}

/// True if at every node of an element either no component is an unknown, or all are, with consecutive numbers: then
/// the entries of a node's rows follow each other in every column of the tangent.
template <int D> bool whole_nodes(const std::vector<int>& unknowns) {
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const int first = unknowns[k - k % D];
    if (unknowns[k] != (first < 0 ? -1 : first + static_cast<int>(k % D))) return false;
  }
  return true;
}

/// Adds the element blocks K_ij, i ≤ j, to the rows (a, i), i < D, of the columns (b, j); `position` of row (a, 0), a
/// fastest, then j.
template <int D, std::size_t... I>
void add_nodes(std::size_t n, const int* position, const double* blocks, double* values, std::index_sequence<I...>) {
  const double* block[D][D];
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = i; j < D; ++j, blocks += n * n) block[i][j] = blocks;
  for (std::size_t b = 0; b < n; ++b)
    for (std::size_t j = 0; j < D; ++j) {
      // K_ij(a, b) at a n + b, of K_ji(b, a) at b n + a
      const double* const from[] = {(I <= j ? block[I][j] + b : block[j][I] + b * n)...};
      const std::size_t stride[] = {(I <= j ? n : 1)...};
      for (std::size_t a = 0; a < n; ++a) {
        double* const to = values + *position++;
        ((to[I] += from[I][a * stride[I]]), ...);
      }
    }
}

/// Adds an element's tangent. Positions are those of add_nodes() or, if not all nodes are whole, of every entry: of
/// K_ij, i ≤ j, and of K_ji.
template <int D> void scatter(std::size_t n, bool whole, const int* position, const double* block, double* values) {
  if (whole) return add_nodes<D>(n, position, block, values, std::make_index_sequence<D>());
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j, block += n * n)
      for (int twin = 0; twin < (i == j ? 1 : 2); ++twin, position += n * n)
        for (std::size_t k = 0; k < n * n; ++k) values[position[k]] += block[k];
}

/// Calls use(row, column) for the entries of an element of n nodes in the order of the positions for scatter().
template <int D, class Use> void visit_positions(int n, bool whole, const Use& use) {
  for (int column = 0; column < D * n && whole; ++column)
    for (int a = 0; a < n; ++a) use(D * a, column);
  for (int i = 0; i < D && !whole; ++i)
    for (int j = i; j < D; ++j)
      for (int twin = 0; twin < (i == j ? 1 : 2); ++twin)
        for (int a = 0; a < n; ++a)
          for (int b = 0; b < n; ++b) twin ? use(D * b + j, D * a + i) : use(D * a + i, D * b + j);
}

/// Adds an element's tangent times `direction` to the product; `offset`: the body's first degree of freedom.
template <int D, class Functions>
void multiply(const Functions& functions, int offset, const double* block, const VectorX& direction, VectorX& product) {
  const int n = std::ssize(functions);
  const auto dof = [&](int a, int i) { return offset + D * functions[a] + i; };
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j, block += n * n)
      for (int a = 0; a < n; ++a)
        for (int c = 0; c < n; ++c) {
          product(dof(a, i)) += block[a * n + c] * direction(dof(c, j));
          if (i != j) product(dof(c, j)) += block[a * n + c] * direction(dof(a, i));
        }
}

} // namespace

template <int D>
BulkAssembly<D>::BulkAssembly(const Scene<D>& scene, const Unknowns<D>& unknowns, const TieTerms& ties)
    : scene_(scene), unknowns_(unknowns), accounts_(scene.bodies.size()) {
  const auto& bodies = scene.bodies;
  const bool linear = std::ranges::all_of(bodies, [](const auto& named) { return named.body->linear(); });
  if (linear) stiffness_ = stiffness_of(scene);
  const std::vector<char> of_several = of_several_bodies(scene, unknowns);
  std::vector<std::vector<int>> groups; // unknowns of each element
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const solid::Body<D>& body = *bodies[b].body;
    const int offset = unknowns.offset(static_cast<int>(b));
    if (linear) {
      tasks_.push_back({b, 0, solid::ElementArrays<D>(body)});
    } else {
      partitions_.push_back(partition(unknowns, body, offset, of_several));
      for (std::size_t share = 0; share < partitions_.back().heads.size(); ++share)
        tasks_.push_back({b, share, solid::ElementArrays<D>(body)});
    }
    elements_.emplace_back();
    for (int e = 0; e < body.macro_elements(); ++e) {
      std::vector<int> group;
      bool supported = false;
      const auto functions = body.functions_of_macro(e);
      group.reserve(D * functions.size());
      for (int function : functions)
        for (int c = 0; c < D; ++c) {
          const int dof = offset + D * function + c;
          group.push_back(unknowns.unknown(dof));
          supported = supported || unknowns.constrained(dof);
        }
      if (!linear) elements_.back().push_back({supported, whole_nodes<D>(group), 0});
      groups.push_back(std::move(group));
    }
  }
  for (const auto& [multiplier, displacement, value] : ties.couplings)
    groups.push_back({unknowns.unknown(multiplier), unknowns.unknown(displacement)});
  pattern_ = solve::couple(unknowns.size(), groups);
  if (!linear) find_positions(groups);
}

template <int D> void BulkAssembly<D>::find_positions(const std::vector<std::vector<int>>& groups) {
  std::size_t positions = 0;
  auto group = groups.begin();
  for (auto& elements : elements_)
    for (Element& element : elements) {
      element.first_position = positions;
      positions += group->size() * group->size() / (element.whole ? D : 1);
      ++group;
    }
  own_positions_.reserve(positions);
  std::vector<int> found; // of an element, column by column
  group = groups.begin();
  int first_scratch = pattern_.entries();
  for (std::size_t b = 0; b < elements_.size(); ++b) {
    const Partition& shares = partitions_[b];
    for (std::size_t e = 0; e < elements_[b].size(); ++e, ++group) {
      const int scratch = first_scratch + D * shares.share[e];
      found.clear();
      for (const int column : *group) {
        int before = -2, position = 0; // the last unknown, and its position
        for (const int row : *group) {
          if (row < 0 || column < 0) {
            found.push_back(scratch);
            continue;
          }
          // Unknowns with consecutive numbers, such as a node's free components, follow each other in every column.
          position = row == before + 1 ? position + 1 : pattern_.find(row, column);
          before = row;
          found.push_back(position);
        }
      }
      const int n = std::ssize(*group) / D;
      visit_positions<D>(n, elements_[b][e].whole,
                         [&](int row, int column) { own_positions_.push_back(found[column * D * n + row]); });
    }
    first_scratch += D * static_cast<int>(shares.heads.size());
  }
}

template <int D> int BulkAssembly<D>::scratch_entries() const {
  return stiffness_.empty() ? D * static_cast<int>(tasks_.size()) : 0;
}

template <int D> void BulkAssembly<D>::locate(const std::vector<int>& moved) {
  positions_.resize(own_positions_.size());
  for (std::size_t i = 0; i < positions_.size(); ++i) positions_[i] = moved[own_positions_[i]];
}

template <int D> void BulkAssembly<D>::start() {
  for (Task& task : tasks_) {
    task.seconds = 0;
    task.inverted.reset();
  }
}

template <int D> void BulkAssembly<D>::add_head(std::size_t index, const Evaluation<D>& evaluation) {
  Task& task = tasks_[index];
  if (stiffness_.empty()) return add_elements(partitions_[task.body].heads[task.share], evaluation, task);
  ScopedTimer timer(task.seconds);
  const int offset = unknowns_.offset(static_cast<int>(task.body));
  const auto multiply = [&](const VectorX& from, VectorX& to) {
    stiffness_[task.body].multiply(from.data() + offset, to.data() + offset);
  };
  multiply(evaluation.states.present.displacement, evaluation.states.present.force);
  if (evaluation.direction) multiply(*evaluation.direction, evaluation.product);
}

template <int D> void BulkAssembly<D>::add_tails(const Evaluation<D>& evaluation) {
  if (!stiffness_.empty()) return;
  parallel(std::ssize(tasks_), [&](int i) {
    Task& task = tasks_[i];
    add_elements(partitions_[task.body].tails[task.share], evaluation, task);
  });
  for (Task& task : tasks_)
    if (task.share == 0) add_elements(partitions_[task.body].rest, evaluation, task);
}

template <int D>
void BulkAssembly<D>::add_elements(const std::vector<int>& elements, const Evaluation<D>& evaluation, Task& task) {
  ScopedTimer timer(task.seconds);
  for (int e : elements)
    if (!task.inverted) add_element(e, evaluation, task);
}

template <int D> void BulkAssembly<D>::add_element(int e, const Evaluation<D>& evaluation, Task& task) {
  const int b = static_cast<int>(task.body), offset = unknowns_.offset(b);
  const solid::Body<D>& body = *scene_.bodies[b].body;
  const auto& [present, accepted, controls, loads, before] = evaluation.states;
  const auto& [supported, whole, first_position] = elements_[b][e];
  const bool multiplies = evaluation.direction && supported;
  if (const auto inversion =
          internal_force(body, e, present.displacement.data() + offset, task.arrays, evaluation.tangent || multiplies,
                         {accepted.internal[b], present.internal[b], duration(evaluation.states)},
                         before ? before->data() + offset : nullptr)) {
    task.inverted = BodyInversion{b, *inversion};
    return;
  }
  const auto functions = body.functions_of_macro(e);
  const std::size_t n = functions.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t i = 0; i < D; ++i)
      present.force(offset + D * functions[a] + static_cast<int>(i)) += task.arrays.force[i * n + a];
  const double* blocks = task.arrays.blocks.data();
  if (evaluation.tangent)
    scatter<D>(n, whole, positions_.data() + first_position, blocks, evaluation.matrix.values.data());
  if (multiplies) multiply<D>(functions, offset, blocks, *evaluation.direction, evaluation.product);
}

template <int D>
solid::Account BulkAssembly<D>::account(int index, const VectorX& displacement,
                                        const std::vector<std::vector<double>>& internal) const {
  const solid::Body<D>& body = *scene_.bodies[index].body;
  const Eigen::Map<const VectorX> own(displacement.data() + unknowns_.offset(index), D * body.functions());
  if (stiffness_.empty()) {
    KnownAccount& known = accounts_[index];
    if (known.displacement.size() != own.size() || known.displacement != own || known.internal != internal[index])
      known = {own, internal[index], solid::account(body, own.data(), internal[index])};
    return known.account;
  }
  // ½ u·K u
  VectorX force = VectorX::Zero(own.size());
  stiffness_[index].multiply(own.data(), force.data());
  return {0.5 * force.dot(own), 0};
}

template <int D>
solid::Account BulkAssembly<D>::account(const VectorX& displacement,
                                        const std::vector<std::vector<double>>& internal) const {
  solid::Account sum;
  for (int b = 0; b < std::ssize(scene_.bodies); ++b) {
    const solid::Account own = account(b, displacement, internal);
    sum.stored += own.stored;
    sum.viscous += own.viscous;
  }
  return sum;
}

template <int D> double BulkAssembly<D>::memory() const {
  double sum = bytes_of(own_positions_) + bytes_of(positions_) + bytes_of(pattern_.starts) + bytes_of(pattern_.rows);
  for (const auto& stiffness : stiffness_) sum += stiffness.memory();
  return sum;
}

template class BulkAssembly<2>;
template class BulkAssembly<3>;

} // namespace signorini::model
