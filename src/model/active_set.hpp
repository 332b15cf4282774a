#pragma once
// States of contact points (open, stick, slip) over the iterations of a step: holds them back, finds those that cycle.

#include "contact/formulation.hpp"
#include "model/constants.hpp"
#include "model/step_options.hpp"

#include <deque>
#include <string>

namespace signorini::model {

/// A contact point: index of its contact, and of the point there.
struct PointIndex {
  int contact, point;
};

template <int D> class ActiveSet {
public:
  using Histories = std::vector<contact::History<D>>;
  using Controls = std::vector<contact::Controls>;

  /// Starts a step from the states of the last evaluation: who touches and who does not is held when options.freeze
  /// says so.
  void begin(const contact::Formulations<D>& contacts, const Histories& histories, const ActiveSetOptions& options,
             Controls& controls);
  /// Notes the states of an evaluation with its residual, and holds points that have changed too often.
  void note(const Histories& histories, double residual, Controls& controls);
  /// Frees what is frozen when `ratio`, |f·Δu| over its first value, is small enough.
  void thaw(double ratio, Controls& controls);
  /// Frees all; returns whether any point was held. Those that change too often may be held again `rounds` times.
  bool release(Controls& controls);
  bool exhausted() const { return rounds_ > most_rounds; }

  /// The number of iterations after which residuals and states have come back twice, to 1e-9; 0 when they have not. An
  /// iteration that depends on nothing but its state will go on so for ever.
  int period() const;
  /// Points whose state changed at least twice in the last evaluations, those that changed most first.
  std::vector<PointIndex> restless() const;
  /// The states between which a point went in the last evaluations, the present one last: "stick / slip",
  /// "open / stick / slip", "beyond / open", without friction "open / touching".
  std::string alternating(const PointIndex& index) const;
  /// Those among them whose closest point was an open end of the master in between.
  std::vector<PointIndex> strays() const;

private:
  struct Entry {
    double residual;
    std::vector<unsigned char> states; ///< of all points, contact after contact; see code()
  };
  std::vector<int> changes(bool stray) const;
  std::vector<PointIndex> points_with(const std::vector<int>& changes, int least) const;

  ActiveSetOptions options_;
  std::deque<Entry> entries_;
  std::vector<int> counts_;      ///< changes of each point in this step
  std::vector<int> first_;       ///< index of each contact's first point
  std::vector<bool> frictional_; ///< of each contact
  bool frozen_ = false;
  int rounds_ = 0;
};

} // namespace signorini::model
