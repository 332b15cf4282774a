#pragma once
// Gauss-point-to-surface contact between a slave face and a master: residual, tangent and history.

#include "contact/adhesion.hpp"
#include "contact/master.hpp"
#include "contact/penalty.hpp"
#include "contact/products.hpp"

#include <functional>
#include <variant>
#include <vector>

namespace signorini::contact {

/// The contributions of all active points that share a slave, a master and a slip-point element, as one dense block.
/// Row nodes: the slave element's functions, then the master element's (a rigid master's one node is element 0). Column
/// nodes: the same, then the slip element's unless that is the master element. D rows (columns) per node; face-local
/// indices.
struct Group {
  int slave_element, master_element;
  int slip_element;           ///< −1 when the slip points lie in the master element or play no part
  int rows, columns;          ///< of the matrix, in scalars
  std::vector<double> force;  ///< residual contribution
  std::vector<double> matrix; ///< ∂force, row by row; empty when it was not wanted
};

/// What acts between a slave face and its master.
using Law = std::variant<PenaltyLaw, Adhesion>;

/// Says for a point of the reference configuration whether the contact acts there; empty: everywhere.
template <int D> using Region = std::function<bool(const Vec<D>&)>;

/// What a contact point did in the last evaluation.
template <int D> struct PointResult {
  ContactState state = ContactState::open;
  Vec<D> position = Vec<D>::Zero(); ///< current slave point
  double gap = 0;                   ///< of a point that the law acts on
  bool beyond = false;              ///< its closest point is an open end of the master
  bool settled = true;              ///< the searches for its closest point and, once accepted, its slip point converged
  double pressure = 0;
  /// Of the slave face at a touching point, current, not of unit length
  Eigen::Matrix<double, D, D - 1> tangents = Eigen::Matrix<double, D, D - 1>::Zero();
  Vec<D> friction = Vec<D>::Zero(); ///< t_T; the traction on the slave is t_N n̄ − t_T
  Vec<D> force = Vec<D>::Zero();    ///< on the slave: traction × current area of the point
  double area = 0;                  ///< that the traction acts on: current, adhesion: reference
  double potential = 0;             ///< energy of the law at this point
};

/// Sums over a contact. Area, largest pressure and penetration are those of the points that are not open.
template <int D> struct Resultant {
  Vec<D> force = Vec<D>::Zero(); ///< that the master exerts on the slave
  double area = 0, max_pressure = 0, max_penetration = 0;
  int active = 0, slipping = 0;
};

/// One contact: integrates over the slave face with Gauss points, projects onto the master face.
template <int D> class Pair {
public:
  /// `points` Gauss points per slave element and direction; those outside `where` are left out. `revolved`: the scene
  /// is axisymmetric about the second axis. Throws Error on constants without sense and when no point is left.
  Pair(Surface<D> slave, Master<D> master, Law law, int points, bool revolved = false, const Region<D>& where = {});

  /// Computes groups and results at the given displacements (D values per function of the two bodies, D values for a
  /// rigid master). Without `tangent` the groups' matrices are left empty.
  void evaluate(const double* slave_displacement, const double* master_displacement, bool tangent = true);
  /// The same piece by piece: move() once, then evaluate_part() for 0 … parts() − 1, in any order and side by side,
  /// then gather(). The result is the same, bit by bit.
  void move(const double* slave_displacement, const double* master_displacement);
  int parts() const { return static_cast<int>(parts_.size()); }
  void evaluate_part(int part, bool tangent);
  void gather();
  const std::vector<Group>& groups() const { return groups_; }

  /// Takes the state of the last evaluation as accepted: slip points advance; points that touch later slip from where
  /// they would have touched now. Call after evaluate() at the converged displacements.
  void accept();
  /// Forgets what happened since the last accept(); the faces must have been moved back to where they were then.
  void rollback();
  /// Keeps points in a state until it is called again: one entry per point; empty frees all. Adhesion is always free.
  void hold(std::vector<Held> states) { held_ = std::move(states); }
  bool holds() const { return !held_.empty(); }
  /// For the first guess of a step, which starts where states are undecided: what only rounding error decides is
  /// decided by a rule. Points that are free and nearer than `distance` to touching, on either side, touch and stick.
  /// Points whose slip is that near to Coulomb's cone, as all are that slipped in the last step, go on slipping where
  /// the path goes straight on (`onward`), and stick where it turns. 0: no rule.
  void guess(double distance, bool onward = false) {
    guessed_ = distance;
    tie_ = onward ? -distance : distance;
  }
  /// Uzawa's step of the augmented Lagrangian method (J. C. Simo, T. A. Laursen, Comput. Struct. 42, 1992): λ_N at each
  /// point becomes the pressure λ_N − ε_N g of the last evaluation. Part of the history. Nothing under adhesion.
  void augment();
  /// Whether points that touch stick, however far they would slip: while a falling body lands. It sinks in much too
  /// deep at first; were its points to slip there, the direction of slip would flip from one iteration to the next.
  void land(bool landing) { landing_ = landing; }
  /// Multiplies both penalty parameters of the law as it was given. Nothing under adhesion.
  void scale_penalty(double factor);

  /// The accepted state, to return to later.
  struct History;
  History history() const;
  void restore(const History& history);
  /// Whether to take the time of the search: a clock is read twice per point that is projected.
  void time_search(bool wanted) { times_search_ = wanted; }
  /// Seconds that moving the search tree and projections took while that was wanted, summed over threads.
  double search_seconds() const { return search_seconds_; }
  /// Drops all that evaluations in the past have left behind and that rounding may depend on later, so that what comes
  /// next depends on the accepted state alone. Call it when both faces stand there and nothing is pending.
  void settle();

  const Surface<D>& slave() const { return slave_; }
  const Master<D>& master() const { return master_; }
  const Law& law() const { return law_; }
  /// Per contact point, along the slave face (element by element).
  const std::vector<PointResult<D>>& results() const { return results_; }
  /// The same in the accepted state.
  const std::vector<PointResult<D>>& accepted_results() const { return accepted_results_; }
  /// Element of the slave face that contact point i lies in, and its number there, ξ¹ running fastest; those that a
  /// region leaves out are counted.
  std::pair<int, int> place(std::size_t i) const { return {points_[i].element, points_[i].number}; }
  /// Positions of the contact points in the reference configuration.
  const std::vector<Vec<D>>& reference_positions() const { return reference_positions_; }
  Resultant<D> resultant() const;
  /// ‖a ∂t/∂g‖ over the points that the law acted on in the last evaluation, a their areas, or ‖a ε_T‖ where that is
  /// more: what an error in all gaps and slips, each on its own, is multiplied by in the residual.
  double stiffness() const;
  /// Energy of the law in the last evaluation: springs of the penalty law, or adhesion.
  double potential() const;
  /// Work of friction in all accepted steps: ∫ μ t_N dγ da, by the trapezoidal rule over each step.
  double dissipated() const { return dissipated_; }
  /// Points of all accepted states whose closest point or slip point was not found to tolerance, each state's counted;
  /// and the reference position of the latest.
  std::size_t unsettled() const { return unsettled_; }
  const Vec<D>& unsettled_position() const { return unsettled_position_; }
  /// Points of all accepted states that had gone through the master since the state before (crossing.hpp), each
  /// state's counted; and the reference position of the latest.
  std::size_t crossed() const { return crossed_; }
  const Vec<D>& crossed_position() const { return crossed_position_; }
  /// Bytes of points, history and results, and of the last evaluation's groups.
  double memory() const;
  /// Gaps of all points in the configuration of the last evaluation (evaluate() looks at those only that may touch).
  std::vector<double> gaps() const;

private:
  /// A Gauss point of the slave face: constant data.
  struct Point {
    int element, number;
    double weight;      ///< parametric
    double reference;   ///< reference area per parametric area
    std::size_t values; ///< offset into values_: R_A, then R_A,1 …
  };
  /// What is remembered between evaluations.
  struct Memory {
    Projection<D> projection;
    double cleared = 0; ///< value of travel_ up to which an open point cannot touch
    bool slips = false; ///< has a slip point
    FaceCoordinates<D> slip = FaceCoordinates<D>::Zero();
    double limit = 0;      ///< μ t_N times the area in the accepted state
    double multiplier = 0; ///< λ_N, what augmentation adds to the pressure
  };

  /// A piece of the slave face: whole elements, with what its evaluation makes and uses.
  struct Part {
    std::size_t first, last; ///< points
    std::vector<Group> groups = {}, spare = {};
    std::vector<double> rows = {};       ///< working space of add(): ∂force and ∂ξ̄ by column
    std::vector<Products> products = {}; ///< of the last groups, those of the present slave element
    double search_seconds = 0;           ///< since the last gather()
  };

  bool friction() const { return penalty_ && penalty_->friction > 0; }
  void evaluate_point(std::size_t i, bool tangent, Part& part);
  void add(const Point& point, const FacePoint<D>& master, const FacePoint<D>* slip_point, const LocalForce<D>& force,
           bool tangent, Part& part);
  void advance(std::size_t i);
  void remember_touch(std::size_t i);
  bool has_crossed(std::size_t i) const;
  /// Current position of the slave point.
  Vec<D> position(std::size_t i) const;
  /// Current tangents of the slave face there.
  std::array<Vec<D>, D - 1> tangents(std::size_t i) const;
  std::size_t group(int slave_element, int master_element, int slip_element, bool tangent, Part& part);

  Surface<D> slave_;
  Master<D> master_, accepted_master_;
  Law law_;
  std::optional<PenaltyLaw> penalty_; ///< the law when it is this one, times what scale_penalty() said
  std::vector<Held> held_;
  double guessed_ = 0, tie_ = 0; ///< see guess()
  bool landing_ = false;
  bool revolved_;
  std::vector<Point> points_;
  std::vector<double> values_;
  std::vector<Memory> accepted_, memory_;
  std::vector<PointResult<D>> results_, accepted_results_;
  std::vector<Vec<D>> reference_positions_, accepted_positions_; ///< of the slave points
  std::vector<Part> parts_;
  std::vector<Group> groups_;
  std::vector<std::size_t> shares_; ///< how many of them came from each part
  /// Bound on how far slave and master points have moved towards each other, summed over all evaluations.
  double travel_ = 0, accepted_travel_ = 0; ///< now, and when the accepted state was reached or returned to
  double dissipated_ = 0;
  std::size_t unsettled_ = 0, crossed_ = 0;
  Vec<D> unsettled_position_ = Vec<D>::Zero(), crossed_position_ = Vec<D>::Zero();
  bool times_search_ = false;
  double search_seconds_ = 0;
  Eigen::Matrix<double, D, Eigen::Dynamic> previous_slave_;
};

template <int D> struct Pair<D>::History {
  std::vector<Memory> memory;
  Master<D> master;
  std::vector<Vec<D>> positions;
  std::vector<PointResult<D>> results;
  double dissipated;
};

} // namespace signorini::contact
