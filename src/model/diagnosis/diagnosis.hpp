#pragma once
// Diagnosis of failed steps: reason, places in the model, and remedies.

#include "model/steps/model.hpp"

#include <set>

namespace signorini::model {

/// A place related to a failure.
struct FailurePlace {
  std::string kind;  ///< "element", "contact point", "control point"
  std::string where; ///< name of the body, or of the contact
  int index;         ///< of the element (of the slave face for a contact point), of the control point; from 0
  VectorX reference; ///< X; for a control point its position
  VectorX current;   ///< x in the accepted state
  double value;      ///< J, gap, unbalanced force, or component of the direction
  Message what;      ///< J, gap, or the states between which a contact point alternates
};

struct Diagnosis {
  solve::Outcome outcome;               ///< the report's, or `indefinite` if that is the cause
  bool friction_exhausted = false;      ///< whether that is the cause, see sliding.hpp
  std::vector<Message> messages;        ///< reasons
  std::vector<Message> remedies;        ///< remedies
  std::vector<FailurePlace> places;     ///< worst first
  std::vector<FailurePlace> unbalanced; ///< control points with the largest unbalanced forces
};

/// Controls that are already on: "step", "line_search", "damping", "active_set_changes", "arc_length", "penalty",
/// "pseudo_transient".
using ControlsOn = std::set<std::string>;

/// Diagnoses the state in which a step failed; to be called before the roll-back. Costs a few factorizations if the
/// tangent is analyzed (null vector, directions of negative stiffness). Remedies do not include controls that are on.
template <int D>
Diagnosis diagnose(const Model<D>& model, const solve::NewtonReport& report, const ControlsOn& on = {});

} // namespace signorini::model
