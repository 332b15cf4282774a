#pragma once
// Interface of contact formulations, which turn the positions of a slave face and its master into residual and tangent.

#include "contact/gauss/block.hpp"
#include "contact/point/history.hpp"
#include "contact/point/master.hpp"
#include "contact/point/penalty.hpp"

#include <memory>
#include <span>
#include <string>

namespace signorini::contact {

/// Geometry of a contact: faces, contact points and region.
template <int D> struct ContactSetting {
  Surface<D> slave;
  Master<D> master;
  int points;            ///< Gauss points per slave element and direction
  bool revolved = false; ///< the scene is axisymmetric about the second axis
  Region<D> where = {};
  Start start = {};
  Region<D> bonded = {}; ///< of a cohesive contact
  bool adaptive = false; ///< elements away from the border of the contact have 2/3 of the points, see point_choice.hpp
};

/// Rules of a step that take precedence over the gap and friction of contact points.
struct Controls {
  std::vector<FixedContactState> fixed_states = {}; ///< one entry per constraint; empty: all are free
  /// Contact tolerance of a step's first guess, where otherwise rounding error would decide the states. Free points
  /// with a distance to contact below it, on either side, touch and stick. Points whose slip is within this distance of
  /// Coulomb's cone (all that slipped in the last step) continue to slip if the path continues in its direction
  /// (`onward`), and stick at a turning point. 0: no rule.
  double guessed = 0;
  bool onward = false;
  /// Whether touching points stick at any trial slip, while an unconstrained body comes into contact. It first
  /// penetrates far too deep; slipping points would change their direction of slip in every iteration.
  bool landing = false;
  /// Whether the state is the guess of the step, its first state away from the accepted one: points that it closes slip
  /// from where they touch on the way to it (touch.hpp), for the whole step. Not in landing: damping moves a body until
  /// some points touch, and the others, without a forecast, would pull against these.
  bool foresees = false;
};

/// A trial state. Evaluations write foot points and results of the contact points into `present`.
template <int D> struct Trial {
  History<D>& present;
  const History<D>& accepted;
  const Controls& controls;
  double penalty_factor = 1;     ///< multiplies all penalty parameters
  const double* extra = nullptr; ///< values of the formulation's additional unknowns
};

/// First degree of freedom of the master, which is not 0 for an obstacle only, and of the additional unknowns.
/// Functions of faces are numbered through all bodies.
struct Offsets {
  int master, extra;
};

/// One contact. Members hold constant data and the moving faces; everything else is in the History passed to its
/// methods. commit() and return_to_accepted() store the faces' accepted position.
template <int D> class Formulation {
public:
  /// Throws Error if no contact point is left.
  explicit Formulation(ContactSetting<D> setting);
  virtual ~Formulation() = default;
  Formulation(const Formulation&) = delete;
  Formulation& operator=(const Formulation&) = delete;

  const Surface<D>& slave() const { return slave_; }
  const Master<D>& master() const { return master_; }
  const ContactPoints<D>& points() const { return points_; }
  /// Number of unknowns added to the displacements. Their rows of the residual must be forces.
  virtual int extra_unknowns() const { return 0; }
  /// Whether the contribution to the tangent is symmetric, up to points beyond an open end of the master, where the
  /// area fades.
  virtual bool has_potential() const = 0;
  /// Coulomb's μ and the penalty parameter ε_N (0: none), which warnings and the diagnosis compare with usual values.
  double friction(const History<D>& history) const { return law() ? changed(*law(), history.changes).friction : 0; }
  double penalty(const History<D>& history) const { return law() ? changed(*law(), history.changes).normal : 0; }
  /// Whether steps augment it until its violation() is small.
  bool augmented() const { return law() && law()->enforcement == Enforcement::augmented; }
  bool active(const History<D>& history) const { return history.changes.active.value_or(start_.active); }
  /// The gap at which the faces touch; at point i, where an overlap is allowed.
  double offset(const History<D>& history) const { return history.changes.offset.value_or(start_.offset); }
  double offset(std::size_t i, const History<D>& history) const {
    return offset(history) - (overlap_.empty() ? 0 : history.changes.overlap * overlap_[i]);
  }
  /// Overlap of the initial shapes at the points, if the contact is an interference fit; otherwise empty.
  const std::vector<double>& overlap() const { return overlap_; }

  /// Closest points at which the points are bonded in the initial state, with Foot::none if they are not, with an
  /// element if they are only too far from it; empty unless cohesive.
  virtual std::span<const Projection<D>> bonds() const { return {}; }
  /// Fraction of their stiffness that the points' bonds have lost, 1 without a bond; empty unless cohesive.
  virtual std::vector<double> damage(const History<D>&) const { return {}; }

  /// Number of multipliers, eliminated or unknowns; their histories are then the constraints of history.hpp.
  virtual int multipliers() const { return 0; }
  /// The contact point where a constraint is, for messages.
  virtual int point_of(int constraint) const { return constraint; }

  /// Evaluation: move() once, then evaluate_part() for 0 … parts() − 1, in any order and in parallel, then gather(),
  /// which may use parallel() itself. blocks() are then those of the trial, bitwise independent of the order. Without
  /// `tangent` their matrices are empty.
  void move(const double* slave_displacement, const double* master_displacement);
  virtual int parts() const = 0;
  virtual void evaluate_part(int part, const Trial<D>& trial, bool tangent) = 0;
  virtual void gather(const Trial<D>& trial, bool tangent) = 0;
  const std::vector<Block>& blocks() const { return blocks_; }
  /// Appends the degrees of freedom of a block's columns, those of the rows first.
  void append_dofs(const Block& block, const Offsets& offsets, std::vector<int>& dofs) const;
  /// Appends those of a slave element; of a master element and, if `and_next`, of its neighbors on the face.
  void append_slave(int element, std::vector<int>& dofs) const;
  void append_master(int element, const Offsets& offsets, std::vector<int>& dofs, bool and_next = false) const;

  /// Updates the history at the end of an accepted step, for example by advancing slip points, at the displacements
  /// evaluated last. The caller then makes `present` the accepted history.
  void commit(History<D>& present, const History<D>& accepted, double penalty_factor);
  /// Numbers of the points that have passed through the master since the accepted state (crossing.hpp), at the
  /// displacements evaluated last.
  std::vector<int> crossed(const History<D>& present, const History<D>& accepted) const;
  /// To be called after the faces have been moved back to the accepted state.
  void return_to_accepted();
  /// Drops everything from past evaluations that affects rounding later, so that the continuation depends on the
  /// accepted state alone. Requires both faces in the accepted state.
  void settle(History<D>& accepted);
  /// Uzawa's step of the augmented Lagrangian method (J. C. Simo, T. A. Laursen, Comput. Struct. 42, 1992), for
  /// formulations whose multipliers are not unknowns.
  virtual void augment(History<D>&) const {}
  /// Largest |gap| of the points with contact pressure, as far as augmentation reduces it.
  virtual double violation(const History<D>&) const { return 0; }

  /// Factor from independent errors of gaps and slips to the residual: ‖a ∂t/∂g‖ over the active points, a their areas.
  virtual double stiffness(const History<D>& history, double penalty_factor) const = 0;
  /// Gaps of all points, less their offsets, at the faces' current position (an evaluation projects only points that
  /// may touch).
  std::vector<double> gaps(const History<D>& history) const;

  /// Number of points, summed over all accepted states, and reference position of the latest.
  struct Tally {
    std::size_t count = 0;
    Vec<D> latest = Vec<D>::Zero();
  };
  /// Points whose closest point or slip point was not found to tolerance.
  const Tally& unsettled() const { return unsettled_; }
  /// Continues the counts and times of a formulation of the same faces.
  void continue_from(const Formulation& other) {
    unsettled_ = other.unsettled_;
    times_search_ = other.times_search_;
    search_seconds_ = other.search_seconds_;
  }
  /// Whether to time the search, which reads a clock twice per projected point.
  void time_search(bool wanted) { times_search_ = wanted; }
  /// Seconds for updates of the search tree and projections while timing was on, summed over threads.
  double search_seconds() const { return search_seconds_; }
  /// Bytes of constant data and of the last evaluation's blocks, without histories.
  virtual double memory() const;

protected:
  /// The penalty law of the scene, if the formulation has one.
  virtual const PenaltyLaw* law() const { return nullptr; }
  /// Its share of the energies, since the energies of two half passes are added.
  virtual double share() const { return 1; }
  /// Evaluates the results of points at the displacements evaluated last, where the accepted state equals `present`.
  virtual void evaluate_points(History<D>& /*present*/, const std::vector<std::size_t>& /*points*/,
                               double /*penalty_factor*/) {}
  /// Called by commit() before points are counted.
  virtual void commit_points(History<D>& /*present*/, const History<D>& /*accepted*/, double /*penalty_factor*/) {}
  /// Returns the last evaluation's blocks to their source, to reuse their memory.
  virtual void take_back(std::vector<Block>& blocks) { blocks.clear(); }

  Surface<D> slave_;
  Master<D> master_, accepted_master_;
  double travel_ = 0; ///< bound on the approach of slave and master points, summed over all moves
  ContactPoints<D> points_;
  Start start_;
  std::vector<double> overlap_;
  std::vector<Block> blocks_;
  bool times_search_ = false;
  double search_seconds_ = 0;

private:
  void choose_points(History<D>& present, double moved, double penalty_factor);
  bool is_near(const History<D>& present, std::span<const std::size_t> points, double distance,
               double penalty_factor) const;
  bool has_crossed(std::size_t i, const History<D>& present, const History<D>& accepted, double moved) const;

  Tally unsettled_;
};

/// All contacts of a scene.
template <int D> using Formulations = std::vector<std::unique_ptr<Formulation<D>>>;

} // namespace signorini::contact
