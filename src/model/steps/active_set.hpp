#pragma once
// Active set of a step: records the states of contact points or multipliers (open, stick, slip) over the iterations,
// fixes states, and detects set cycling.

#include "contact/gauss/formulation.hpp"
#include "model/constants.hpp"
#include "model/steps/step_options.hpp"

#include <deque>
#include <functional>
#include <string>
#include <utility>

namespace signorini::model {

/// A constraint (contact/history.hpp): index of the contact, and index of the point or multiplier in it.
struct PointIndex {
  int contact, point;
};

template <int D> class ActiveSet {
public:
  using Histories = std::vector<contact::History<D>>;
  using Controls = std::vector<contact::Controls>;

  /// Starts a step from the states of the last evaluation. If options.freeze > 0, the active set is frozen: points stay
  /// open or closed.
  void begin(const contact::Formulations<D>& contacts, const Histories& histories, const ActiveSetOptions& options,
             Controls& controls);
  /// Records the states of an evaluation with its residual, and fixes points whose state has changed too often. A
  /// multiplier whose slip reverses sticks in the next evaluation: Newton's method has passed over a state of stick,
  /// and would return, because the tangent of slip has no stiffness that stops it.
  void note(const Histories& histories, double residual, Controls& controls);
  /// Principal pivoting for multipliers that are unknowns (J. J. Júdice, F. M. Pires, Comput. Oper. Res. 21, 1994): all
  /// states change at once until those of an earlier evaluation return; then states are held so that only the one
  /// changes whose conditions are violated most, with those that equal it by symmetry: a choice that neither the
  /// direction of the face nor rounding error affects. `violation` returns the norm of the residual of the conditions.
  /// Call after note(); returns whether states are held, for another evaluation. With a penalty pressures are
  /// continuous in the gaps, and held states lead away from the solution.
  bool hold_back(const Histories& histories, const std::function<double(const PointIndex&)>& violation,
                 Controls& controls);
  /// Ends the freeze if `ratio`, |f·Δu| over its first value, is below options.freeze.
  void thaw(double ratio, Controls& controls);
  /// Frees the states that hold_back() holds, before an evaluation; returns whether any was held.
  bool let_go(Controls& controls);
  /// Frees all points; returns whether any was fixed. Points that change too often may be fixed again in `most_rounds`
  /// rounds.
  bool release(Controls& controls);
  bool exhausted() const { return rounds_ > most_rounds; }

  /// Period of set cycling: the number of iterations after which residuals (to 1e-9) and states have repeated twice; 0
  /// if they have not. An iteration that depends on its state alone then repeats forever.
  int period() const;
  /// Points whose state changed at least twice in the last evaluations, those with most changes first.
  std::vector<PointIndex> cycling_points() const;
  /// The states between which a point alternated in the last evaluations, the current one last: "stick / slip",
  /// "open / stick / slip", "beyond / open", without friction "open / touching".
  std::string alternating(const PointIndex& index) const;
  /// Those among the cycling points whose closest point was in between an open end of the master.
  std::vector<PointIndex> cycling_past_end() const;

private:
  struct Entry {
    double residual;
    std::vector<unsigned char> states; ///< of all points, contact after contact; see code()
  };
  void stick_where_reversed(const Histories& histories, Controls& controls);
  std::vector<int> changes(bool past_end) const;
  std::vector<PointIndex> points_with(const std::vector<int>& changes, int least) const;

  ActiveSetOptions options_;
  std::deque<Entry> entries_;
  std::vector<int> counts_;      ///< changes of each point in this step
  std::vector<int> first_;       ///< index of each contact's first point
  std::vector<bool> frictional_; ///< of each contact
  std::vector<bool> solved_;     ///< of each contact: its multipliers are unknowns
  /// Multipliers that stick in this evaluation, with the states to which they return.
  std::vector<std::pair<PointIndex, contact::FixedContactState>> reversed_;
  std::vector<std::vector<contact::FaceCoordinates<D>>> frictions_; ///< per contact and multiplier, before
  bool frozen_ = false;
  int rounds_ = 0;
  bool held_ = false; ///< states are held in the present evaluation
};

} // namespace signorini::model
