#pragma once
// States of a contact point.

namespace signorini::contact {

/// Open: no traction (penalty), or beyond the distance of the strongest attraction (adhesion). Stick and slip: closed
/// (penalty), without friction always stick. Adhesion: closer than the distance of the strongest attraction. Bonded:
/// not closed, held by a cohesive bond.
enum class ContactState { open, stick, slip, adhesion, bonded };

/// True if the faces touch.
constexpr bool touches(ContactState state) {
  return state == ContactState::stick || state == ContactState::slip;
}

/// State to which a point is fixed, independent of its gap and friction; free: not fixed. Touching: stick or slip
/// according to the friction law.
enum class FixedContactState : unsigned char { free, open, touching, stick };

/// What is wrong with a formula of friction or wear at a point: friction jumps at the onset of slip, since it falls
/// faster than its spring can follow; the coefficient or the rate of wear is negative, and counts as 0; or it is not a
/// finite number.
enum class FrictionFlaw : unsigned char { none, jumps, negative, grows, undefined, undefined_wear };

/// "open", "stick", "slip", "adhesion", "bonded".
constexpr const char* name_of(ContactState state) {
  constexpr const char* names[] = {"open", "stick", "slip", "adhesion", "bonded"};
  return names[static_cast<int>(state)];
}

} // namespace signorini::contact
