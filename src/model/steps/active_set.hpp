#pragma once
// Active set of a step: records the states of contact points or multipliers (open, stick, slip) over the iterations,
// fixes states, and detects set cycling.

#include "contact/gauss/formulation.hpp"
#include "model/constants.hpp"
#include "model/steps/step_options.hpp"

#include <deque>
#include <string>

namespace signorini::model {

/// A constraint (contact/point/history.hpp): index of the contact, and index of the point or multiplier in it.
struct PointIndex {
  int contact, point;
};

/// Call update() before each evaluation, record() after it, release_all() when the residual is small. fixed() holds the
/// states of the next evaluation. The rules that freeze and fix states are in the first lines of the source.
template <int D> class ActiveSet {
public:
  using Histories = std::vector<contact::History<D>>;

  /// Starts a step from the states of the last evaluation.
  void begin(const contact::Formulations<D>& contacts, const Histories& histories, const ActiveSetOptions& options);
  /// Ends a freeze whose rule no longer holds, and frees the states that were held in the last evaluation. `energies`:
  /// |f·Δu| of the iterations so far. Returns true if it has freed any.
  bool update(const std::vector<double>& energies);
  /// Records the states of an evaluation with its residual, and decides which are fixed in the next one. Returns true
  /// if states are held: then evaluate again. `begins`: the evaluation is that of the accepted state, which holds none.
  bool record(const Histories& histories, double residual, bool begins);
  /// Frees all constraints; returns true if any was fixed. Points that change too often may be fixed again in
  /// `most_rounds` rounds.
  bool release_all();
  bool exhausted() const { return rounds_ > most_rounds; }

  /// Fixed states of a contact's constraints; empty if all are free.
  const std::vector<contact::FixedContactState>& fixed(int contact) const { return fixed_[contact]; }

  /// True if fewer constraints are closed in the last evaluations than in those before: the closed set shrinks by a few
  /// constraints in each iteration, as where a face that touched as a whole lifts off.
  bool shrinks() const;

  /// Period of set cycling: the number of iterations after which residuals (to 1e-9) and states have repeated twice; 0
  /// if they have not. An iteration that depends on its state alone then repeats forever.
  int period() const;
  /// Points whose state changed at least twice in the last evaluations, those with most changes first. `past_end`: only
  /// changes count for which the closest point came to or from beyond an open end of the master.
  std::vector<PointIndex> cycling_points(bool past_end = false) const;
  /// The states between which a point alternated in the last evaluations, the current one last: "stick / slip",
  /// "open / stick / slip", "beyond / open", without friction "open / touching".
  std::string alternating(const PointIndex& index) const;

private:
  enum class Phase {
    free,   ///< states follow the contact conditions, except for constraints that change too often
    frozen, ///< constraints stay open or closed as in the accepted state, from begin() until the rule ends it
    held    ///< states are held in one evaluation, see retain() and stick_reversed()
  };
  /// Of all constraints, contact after contact
  struct Entry {
    double residual;
    int closed = 0;                         ///< number of those that touch
    std::vector<unsigned char> states = {}; ///< see code()
    std::vector<double> gaps = {};          ///< less their offsets
    std::vector<Vec<D>> frictions = {};     ///< of those that slip, otherwise 0; empty if no contact has multipliers
  };
  struct ContactEntry {
    int first, last;                   ///< indices of its first constraint and after its last one
    bool frictional, weighted, solved; ///< `weighted`: has multipliers; `solved`: they are unknowns
    const contact::Parameters* parameters;

    bool has_multipliers() const { return weighted || solved; }
  };
  void release();
  Entry entry(const Histories& histories, double residual) const;
  bool retain();
  bool stick_reversed();
  void fix_changing(const Histories& histories);

  ActiveSetOptions options_;
  Phase phase_ = Phase::free;
  std::vector<std::vector<contact::FixedContactState>> fixed_; ///< by contact
  std::deque<Entry> entries_;
  std::vector<ContactEntry> contacts_;
  std::vector<int> counts_; ///< changes of each constraint in this step
  int rounds_ = 0;          ///< in which points that change too often were fixed
};

} // namespace signorini::model
