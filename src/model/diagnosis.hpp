#pragma once
// Why a step failed: where in the model, and what may help.

#include "model/model.hpp"

#include <set>

namespace signorini::model {

/// A place that has to do with a failure.
struct TroubleSpot {
  std::string kind;  ///< "element", "contact point", "control point"
  std::string where; ///< name of the body, or of the contact
  int index;         ///< of the element (of the slave face for a contact point), of the control point; from 0
  VectorX reference; ///< X, of a control point its own position
  VectorX current;   ///< x in the accepted state
  double value;      ///< J, gap, unbalanced force, part of the direction
  Message what;      ///< J, the gap, the states between which a contact point alternates
};

struct Diagnosis {
  solve::Outcome outcome;              ///< the report's, or `indefinite` where that is found to be behind it
  std::vector<Message> messages;       ///< what happened
  std::vector<Message> cures;          ///< what may help
  std::vector<TroubleSpot> places;     ///< the worst first
  std::vector<TroubleSpot> unbalanced; ///< control points with the largest unbalanced forces
};

/// Controls that the caller has turned on already: "step", "line_search", "damping", "active_set_changes",
/// "arc_length", "penalty", "pseudo_transient".
using ControlsOn = std::set<std::string>;

/// Looks at the state in which a step failed: call it before the roll-back. Costs a few factorizations where the
/// tangent is looked into (its null vector, its directions of negative stiffness), else next to nothing. The cure does
/// not name what is on.
template <int D>
Diagnosis diagnose(const Model<D>& model, const solve::NewtonReport& report, const ControlsOn& on = {});

} // namespace signorini::model
