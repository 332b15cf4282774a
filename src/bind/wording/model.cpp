#include "bind/wording/wording.hpp"

namespace signorini::bind {

namespace {

constexpr Wording model_rows[] = {
    {"model.arc.no_path", "an arc needs a path. Hint: set a target other than the accepted one"},
    {"model.arc.length", "length of an arc must be positive, got {length}"},
    {"model.checkpoint.size", "a state of {saved} degrees of freedom was saved, the model has {dofs}"},
    {"model.checkpoint.internal_variables", "a body with {saved:internal variable} was saved, this one has {count}"},
    {"model.checkpoint.unsettled",
     "the file would hold the accepted state alone, and there are a step, targets or penalties that are not accepted. "
     "Hint: call model:accept() to keep them, or model:rollback() first"},
    {"model.checkpoint.dimension", "'{file}' holds a model of dimension {dimension}, this one has {expected}. Hint: "
                                   "name the file that this model's run has written, or start again without it"},
    {"model.checkpoint.scene", "'{file}' was saved of another scene; differences: {differences}. Hint: name another "
                               "file, or remove this one to start again"},
    {"model.support.axis", "supports.{support} must rotate about a unit vector"},
    {"model.drive.unknown", "drive {drive} is unknown; the model has {count}"},
    {"model.drive.component", "'{drive}' has no component {component}; it has {count}"},
    {"model.face.no_area",
     "face '{face}' has no area: it is collapsed to a line or a point, and has no centroid to turn about"},
    {"model.step.no_residual", "the present state has no residual: {why}. Hint: call model:rollback()"},
    {"model.step.unbalanced", "the state is not in equilibrium yet: its residual is {residual}, asked is {enough}. "
                              "Hint: move on, or call model:rollback()"},
    {"model.field.unknown", "unknown field '{field}'; known: {known}, contact_pressure"},
    {"model.linear.condensed", "linear = \"condensed\" needs bodies that are all linear elastic, and a contact, "
                               "without damping of unconstrained bodies. Hint: use \"auto\""},
    {"model.move.size", "a move must have {expected} values, one per unknown, got {count}"},
    {"model.move.finite", "a move must have finite values"},
    {"model.penalty.factor", "the penalty's factor must be positive, got {factor}"},
    {"model.accept.unsolved",
     "no step has been solved since targets or penalties were changed. Hint: solve one, or call model:rollback()"},
    {"model.accept.iterating", "the step is not in equilibrium yet. Hint: iterate on until its reason is "
                               "\"converged\", or call model:rollback()"},
    {"model.accept.failed",
     "the step has failed ({reason}), its state is not in equilibrium. Hint: call model:rollback()"},
    {"model.archive.parts", "the file's scene has only {count:part}"},
    {"model.scene.no_body", "bodies must have at least one body"},
    {"model.scene.own_face", "contacts.{contact} has the same face as slave and as master; a face cannot touch itself. "
                             "Hint: name the other body's face as master"},
    {"model.scene.kind", "bodies.{body} must be of the scene's kind (plane strain or axisymmetric)"},
    {"model.scene.held_twice",
     "supports.{support} {verb} {component} of a control point that supports.{other} {other_verb} already. Hint: a "
     "component is held by one support, take it out of one of the two"},
    {"model.verb.fixes", "fixes"},
    {"model.verb.drives", "drives"},
    {"model.verb.turns", "turns"},
    {"model.face.of_body", "face '{face}' of body '{body}'"},
    {"model.face.obstacle", "one obstacle"},
    {"model.field.pressure_known", "contact_pressure is known on slave faces alone; on this body give {places}. Hint: "
                                   "or take model:profile(contact)"},
    {"model.field.pressure_nowhere", "contact_pressure is known on slave faces alone; no face of this body is one. "
                                     "Hint: take the other body, or model:profile(contact)"},
    {"model.field.pressure_place", "xi[{direction:+1}] = {xi} (contact '{contact}')"},
    {"model.warning.locking",
     "bodies.{body}: at Poisson's ratio {nu} elements of degree {degree} (along xi{direction:+1}) lock: displacements "
     "come out too small, forces too large. Hint: take {cure}"},
    {"model.locking.nu", "nu = {nu} or less"},
    {"model.locking.degree", "degree 2 or more in all directions (order N2 or above, through = 2 or left out)"},
    {"model.locking.both", "nu = {nu} or less, and degree 2 or more in all directions"},
    {"model.warning.friction", "contacts.{contact}: friction.mu = {mu} is far above what materials have; mu is the "
                               "tangent of the angle of friction{hint}"},
    {"model.warning.friction_angle", ". Hint: for an angle of {angle} degrees mu = {mu:6}"},
    {"model.warning.stiffness", "contacts.{contact}: penalty = {penalty} is {ratio:6} times the stiffness E/h of an "
                                "element of body '{body}': over this range of stiffness the body's share is lost in "
                                "rounding error. Hint: 10 to 1000 times E/h = {stiffness:6} is usual"},
    {"model.warning.twins", "contacts.{first} and contacts.{second} act between the same faces, {slave} and {master}, "
                            "so pressures count twice. Hint: take one of the two out, or part them by where"},
    {"model.warning.overlap",
     "contacts.{contact}: {slave} penetrates {master} by {depth:6} before the first step, at {at}, which is {percent} "
     "% of the thickness of the thinner body. Hint: the first step removes an overlap that is meant (an interference "
     "fit); otherwise move the bodies apart, or check that both faces are the right ones and no normal is reversed"},
    {"model.clearance.overlap",
     "contacts.{contact}: {slave} penetrates {master} by {depth:6} before the first step, at {at}, which is {percent} "
     "% of the thickness of the thinner body, more than {most} %. Hint: {hint}"},
    {"model.clearance.wrong_face",
     "the master may be the wrong face, with its normal pointing away from the slave; did you mean face '{face}'?"},
    {"model.clearance.apart", "move the bodies apart; if they are in place, the slave or the master is the wrong face, "
                              "or its normal is reversed"},
    {"model.clearance.inside",
     "contacts.{contact}: the obstacle is inside body '{body}' at the start: the face reaches {depth} deep into it at "
     "{at}. Hint: move the obstacle out, or reverse its normal"},
    {"model.clearance.inside_patch",
     "contacts.{contact}: the obstacle is inside body '{body}' at the start: the face reaches {depth} deep into it at "
     "{at}. Hint: move the obstacle out, or reverse its normal by patch:reverse(1)"},
    {"model.clearance.middle", "contacts.{contact}: the obstacle holds the middle of body '{body}' at the start, {at}. "
                               "Hint: reverse the plane's normal, which points out of the obstacle, towards the body"},
    {"model.clearance.center", "contacts.{contact}: the obstacle is inside body '{body}' at the start: its center "
                               "{center} lies in the body. Hint: move the obstacle out"},
    {"model.warning.inverted",
     "bodies.{body}: the linear elastic body is turned inside out in element {element:+1} (det F = {determinant:6}) at "
     "X = {place}, far beyond small strains. Hint: take sg.neo_hookean, or smaller loads and displacements"},
};

} // namespace

std::span<const Wording> model_wordings() {
  return model_rows;
}

} // namespace signorini::bind
