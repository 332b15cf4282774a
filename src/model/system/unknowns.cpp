#include "model/system/unknowns.hpp"

#include "base/error.hpp"
#include "model/scene/contact_faces.hpp"
#include "model/scene/turning.hpp"

#include <algorithm>

namespace signorini::model {

namespace {

/// Message code of the constraint of a component.
template <int D> const char* verb(const Support<D>& support, int component) {
  if (support.freed[component] && support.constraint[component] == Constraint::free) return "model.verb.frees";
  if (support.rotates) return "model.verb.turns";
  return support.constraint[component] == Constraint::driven ? "model.verb.drives" : "model.verb.fixes";
}

} // namespace

std::string component_name(int component) {
  return std::string(1, static_cast<char>('x' + component));
}

template <int D>
Unknowns<D>::Unknowns(const Scene<D>& scene, const contact::Formulations<D>& contacts, const contact::Ties<D>& ties) {
  int count = 0;
  for (const auto& body : scene.bodies) {
    offsets_.push_back(count);
    count += D * body.body->functions();
  }
  obstacles_ = count;
  check_obstacles(scene);
  for (int k = 0; k < std::ssize(scene.obstacles); ++k) {
    obstacle_offsets_.push_back(count);
    count += D;
    const auto turn = turn_of(scene, k);
    if (turn && turn->free) free_angles_.push_back({k, count + D * D, count, turn->axis, turn->turning.arm});
    if (turn) count += D * (turn->free ? D + 1 : D);
  }

  // Coincident control points of a body, and those of joined faces, share the unknowns of the first of them.
  const std::vector<std::vector<int>> mates = coincident_points(scene).all();
  std::vector<int> group_of(count / D, -1);
  for (std::size_t group = 0; group < mates.size(); ++group)
    for (int member : mates[group]) group_of[member] = static_cast<int>(group);

  // The support of each degree of freedom
  std::vector<const Support<D>*> support_of(count, nullptr);
  for (const Support<D>& support : scene.supports)
    for (int c = 0; c < D; ++c) {
      const Constraint constraint = support.constraint[c];
      std::vector<int> list;
      for (const SupportedControlPoints& points : support.on)
        for (int function : points.functions) list.push_back(offset(points.body) + D * function + c);
      for (int obstacle : support.obstacles) list.push_back(obstacle_offset(obstacle) + c);
      for (std::size_t i = 0, own = list.size(); i < own; ++i)
        if (const int group = group_of[list[i] / D]; group >= 0)
          for (int member : mates[group]) list.push_back(D * member + c);
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      if (constraint != Constraint::free || support.rotates || support.freed[c])
        for (int dof : list) {
          // Control points that a support does not constrain are free; of obstacles the translation that it frees.
          const bool moved = dof < obstacles_ ? support.rotates : support.freed[c];
          if (constraint == Constraint::free && !moved) continue;
          const Support<D>*& other = support_of[dof];
          const bool both_fixed = constraint == Constraint::fixed && !support.rotates &&
                                  (!other || (other->constraint[c] == constraint && !other->rotates));
          if (other && !both_fixed)
            fail(dof < obstacles_ ? "model.scene.constrained_twice" : "model.scene.moved_twice",
                 {{"support", support.name},
                  {"verb", Message(verb(support, c))},
                  {"component", component_name(c)},
                  {"other", other->name},
                  {"other_verb", Message(verb(*other, c))}});
          other = &support;
        }
      of_support_.push_back(std::move(list));
    }

  std::vector<std::array<int, D>> shared(scene.supports.size());
  for (auto& list : shared) list.fill(-1);
  for (int dof = 0; dof < count; ++dof) {
    const Support<D>* support = support_of[dof];
    const int c = dof % D; // every body and obstacle has D components per control point
    constrained_.push_back(support != nullptr || dof >= obstacles_);
    if (dof >= obstacles_) {
      const bool freed = support && support->constraint[c] == Constraint::free;
      unknown_.push_back(freed ? size_++ : -1);
      constrained_.back() = !freed;
    } else if (!support) {
      const int group = group_of[dof / D], lead = group < 0 ? dof : D * mates[group].front() + c;
      unknown_.push_back(lead < dof ? unknown(lead) : size_++);
    } else if (support->rotates && support->constraint[c] == Constraint::free) {
      int& unknown = shared[support - scene.supports.data()][c];
      if (unknown < 0) unknown = size_++;
      unknown_.push_back(unknown);
    } else {
      unknown_.push_back(-1);
    }
  }
  for (const FreeAngle<D>& angle : free_angles_) {
    unknown_[angle.dof] = size_++;
    std::fill_n(constrained_.begin() + angle.markers, D * D + 1, false);
  }
  displacements_ = count;
  free_displacements_ = size_;
  std::vector<int> owner(size_, -1);
  of_several_bodies_.assign(size_, false);
  for (int b = 0; b < std::ssize(scene.bodies); ++b)
    for (int dof = offset(b), end = dof + D * scene.bodies[b].body->functions(); dof < end; ++dof)
      if (const int i = unknown(dof); i >= 0) {
        if (owner[i] >= 0 && owner[i] != b) of_several_bodies_[i] = any_of_several_bodies_ = true;
        owner[i] = b;
      }
  const auto add = [&](int further) {
    for (int i = 0; i < further; ++i) {
      constrained_.push_back(false);
      unknown_.push_back(size_++);
    }
  };
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact<D>& contact = scene.contacts[k];
    const auto* obstacle = std::get_if<ObstacleReference>(&contact.master);
    of_contacts_.push_back({obstacle ? obstacle_offset(obstacle->obstacle) : 0, dofs()});
    add(contacts[k]->extra_unknowns());
  }
  for (const contact::Tie<D>& tie : ties) {
    of_ties_.push_back(dofs());
    add(tie.multipliers());
  }
  if (!free_angles_.empty()) movers_ = unknown_;
  for (const FreeAngle<D>& angle : free_angles_)
    std::fill_n(movers_.begin() + angle.markers, D * D, unknown(angle.dof));
}

template <int D> VectorX Unknowns<D>::gather(const VectorX& values) const {
  VectorX sums = VectorX::Zero(size_);
  for (int dof = 0; dof < dofs(); ++dof)
    if (const int i = unknown(dof); i >= 0) sums(i) += values(dof);
  return sums;
}

template <int D> VectorX Unknowns<D>::spread(const VectorX& values) const {
  VectorX all(dofs());
  for (int dof = 0; dof < dofs(); ++dof) {
    const int i = unknown(dof);
    all(dof) = i < 0 ? 0.0 : values(i);
  }
  return all;
}

template <int D> double Unknowns<D>::constrained_norm(const VectorX& values) const {
  double sum = 0;
  for (int dof = 0; dof < displacements(); ++dof)
    if (constrained(dof)) sum += values(dof) * values(dof);
  return std::sqrt(sum);
}

template <int D> Vec<D> Unknowns<D>::resultant(const VectorX& values) const {
  if (obstacle_offsets_.empty()) return values.head(displacements_).reshaped(D, Eigen::AutoSize).rowwise().sum();
  Vec<D> sum = values.head(obstacles_).reshaped(D, Eigen::AutoSize).rowwise().sum();
  for (const int translation : obstacle_offsets_) sum += values.template segment<D>(translation);
  return sum;
}

template class Unknowns<2>;
template class Unknowns<3>;

} // namespace signorini::model
