#include "bind/wording/wording.hpp"

namespace signorini::bind {

namespace {

constexpr Wording failure_rows[] = {
    {"solve.newton.interrupted", "stopped by Ctrl-C"},
    {"solve.newton.not_finite", "the residual is not a finite number"},
    {"solve.newton.diverged", "the residual grew to {residual}"},
    {"solve.newton.no_convergence",
     "no convergence in {iterations:iteration}; the residual is {residual}, asked was {enough}"},
    {"solve.newton.near_rounding", "no convergence in {iterations:iteration}; the residual is {residual}, asked was "
                                   "{enough}, near what rounding leaves of it"},
    {"solve.newton.singular", "the tangent is singular"},
    {"solve.newton.line_search",
     "line search: no part of the move down to 1/128 brings the residual, {residual}, down"},
    {"model.step.inverted", "element {element:+1} of body '{body}' is inverted (J = {jacobian}) at X = {place}"},
    {"model.step.cycling", "the states of contact points repeat every {period:iteration}"},
    {"model.step.changing", "the states of contact points keep changing"},
    {"model.step.held_points", "points that were held do not keep their states when they are freed"},
    {"model.step.penetration",
     "points that press are up to {distance} off the master after {loops:augmentation}, asked was {enough}"},
    {"model.diagnosis.points",
     "{count:point} of contact '{contact}', the first in slave element {element:+1} at X = {place}"},
    {"model.diagnosis.moves", "in its direction body '{body}' moves as a whole along {direction}"},
    {"model.diagnosis.turns", "in its direction body '{body}' turns as a whole"},
    {"model.diagnosis.moves_most",
     "in its direction, control point {point:+1} of body '{body}' at X = {place} moves most"},
    {"model.diagnosis.indefinite", "the tangent is indefinite there"},
    {"model.diagnosis.stiffness",
     "the penalty of contact '{contact}' is {ratio:6} times the stiffness E/h of an element of body '{body}'"},
    {"model.diagnosis.rounding",
     "the penalty of contact '{contact}' is {ratio:6} times the stiffness E/h of an element of body '{body}', and this "
     "range of stiffness is the cause: the body's share is lost in rounding error"},
    {"model.spot.jacobian", "J = {jacobian:6}"},
    {"model.spot.gap", "gap {gap:6}"},
    {"model.spot.direction", "part of the direction {part:6}"},
    {"model.spot.force", "unbalanced force {force:6}"},
    {"model.spot.states", "{states}"},
    {"model.cure.iterations", "allow more iterations (newton = {{ iterations = … }})"},
    {"model.cure.step", "take smaller steps (step = {{ adaptive = true }})"},
    {"model.cure.step_min", "allow smaller steps (step = {{ min = … }})"},
    {"model.cure.tolerance", "where rounding error is the limit, take a looser newton.tolerance or a lower penalty"},
    {"model.cure.line_search", "use a line search (newton = {{ line_search = \"residual\" }})"},
    {"model.cure.points", "take more contact points per element (points)"},
    {"model.cure.active_set", "hold points that change too often (newton = {{ active_set_changes = 4 }})"},
    {"model.cure.pseudo_transient", "let the bodies come to rest as in a viscous medium (pseudo_transient = true)"},
    {"model.cure.extend_master", "extend the master face beyond where the slave face reaches"},
    {"model.cure.end_path", "end the path before it"},
    {"model.cure.mesh", "take a mesh that can follow the deformation"},
    {"model.cure.support", "hold the body with a support"},
    {"model.cure.damping", "damping = true carries a body that only contact will hold until it touches"},
    {"model.cure.arc_length",
     "the state may be at or beyond a limit of stability: arc_length = true follows the path around it"},
    {"model.cure.stability", "the state may be at or beyond a limit of stability"},
    {"model.cure.no_line_search", "take no line search"},
    {"model.cure.penalty", "raise the penalty"},
    {"model.cure.augmented",
     "allow more loops (augmented = {{ loops = … }}) or more penetration; where a curved master meets more contact "
     "points than the slave has control points, some penetration always remains"},
    {"model.cure.first_step",
     "the first step may lead beyond a limit of stability, or be too long for contact with friction"},
    {"model.cure.penalty_growth", "let the penalties grow (penalty = {{ start = 0.01, steps = 20 }})"},
    {"model.cure.no_arc_yet", "arcs can only begin where a step was accepted"},
    {"model.cure.friction", "contact '{contact}' is frictionless, so nothing holds body '{body}' along it: give the "
                            "contact friction = {{ mu = …, penalty = … }}, or the body a support"},
    {"model.cure.lower_penalty",
     "lower the penalty of contact '{contact}': 10 to 1000 times E/h = {stiffness:6} is usual"},
};

} // namespace

std::span<const Wording> failure_wordings() {
  return failure_rows;
}

} // namespace signorini::bind
