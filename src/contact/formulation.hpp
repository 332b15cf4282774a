#pragma once
// A contact formulation: what turns the place of a slave face and its master into residual and tangent.

#include "contact/block.hpp"
#include "contact/history.hpp"
#include "contact/master.hpp"

#include <memory>
#include <string>

namespace signorini::contact {

/// Where a contact acts.
template <int D> struct ContactSetting {
  Surface<D> slave;
  Master<D> master;
  int points;            ///< Gauss points per slave element and direction
  bool revolved = false; ///< the scene is axisymmetric about the second axis
  Region<D> where = {};
};

/// What a step asks of contact points, whatever their gaps and friction say.
struct Controls {
  std::vector<FixedContactState> fixed_states = {}; ///< keeps points in a state: one entry per point; empty frees all
  /// For the first guess of a step, which starts where states are undecided: what only rounding error decides is
  /// decided by a rule. Points that are free and nearer than this distance to touching, on either side, touch and
  /// stick. Points whose slip is that near to Coulomb's cone, as all are that slipped in the last step, go on slipping
  /// where the path goes straight on (`onward`), and stick where it turns. 0: no rule.
  double guessed = 0;
  bool onward = false;
  /// Whether points that touch stick, however far they would slip: while a falling body lands. It sinks in much too
  /// deep at first; were its points to slip there, the direction of slip would flip from one iteration to the next.
  bool landing = false;
};

/// A state that is tried out. Evaluations write where searches ended and what the points did into `present`.
template <int D> struct Trial {
  History<D>& present;
  const History<D>& accepted;
  const Controls& controls;
  double penalty_factor = 1;     ///< multiplies all penalty parameters
  const double* extra = nullptr; ///< values of the formulation's own unknowns
};

/// First degrees of freedom: of the slave's body, of the master's body or the obstacle, of the unknowns of its own.
struct Offsets {
  int slave, master, extra;
};

/// One contact. Constant data and the faces in motion are members, all else is in the History that it is handed; the
/// faces' accepted place is kept by commit() and stand().
template <int D> class Formulation {
public:
  /// Throws Error when no contact point is left.
  explicit Formulation(ContactSetting<D> setting);
  virtual ~Formulation() = default;
  Formulation(const Formulation&) = delete;
  Formulation& operator=(const Formulation&) = delete;

  const Surface<D>& slave() const { return slave_; }
  const Master<D>& master() const { return master_; }
  const ContactPoints<D>& points() const { return points_; }
  /// Names of the unknowns that it adds to the displacements. Their rows of the residual must be forces.
  virtual std::vector<std::string> extra_unknowns() const { return {}; }
  /// Whether what it adds to the tangent is symmetric.
  virtual bool has_potential() const = 0;
  /// Coulomb's μ, and ε_N where there is one: what warnings and the diagnosis compare with what is usual.
  virtual double friction() const { return 0; }
  virtual double penalty() const { return 0; }

  /// move() once, then evaluate_part() for 0 … parts() − 1, in any order and side by side, then gather(): blocks() are
  /// then those of the trial, the same bits in any order. Without `tangent` their matrices are left empty.
  void move(const double* slave_displacement, const double* master_displacement);
  virtual int parts() const = 0;
  virtual void evaluate_part(int part, const Trial<D>& trial, bool tangent) = 0;
  virtual void gather() = 0;
  const std::vector<Block>& blocks() const { return blocks_; }
  /// Degrees of freedom of a block's columns, the rows' first.
  void append_dofs(const Block& block, const Offsets& offsets, std::vector<int>& dofs) const;
  /// Those of a slave element; of a master element and, where it is a face, those next to it.
  void append_slave(int element, const Offsets& offsets, std::vector<int>& dofs) const;
  void append_master(int element, const Offsets& offsets, std::vector<int>& dofs, bool and_next = false) const;

  /// What a state that is accepted leaves behind, such as slip points that advance; call it at the displacements that
  /// were evaluated last. The caller then makes `present` the accepted history.
  void commit(History<D>& present, const History<D>& accepted, double penalty_factor);
  /// The faces have been moved back to the accepted state.
  void stand();
  /// Drops all that evaluations in the past have left behind and that rounding may depend on later, so that what comes
  /// next depends on the accepted state alone. Call it when both faces stand there.
  void settle(History<D>& accepted);
  /// Uzawa's step of the augmented Lagrangian method (J. C. Simo, T. A. Laursen, Comput. Struct. 42, 1992), where the
  /// formulation has multipliers that are no unknowns.
  virtual void augment(History<D>&) const {}
  /// Largest distance from the master of a point that presses, as far as augmentation reduces it.
  virtual double violation(const History<D>&) const { return 0; }

  /// What an error in all gaps and slips, each on its own, is multiplied by in the residual: ‖a ∂t/∂g‖ over the points
  /// that act, a their areas.
  virtual double stiffness(const History<D>& history, double penalty_factor) const = 0;
  /// Gaps of all points where the faces stand now (an evaluation looks at those only that may touch).
  std::vector<double> gaps(const History<D>& history) const;

  /// Points of all accepted states whose closest point or slip point was not found to tolerance, and those that had
  /// gone through the master since the state before (crossing.hpp): each state's counted, and the reference position of
  /// the latest.
  struct Tally {
    std::size_t count = 0;
    Vec<D> latest = Vec<D>::Zero();
  };
  const Tally& unsettled() const { return unsettled_; }
  const Tally& crossed() const { return crossed_; }
  /// Whether to take the time of the search: a clock is read twice per point that is projected.
  void time_search(bool wanted) { times_search_ = wanted; }
  /// Seconds that moving the search tree and projections took while that was wanted, summed over threads.
  double search_seconds() const { return search_seconds_; }
  /// Bytes of constant data and of the last evaluation's blocks; histories come on top.
  virtual double memory() const;

protected:
  /// What commit() does at each point before points are counted.
  virtual void commit_points(History<D>&, double /*penalty_factor*/) {}
  /// The last evaluation's blocks, on their way back to where they came from.
  virtual void take_back(std::vector<Block>& blocks) { blocks.clear(); }

  Surface<D> slave_;
  Master<D> master_, accepted_master_;
  /// Bound on how far slave and master points have moved towards each other, summed over all moves, and when the
  /// accepted state was reached or returned to.
  double travel_ = 0, accepted_travel_ = 0;
  ContactPoints<D> points_;
  std::vector<Block> blocks_;
  bool times_search_ = false;
  double search_seconds_ = 0;

private:
  bool has_crossed(std::size_t i, const History<D>& present, const History<D>& accepted) const;

  Eigen::Matrix<double, D, Eigen::Dynamic> previous_slave_; ///< control points before the last move
  Tally unsettled_, crossed_;
};

/// All contacts of a scene.
template <int D> using Formulations = std::vector<std::unique_ptr<Formulation<D>>>;

} // namespace signorini::contact
