#include "bind/wording/wording.hpp"

namespace signorini::bind {

namespace {

constexpr Wording nurbs_rows[] = {
    {"nurbs.basis.derivative", "a space without knots has derivatives up to order 2, got {order}"},
    {"nurbs.body.seam", "contact face '{face}' is the seam of a closed body, where it meets its opposite face. Hint: "
                        "name a face of the outer surface"},
    {"nurbs.body.torn_layer",
     "face '{face}' of this body collapses across the layer on contact face '{contact}', which would tear it open "
     "there. Hint: take one label for all rows, such as N2, or another contact face"},
    {"nurbs.ruled.dimension", "both patches must lie in the same space, got dimension {first} and {second}. Hint: "
                              "patch:to_space{{ z = 0 }} or patch:to_plane() brings one to the other's"},
    {"nurbs.ruled.directions",
     "both patches must have the same number of parametric directions, got {first} and {second}"},
    {"nurbs.ruled.volumes", "a ruled patch lies between two curves or two surfaces, got volumes"},
    {"nurbs.extrude.length", "along must not be zero: it is the vector to sweep along"},
    {"nurbs.extrude.volume", "only a curve or a surface can be swept, got a volume"},
    {"nurbs.revolve.patch",
     "only a curve or a surface in 3D can be revolved, got {directions:parametric direction} in {dimension}D"},
    {"nurbs.revolve.angle", "angle must lie between -360 and 360 degrees and not be 0, got {angle}"},
    {"nurbs.coons.apart", "'{first}' and '{second}' must meet, but one is at {at}, the other at {other}. Hint: each "
                          "must run along the rising parameter, west to east, south to north, front to back"},
    {"nurbs.coons.weights",
     "'{first}' and '{second}' must meet with one weight, but at {at} they have {one} and {other}"},
    {"nurbs.coons.count",
     "four curves (west, east, south, north) or six surfaces (also front, back) are needed, got {count}"},
    {"nurbs.coons.directions",
     "'{face}' must have {expected:parametric direction} as one of {count}, got {directions}"},
    {"nurbs.coons.dimension", "'{face}' must lie in space of dimension {expected} as 'west' does, got {dimension}"},
    {"nurbs.coons.blend", "the boundary's weights blend to {weight} inside, which must be positive. Hint: give "
                          "boundaries whose weights differ less"},
    {"nurbs.line.point", "a line must have two different ends, got {point} twice"},
    {"nurbs.arc.radius", "radius must be a positive length, got {radius}"},
    {"nurbs.arc.angles", "the arc's angles must be finite numbers of degrees, got {start} and {stop}"},
    {"nurbs.arc.empty", "the arc must have two different angles, but it starts and ends at {angle} degrees"},
    {"nurbs.arc.turn", "the arc must not exceed a full turn, got {start} to {stop} degrees"},
    {"nurbs.body.elements", "elements must have {expected} numbers, one per parametric direction, got {count}"},
    {"nurbs.body.grading", "grading must have {expected} entries, one per parametric direction, got {count}"},
    {"nurbs.body.contact_count", "contact must name one face or two opposite ones, got {count}"},
    {"nurbs.body.contact_meets", "contact must name opposite faces, but '{first}' and '{second}' meet"},
    {"nurbs.body.contact_twice", "contact must name different faces, got '{face}' twice"},
    {"nurbs.body.labels", "order must have {expected:label}, one per direction along the contact face, got {count}"},
    {"nurbs.body.mixed_labels", "order '{first}' and '{second}' cannot be mixed: a body is of L or of N elements"},
    {"nurbs.body.layer_nowhere", "order '{label}' has a layer, but the body names no contact face to put it on. Hint: "
                                 "add contact = \"south\" or the like"},
    {"nurbs.body.layer_depths",
     "order '{label}' and '{other}' must have layers of the same depth. Hint: give both the same xr"},
    {"nurbs.body.degree", "order '{label}' asks for degree {degree}, but the geometry is of degree {lowest} there; "
                          "N{lowest} is the lowest that is exact"},
    {"nurbs.body.through", "through must be at least the geometry's own degree, {lowest}, got {degree}"},
    {"nurbs.space.ends", "the first function of a body's spaces must be 1 at their start, the last at their end"},
    {"nurbs.body.layer_too_deep", "order '{label}' has a layer of {rows:row}, but the body has only {available:row} of "
                                  "control points in its thickness direction"},
    {"nurbs.body.rows", "a body of {expected:row} of control points was given {count}"},
    {"nurbs.body.row_dimension", "a body's rows must have one dimension less than space"},
    {"nurbs.body.row_elements", "all rows of a body must have the same elements"},
    {"nurbs.body.face_across_layer", "face '{face}' crosses the layer of this body, so it is not a NURBS of its own. "
                                     "Hint: contact and loads act on '{contact}'; or take a uniform label"},
    {"nurbs.patch.parameters",
     "xi must have {expected:parameter}, one per parametric direction of the patch, got {count}"},
    {"nurbs.patch.derivative", "derivatives must be of order 0 … {most}, got {order}"},
    {"nurbs.grading.share", "grading.{argument} must be a share between 0 and 1, got {share}"},
    {"nurbs.grading.elements",
     "elements must be at least {least}, which the patch's own knots make in this direction, got {elements}"},
    {"nurbs.knots.degree", "degree must lie in 0 … {most}, got {degree}"},
    {"nurbs.knots.count", "knots of degree {degree} must be at least {least} ({ends} at each end), got {count}"},
    {"nurbs.knots.finite", "knots must be finite numbers, but knot {number:+1} is {knot}"},
    {"nurbs.knots.order",
     "knots must not fall, but knot {number:+1} ({knot}) is below knot {before:+1} ({knot_before})"},
    {"nurbs.knots.equal", "knots must rise, but all are {knot}"},
    {"nurbs.knots.interior",
     "interior knot {knot} occurs {count:time}, more than the degree {degree}: the curve would fall apart there"},
    {"nurbs.knots.close",
     "knots {knot} and the next one differ by only {distance}. Hint: make them equal or move them apart"},
    {"nurbs.knots.outside", "xi = {xi} is outside the knots, [{first}, {last}]"},
    {"nurbs.knots.just_outside", "xi = {xi} is outside the knots, [{first}, {last}], by {distance}"},
    {"nurbs.knots.first_ends",
     "the first knot, {knot}, occurs {count:time}; an open knot vector of degree {degree} repeats it {expected:time}"},
    {"nurbs.knots.last_ends",
     "the last knot, {knot}, occurs {count:time}; an open knot vector of degree {degree} repeats it {expected:time}"},
    {"nurbs.label.degree", "order '{label}' has degree {degree}, which must lie in 1 … {most}"},
    {"nurbs.label.unknown", "order must be a discretization label, got '{label}'; labels read Np (N2), Np.s (N2.1), Lp "
                            "(L2), Nb-Nc (N2-N4), Nb-Nc.s (N2-N2.2), or Nb-Nc.sxr (N2-N2.2x2)"},
    {"nurbs.label.bulk", "order '{label}' must have a plain bulk, Np, below its layer. Hint: write N{degree}{layer}"},
    {"nurbs.label.layer_degree",
     "order '{label}' has a layer of degree {degree}, which must not be below the bulk's, {bulk}"},
    {"nurbs.label.layer_depth", "order '{label}' has a layer {rows:row} deep; x1 is the least"},
    {"nurbs.patch.directions", "a patch must have 1 to 3 parametric directions, got {count}"},
    {"nurbs.patch.coordinates", "points must have 2 or 3 coordinates, got {count}"},
    {"nurbs.patch.dimension", "a patch of {directions:parametric direction} does not fit into space of dimension "
                              "{dimension}. Hint: give the points {directions:coordinate}"},
    {"nurbs.patch.degree", "degree must be 1 or higher in every direction of a patch"},
    {"nurbs.patch.weight", "weights must be positive numbers, but weight {number:+1} is {weight}"},
    {"nurbs.patch.point",
     "points must be finite numbers, but control point {number:+1} has a coordinate that is not finite"},
    {"nurbs.patch.weights", "weights must be as many as the control points, {points}, got {count}"},
    {"nurbs.patch.direction",
     "direction must lie in 1 … {count}, the patch's parametric directions, got {direction:+1}"},
    {"nurbs.insert.outside", "knots must lie between {first} and {last} to be inserted, got {knot}"},
    {"nurbs.insert.multiplicity",
     "knot {knot} would occur {count:time}, more than the degree {degree}; it is there {present:time} already"},
    {"nurbs.elevate.times", "times must be 0 or more, got {times}"},
    {"nurbs.elevate.degree", "degree {degree} + {times} is above the highest, {most}"},
    {"nurbs.elevate.lowered", "degree must not be below the patch's own, {own} in direction {direction:+1}, got "
                              "{degree}; degrees are raised, never lowered"},
    {"nurbs.elevate.highest", "degree must not be above the highest, {most}, got {degree}"},
    {"nurbs.shapes.length", "{argument} must be a positive length, got {length}"},
    {"nurbs.shapes.rounding", "{argument} = {length} is lost in rounding error next to {coordinate} = {start}. Hint: "
                              "move the shape towards the origin"},
    {"nurbs.shapes.radii", "inner must be below outer, {outer}, got {inner}"},
    {"nurbs.shapes.cap_elements", "elements must be 1 or more per direction of the cap, got {elements}"},
    {"nurbs.shapes.cap_radius", "radius must be at least half the diagonal, {least}, so that the sphere reaches the "
                                "corners, got {radius}. Hint: take a larger radius"},
    {"nurbs.shapes.cap_height", "height must be above {cap}, by which the cap rises to its corners, got {height}. "
                                "Hint: give a larger height or radius"},
    {"nurbs.face.direction",
     "the face's direction must lie in 1 … {count}, the patch's parametric directions, got {direction:+1}"},
    {"nurbs.face.curve", "a curve has end points, not faces. Hint: take a surface or a volume"},
    {"nurbs.row.direction",
     "the row's direction must lie in 1 … {count}, the patch's parametric directions, got {direction:+1}"},
    {"nurbs.row.number", "row must lie in 1 … {count}, got {row:+1}"},
    {"nurbs.face.unknown", "face must be one of {known}, the ends of {ends:and}, got '{face}'{suggestion}"},
    {"nurbs.face.did_you_mean", ". Hint: did you mean '{face}'?"},
    {"nurbs.space.breakpoints", "a space of {elements:element} must have one breakpoint and one order of smoothness "
                                "more, got {breakpoints} and {smoothness}"},
    {"nurbs.space.rising", "the breakpoints of a space must be finite and rise, got {first} and {second}"},
    {"nurbs.space.degree", "the degree of a space must lie in 0 … {most}, got {degree}"},
    {"nurbs.space.extraction",
     "element {element:+1} of degree {degree} has {functions:function} with an extraction of {rows} x {columns}"},
    {"nurbs.space.sum", "the functions of element {element:+1} must sum to 1"},
    {"nurbs.space.numbers", "the functions of element {element:+1} must be numbered from 0 and rise"},
    {"nurbs.space.unused", "every function of a space must live on an element"},
    {"nurbs.transform.coordinates", "{argument} must have {expected:coordinate}, got {count}"},
    {"nurbs.transform.finite", "{argument} must have finite numbers, got {point}"},
    {"nurbs.transform.angle", "angle must be a finite number of degrees, got {angle}"},
    {"nurbs.transform.axis", "axis must not be zero: it is the direction of the axis"},
    {"nurbs.transform.plane_axis",
     "axis is for patches in 3D, a plane patch turns about its center. Hint: leave the axis out"},
    {"nurbs.to_space.dimension", "the patch lies in 3D already. Hint: patch:translate moves it there"},
    {"nurbs.to_space.z", "z must be a finite number, got {z}"},
    {"nurbs.to_plane.volume", "a volume does not fit into the plane. Hint: take one of its faces"},
    {"nurbs.to_plane.slanted", "the control points must have one z for all, but z goes from {low:6} to {high:6}. Hint: "
                               "turn the patch with patch:rotate first"},
    {"nurbs.transform.zero_factor", "factors must be positive, got {factor}, which would leave nothing of the patch"},
    {"nurbs.transform.negative_factor", "factors must be positive, got {factor}, which would turn the patch inside "
                                        "out. Hint: take patch:mirror{{ normal = … }} for a mirror image"},
    {"nurbs.mirror.normal", "normal must not be zero: it is the direction across the mirror"},
    {"nurbs.body.surface", "patch must be a surface for a body of dimension 2, got {directions:parametric direction}"},
    {"nurbs.body.volume", "patch must be a volume for a body of dimension 3, got {directions:parametric direction}"},
    {"nurbs.patch.points", "points must be {expected} as the degrees and knots ask ({factors:·}), got {count}"},
};

} // namespace

std::span<const Wording> nurbs_wordings() {
  return nurbs_rows;
}

} // namespace signorini::bind
