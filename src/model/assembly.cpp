#include "model/assembly.hpp"

#include "base/timer.hpp"

#include <algorithm>

namespace signorini::model {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

std::uint64_t key(const contact::Group& group) {
  constexpr int bits = 21; // two million elements on a face
  return (static_cast<std::uint64_t>(group.slave_element) << (2 * bits)) |
         (static_cast<std::uint64_t>(group.master_element) << bits) |
         static_cast<std::uint64_t>(group.slip_element + 1);
}

} // namespace

template <int D>
Assembly<D>::Assembly(const Scene<D>& scene, const Unknowns<D>& unknowns)
    : scene_(scene), unknowns_(unknowns), placements_(scene.contacts.size()), residual_(unknowns.dofs()) {
  build_bulk();
  for (const auto& named : scene_.bodies) arrays_.emplace_back(*named.body);
  cover({});
}

template <int D> void Assembly<D>::build_bulk() {
  std::vector<Nodes> groups;
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
    const solid::Body<D>& body = *scene_.bodies[b].body;
    holds_.emplace_back();
    for (int e = 0; e < body.elements(); ++e) {
      Nodes group;
      for (int function : body.functions_of(e))
        for (int c = 0; c < D; ++c)
          group.push_back(unknowns_.unknown(unknowns_.offset(static_cast<int>(b)) + D * function + c));
      holds_.back().push_back(std::find(group.begin(), group.end(), -1) != group.end());
      groups.push_back(std::move(group));
    }
  }
  bulk_pattern_ = solve::couple(unknowns_.size(), groups);

  // Positions in the order in which scatter walks through ElementArrays::blocks
  const int trash = bulk_pattern_.entries();
  const auto find = [&](int row, int column) {
    return row < 0 || column < 0 ? trash : bulk_pattern_.find(row, column);
  };
  std::size_t g = 0;
  for (const auto& named : scene_.bodies) {
    first_position_.emplace_back();
    for (int e = 0; e < named.body->elements(); ++e, ++g) {
      const Nodes& group = groups[g];
      const int n = named.body->element(e).functions;
      first_position_.back().push_back(bulk_positions_.size());
      for (int i = 0; i < D; ++i)
        for (int j = i; j < D; ++j) {
          for (int a = 0; a < n; ++a)
            for (int b = 0; b < n; ++b) bulk_positions_.push_back(find(group[at(D * a + i)], group[at(D * b + j)]));
          if (i == j) continue;
          for (int a = 0; a < n; ++a)
            for (int b = 0; b < n; ++b) bulk_positions_.push_back(find(group[at(D * b + j)], group[at(D * a + i)]));
        }
    }
  }
}

template <int D>
void Assembly<D>::append_dofs(const FaceReference& face, const contact::Surface<D>& surface, int element,
                              Nodes& dofs) const {
  const int* nodes = surface.nodes(element);
  for (int a = 0; a < surface.functions_per_element(); ++a)
    for (int c = 0; c < D; ++c) dofs.push_back(unknowns_.offset(face.body) + D * surface.body_function(nodes[a]) + c);
}

template <int D>
typename Assembly<D>::Nodes Assembly<D>::columns(const Contact& contact, const contact::Pair<D>& pair,
                                                 const contact::Group& group) const {
  Nodes dofs;
  append_dofs(contact.slave, pair.slave(), group.slave_element, dofs);
  append_dofs(contact.master, pair.master(), group.master_element, dofs);
  if (group.slip_element >= 0) append_dofs(contact.master, pair.master(), group.slip_element, dofs);
  return dofs;
}

/// Makes the pattern cover the bulk, all present contact groups, and the master elements next to those: so that sliding
/// on by part of an element does not need a new pattern.
template <int D> void Assembly<D>::cover(const std::vector<contact::Pair<D>>& pairs) {
  std::vector<Nodes> groups;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    for (const contact::Group& group : pairs[k].groups()) {
      Nodes dofs = columns(scene_.contacts[k], pairs[k], group);
      for (int alpha = 0; alpha < D - 1; ++alpha)
        for (bool at_end : {false, true}) {
          const int next = pairs[k].master().neighbour(group.master_element, alpha, at_end);
          if (next >= 0) append_dofs(scene_.contacts[k].master, pairs[k].master(), next, dofs);
        }
      for (int& dof : dofs) dof = unknowns_.unknown(dof);
      groups.push_back(std::move(dofs));
    }
  std::vector<int> moved;
  pattern_ = solve::extend(bulk_pattern_, groups, moved);
  moved.push_back(pattern_.entries());
  positions_.resize(bulk_positions_.size());
  for (std::size_t i = 0; i < positions_.size(); ++i) positions_[i] = moved[at(bulk_positions_[i])];
  diagonal_.clear();
  for (int i = 0; i < pattern_.size; ++i) diagonal_.push_back(pattern_.find(i, i));
  values_.resize(at(pattern_.entries()) + 1);
  for (auto& placements : placements_) placements.clear();
  ++version_;
}

/// Finds the places of all present groups; false when the pattern does not hold them.
template <int D> bool Assembly<D>::locate(const std::vector<contact::Pair<D>>& pairs) {
  for (std::size_t k = 0; k < pairs.size(); ++k)
    for (const contact::Group& group : pairs[k].groups()) {
      Placement& placement = placements_[k][key(group)];
      if (!placement.positions.empty()) continue;
      placement.columns = columns(scene_.contacts[k], pairs[k], group);
      placement.rows.assign(placement.columns.begin(), placement.columns.begin() + group.rows);
      std::vector<int> positions;
      for (int row : placement.rows)
        for (int column : placement.columns) {
          const int i = unknowns_.unknown(row), j = unknowns_.unknown(column);
          positions.push_back(i < 0 || j < 0 ? pattern_.entries() : pattern_.find(i, j));
          if (positions.back() < 0) return false;
        }
      placement.positions = std::move(positions);
    }
  return true;
}

template <int D>
std::optional<BodyInversion> Assembly<D>::assemble(std::vector<contact::Pair<D>>& pairs, const VectorX& displacement,
                                                   const VectorX* increment, bool tangent, Timings& timings) {
  residual_.setZero();
  {
    ScopedTimer timer(timings.contact);
    for (std::size_t k = 0; k < pairs.size(); ++k)
      pairs[k].evaluate(displacement.data() + unknowns_.offset(scene_.contacts[k].slave.body),
                        displacement.data() + unknowns_.offset(scene_.contacts[k].master.body), tangent);
    if (!locate(pairs)) {
      cover(pairs);
      locate(pairs);
    }
  }
  {
    ScopedTimer timer(timings.bulk);
    if (tangent) std::fill(values_.begin(), values_.end(), 0.0);
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
      const solid::Body<D>& body = *scene_.bodies[b].body;
      const int offset = unknowns_.offset(static_cast<int>(b));
      solid::ElementArrays<D>& arrays = arrays_[b];
      for (int e = 0; e < body.elements(); ++e) {
        if (auto inversion = internal_force(body, e, displacement.data() + offset, arrays, tangent))
          return BodyInversion{static_cast<int>(b), *inversion};
        const auto functions = body.functions_of(e);
        const std::size_t n = functions.size();
        for (std::size_t a = 0; a < n; ++a)
          for (std::size_t i = 0; i < D; ++i)
            residual_(offset + D * functions[a] + static_cast<int>(i)) += arrays.force[i * n + a];
        if (!tangent) continue;
        const int* position = positions_.data() + first_position_[b][at(e)];
        const double* block = arrays.blocks.data();
        for (int i = 0; i < D; ++i)
          for (int j = i; j < D; ++j, block += n * n)
            for (int twin = 0; twin < (i == j ? 1 : 2); ++twin, position += n * n)
              for (std::size_t k = 0; k < n * n; ++k) values_[at(position[k])] += block[k];
        if (increment && holds_[b][at(e)]) add_bulk_increment(static_cast<int>(b), e, arrays, *increment);
      }
    }
  }
  ScopedTimer timer(timings.contact);
  add_contacts(pairs, increment, tangent);
  if (tangent) find_largest_diagonal();
  return std::nullopt;
}

template <int D>
void Assembly<D>::add_bulk_increment(int b, int e, const solid::ElementArrays<D>& arrays, const VectorX& increment) {
  const auto functions = scene_.bodies[at(b)].body->functions_of(e);
  const int n = static_cast<int>(functions.size()), offset = unknowns_.offset(b);
  const auto dof = [&](int a, int i) { return offset + D * functions[at(a)] + i; };
  const double* block = arrays.blocks.data();
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j, block += n * n)
      for (int a = 0; a < n; ++a)
        for (int c = 0; c < n; ++c) {
          residual_(dof(a, i)) += block[a * n + c] * increment(dof(c, j));
          if (i != j) residual_(dof(c, j)) += block[a * n + c] * increment(dof(a, i));
        }
}

template <int D>
void Assembly<D>::add_contacts(const std::vector<contact::Pair<D>>& pairs, const VectorX* increment, bool tangent) {
  for (std::size_t k = 0; k < pairs.size(); ++k)
    for (const contact::Group& group : pairs[k].groups()) {
      const Placement& placement = placements_[k].find(key(group))->second;
      const double* matrix = group.matrix.data();
      const int* position = placement.positions.data();
      for (int r = 0; r < group.rows; ++r, matrix += group.columns, position += group.columns) {
        double sum = group.force[at(r)];
        if (increment)
          for (int c = 0; c < group.columns; ++c) sum += matrix[c] * (*increment)(placement.columns[at(c)]);
        residual_(placement.rows[at(r)]) += sum;
        if (!tangent) continue;
        for (int c = 0; c < group.columns; ++c) values_[at(position[c])] += matrix[c];
      }
    }
}

template <int D> void Assembly<D>::find_largest_diagonal() {
  largest_diagonal_ = 0;
  for (int position : diagonal_) largest_diagonal_ = std::max(largest_diagonal_, values_[at(position)]);
}

template class Assembly<2>;

} // namespace signorini::model
