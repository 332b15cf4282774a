#include "model/adapt/adaptation.hpp"

#include "base/error.hpp"
#include "model/adapt/scene_archive.hpp"
#include "model/constants.hpp"
#include "model/steps/equilibrium.hpp"
#include "nurbs/row_projection.hpp"

#include <algorithm>
#include <utility>

namespace signorini::model {

namespace {

/// The model's scene with its regions, as it was before any other rows.
template <int D> std::shared_ptr<const Origin<D>> origin_of(const Model<D>& model) {
  if (model.origin) return model.origin;
  auto origin = std::make_shared<Origin<D>>(Origin<D>{model.system.scene, scene_parts(model)});
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k) {
    Contact<D>& contact = origin->scene.contacts[k];
    contact = with_regions(std::move(contact), *model.system.contacts[k], model.system.size);
  }
  return origin;
}

/// A contact's multipliers, none without.
template <int D>
std::optional<contact::FaceMultipliers<D>> multipliers_of(const Contact<D>& contact,
                                                          const contact::Formulation<D>& formulation) {
  const auto kind = contact.method.multipliers;
  if (!kind) return {};
  return contact::FaceMultipliers<D>(formulation.slave(), *kind, contact.method.unknown.joined);
}

/// The map of values of one face's multipliers to those of another one with other rows.
template <int D> class MultiplierMap {
public:
  MultiplierMap(contact::FaceMultipliers<D> from, contact::FaceMultipliers<D> to)
      : from_(std::move(from)), to_(std::move(to)) {
    for (std::size_t d = 0; d < from_.along.size(); ++d) along_[d] = nurbs::projection(from_.along[d], to_.along[d]);
  }
  /// Multipliers of the first face.
  int count() const { return from_.count; }
  /// One column per multiplier.
  MatrixX operator()(const MatrixX& values) const {
    const auto& [first, second] = along_;
    MatrixX result(values.rows(), to_.count);
    VectorX products(static_cast<Eigen::Index>(from_.number.size()));
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      for (Eigen::Index k = 0; k < products.size(); ++k) products(k) = values(i, from_.number[k]);
      const MatrixX carried = first * products.reshaped(first.cols(), second.cols()) * second.transpose();
      // Products of one function, on a border, have equal values, which projections keep.
      for (Eigen::Index k = 0; k < carried.size(); ++k) result(i, to_.number[k]) = carried.reshaped()(k);
    }
    return result;
  }

private:
  contact::FaceMultipliers<D> from_, to_;
  std::array<MatrixX, 2> along_{MatrixX::Identity(1, 1), MatrixX::Identity(1, 1)};
};

/// Carries values from one model to another one with other rows.
template <int D> class Carrier {
public:
  Carrier(const System<D>& from, const System<D>& to) : from_(from), to_(to) {
    for (std::size_t k = 0; k < from.contacts.size(); ++k) {
      const contact::Formulation<D>&old = *from.contacts[k], &own = *to.contacts[k];
      require(own.points().size() == old.points().size(), "model.adapt.points",
              {{"contact", from.scene.contacts[k].name}});
      auto before = multipliers_of(from.scene.contacts[k], old), after = multipliers_of(to.scene.contacts[k], own);
      require(before || (!old.multipliers() && old.extra_unknowns() == 0), "model.adapt.formulation",
              {{"contact", from.scene.contacts[k].name}});
      multipliers_.emplace_back();
      if (before) multipliers_.back().emplace(std::move(*before), std::move(*after));
    }
  }

  /// Displacements and unknowns of contacts and ties, by degree of freedom.
  VectorX degrees_of_freedom(const VectorX& values) const {
    const Unknowns<D>&old = from_.unknowns, &own = to_.unknowns;
    VectorX result = VectorX::Zero(own.dofs());
    for (int b = 0; b < std::ssize(from_.scene.bodies); ++b) {
      const nurbs::Discretization &before = from_.scene.bodies[b].body->space(),
                                  &after = to_.scene.bodies[b].body->space();
      for (int j = 0; j < std::ssize(before.rows()); ++j) {
        const nurbs::Row &row = before.rows()[j], &other = after.rows()[j];
        const auto part = values.segment(old.offset(b) + D * before.first_function(j), D * row.functions());
        result.segment(own.offset(b) + D * after.first_function(j), D * other.functions()) =
            nurbs::project_row(row, other, part.reshaped(D, row.functions())).reshaped();
      }
    }
    const int behind = old.displacements() - old.obstacles(); // of obstacles
    result.segment(own.obstacles(), behind) = values.segment(old.obstacles(), behind);
    for (std::size_t k = 0; k < multipliers_.size(); ++k) {
      const int count = from_.contacts[k]->extra_unknowns();
      if (count == 0) continue;
      const int multipliers = multipliers_[k]->count();
      const MatrixX part = values.segment(old.of_contact(k).extra, count).reshaped(count / multipliers, multipliers);
      const VectorX carried = (*multipliers_[k])(part).reshaped();
      result.segment(own.of_contact(k).extra, carried.size()) = carried;
    }
    for (std::size_t k = 0; k < from_.ties.size(); ++k)
      result.segment(own.of_tie(k), from_.ties[k].multipliers()) =
          values.segment(old.of_tie(k), from_.ties[k].multipliers());
    return result;
  }

  contact::History<D> history(std::size_t k, const contact::History<D>& old) const {
    const contact::Formulation<D>& own = *to_.contacts[k];
    contact::History<D> result = old;
    if (old.multipliers.empty()) return result;
    // Multipliers carry the friction; slips of the next step start at the feet on the new shape, at all points.
    for (contact::PointHistory<D>& point : result.points) point.slips = false;
    // Elastic slip, limit, slips and wear of each multiplier
    MatrixX values(D + 3, old.multipliers.size());
    for (std::size_t a = 0; a < old.multipliers.size(); ++a) {
      const contact::MultiplierHistory<D>& one = old.multipliers[a];
      const double area = old.multiplier_results[a].area;
      values.col(static_cast<Eigen::Index>(a)) << one.elastic, area > 0 ? one.limit / area : 0, one.slipped, one.recent,
          one.worn;
    }
    const MatrixX carried = (*multipliers_[k])(values);
    result.multipliers.assign(own.multipliers()->count(), {});
    result.multiplier_results.assign(own.multipliers()->count(), {});
    for (std::size_t a = 0; a < result.multipliers.size(); ++a) {
      const auto column = carried.col(static_cast<Eigen::Index>(a));
      contact::MultiplierHistory<D>& one = result.multipliers[a];
      one.elastic = column.template head<D - 1>();
      one.limit = std::max(0.0, column(D - 1)); // μ z_A; times a_A once that is evaluated
      one.slipped = std::max(0.0, column(D));
      one.recent = std::max(0.0, column(D + 1));
      one.worn = std::max(0.0, column(D + 2));
    }
    return result;
  }

private:
  const System<D>&from_, &to_;
  std::vector<std::optional<MultiplierMap<D>>> multipliers_; ///< by contact
};

/// Makes the forces of the present state those of the equilibrium that it comes from: on free control points those of
/// the loads, on supports with the former resultants. Other functions distribute them differently, which does no work.
template <int D> void carry_reactions(const Model<D>& from, Model<D>& to) {
  const Unknowns<D>&old = from.system.unknowns, &own = to.system.unknowns;
  VectorX& force = to.present.force;
  for (int dof = 0; dof < own.displacements(); ++dof)
    if (!own.constrained(dof)) force(dof) = to.external(dof);
  // Obstacles, with their markers, are the same in both models.
  const int behind = own.displacements() - own.obstacles();
  force.segment(own.obstacles(), behind) = from.accepted.force.segment(old.obstacles(), behind);
  for (int s = 0; s < std::ssize(to.system.scene.supports); ++s)
    for (int c = 0; c < D; ++c) {
      double missing = 0;
      int count = 0;
      for (const int dof : old.of_support(s, c))
        if (old.constrained(dof)) missing += from.residual(dof);
      for (const int dof : own.of_support(s, c))
        if (own.constrained(dof)) missing -= force(dof) - to.external(dof), ++count;
      for (const int dof : own.of_support(s, c))
        if (own.constrained(dof)) force(dof) += missing / count;
    }
  take_residual(to);
}

} // namespace

template <int D> std::shared_ptr<Model<D>> with_bodies(const Model<D>& model, const Bodies<D>& bodies) {
  require(settled(model), "model.adapt.unsettled");
  const std::shared_ptr<const Origin<D>> origin = origin_of(model);
  auto result = std::make_shared<Model<D>>(with_bodies(origin->scene, bodies), NotStarted{});
  Model<D>& other = *result;
  other.origin = origin;
  const Carrier<D> carry(model.system, other.system);

  State<D>& state = other.accepted;
  const State<D>& old = model.accepted;
  state.displacement = carry.degrees_of_freedom(old.displacement);
  const VectorX prescribed = other.system.drives.displacement(old.targets);
  for (int dof = 0; dof < other.system.unknowns.obstacles(); ++dof)
    if (other.system.unknowns.unknown(dof) < 0) state.displacement(dof) = prescribed(dof); // without rounding errors
  state.targets = old.targets;
  state.penalty_factor = old.penalty_factor;
  state.time = old.time;
  state.internal = old.internal;
  for (std::size_t k = 0; k < old.contacts.size(); ++k) state.contacts.own()[k] = carry.history(k, old.contacts[k]);
  other.path = model.path;
  other.path.increment = carry.degrees_of_freedom(model.path.increment);
  other.path.before = carry.degrees_of_freedom(model.path.before);
  settle(other); // accepted positions of contact points, too, are those of the new shape

  // Points on Coulomb's cone continue to slip.
  const InitialContact onward{gap_rounding * largest_position(other), true};
  Message why;
  if (evaluate(other, {.tangent = false, .initial = onward}, why) != solve::Outcome::converged) return nullptr;
  for (contact::History<D>& history : other.present.contacts.own())
    for (std::size_t a = 0; a < history.multipliers.size(); ++a)
      history.multipliers[a].limit *= history.multiplier_results[a].area;
  carry_reactions(model, other);
  other.accepted = other.present;
  other.system.return_to_accepted(other.accepted);

  for (std::size_t k = 0; k < other.system.contacts.size(); ++k)
    other.system.contacts[k]->counters = model.system.contacts[k]->counters;
  other.linear.continue_from(model.linear);
  other.timings = model.timings;
  other.scene_warnings = model.scene_warnings;
  return result;
}

template std::shared_ptr<Model<2>> with_bodies(const Model<2>&, const Bodies<2>&);
template std::shared_ptr<Model<3>> with_bodies(const Model<3>&, const Bodies<3>&);

} // namespace signorini::model
