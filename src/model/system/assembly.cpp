#include "model/system/assembly.hpp"

#include "model/system/free_angles.hpp"
#include "os/parallel.hpp"
#include "os/timer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::model {

namespace {

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

} // namespace

template <int D>
Assembly<D>::Assembly(const Scene<D>& scene, const Unknowns<D>& unknowns, const contact::Formulations<D>& contacts,
                      const contact::Ties<D>& ties, const FollowerLoads<D>& followers, const Springs<D>& springs)
    : scene_(scene), unknowns_(unknowns), contacts_(contacts), followers_(followers), springs_(springs),
      ties_(tie_terms(scene, unknowns, ties)), border_(tie_border(scene, unknowns, ties)), placements_(contacts.size()),
      is_contact_unknown_(unknowns.size(), false), product_(unknowns.dofs()) {
  for (const auto& named : scene_.bodies) linear_ = linear_ && named.body->linear();
  for (std::size_t b = 0; b < scene_.bodies.size() && !linear_; ++b) {
    const solid::Body<D>& body = *scene_.bodies[b].body;
    partitions_.push_back(partition(unknowns_, body, unknowns_.offset(static_cast<int>(b))));
    arrays_.insert(arrays_.end(), partitions_.back().heads.size(), solid::ElementArrays<D>(body));
  }
  if (linear_) build_stiffness();
  // Bodies have no stiffness at the unknowns of obstacles, which their factors must not contain.
  for (int dof = unknowns.obstacles(); dof < unknowns.displacements(); ++dof)
    if (const int i = unknowns.unknown(dof); i >= 0) border_.push_back(i);
  build_bulk();
  cover(false);
  forget_contact_unknowns();
}

/// Adds the ties' constant tangent.
template <int D> void Assembly<D>::add_ties(double* values) const {
  for (std::size_t k = 0; k < tie_positions_.size(); ++k)
    if (tie_positions_[k] >= 0) values[tie_positions_[k]] += ties_.couplings[k / 2].value;
  for (const auto& [multiplier, value] : ties_.proximal) values[diagonal_[unknowns_.unknown(multiplier)]] += value;
}

template <int D>
std::optional<BodyInversion> Assembly<D>::assemble(const States<D>& states, const VectorX* direction, bool tangent,
                                                   Timings& timings) {
  const Request request{states, direction, tangent};
  const std::optional<BodyInversion> inverted = add_bulk(request, timings);
  if (inverted) return inverted;
  ScopedTimer timer(timings.contact);
  watch_contacts();
  add_contacts(request);
  ties_.multiply(states.present.displacement, states.present.force);
  springs_.multiply(states.present.displacement, states.present.force);
  if (direction) ties_.multiply(*direction, product_);
  if (direction) springs_.multiply(*direction, product_);
  if (direction) add_moments(unknowns_, states.present.displacement, product_);
  if (tangent) add_angles(request);
  if (tangent) add_followers(request);
  if (tangent) find_diagonal_norm();
  return std::nullopt;
}

/// Assembly of a share of a body, or of a whole linear body, and the time for it.
template <int D> struct Assembly<D>::Task {
  std::size_t body, share;
  solid::ElementArrays<D>* arrays; ///< not of a linear body
  double seconds = 0;
  std::optional<BodyInversion> inverted = {};
};

/// Evaluates the contacts and assembles all bodies. Contacts and shares of bodies are parallel tasks; if the contacts
/// then need a new pattern, the bodies are assembled again.
template <int D> std::optional<BodyInversion> Assembly<D>::add_bulk(const Request& request, Timings& timings) {
  std::vector<Task> tasks;
  for (std::size_t b = 0; b < stiffness_.size(); ++b) tasks.push_back({b, 0, nullptr});
  for (std::size_t b = 0; b < partitions_.size(); ++b)
    for (std::size_t share = 0; share < partitions_[b].heads.size(); ++share)
      tasks.push_back({b, share, &arrays_[tasks.size()]});
  const auto& [present, accepted, controls, loads] = request.states;
  struct ContactTask {
    std::size_t contact;
    int part;
    double seconds = 0;
  };
  std::vector<ContactTask> contact_tasks;
  std::vector<contact::Trial<D>> trials;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    trials.push_back({present.contacts[k], accepted.contacts[k], controls[k], present.penalty_factor,
                      present.displacement.data() + unknowns_.of_contact(k).extra});
    for (int part = 0; part < contacts_[k]->parts(); ++part) contact_tasks.push_back({k, part});
  }
  const auto add_heads = [&](int contacts) {
    clear(request);
    parallel(static_cast<int>(contacts + tasks.size()), [&](int i) {
      if (i < contacts) {
        ContactTask& task = contact_tasks[i];
        ScopedTimer timer(task.seconds);
        return contacts_[task.contact]->evaluate_part(task.part, trials[task.contact], request.tangent);
      }
      Task& task = tasks[i - contacts];
      if (linear_) return add_linear_body(request, task);
      add_elements(partitions_[task.body].heads[task.share], request, task);
    });
  };

  const Stopwatch watch;
  move(present.displacement);
  add_heads(contact_tasks.size());
  double gathering = 0;
  {
    ScopedTimer timer(gathering);
    for (std::size_t k = 0; k < contacts_.size(); ++k) contacts_[k]->gather(trials[k], request.tangent);
  }
  if (!locate()) {
    cover(true);
    locate();
    if (linear_)
      set_values(request);
    else
      add_heads(0);
  }
  if (!linear_) {
    parallel(std::ssize(tasks), [&](int i) {
      Task& task = tasks[i];
      add_elements(partitions_[task.body].tails[task.share], request, task);
    });
    for (Task& task : tasks)
      if (task.share == 0) add_elements(partitions_[task.body].rest, request, task);
  }

  // The elapsed time is divided in proportion to the times of the tasks.
  double bulk = 0, contact = gathering;
  for (const Task& task : tasks) bulk += task.seconds;
  for (const ContactTask& task : contact_tasks) contact += task.seconds;
  const double scale = watch.seconds() / (bulk + contact);
  timings.bulk += scale * bulk;
  timings.contact += scale * contact;
  for (const Task& task : tasks)
    if (task.inverted) return task.inverted;
  return std::nullopt;
}

template <int D> void Assembly<D>::clear(const Request& request) {
  request.states.present.force.setZero();
  if (request.direction) product_.setZero();
  set_values(request);
}

template <int D> void Assembly<D>::add_elements(const std::vector<int>& elements, const Request& request, Task& task) {
  ScopedTimer timer(task.seconds);
  for (int e : elements)
    if (!task.inverted) add_element(e, request, task);
}

/// Adds a linear body's force K u and, if there is a direction, the product with it.
template <int D> void Assembly<D>::add_linear_body(const Request& request, Task& task) {
  ScopedTimer timer(task.seconds);
  const int offset = unknowns_.offset(static_cast<int>(task.body));
  const auto& [present, accepted, controls, loads] = request.states;
  const solve::SymmetricBlocks<D>& stiffness = stiffness_[task.body];
  stiffness.multiply(present.displacement.data() + offset, present.force.data() + offset);
  if (request.direction) stiffness.multiply(request.direction->data() + offset, product_.data() + offset);
}

template <int D> void Assembly<D>::add_element(int e, const Request& request, Task& task) {
  const int b = static_cast<int>(task.body), offset = unknowns_.offset(b);
  const solid::Body<D>& body = *scene_.bodies[task.body].body;
  solid::ElementArrays<D>& arrays = *task.arrays;
  const bool multiplies = request.direction && supports_[task.body][e].any;
  const double* displacement = request.states.present.displacement.data() + offset;
  if (const auto inversion =
          internal_force(body, e, displacement, arrays, request.tangent || multiplies,
                         request.states.accepted.internal[task.body], request.states.present.internal[task.body])) {
    task.inverted = BodyInversion{b, *inversion};
    return;
  }
  const auto functions = body.functions_of_macro(e);
  const std::size_t n = functions.size();
  VectorX& force = request.states.present.force;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t i = 0; i < D; ++i)
      force(offset + D * functions[a] + static_cast<int>(i)) += arrays.force[i * n + a];
  if (request.tangent) scatter(b, e, arrays);
  if (multiplies) multiply(b, e, arrays, *request.direction);
}

/// Positions are those of add_nodes() or, if not all nodes are whole, of every entry: of K_ij, i ≤ j, and of K_ji.
template <int D> void Assembly<D>::scatter(int b, int e, const solid::ElementArrays<D>& arrays) {
  const std::size_t n = scene_.bodies[b].body->functions_of_macro(e).size();
  const int* position = positions_.data() + first_position_[b][e];
  const double* block = arrays.blocks.data();
  double* const values = values_.data();
  if (supports_[b][e].whole) return add_nodes<D>(n, position, block, values, std::make_index_sequence<D>());
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j, block += n * n)
      for (int twin = 0; twin < (i == j ? 1 : 2); ++twin, position += n * n)
        for (std::size_t k = 0; k < n * n; ++k) values[position[k]] += block[k];
}

/// Adds the element's tangent times `direction` to product().
template <int D>
void Assembly<D>::multiply(int b, int e, const solid::ElementArrays<D>& arrays, const VectorX& direction) {
  const auto functions = scene_.bodies[b].body->functions_of_macro(e);
  const int n = std::ssize(functions), offset = unknowns_.offset(b);
  const auto dof = [&](int a, int i) { return offset + D * functions[a] + i; };
  const double* block = arrays.blocks.data();
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j, block += n * n)
      for (int a = 0; a < n; ++a)
        for (int c = 0; c < n; ++c) {
          product_(dof(a, i)) += block[a * n + c] * direction(dof(c, j));
          if (i != j) product_(dof(c, j)) += block[a * n + c] * direction(dof(a, i));
        }
}

/// Adds the part of the tangent of free angles that is due to the path of their markers.
template <int D> void Assembly<D>::add_angles(const Request& request) {
  const auto& [displacement, targets, force, factor, contacts, internal] = request.states.present;
  if (!unknowns_.free_angles().empty()) changed_.reset();
  for (const FreeAngle<D>& angle : unknowns_.free_angles())
    values_[diagonal_[unknowns_.unknown(angle.dof)]] += angle_curvature(angle, displacement, force);
}

template <int D> void Assembly<D>::add_contacts(const Request& request) {
  VectorX& force = request.states.present.force;
  const bool turns = request.tangent && !unknowns_.free_angles().empty();
  const VectorX rates = turns ? angle_rates(unknowns_, request.states.present.displacement) : VectorX();
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    for (const contact::Block& block : contacts_[k]->blocks()) {
      const Placement& placement = placements_[k].find(block.key())->second;
      const double* matrix = block.matrix.data();
      for (int r = 0; r < block.rows; ++r) {
        force(placement.rows[r]) += block.force[r];
        for (int c = 0; c < block.columns && request.direction; ++c)
          product_(placement.rows[r]) += matrix[r * block.columns + c] * (*request.direction)(placement.columns[c]);
      }
      if (!request.tangent) continue;
      const int* position = placement.positions.data();
      for (const auto& [first, count] : placement.runs)
        for (int c = 0; c < block.columns; ++c, ++position) {
          if (*position < 0) continue;
          double* const to = values_.data() + *position;
          const double* const from = matrix + first * block.columns + c;
          for (int k = 0; k < count && !turns; ++k) to[k] += from[k * block.columns];
          for (int k = 0; k < count && turns; ++k)
            to[k] += rates(placement.rows[first + k]) * from[k * block.columns] * rates(placement.columns[c]);
          for (int k = 0; k < count && changed_; ++k) changed_->push_back(*position + k);
        }
    }
}

template <int D> void Assembly<D>::find_diagonal_norm() {
  double sum = 0;
  for (int position : diagonal_) sum += values_[position] * values_[position];
  diagonal_norm_ = std::sqrt(sum);
}

template <int D> VectorX Assembly<D>::diagonal() const {
  VectorX result(diagonal_.size());
  for (std::size_t i = 0; i < diagonal_.size(); ++i) result(static_cast<Eigen::Index>(i)) = values_[diagonal_[i]];
  return result;
}

template <int D> void Assembly<D>::add_diagonal(const VectorX& shift) {
  changed_.reset();
  for (std::size_t i = 0; i < diagonal_.size(); ++i) values_[diagonal_[i]] += shift(static_cast<Eigen::Index>(i));
}

template <int D> double Assembly<D>::memory() const {
  const auto bytes = [](const auto& list) { return static_cast<double>(list.capacity() * sizeof(list[0])); };
  double sum = bytes(values_) + bytes(constant_) + bytes(constant_positions_) + bytes(positions_) +
               bytes(bulk_positions_) + bytes(ties_.couplings) + bytes(tie_positions_) + bytes(follower_positions_) +
               bytes(spring_positions_);
  for (const auto& stiffness : stiffness_) sum += stiffness.memory();
  for (const solve::Pattern* pattern : {&bulk_pattern_, &pattern_})
    sum += bytes(pattern->starts) + bytes(pattern->rows);
  for (const auto& placements : placements_)
    for (const auto& [groups, placement] : placements) sum += bytes(placement.positions);
  return sum;
}

template <int D> void Assembly<D>::move(const VectorX& displacement) const {
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    contacts_[k]->move(displacement.data(), displacement.data() + unknowns_.of_contact(k).master);
}

template class Assembly<2>;
template class Assembly<3>;

} // namespace signorini::model
