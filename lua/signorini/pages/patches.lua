-- Pages: shapes and patches.

local t = require "signorini.types"

local a_patch = t.object "patch"

local function radii(where)
  return { "inner", t.positive, "inner radius" .. where, unit = "length" },
    { "outer", t.positive, "outer radius" .. where, unit = "length" }
end
local inner, outer = radii ""
local center_in_plane = { "center", t.plane_point, "center of the circles", default = { 0, 0 }, unit = "length" }
local center_in_space = { "center", t.space_point, "center of the spheres", default = { 0, 0, 0 }, unit = "length" }

return {
  title = "Shapes and patches", word = "patches",
  { "sg.shapes.rectangle", "Returns a rectangle of degree 1; xi1 along x, xi2 along y.",
    named = { { "width", t.positive, "size along x", unit = "length" },
              { "height", t.positive, "size along y", unit = "length" },
              { "corner", t.plane_point, "lower left corner", default = { 0, 0 }, unit = "length" } },
    returns = a_patch,
    example = "sg.shapes.rectangle{ width = 3, height = 1 }" },
  { "sg.shapes.half_annulus", [[Returns the lower half of a ring: xi1 along the arc from the left end over the bottom to
the right end (two quarter arcs, degree 2), xi2 from the outer (south) to the inner radius (north). The flat ends are
west and east.]],
    named = { inner, outer, center_in_plane },
    returns = a_patch,
    example = "sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = {0.75, 1.5} }" },
  { "sg.shapes.quarter_annulus", [[Returns a quarter ring, counterclockwise: xi1 along the arc (degree 2), xi2 from the
outer (south) to the inner radius (north).]],
    named = { inner, outer, center_in_plane,
              { "start", t.number, "angle of the first end", default = 270, unit = "degrees" } },
    returns = a_patch,
    example = "sg.shapes.quarter_annulus{ inner = 0.5, outer = 1, start = 0 }" },
  { "sg.shapes.block", "Returns a block of degree 1; xi1, xi2, xi3 along x, y, z.",
    named = { { "size", t.space_point, "sizes along x, y, z", unit = "length" },
              { "corner", t.space_point, "corner with the smallest x, y, z", default = { 0, 0, 0 }, unit = "length" } },
    returns = a_patch,
    example = "sg.shapes.block{ size = {6, 4, 2} }" },
  { "sg.shapes.half_cylinder_shell", [[Returns the lower half of a pipe along y: xi1 along the arc (degree 2), xi2 along
y, xi3 from the outer (front) to the inner radius (back). With its center at the origin, west (x < 0) and east (x > 0)
are in z = 0, south in y = 0, north in y = width.]],
    named = { inner, outer, { "width", t.positive, "size along y", unit = "length" },
              { "center", t.space_point, "start of the axis", default = { 0, 0, 0 }, unit = "length" } },
    returns = a_patch,
    example = "sg.shapes.half_cylinder_shell{ inner = 0.3, outer = 0.5, width = 2 }" },
  { "sg.shapes.sphere_octant", [[Returns the lower octant of a hollow sphere: xi1 around the z axis, xi2 from the
equator to the pole, xi3 from the outer (front) to the inner radius (back). With its center at the origin it occupies x,
y > 0 and z < 0: west is in y = 0, east in x = 0, south in z = 0; north is the axis x = y = 0, where the map is
degenerate. For symmetry, fix west along y and east along x.]],
    named = { inner, outer, center_in_space },
    returns = a_patch,
    example = "sg.shapes.sphere_octant{ inner = 0.5, outer = 1 }" },
  { "sg.shapes.hollow_hemisphere", [[Returns the lower half of a hollow sphere, exact, of degree 2; xi3 from the outer
(front) to the inner radius (back). The map has poles, where an edge collapses to a point.]],
    named = { inner, outer, center_in_space,
              { "poles", t.choice { "ends", "bottom" }, [["ends": at both ends of the ring's diameter along y, none
where it touches a plane below. xi1 runs from -x over the bottom to x, xi2 from -y to y; the flat ring on top, in z = 0
with the center at the origin, is two faces, west (x < 0) and east (x > 0); south and north are degenerate, on the line
x = z = 0. "bottom": one pole, at the lowest point. xi1 runs once around the z axis (at least 4 elements), xi2 from the
ring down to the pole; the flat ring in z = 0 is one face, south, and the mesh the same at every angle; north is the
axis x = y = 0, west and east are the seam in y = 0.]], default = "ends" } },
    returns = a_patch,
    example = "sg.shapes.hollow_hemisphere{ inner = 2/3, outer = 1, center = {0, 0, 3} }" },
  { "sg.shapes.spherical_indenter", [[Returns a block with a flat top whose bottom (front) is a spherical cap,
approximated by biquadratic spans that interpolate the sphere. west, east, south and north are in x = 0, x = width, y =
0 and y = depth, back in z = height. The cap's own knots keep their continuity with every order label; with elements =
1, labels have the same functions as on a block.]],
    named = { { "width", t.positive, "size along x", unit = "length" },
              { "depth", t.positive, "size along y", unit = "length" },
              { "height", t.positive, "from the cap's lowest point to the flat top", unit = "length" },
              { "radius", t.positive, "radius of the cap", unit = "length" },
              { "elements", t.count, "spans of the cap in each direction" },
              { "corner", t.space_point, "x, y of the corner and z of the lowest point", default = { 0, 0, 0 },
                unit = "length" } },
    returns = a_patch,
    example = "sg.shapes.spherical_indenter{ width = 1, depth = 1, height = 0.6, radius = 2, elements = 4 }" },
}
