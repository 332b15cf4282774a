-- Pages: shapes and patches.

local patch_types = require "signorini.call.patch_types"
local t = require "signorini.call.types"

local a_patch = t.object "patch"

local function radii(where)
  return { "inner", t.positive, "inner radius" .. where, unit = "length" },
    { "outer", t.positive, "outer radius" .. where, unit = "length" }
end
local inner, outer = radii ""
local radius = { "radius", t.positive, "radius", unit = "length" }
local width = { "width", t.positive, "size along y", unit = "length" }
local axis_start = { "center", t.space_point, "start of the axis", default = { 0, 0, 0 }, unit = "length" }
local center_in_plane = { "center", t.plane_point, "center of the circles", default = { 0, 0 }, unit = "length" }
local center_in_space = { "center", t.space_point, "center of the spheres", default = { 0, 0, 0 }, unit = "length" }

--- The sentence about the result of shapes of several patches.
local function several(boundaries)
  return ([[
The result is a list of patches with a field boundaries = { %s }, lists of faces such as "2.south", the face south of
the second patch. Neighboring faces have the same knots, points and weights; they stay so if all patches are refined by
the same numbers.]]):format(boundaries)
end

return {
  title = "Shapes and patches", word = "patches",
  { "sg.shapes.rectangle", "Returns a rectangle of degree 1; xi1 along x, xi2 along y.",
    named = { { "width", t.positive, "size along x", unit = "length" },
              { "height", t.positive, "size along y", unit = "length" },
              { "corner", t.plane_point, "lower left corner", default = { 0, 0 }, unit = "length" } },
    returns = a_patch, example = "sg.shapes.rectangle{ width = 3, height = 1 }" },
  { "sg.shapes.half_annulus", [[Returns the lower half of a ring: xi1 along the arc from the left end over the bottom to
the right end (two quarter arcs, degree 2), xi2 from the outer (south) to the inner radius (north). The flat ends are
west and east.]],
    named = { inner, outer, center_in_plane },
    returns = a_patch, example = "sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = {0.75, 1.5} }" },
  { "sg.shapes.quarter_annulus", [[Returns a quarter ring, counterclockwise: xi1 along the arc (degree 2), xi2 from the
outer (south) to the inner radius (north).]],
    named = { inner, outer, center_in_plane,
              { "start", t.number, "angle of the first end", default = 270, unit = "degrees" } },
    returns = a_patch, example = "sg.shapes.quarter_annulus{ inner = 0.5, outer = 1, start = 0 }" },
  { "sg.shapes.ring", [[Returns a full ring: xi1 once around, counterclockwise from the highest point (four quarter
arcs, degree 2; west and east are the seam, whose two sides share their unknowns), xi2 from the outer (south) to the
inner radius (north).]],
    named = { inner, outer, center_in_plane },
    returns = a_patch, example = "sg.shapes.ring{ inner = 0.5, outer = 1 }" },
  { "sg.shapes.disc", [[Returns a disc of five patches of degree 2 without singular points. 1 (below), 2 (right), 3
(above) and 4 (left) have a quarter of the circle each: xi1 counterclockwise along it, xi2 from the circle (south) to
the core (north), the neighbors are at west and east. 5 is the core, a square with its corners at half the radius, xi1
along x, xi2 along y. Boundary: outer, the circle.]],
    named = { radius, center_in_plane }, more = several "outer",
    returns = patch_types.several, example = "disc = sg.shapes.disc{ radius = 1 }\nsg.picture{ patch = disc }" },
  { "sg.shapes.polar_disc", [[Returns a disc of one patch: xi1 once around, counterclockwise from the highest point
(west and east are the seam), xi2 from the circle (south) to the center, to which north is collapsed: the map is
degenerate there. sg.shapes.disc has no such point.]],
    named = { radius, center_in_plane },
    returns = a_patch, example = "sg.shapes.polar_disc{ radius = 1 }" },
  { "sg.shapes.hook", [[Returns a snap-fit hook of degree 1: a beam along x with a nose on its upper side, xi1 along x,
xi2 along y. west is the root, east the tip, south the straight lower side, north the upper side with the nose: beam,
retention face, land and insertion face, with knots at the edges between them. sg.nurbs.extrude makes a solid of it.]],
    named = { { "length", t.positive, "from the root to the nose", unit = "length" },
              { "thickness", t.positive, "thickness of the beam", unit = "length" },
              { "nose", t.positive, "height of the nose above the beam", unit = "length" },
              { "land", t.positive, "length of the nose's flat top", unit = "length" },
              { "insertion", t.number, "angle between the insertion face and x, below 90", default = 30,
                unit = "degrees" },
              { "retention", t.number, "angle between the retention face and x, 90: upright", default = 90,
                unit = "degrees" },
              { "corner", t.plane_point, "lower corner of the root", default = { 0, 0 }, unit = "length" } },
    returns = a_patch, example = {
      "sg.shapes.hook{ length = 10, thickness = 1.5, nose = 1, land = 0.5, retention = 45 }",
      "flat = sg.shapes.hook{ length = 10, thickness = 1.5, nose = 1, land = 0.5 }\n"
        .. "hook = sg.nurbs.extrude{ patch = flat, along = {0, 0, 4} }" } },
  { "sg.shapes.block", "Returns a block of degree 1; xi1, xi2, xi3 along x, y, z.",
    named = { { "size", t.space_point, "sizes along x, y, z", unit = "length" },
              { "corner", t.space_point, "corner with the smallest x, y, z", default = { 0, 0, 0 }, unit = "length" } },
    returns = a_patch, example = "sg.shapes.block{ size = {6, 4, 2} }" },
  { "sg.shapes.half_cylinder_shell", [[Returns the lower half of a pipe along y: xi1 along the arc (degree 2), xi2 along
y, xi3 from the outer (front) to the inner radius (back). With its center at the origin, west (x < 0) and east (x > 0)
are in z = 0, south in y = 0, north in y = width.]],
    named = { inner, outer, width, axis_start },
    returns = a_patch, example = "sg.shapes.half_cylinder_shell{ inner = 0.3, outer = 0.5, width = 2 }" },
  { "sg.shapes.tube", [[Returns a pipe along y: xi1 once around from the highest line (degree 2; west and east are the
seam, whose two sides share their unknowns), xi2 along y, xi3 from the outer (front) to the inner radius (back). With
its center at the origin, south is in y = 0, north in y = width. patch:rotate turns it.]],
    named = { inner, outer, width, axis_start },
    returns = a_patch, example = "sg.shapes.tube{ inner = 0.4, outer = 0.5, width = 2 }" },
  { "sg.shapes.cylinder", [[Returns a solid cylinder along y of five patches of degree 2 without singular points, the
extruded sg.shapes.disc. 1 (below), 2 (right), 3 (above) and 4 (left): xi1 along the circle, xi2 along y, xi3 from the
circle (front) to the core (back). 5 is the core; xi1, xi2, xi3 along x, y, z. Boundaries: outer, the curved surface;
south and north, the flat ends, with the center at the origin in y = 0 and y = width.]],
    named = { radius, width, axis_start }, more = several "outer, south, north",
    returns = patch_types.several, example = "sg.shapes.cylinder{ radius = 0.5, width = 2 }" },
  { "sg.shapes.polar_cylinder", [[Returns a solid cylinder along y of one patch: xi1 once around from the highest line
(west and east are the seam), xi2 along y, xi3 from the circle (front) to the axis, to which back is collapsed: the map
is degenerate there. With its center at the origin, south is in y = 0, north in y = width.]],
    named = { radius, width, axis_start },
    returns = a_patch, example = "sg.shapes.polar_cylinder{ radius = 0.5, width = 2 }" },
  { "sg.shapes.torus", [[Returns a solid torus about the z axis of five patches of degree 2 without singular points,
sg.shapes.disc around a circle. 1 (below), 2 (outside), 3 (above), 4 (inside): xi1 along the section's circle, xi2 once
around the axis (south and north are the seam), xi3 from the surface (front) to the core (back). 5 is the core: xi1 away
from the axis, xi3 along z. Boundary: outer, the surface.]],
    named = { { "radius", t.positive, "distance of the section's center from the axis", unit = "length" },
              { "section", t.positive, "radius of the section, below radius", unit = "length" },
              { "center", t.space_point, "center of the torus", default = { 0, 0, 0 }, unit = "length" } },
    more = several "outer",
    returns = patch_types.several, example = "sg.shapes.torus{ radius = 2, section = 0.5 }" },
  { "sg.shapes.ball", [[Returns a solid ball of seven patches of degree 4 without singular points. 1 (below), 2 (+x), 3
(+y), 4 (-x), 5 (-y) and 6 (above) have a sixth of the sphere each, exact (J. E. Cobb 1988): front is the sphere, back
the core, the other four faces are the neighbors'. 7 is the core, a cube along the axes with its corners at half the
radius. xi1 and xi2 of patch 1 and all of the core run along x, y, z. Boundary: outer, the sphere. Bodies need at least
the label N4.]],
    named = { radius, center_in_space }, more = several "outer",
    returns = patch_types.several, example = "#sg.shapes.ball{ radius = 1 }  --> 7" },
  { "sg.shapes.polar_ball", [[Returns a solid ball of one patch of degree 2: xi1 once around the z axis from x over y
(west and east are the seam), xi2 from the upper to the lower pole, xi3 from the sphere (front) to the center. The map
is degenerate on the axis, to which south (z > 0) and north (z < 0) are collapsed, and in the center, back. With N2 it
has fewer unknowns than sg.shapes.ball, but its elements are narrow at the poles, where it should not touch.]],
    named = { radius, center_in_space },
    returns = a_patch, example = "sg.shapes.polar_ball{ radius = 1 }" },
  { "sg.shapes.sphere_octant", [[Returns the lower octant of a hollow sphere: xi1 around the z axis, xi2 from the
equator to the pole, xi3 from the outer (front) to the inner radius (back). With its center at the origin it occupies x,
y > 0 and z < 0: west is in y = 0, east in x = 0, south in z = 0; north is the axis x = y = 0, where the map is
degenerate. For symmetry, fix west along y and east along x.]],
    named = { inner, outer, center_in_space },
    returns = a_patch, example = "sg.shapes.sphere_octant{ inner = 0.5, outer = 1 }" },
  { "sg.shapes.hollow_hemisphere", [[Returns the lower half of a hollow sphere, exact, of degree 2; xi3 from the outer
(front) to the inner radius (back). The map has poles, where an edge collapses to a point.]],
    named = { inner, outer, center_in_space,
              { "poles", t.choice { "ends", "bottom" }, [["ends": at both ends of the ring's diameter along y, none
where it touches a plane below. xi1 runs from -x over the bottom to x, xi2 from -y to y; the flat ring on top, in z = 0
with the center at the origin, is two faces, west (x < 0) and east (x > 0); south and north are degenerate, on the line
x = z = 0. "bottom": one pole, at the lowest point. xi1 runs once around the z axis (at least 4 elements), xi2 from the
ring down to the pole; the flat ring in z = 0 is one face, south, and the mesh the same at every angle; north is the
axis x = y = 0, west and east are the seam in y = 0.]], default = "ends" } },
    returns = a_patch, example = "sg.shapes.hollow_hemisphere{ inner = 2/3, outer = 1, center = {0, 0, 3} }" },
  { "sg.shapes.spherical_indenter", [[Returns a block with a flat top whose bottom (front) is a spherical cap,
approximated by biquadratic elements that interpolate the sphere. west, east, south and north are in x = 0, x = width, y
= 0 and y = depth, back in z = height. The cap's own knots keep their continuity with every order label; with elements =
1, labels have the same functions as on a block.]],
    named = { { "width", t.positive, "size along x", unit = "length" },
              { "depth", t.positive, "size along y", unit = "length" },
              { "height", t.positive, "from the cap's lowest point to the flat top", unit = "length" },
              { "radius", t.positive, "radius of the cap", unit = "length" },
              { "elements", t.integer(1, 200), "elements of the cap in each direction" },
              { "corner", t.space_point, "x, y of the corner and z of the lowest point", default = { 0, 0, 0 },
                unit = "length" } },
    returns = a_patch,
    example = "sg.shapes.spherical_indenter{ width = 1, depth = 1, height = 0.6, radius = 2, elements = 4 }" },
}
