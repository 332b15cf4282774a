#pragma once
// Interface of contact formulations, which turn the positions of a slave face and its master into residual and tangent.

#include "contact/gauss/block.hpp"
#include "contact/point/bonds.hpp"
#include "contact/point/controls.hpp"
#include "contact/point/faces.hpp"
#include "contact/point/parameters.hpp"

#include <memory>
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

/// A trial state. Evaluations write foot points and results of the contact points into `present`.
template <int D> struct Trial {
  History<D>& present;
  const History<D>& accepted;
  const Controls& controls;
  double penalty_factor = 1;     ///< multiplies all penalty parameters
  const double* extra = nullptr; ///< values of the formulation's additional unknowns
  double duration = 0;           ///< of the step; 0: none
};

/// Multipliers of a formulation that are eliminated; their histories are then the constraints of history.hpp.
struct Multipliers {
  std::vector<int> points; ///< the contact point where each is largest, for messages
  int count() const { return std::ssize(points); }
};

/// What a contact counts and times over a path.
template <int D> struct ContactCounters {
  /// Number of points with a force whose closest point or slip point was not found to tolerance, summed over all
  /// accepted states, and reference position of the latest.
  int unsettled = 0;
  Vec<D> unsettled_at = Vec<D>::Zero();
  /// The same of points or multipliers whose formula of friction has a flaw, and the latest flaw.
  int flawed = 0;
  Vec<D> flawed_at = Vec<D>::Zero();
  FrictionFlaw flaw = FrictionFlaw::none;
  bool times_search = false; ///< reads a clock twice per projected point
  double search_seconds = 0; ///< for updates of the search tree and projections while timed, summed over threads
};

/// One contact. Members hold constant data and the moving faces; everything else is in the History passed to its
/// methods. commit() and return_to_accepted() store the faces' accepted position.
template <int D> class Formulation {
public:
  /// Throws Error if no contact point is left, or a constant of the law is invalid.
  explicit Formulation(ContactSetting<D> setting, std::optional<InterfaceLaw> law = {}, Pass pass = Pass::full);
  virtual ~Formulation() = default;
  Formulation(const Formulation&) = delete;
  Formulation& operator=(const Formulation&) = delete;

  const Faces<D>& faces() const { return faces_; }
  const Surface<D>& slave() const { return faces_.slave; }
  const Master<D>& master() const { return faces_.master; }
  const ContactPoints<D>& points() const { return points_; }
  const Parameters& parameters() const { return parameters_; }

  /// True if the contribution to the tangent is symmetric, up to points beyond an open end of the master, where the
  /// area fades.
  virtual bool has_potential() const = 0;
  /// Number of unknowns added to the displacements. Their rows of the residual must be forces.
  virtual int extra_unknowns() const { return 0; }
  /// Null without eliminated multipliers.
  virtual const Multipliers* multipliers() const { return nullptr; }
  /// Null unless cohesive.
  virtual const Bonds<D>* bonds() const { return nullptr; }

  /// Evaluation: move() once, then evaluate_part() for 0 … parts() − 1, in any order and in parallel, then gather(),
  /// which may use parallel() itself. blocks() are then those of the trial, bitwise independent of the order. Without
  /// `tangent` their matrices are empty.
  void move(const double* slave_displacement, const double* master_displacement);
  virtual int parts() const = 0;
  virtual void evaluate_part(int part, const Trial<D>& trial, bool tangent) = 0;
  virtual void gather(const Trial<D>& trial, bool tangent) = 0;
  const std::vector<Block>& blocks() const { return blocks_; }

  /// Updates the history at the end of an accepted step, for example by advancing slip points, at the displacements
  /// evaluated last. The caller then makes `present` the accepted history. Overrides end with this function.
  virtual void commit(History<D>& present, const History<D>& accepted, double penalty_factor);
  /// To be called after the faces have been moved back to the accepted state.
  void return_to_accepted() {
    if (faces_.master.set()) faces_.master.note_motion(faces_.master);
    faces_.accepted = faces_.master;
  }
  /// Drops everything from past evaluations that affects rounding later, so that the continuation depends on the
  /// accepted state alone. Requires both faces in the accepted state.
  void settle(History<D>& accepted);

  /// Factor from independent errors of gaps and slips to the residual: ‖a ∂t/∂g‖ over the active points, a their areas.
  virtual double stiffness(const History<D>& history, double penalty_factor) const = 0;
  /// Bytes of constant data and of the last evaluation's blocks, without histories.
  virtual double memory() const;

  ContactCounters<D> counters;

protected:
  /// Returns the last evaluation's blocks to their source, to reuse their memory.
  virtual void take_back(std::vector<Block>& blocks) { blocks.clear(); }

  Faces<D> faces_;
  ContactPoints<D> points_;
  Parameters parameters_;
  std::vector<Block> blocks_;
};

/// All contacts of a scene.
template <int D> using Formulations = std::vector<std::unique_ptr<Formulation<D>>>;

/// The history of a contact that has not been evaluated.
template <int D> History<D> initial_history(const Formulation<D>& contact);
/// Position of point i in the last evaluation, which its result has only while it is watched.
template <int D> Vec<D> position(const Formulation<D>& contact, const History<D>& history, std::size_t i);
/// Gaps of all points, less their offsets, at the faces' current position (an evaluation projects only points that may
/// touch); infinite without a foot.
template <int D> std::vector<double> gaps(const Formulation<D>& contact, const History<D>& history);
/// Energy of the law at point i and of multiplier a: that of springs and of adhesion, which is part of the result, and
/// ∫ p dg A where the pressure is a formula, which evaluations leave out.
template <int D> double potential(const Formulation<D>& contact, const History<D>& history, std::size_t i);
template <int D> double multiplier_potential(const Formulation<D>& contact, const History<D>& history, std::size_t a);
/// Energy of all points and multipliers.
template <int D> double potential(const Formulation<D>& contact, const History<D>& history);
/// Numbers of the points that have passed through the master since the accepted state (crossing.hpp), at the
/// displacements evaluated last.
template <int D>
std::vector<int> crossed(const Formulation<D>& contact, const History<D>& present, const History<D>& accepted);

} // namespace signorini::contact
