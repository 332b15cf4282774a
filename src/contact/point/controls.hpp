#pragma once
// Rules of a step that take precedence over the gap and friction of constraints.

#include "contact/point/local.hpp"

#include <cmath>
#include <optional>
#include <vector>

namespace signorini::contact {

struct Controls {
  std::vector<FixedContactState> fixed_states = {}; ///< one entry per constraint; empty: all are free
  /// Contact tolerance of a step's first guess, where otherwise rounding error would decide the states. Free points
  /// with a distance to contact below it, on either side, touch and stick. Points whose slip is within this distance of
  /// Coulomb's cone (all that slipped in the last step) continue to slip if the path continues in its direction
  /// (`onward`), and stick at a turning point. 0: no rule.
  double guessed = 0;
  bool onward = false;
  /// Touching points stick at any trial slip, while an unconstrained body comes into contact. It first penetrates far
  /// too deep; slipping points would change their direction of slip in every iteration.
  bool all_stick = false;
  /// The state is the guess of the step, its first state away from the accepted one: points that it closes slip from
  /// where they touch on the way to it (touch.hpp), for the whole step. Not with `all_stick`: damping moves a body
  /// until some points touch, and the others, without a forecast, would pull against these.
  bool foresees = false;

  FixedContactState fixed(int constraint) const {
    return fixed_states.empty() ? FixedContactState::free : fixed_states[constraint];
  }
  /// Distance from Coulomb's cone within which a trial slip sticks, if negative slips.
  double tie() const { return onward ? -guessed : guessed; }
  /// The fixed state of a constraint that is closed, none if it is open. `distance`: negative where a free one closes.
  std::optional<FixedContactState> closed(int constraint, double distance) const {
    const FixedContactState state = fixed(constraint);
    if (state == FixedContactState::open) return {};
    if (state != FixedContactState::free) return state;
    if (std::abs(distance) < guessed) return FixedContactState::stick;
    if (distance >= 0) return {};
    return all_stick ? FixedContactState::stick : state;
  }
};

} // namespace signorini::contact
