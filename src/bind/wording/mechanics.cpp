#include "bind/wording/wording.hpp"

namespace signorini::bind {

namespace {

constexpr Wording mechanics_rows[] = {
    {"solid.archive.unknown_law", "material '{material}' cannot be saved: files do not know this law"},
    {"solid.archive.law", "the file names an unknown material law, number {number}"},
    {"solid.body.beyond_axis", "patch reaches {point}, beyond the axis x = 0 of an axisymmetric body; x is the radius "
                               "and must be positive. Hint: move the patch to x >= 0, or make the model plane"},
    {"solid.body.no_area", "the patch's map has no area (Jacobian {jacobian}) near {place}: it is folded into a line "
                           "there. Hint: move the control points apart"},
    {"solid.body.no_volume", "the patch's map has no volume (Jacobian {jacobian}) near {place}: it is folded flat "
                             "there. Hint: move the control points apart"},
    {"solid.body.left_handed", "the patch's map is not right-handed (Jacobian {jacobian}) near {place}. Hint: reverse "
                               "one parametric direction with patch:reverse(1), or untangle the control points"},
    {"solid.body.dimension", "a body of dimension {expected} was given a patch of dimension {dimension}"},
    {"solid.body.axisymmetric", "only plane bodies can be axisymmetric, got a body of dimension {dimension}"},
    {"solid.body.interrupted", "interrupted"},
    {"solid.body.internal_variables", "material '{material}' has {expected:internal variable} in this body, got "
                                      "{committed} committed and {trial} trial values"},
    {"solid.kernel.lacking", "SIGNORINI_KERNEL={name} needs instructions that this processor lacks; it runs up to "
                             "{widest}. Hint: unset the environment variable"},
    {"solid.kernel.unknown", "SIGNORINI_KERNEL must be sse2, avx2 or avx512, got '{name}'. Hint: unset the environment "
                             "variable for the fastest kernel"},
    {"solid.load.component", "the traction's component must lie in 0 … {most}, got {component}"},
    {"solid.material.youngs_modulus", "E must be a positive number (Young's modulus, force per area), got {value}"},
    {"solid.material.poissons_ratio", "nu must lie in (-1, 0.5) (Poisson's ratio; 0.5 is incompressible, which a "
                                      "displacement formulation cannot take), got {value}. Hint: try 0.49"},
    {"solid.quadrature.points", "a quadrature rule needs at least 1 point, got {count}"},
    {"contact.adhesion.hamaker",
     "adhesion.hamaker must be a positive number (Hamaker's constant, force times length), got {value}"},
    {"contact.adhesion.distance",
     "adhesion.r0 must be a positive number (equilibrium distance of the potential, a length), got {value}"},
    {"contact.archive.obstacle", "the file names an unknown kind of obstacle, number {number}"},
    {"contact.archive.own_formulation", "a contact with a user-defined formulation cannot be saved"},
    {"contact.archive.law", "the file names an unknown contact law, number {number}"},
    {"contact.archive.points", "a contact of {saved:point} was saved, this one has {count}"},
    {"contact.points.none",
     "where holds nowhere on the slave face: it must return true for the reference positions that take part"},
    {"contact.obstacle.radius", "radius must be a positive number (length), got {radius}"},
    {"contact.plane.finite", "point and normal of a plane must be finite numbers"},
    {"contact.plane.normal", "normal must not be zero: it points out of the obstacle, towards the body"},
    {"contact.obstacle.center", "centre must be finite numbers"},
    {"contact.cylinder.finite", "centre and axis of a cylinder must be finite numbers"},
    {"contact.cylinder.axis", "axis must not be zero: it is the direction of the cylinder"},
    {"contact.penalty.normal", "penalty must be positive (pressure per length), got {value}"},
    {"contact.penalty.friction", "friction.mu must not be negative, got {value}"},
    {"contact.penalty.tangential", "friction.penalty must be positive (pressure per length), got {value}"},
    {"solve.condensed.size", "the constant matrix of a condensed solver must have {expected} values, one for each "
                             "entry of the pattern, got {count}"},
    {"solve.condensed.contact", "the contact unknowns of a condensed solver must increase and lie in 0 … {most}"},
    {"solve.condensed.symmetric", "the constant matrix of a condensed solver must be symmetric"},
    {"solve.cholmod.tangent", "the sparse solver could not analyze the tangent (CHOLMOD status {status})"},
    {"solve.klu.analyze", "the sparse solver could not analyze the tangent (KLU status {status})"},
    {"solve.line_search.unknown", "line_search must be 'none', 'residual' or 'energy', got '{name}'"},
    {"solve.linear.unknown", "linear must be one of {known:quoted}, got '{name}'"},
    {"solve.linear.condensed", "linear = \"condensed\" needs a matrix that is constant but for contact, as bodies that "
                               "are all linear elastic have. Hint: take \"auto\""},
    {"solve.cholmod.matrix", "the sparse solver could not analyze the matrix (CHOLMOD status {status})"},
    {"solve.cholmod.order", "the sparse solver could not order the matrix (CHOLMOD status {status})"},
    {"solve.umfpack.analyze", "the sparse solver could not analyze the tangent (UMFPACK status {status})"},
};

} // namespace

std::span<const Wording> mechanics_wordings() {
  return mechanics_rows;
}

} // namespace signorini::bind
