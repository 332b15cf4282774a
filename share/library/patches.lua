---@meta _
-- Generated from the help pages by scripts/reference; read by editors, not by the program.
-- Shapes and patches

---@class sg
local sg = {}

---@class sg.shapes
sg.shapes = {}

---@class (exact) sg.shapes.rectangle.arguments
---width: size along x (a positive number; length)
---@field width number
---height: size along y (a positive number; length)
---@field height number
---corner: lower left corner (a list of 2 numbers {x, y}; length; default {0, 0})
---@field corner? [number, number]
---@field [string] sg.unknown_argument

---Returns a rectangle of degree 1; xi1 along x, xi2 along y.
---
---```text
---sg.shapes.rectangle{ width, height, corner = {0, 0} }
---```
---
---Example:
---```lua
---sg.shapes.rectangle{ width = 3, height = 1 }
---```
---@param arguments sg.shapes.rectangle.arguments
---@return sg.patch
function sg.shapes.rectangle(arguments) end

---@class (exact) sg.shapes.half_annulus.arguments
---inner: inner radius (a positive number; length)
---@field inner number
---outer: outer radius (a positive number; length)
---@field outer number
---center: center of the circles (a list of 2 numbers {x, y}; length; default {0, 0})
---@field center? [number, number]
---@field [string] sg.unknown_argument

---Returns the lower half of a ring: xi1 along the arc from the left end over the bottom to the right end (two quarter
---arcs, degree 2), xi2 from the outer (south) to the inner radius (north). The flat ends are west and east.
---
---```text
---sg.shapes.half_annulus{ inner, outer, center = {0, 0} }
---```
---
---Example:
---```lua
---sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = {0.75, 1.5} }
---```
---@param arguments sg.shapes.half_annulus.arguments
---@return sg.patch
function sg.shapes.half_annulus(arguments) end

---@class (exact) sg.shapes.quarter_annulus.arguments
---inner: inner radius (a positive number; length)
---@field inner number
---outer: outer radius (a positive number; length)
---@field outer number
---center: center of the circles (a list of 2 numbers {x, y}; length; default {0, 0})
---@field center? [number, number]
---start: angle of the first end (a number; degrees; default 270)
---@field start? number
---@field [string] sg.unknown_argument

---Returns a quarter ring, counterclockwise: xi1 along the arc (degree 2), xi2 from the outer (south) to the inner
---radius (north).
---
---```text
---sg.shapes.quarter_annulus{ inner, outer, center = {0, 0}, start = 270 }
---```
---
---Example:
---```lua
---sg.shapes.quarter_annulus{ inner = 0.5, outer = 1, start = 0 }
---```
---@param arguments sg.shapes.quarter_annulus.arguments
---@return sg.patch
function sg.shapes.quarter_annulus(arguments) end

---@class (exact) sg.shapes.ring.arguments
---inner: inner radius (a positive number; length)
---@field inner number
---outer: outer radius (a positive number; length)
---@field outer number
---center: center of the circles (a list of 2 numbers {x, y}; length; default {0, 0})
---@field center? [number, number]
---@field [string] sg.unknown_argument

---Returns a full ring: xi1 once around, counterclockwise from the highest point (four quarter arcs, degree 2; west and
---east are the seam, whose two sides share their unknowns), xi2 from the outer (south) to the inner radius (north).
---
---```text
---sg.shapes.ring{ inner, outer, center = {0, 0} }
---```
---
---Example:
---```lua
---sg.shapes.ring{ inner = 0.5, outer = 1 }
---```
---@param arguments sg.shapes.ring.arguments
---@return sg.patch
function sg.shapes.ring(arguments) end

---@class (exact) sg.shapes.disc.arguments
---radius: radius (a positive number; length)
---@field radius number
---center: center of the circles (a list of 2 numbers {x, y}; length; default {0, 0})
---@field center? [number, number]
---@field [string] sg.unknown_argument

---@class (exact) sg.shapes.disc.result
---interfaces: faces on each other (a list of entries: each a list of two faces such as '1.east'; optional)
---@field interfaces? [string, string][]
---boundaries: faces by name (a table of names { name = … }; optional)
---@field boundaries? table<string, string[]>
---@field [integer] sg.patch

---Returns a disc of five patches of degree 2 without singular points. 1 (below), 2 (right), 3 (above) and 4 (left) have
---a quarter of the circle each: xi1 counterclockwise along it, xi2 from the circle (south) to the core (north), the
---neighbors are at west and east. 5 is the core, a square with its corners at half the radius, xi1 along x, xi2 along
---y. Boundary: outer, the circle.
---
---```text
---sg.shapes.disc{ radius, center = {0, 0} }
---```
---
---The result is a list of patches with a field boundaries = { outer }, lists of faces such as "2.south", the face south
---of the second patch. Neighboring faces have the same knots, points and weights; they stay so if all patches are
---refined by the same numbers.
---
---Example:
---```lua
---disc = sg.shapes.disc{ radius = 1 }
---sg.picture{ patch = disc }
---```
---@param arguments sg.shapes.disc.arguments
---@return sg.shapes.disc.result
function sg.shapes.disc(arguments) end

---@class (exact) sg.shapes.polar_disc.arguments
---radius: radius (a positive number; length)
---@field radius number
---center: center of the circles (a list of 2 numbers {x, y}; length; default {0, 0})
---@field center? [number, number]
---@field [string] sg.unknown_argument

---Returns a disc of one patch: xi1 once around, counterclockwise from the highest point (west and east are the seam),
---xi2 from the circle (south) to the center, to which north is collapsed: the map is degenerate there. sg.shapes.disc
---has no such point.
---
---```text
---sg.shapes.polar_disc{ radius, center = {0, 0} }
---```
---
---Example:
---```lua
---sg.shapes.polar_disc{ radius = 1 }
---```
---@param arguments sg.shapes.polar_disc.arguments
---@return sg.patch
function sg.shapes.polar_disc(arguments) end

---@class (exact) sg.shapes.hook.arguments
---length: from the root to the nose (a positive number; length)
---@field length number
---thickness: thickness of the beam (a positive number; length)
---@field thickness number
---nose: height of the nose above the beam (a positive number; length)
---@field nose number
---land: length of the nose's flat top (a positive number; length)
---@field land number
---insertion: angle between the insertion face and x, below 90 (a number; degrees; default 30)
---@field insertion? number
---retention: angle between the retention face and x, 90: upright (a number; degrees; default 90)
---@field retention? number
---corner: lower corner of the root (a list of 2 numbers {x, y}; length; default {0, 0})
---@field corner? [number, number]
---@field [string] sg.unknown_argument

---Returns a snap-fit hook of degree 1: a beam along x with a nose on its upper side, xi1 along x, xi2 along y. west is
---the root, east the tip, south the straight lower side, north the upper side with the nose: beam, retention face, land
---and insertion face, with knots at the edges between them. sg.nurbs.extrude makes a solid of it.
---
---```text
---sg.shapes.hook{ length, thickness, nose, land, insertion = 30, retention = 90, corner = {0, 0} }
---```
---
---Example:
---```lua
---sg.shapes.hook{ length = 10, thickness = 1.5, nose = 1, land = 0.5, retention = 45 }
---flat = sg.shapes.hook{ length = 10, thickness = 1.5, nose = 1, land = 0.5 }
---hook = sg.nurbs.extrude{ patch = flat, along = {0, 0, 4} }
---```
---@param arguments sg.shapes.hook.arguments
---@return sg.patch
function sg.shapes.hook(arguments) end

---@class (exact) sg.shapes.block.arguments
---size: sizes along x, y, z (a list of 3 numbers {x, y, z}; length)
---@field size [number, number, number]
---corner: corner with the smallest x, y, z (a list of 3 numbers {x, y, z}; length; default {0, 0, 0})
---@field corner? [number, number, number]
---@field [string] sg.unknown_argument

---Returns a block of degree 1; xi1, xi2, xi3 along x, y, z.
---
---```text
---sg.shapes.block{ size, corner = {0, 0, 0} }
---```
---
---Example:
---```lua
---sg.shapes.block{ size = {6, 4, 2} }
---```
---@param arguments sg.shapes.block.arguments
---@return sg.patch
function sg.shapes.block(arguments) end

---@class (exact) sg.shapes.half_cylinder_shell.arguments
---inner: inner radius (a positive number; length)
---@field inner number
---outer: outer radius (a positive number; length)
---@field outer number
---width: size along y (a positive number; length)
---@field width number
---center: start of the axis (a list of 3 numbers {x, y, z}; length; default {0, 0, 0})
---@field center? [number, number, number]
---@field [string] sg.unknown_argument

---Returns the lower half of a pipe along y: xi1 along the arc (degree 2), xi2 along y, xi3 from the outer (front) to
---the inner radius (back). With its center at the origin, west (x \< 0) and east (x > 0) are in z = 0, south in y = 0,
---north in y = width.
---
---```text
---sg.shapes.half_cylinder_shell{ inner, outer, width, center = {0, 0, 0} }
---```
---
---Example:
---```lua
---sg.shapes.half_cylinder_shell{ inner = 0.3, outer = 0.5, width = 2 }
---```
---@param arguments sg.shapes.half_cylinder_shell.arguments
---@return sg.patch
function sg.shapes.half_cylinder_shell(arguments) end

---@class (exact) sg.shapes.tube.arguments
---inner: inner radius (a positive number; length)
---@field inner number
---outer: outer radius (a positive number; length)
---@field outer number
---width: size along y (a positive number; length)
---@field width number
---center: start of the axis (a list of 3 numbers {x, y, z}; length; default {0, 0, 0})
---@field center? [number, number, number]
---@field [string] sg.unknown_argument

---Returns a pipe along y: xi1 once around from the highest line (degree 2; west and east are the seam, whose two sides
---share their unknowns), xi2 along y, xi3 from the outer (front) to the inner radius (back). With its center at the
---origin, south is in y = 0, north in y = width. patch:rotate turns it.
---
---```text
---sg.shapes.tube{ inner, outer, width, center = {0, 0, 0} }
---```
---
---Example:
---```lua
---sg.shapes.tube{ inner = 0.4, outer = 0.5, width = 2 }
---```
---@param arguments sg.shapes.tube.arguments
---@return sg.patch
function sg.shapes.tube(arguments) end

---@class (exact) sg.shapes.cylinder.arguments
---radius: radius (a positive number; length)
---@field radius number
---width: size along y (a positive number; length)
---@field width number
---center: start of the axis (a list of 3 numbers {x, y, z}; length; default {0, 0, 0})
---@field center? [number, number, number]
---@field [string] sg.unknown_argument

---@class (exact) sg.shapes.cylinder.result
---interfaces: faces on each other (a list of entries: each a list of two faces such as '1.east'; optional)
---@field interfaces? [string, string][]
---boundaries: faces by name (a table of names { name = … }; optional)
---@field boundaries? table<string, string[]>
---@field [integer] sg.patch

---Returns a solid cylinder along y of five patches of degree 2 without singular points, the extruded sg.shapes.disc. 1
---(below), 2 (right), 3 (above) and 4 (left): xi1 along the circle, xi2 along y, xi3 from the circle (front) to the
---core (back). 5 is the core; xi1, xi2, xi3 along x, y, z. Boundaries: outer, the curved surface; south and north, the
---flat ends, with the center at the origin in y = 0 and y = width.
---
---```text
---sg.shapes.cylinder{ radius, width, center = {0, 0, 0} }
---```
---
---The result is a list of patches with a field boundaries = { outer, south, north }, lists of faces such as "2.south",
---the face south of the second patch. Neighboring faces have the same knots, points and weights; they stay so if all
---patches are refined by the same numbers.
---
---Example:
---```lua
---sg.shapes.cylinder{ radius = 0.5, width = 2 }
---```
---@param arguments sg.shapes.cylinder.arguments
---@return sg.shapes.cylinder.result
function sg.shapes.cylinder(arguments) end

---@class (exact) sg.shapes.polar_cylinder.arguments
---radius: radius (a positive number; length)
---@field radius number
---width: size along y (a positive number; length)
---@field width number
---center: start of the axis (a list of 3 numbers {x, y, z}; length; default {0, 0, 0})
---@field center? [number, number, number]
---@field [string] sg.unknown_argument

---Returns a solid cylinder along y of one patch: xi1 once around from the highest line (west and east are the seam),
---xi2 along y, xi3 from the circle (front) to the axis, to which back is collapsed: the map is degenerate there. With
---its center at the origin, south is in y = 0, north in y = width.
---
---```text
---sg.shapes.polar_cylinder{ radius, width, center = {0, 0, 0} }
---```
---
---Example:
---```lua
---sg.shapes.polar_cylinder{ radius = 0.5, width = 2 }
---```
---@param arguments sg.shapes.polar_cylinder.arguments
---@return sg.patch
function sg.shapes.polar_cylinder(arguments) end

---@class (exact) sg.shapes.torus.arguments
---radius: distance of the section's center from the axis (a positive number; length)
---@field radius number
---section: radius of the section, below radius (a positive number; length)
---@field section number
---center: center of the torus (a list of 3 numbers {x, y, z}; length; default {0, 0, 0})
---@field center? [number, number, number]
---@field [string] sg.unknown_argument

---@class (exact) sg.shapes.torus.result
---interfaces: faces on each other (a list of entries: each a list of two faces such as '1.east'; optional)
---@field interfaces? [string, string][]
---boundaries: faces by name (a table of names { name = … }; optional)
---@field boundaries? table<string, string[]>
---@field [integer] sg.patch

---Returns a solid torus about the z axis of five patches of degree 2 without singular points, sg.shapes.disc around a
---circle. 1 (below), 2 (outside), 3 (above), 4 (inside): xi1 along the section's circle, xi2 once around the axis
---(south and north are the seam), xi3 from the surface (front) to the core (back). 5 is the core: xi1 away from the
---axis, xi3 along z. Boundary: outer, the surface.
---
---```text
---sg.shapes.torus{ radius, section, center = {0, 0, 0} }
---```
---
---The result is a list of patches with a field boundaries = { outer }, lists of faces such as "2.south", the face south
---of the second patch. Neighboring faces have the same knots, points and weights; they stay so if all patches are
---refined by the same numbers.
---
---Example:
---```lua
---sg.shapes.torus{ radius = 2, section = 0.5 }
---```
---@param arguments sg.shapes.torus.arguments
---@return sg.shapes.torus.result
function sg.shapes.torus(arguments) end

---@class (exact) sg.shapes.ball.arguments
---radius: radius (a positive number; length)
---@field radius number
---center: center of the spheres (a list of 3 numbers {x, y, z}; length; default {0, 0, 0})
---@field center? [number, number, number]
---@field [string] sg.unknown_argument

---@class (exact) sg.shapes.ball.result
---interfaces: faces on each other (a list of entries: each a list of two faces such as '1.east'; optional)
---@field interfaces? [string, string][]
---boundaries: faces by name (a table of names { name = … }; optional)
---@field boundaries? table<string, string[]>
---@field [integer] sg.patch

---Returns a solid ball of seven patches of degree 4 without singular points. 1 (below), 2 (+x), 3 (+y), 4 (-x), 5 (-y)
---and 6 (above) have a sixth of the sphere each, exact (J. E. Cobb 1988): front is the sphere, back the core, the other
---four faces are the neighbors'. 7 is the core, a cube along the axes with its corners at half the radius. xi1 and xi2
---of patch 1 and all of the core run along x, y, z. Boundary: outer, the sphere. Bodies need at least the label N4.
---
---```text
---sg.shapes.ball{ radius, center = {0, 0, 0} }
---```
---
---The result is a list of patches with a field boundaries = { outer }, lists of faces such as "2.south", the face south
---of the second patch. Neighboring faces have the same knots, points and weights; they stay so if all patches are
---refined by the same numbers.
---
---Example:
---```lua
---#sg.shapes.ball{ radius = 1 }  --> 7
---```
---@param arguments sg.shapes.ball.arguments
---@return sg.shapes.ball.result
function sg.shapes.ball(arguments) end

---@class (exact) sg.shapes.polar_ball.arguments
---radius: radius (a positive number; length)
---@field radius number
---center: center of the spheres (a list of 3 numbers {x, y, z}; length; default {0, 0, 0})
---@field center? [number, number, number]
---@field [string] sg.unknown_argument

---Returns a solid ball of one patch of degree 2: xi1 once around the z axis from x over y (west and east are the seam),
---xi2 from the upper to the lower pole, xi3 from the sphere (front) to the center. The map is degenerate on the axis,
---to which south (z > 0) and north (z \< 0) are collapsed, and in the center, back. With N2 it has fewer unknowns than
---sg.shapes.ball, but its elements are narrow at the poles, where it should not touch.
---
---```text
---sg.shapes.polar_ball{ radius, center = {0, 0, 0} }
---```
---
---Example:
---```lua
---sg.shapes.polar_ball{ radius = 1 }
---```
---@param arguments sg.shapes.polar_ball.arguments
---@return sg.patch
function sg.shapes.polar_ball(arguments) end

---@class (exact) sg.shapes.sphere_octant.arguments
---inner: inner radius (a positive number; length)
---@field inner number
---outer: outer radius (a positive number; length)
---@field outer number
---center: center of the spheres (a list of 3 numbers {x, y, z}; length; default {0, 0, 0})
---@field center? [number, number, number]
---@field [string] sg.unknown_argument

---Returns the lower octant of a hollow sphere: xi1 around the z axis, xi2 from the equator to the pole, xi3 from the
---outer (front) to the inner radius (back). With its center at the origin it occupies x, y > 0 and z \< 0: west is in y
---= 0, east in x = 0, south in z = 0; north is the axis x = y = 0, where the map is degenerate. For symmetry, fix west
---along y and east along x.
---
---```text
---sg.shapes.sphere_octant{ inner, outer, center = {0, 0, 0} }
---```
---
---Example:
---```lua
---sg.shapes.sphere_octant{ inner = 0.5, outer = 1 }
---```
---@param arguments sg.shapes.sphere_octant.arguments
---@return sg.patch
function sg.shapes.sphere_octant(arguments) end

---@class (exact) sg.shapes.hollow_hemisphere.arguments
---inner: inner radius (a positive number; length)
---@field inner number
---outer: outer radius (a positive number; length)
---@field outer number
---center: center of the spheres (a list of 3 numbers {x, y, z}; length; default {0, 0, 0})
---@field center? [number, number, number]
---poles: 'ends' or 'bottom'; default "ends". "ends": at both ends of the ring's diameter along y, none where it touches
---```text
---       a plane below. xi1 runs from -x over the bottom to x, xi2 from -y to y; the flat ring on top, in z = 0 with the
---       center at the origin, is two faces, west (x < 0) and east (x > 0); south and north are degenerate, on the line
---       x = z = 0. "bottom": one pole, at the lowest point. xi1 runs once around the z axis (at least 4 elements), xi2
---       from the ring down to the pole; the flat ring in z = 0 is one face, south, and the mesh the same at every
---       angle; north is the axis x = y = 0, west and east are the seam in y = 0.
---```
---@field poles? "ends"|"bottom"
---@field [string] sg.unknown_argument

---Returns the lower half of a hollow sphere, exact, of degree 2; xi3 from the outer (front) to the inner radius (back).
---The map has poles, where an edge collapses to a point.
---
---```text
---sg.shapes.hollow_hemisphere{ inner, outer, center = {0, 0, 0}, poles = "ends" }
---```
---
---Example:
---```lua
---sg.shapes.hollow_hemisphere{ inner = 2/3, outer = 1, center = {0, 0, 3} }
---```
---@param arguments sg.shapes.hollow_hemisphere.arguments
---@return sg.patch
function sg.shapes.hollow_hemisphere(arguments) end

---@class (exact) sg.shapes.spherical_indenter.arguments
---width: size along x (a positive number; length)
---@field width number
---depth: size along y (a positive number; length)
---@field depth number
---height: from the cap's lowest point to the flat top (a positive number; length)
---@field height number
---radius: radius of the cap (a positive number; length)
---@field radius number
---elements: spans of the cap in each direction (a whole number from 1 to 200)
---@field elements integer
---corner: x, y of the corner and z of the lowest point (a list of 3 numbers {x, y, z}; length; default {0, 0, 0})
---@field corner? [number, number, number]
---@field [string] sg.unknown_argument

---Returns a block with a flat top whose bottom (front) is a spherical cap, approximated by biquadratic spans that
---interpolate the sphere. west, east, south and north are in x = 0, x = width, y = 0 and y = depth, back in z = height.
---The cap's own knots keep their continuity with every order label; with elements = 1, labels have the same functions
---as on a block.
---
---```text
---sg.shapes.spherical_indenter{ width, depth, height, radius, elements, corner = {0, 0, 0} }
---```
---
---Example:
---```lua
---sg.shapes.spherical_indenter{ width = 1, depth = 1, height = 0.6, radius = 2, elements = 4 }
---```
---@param arguments sg.shapes.spherical_indenter.arguments
---@return sg.patch
function sg.shapes.spherical_indenter(arguments) end

---@class sg.nurbs
sg.nurbs = {}

---@class (exact) sg.nurbs.curve.arguments
---degree: polynomial degree (a whole number from 1 to 15)
---@field degree integer
---knots: open knot vector (a list of numbers)
---@field knots number[]
---points: control points, fastest in xi1 (a list of points {{x, y}, …}; length)
---@field points ([number, number]|[number, number, number])[]
---weights: one per control point (a list of numbers; by default 1 each)
---@field weights? number[]
---@field [string] sg.unknown_argument

---Returns a NURBS curve in 2D or 3D.
---
---```text
---sg.nurbs.curve{ degree, knots, points, weights }
---```
---
---The ends of an open knot vector are repeated degree + 1 times; it has points + degree + 1 knots in all.
---
---Example:
---```lua
---sg.nurbs.curve{ degree = 2, knots = {0, 0, 0, 1, 1, 1}, points = {{0, 0}, {1, 2}, {2, 0}} }
---```
---@param arguments sg.nurbs.curve.arguments
---@return sg.patch
function sg.nurbs.curve(arguments) end

---@class (exact) sg.nurbs.surface.arguments
---degrees: polynomial degrees, one per direction (a list of 2 whole numbers from 1 to 15)
---@field degrees [integer, integer]
---knots: open knot vectors, one per direction (a list of 2 lists of numbers)
---@field knots [number[], number[]]
---points: control points, fastest in xi1 (a list of points {{x, y}, …}; length)
---@field points ([number, number]|[number, number, number])[]
---weights: one per control point (a list of numbers; by default 1 each)
---@field weights? number[]
---@field [string] sg.unknown_argument

---Returns a tensor-product NURBS surface in 2D or 3D.
---
---```text
---sg.nurbs.surface{ degrees, knots, points, weights }
---```
---
---Example:
---```lua
---sg.nurbs.surface{ degrees = {1, 1}, knots = {{0, 0, 1, 1}, {0, 0, 1, 1}},
---                  points = {{0, 0}, {1, 0}, {0, 1}, {1, 1}} }
---```
---@param arguments sg.nurbs.surface.arguments
---@return sg.patch
function sg.nurbs.surface(arguments) end

---@class (exact) sg.nurbs.volume.arguments
---degrees: polynomial degrees, one per direction (a list of 3 whole numbers from 1 to 15)
---@field degrees [integer, integer, integer]
---knots: open knot vectors, one per direction (a list of 3 lists of numbers)
---@field knots [number[], number[], number[]]
---points: control points, fastest in xi1 (a list of points {{x, y}, …}; length)
---@field points ([number, number]|[number, number, number])[]
---weights: one per control point (a list of numbers; by default 1 each)
---@field weights? number[]
---@field [string] sg.unknown_argument

---Returns a tensor-product NURBS volume; points run fastest in xi1, then in xi2.
---
---```text
---sg.nurbs.volume{ degrees, knots, points, weights }
---```
---
---Example:
---```lua
---sg.nurbs.volume{ degrees = {1, 1, 1}, knots = {{0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}},
---                 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
---                           {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}} }
---```
---@param arguments sg.nurbs.volume.arguments
---@return sg.patch
function sg.nurbs.volume(arguments) end

---@class (exact) sg.nurbs.line.arguments
---from: first end (a list of 2 or 3 numbers; length)
---@field from [number, number]|[number, number, number]
---to: other end (a list of 2 or 3 numbers; length)
---@field to [number, number]|[number, number, number]
---@field [string] sg.unknown_argument

---Returns a straight line of degree 1.
---
---```text
---sg.nurbs.line{ from, to }
---```
---
---Example:
---```lua
---sg.nurbs.line{ from = {0, 0}, to = {3, 0} }
---```
---@param arguments sg.nurbs.line.arguments
---@return sg.patch
function sg.nurbs.line(arguments) end

---@class (exact) sg.nurbs.arc.arguments
---radius: a positive number; length
---@field radius number
---from: first angle (a number; degrees)
---@field from number
---to: last angle (a number; degrees)
---@field to number
---center: center of the circle (a list of 2 or 3 numbers; length; default {0, 0})
---@field center? [number, number]|[number, number, number]
---@field [string] sg.unknown_argument

---Returns an exact circular arc of degree 2, one segment per 90 degrees or part of them; counterclockwise if the angle
---increases. A center in 3D gives an arc parallel to the x-y plane.
---
---```text
---sg.nurbs.arc{ radius, from, to, center = {0, 0} }
---```
---
---Example:
---```lua
---sg.nurbs.arc{ radius = 0.5, from = 180, to = 360 }
---```
---@param arguments sg.nurbs.arc.arguments
---@return sg.patch
function sg.nurbs.arc(arguments) end

---@class (exact) sg.nurbs.circle.arguments
---radius: a positive number; length
---@field radius number
---center: center of the circle (a list of 2 or 3 numbers; length; default {0, 0})
---@field center? [number, number]|[number, number, number]
---@field [string] sg.unknown_argument

---Returns a full circle of four exact quarter arcs of degree 2.
---
---```text
---sg.nurbs.circle{ radius, center = {0, 0} }
---```
---
---Example:
---```lua
---sg.nurbs.circle{ radius = 1 }
---```
---@param arguments sg.nurbs.circle.arguments
---@return sg.patch
function sg.nurbs.circle(arguments) end

---@class (exact) sg.nurbs.ruled.arguments
---a: start (a patch)
---@field a sg.patch
---b: end (a patch)
---@field b sg.patch
---@field [string] sg.unknown_argument

---Returns the ruled surface between two curves, or the ruled volume between two surfaces, which are first brought to
---common degrees and knots; the new direction is the last one.
---
---```text
---sg.nurbs.ruled{ a, b }
---```
---
---Example:
---```lua
---sg.nurbs.ruled{ a = sg.nurbs.circle{ radius = 2 }, b = sg.nurbs.circle{ radius = 1 } }
---```
---@param arguments sg.nurbs.ruled.arguments
---@return sg.patch
function sg.nurbs.ruled(arguments) end

---@class (exact) sg.nurbs.extrude.arguments
---patch: curve or surface to extrude (a patch)
---@field patch sg.patch
---along: extrusion vector; if it has 3 numbers, a plane patch is placed in z = 0 (a list of 2 or 3 numbers; length)
---@field along [number, number]|[number, number, number]
---@field [string] sg.unknown_argument

---Extrudes a curve or a surface along a vector; the new direction is the last one, of degree 1.
---
---```text
---sg.nurbs.extrude{ patch, along }
---```
---
---Example:
---```lua
---sg.nurbs.extrude{ patch = sg.nurbs.line{ from = {0, 0}, to = {1, 0} }, along = {0, 2} }
---sg.nurbs.extrude{ patch = sg.shapes.quarter_annulus{ inner = 1, outer = 2 }, along = {0, 0, 1} }
---```
---@param arguments sg.nurbs.extrude.arguments
---@return sg.patch
function sg.nurbs.extrude(arguments) end

---@class (exact) sg.nurbs.revolve.arguments
---patch: curve or surface to revolve; a plane patch is placed in z = 0 (a patch)
---@field patch sg.patch
---point: a point of the axis (a list of 2 or 3 numbers; length; by default the origin)
---@field point? [number, number]|[number, number, number]
---axis: direction of the axis (a list of 2 or 3 numbers; by default {0, 0, 1}, for a plane patch {0, -1, 0})
---@field axis? [number, number]|[number, number, number]
---angle: a number; degrees; default 360
---@field angle? number
---@field [string] sg.unknown_argument

---Revolves a curve or a surface about an axis, exactly; the new direction is the last one.
---
---```text
---sg.nurbs.revolve{ patch, point, axis, angle = 360 }
---```
---
---With the default axis of a plane patch, x is the radius as in axisymmetric models, and a right-handed patch at x > 0
---gives a right-handed volume.
---
---Example:
---```lua
---sg.nurbs.revolve{ patch = sg.nurbs.line{ from = {1, 0, 0}, to = {1, 0, 2} }, angle = 180 }
---sg.nurbs.revolve{ patch = sg.shapes.rectangle{ width = 1, height = 2, corner = {3, 0} }, angle = 90 }
---```
---@param arguments sg.nurbs.revolve.arguments
---@return sg.patch
function sg.nurbs.revolve(arguments) end

---@class (exact) sg.nurbs.coons.arguments
---west: where xi1 starts (a patch)
---@field west sg.patch
---east: where xi1 ends (a patch)
---@field east sg.patch
---south: where xi2 starts (a patch)
---@field south sg.patch
---north: where xi2 ends (a patch)
---@field north sg.patch
---front: where xi3 starts; for volumes (a patch; optional)
---@field front? sg.patch
---back: where xi3 ends; for volumes (a patch; optional)
---@field back? sg.patch
---@field [string] sg.unknown_argument

---Returns a Coons patch: the surface between four boundary curves, or the volume between six boundary surfaces, whose
---corners meet. west and east run along xi2, south and north along xi1.
---
---```text
---sg.nurbs.coons{ west, east, south, north, front, back }
---```
---
---Example:
---```lua
---line = sg.nurbs.line
---sg.nurbs.coons{ west = line{ from = {0, 0}, to = {0, 1} }, east = line{ from = {1, 0}, to = {1, 2} },
---                south = line{ from = {0, 0}, to = {1, 0} }, north = line{ from = {0, 1}, to = {1, 2} } }
---```
---@param arguments sg.nurbs.coons.arguments
---@return sg.patch
function sg.nurbs.coons(arguments) end

---@class (exact) sg.nurbs.read.result
---interfaces: faces on each other (a list of entries: each a list of two faces such as '1.east'; optional)
---@field interfaces? [string, string][]
---boundaries: faces by name (a table of names { name = … }; optional)
---@field boundaries? table<string, string[]>
---@field [integer] sg.patch

---Returns all patches of a file as a list, in the file's order; sg.body takes the list as a body of several patches.
---The format is detected from the beginning of the file:
---
---```text
---  G+Smo's XML: geometries BSpline, Nurbs, TensorBSpline2 and 3, TensorNurbs2 and 3
---  the text file of GeoPDEs and the NURBS toolbox, versions 0.7, 1.0 and 2.1, one or several patches
---  MFEM NURBS mesh v1.0 with a section `patches`
---```
---The list has the fields `interfaces`, { { "1.east", "2.west" }, … }, and `boundaries`, { name = { "1.north", … } },
---as far as the file has them; in MFEM's files the name of a boundary is its attribute. Errors in a file are reported
---with file and line.
---
---Example:
---```lua
---sg.shapes.half_annulus{ inner = 1, outer = 2 }:write "bracket.xml"
---bracket = sg.nurbs.read("bracket.xml")[1]
---```
---@param file string # file: name of the patch file (a string)
---@return sg.nurbs.read.result
function sg.nurbs.read(file) end

---@class (exact) sg.nurbs.write.patches
---interfaces: faces on each other (a list of entries: each a list of two faces such as '1.east'; optional)
---@field interfaces? [string, string][]
---boundaries: faces by name (a table of names { name = … }; optional)
---@field boundaries? table<string, string[]>
---@field [integer] sg.patch
---@field [string] sg.unknown_argument

---Writes a patch or a list of patches to a file, atomically; knots, weights and control points are read back bitwise
---identical. Written, too, are interfaces (those of the list, otherwise all faces of two patches that match point by
---point) and boundaries.
---
---```text
---  "gismo":   .xml, G+Smo's XML
---  "geopdes": .txt, text file of GeoPDEs, version 2.1
---  "mfem":    .mesh, MFEM NURBS mesh v1.0; neighbors must run along their common edges in the same direction. The
---             attributes of the sides of one patch are west 1, east 2, south 3, north 4, front 5, back 6; of several the
---             numbers of the boundaries by name, other faces the next number
---```
---
---Example:
---```lua
---sg.nurbs.write("annulus.txt", sg.shapes.half_annulus{ inner = 1, outer = 2 })
---```
---@param file string # file: name of the patch file (a string)
---@param patches sg.patch|sg.nurbs.write.patches # patches: patches to write (a patch or a list of one or more patches)
---@param form? "gismo"|"geopdes"|"mfem" # form: format of the file ('gismo', 'geopdes' or 'mfem'; by default by the file's ending)
function sg.nurbs.write(file, patches, form) end

---A NURBS curve, surface or volume, an immutable value: methods that change something return a new patch. sg.shapes.\*
---and sg.nurbs.\* make patches. Called as a function, a patch returns the point at xi, {x, y} or {x, y, z}.
---
---```text
---patch(xi)
---```
---
---Methods: evaluate, derivatives, basis, insert, elevate, refine, face, degrees, elements, knots, points, weights,
---translate, rotate, scale, mirror, reverse, swap, to_plane, to_space, write; see for example help "patch:refine".
---
---Example:
---```lua
---sg.shapes.rectangle{ width = 3, height = 1 }{0.5, 0.5}  --> {1.5, 0.5}
---```
---@class sg.patch
---@overload fun(xi: number|number[]): [number, number]|[number, number, number]
local patch = {}

---Returns the point at xi, {x, y} or {x, y, z}, as patch(xi) does.
---
---Example:
---```lua
---patch:evaluate{0.5, 0.5}  --> {1.5, 0.5}
---```
---@param xi number|number[] # xi: parametric coordinates (a list of numbers {xi1, xi2})
---@return [number, number]|[number, number, number]
function patch:evaluate(xi) end

---@class (exact) sg.patch.derivatives.result
---@field orders integer[]
---@field value [number, number]|[number, number, number]

---Returns all partial derivatives of the map at xi up to total order n: a list of { orders = {1, 0}, value = {x, y} },
---sorted by total order, then by decreasing order in xi1.
---
---Source: Piegl & Tiller, The NURBS Book, eq. (4.20).
---
---Example:
---```lua
---patch:derivatives({0.5, 0.5}, 1)[2].value  --> {3.0, 0.0}
---```
---@param xi number|number[] # xi: parametric coordinates (a list of numbers {xi1, xi2})
---@param n integer # n: highest total order (a whole number from 0 to 15)
---@return sg.patch.derivatives.result[]
function patch:derivatives(xi, n) end

---@class (exact) sg.patch.basis.result
---@field index integer
---@field value number

---Returns the rational basis functions that are nonzero at xi, as a list of { index, value }; index is the number of
---the control point from 1, fastest in xi1. The values add up to 1.
---
---Example:
---```lua
---patch:basis({0.5, 0.5})[1].value  --> 0.25
---```
---@param xi number|number[] # xi: parametric coordinates (a list of numbers {xi1, xi2})
---@return sg.patch.basis.result[]
function patch:basis(xi) end

---Inserts knots in one direction; the shape is unchanged.
---
---Example:
---```lua
---patch:insert(1, {0.25, 0.5}):elements()  --> {3, 1}
---```
---@param dir integer # dir: parametric direction (a whole number from 1 to 3)
---@param knots number[] # knots: knots to insert, with repetitions (a list of numbers)
---@return sg.patch
function patch:insert(dir, knots) end

---Raises the degree in one direction and keeps the continuity; the shape is unchanged.
---
---Example:
---```lua
---patch:elevate(1, 2):degrees()  --> {3, 1}
---```
---@param dir integer # dir: parametric direction (a whole number from 1 to 3)
---@param times? integer # times: by how much (a whole number from 1 to 15; default 1)
---@return sg.patch
function patch:elevate(dir, times) end

---@class (exact) sg.patch.refine.arguments.grading
---elements: fraction of the elements (a number above 0 and below 1)
---@field elements number
---length: fraction of the knot length that they fill (a number above 0 and below 1)
---@field length number
---at: the end with the small elements ('start' or 'end')
---@field at "start"|"end"
---@field [string] sg.unknown_argument

---@class (exact) sg.patch.refine.arguments
---elements: knot spans (a list of whole numbers from 1 to 1000000, one per direction; by default the patch's own)
---@field elements? integer|integer[]
---degree: polynomial degrees (a list of whole numbers from 1 to 15, one per direction; by default the patch's own)
---@field degree? integer|integer[]
---grading: where elements are concentrated; false: uniform (a list of entries: each a table of named arguments or
---false,
---```text
---         one per direction; by default uniform elements)
---  elements: fraction of the elements (a number above 0 and below 1)
---  length:   fraction of the knot length that they fill (a number above 0 and below 1)
---  at:       the end with the small elements ('start' or 'end')
---```
---@field grading? sg.patch.refine.arguments.grading|false|(sg.patch.refine.arguments.grading|false)[]
---@field [string] sg.unknown_argument

---Applies k-refinement: raises the degrees first, then inserts knots until each direction has the given number of
---elements (nonempty knot spans); existing knots and the shape are unchanged. For a curve, arguments are values instead
---of lists.
---
---```text
---patch:refine{ elements, degree, grading }
---```
---
---grading = { { elements = 0.8, length = 0.1, at = "start" }, false } puts 80 % of the elements of the first direction
---into the first tenth of its length and leaves the second direction uniform.
---
---Example:
---```lua
---patch:refine{ elements = {8, 3}, degree = {2, 2} }
---```
---@param arguments sg.patch.refine.arguments
---@return sg.patch
function patch:refine(arguments) end

---Returns a side as a patch of one direction less.
---
---Example:
---```lua
---patch:face "south"
---```
---@param name string # name: west, east (ends of xi1), south, north (xi2), front, back (xi3) (a face name)
---@return sg.patch
function patch:face(name) end

---Returns the list of the polynomial degrees, one per direction.
---
---Example:
---```lua
---patch:degrees()  --> {1, 1}
---```
---@return integer[]
function patch:degrees() end

---Returns the list of the numbers of elements (nonempty knot spans), one per direction.
---
---Example:
---```lua
---patch:elements()  --> {1, 1}
---```
---@return integer[]
function patch:elements() end

---Returns the knot vector of a direction.
---
---Example:
---```lua
---patch:knots(1)  --> {0.0, 0.0, 1.0, 1.0}
---```
---@param dir integer # dir: parametric direction (a whole number from 1 to 3)
---@return number[]
function patch:knots(dir) end

---Returns the control points {{x, y}, …}, fastest in xi1.
---
---Example:
---```lua
---patch:points()[4]  --> {3.0, 1.0}
---```
---@return ([number, number]|[number, number, number])[]
function patch:points() end

---Returns the weights of the control points, in the order of patch:points().
---
---Example:
---```lua
---patch:weights()[1]  --> 1.0
---```
---@return number[]
function patch:weights() end

---Moves the patch by a vector.
---
---Example:
---```lua
---patch:translate{1, 0}{0, 0}  --> {1.0, 0.0}
---```
---@param by [number, number]|[number, number, number] # by: displacement (a list of 2 or 3 numbers; length)
---@return sg.patch
function patch:translate(by) end

---@class (exact) sg.patch.rotate.arguments
---angle: counterclockwise (a number; degrees)
---@field angle number
---axis: direction of the axis; needed in 3D, not allowed in 2D (a list of 3 numbers {x, y, z}; optional)
---@field axis? [number, number, number]
---center: the fixed point (a list of 2 or 3 numbers; length; by default the origin)
---@field center? [number, number]|[number, number, number]
---@field [string] sg.unknown_argument

---Rotates the patch about a center, in 3D about an axis through it.
---
---```text
---patch:rotate{ angle, axis, center }
---```
---
---Example:
---```lua
---patch:rotate{ angle = 30, center = {1.5, 0.5} }
---```
---@param arguments sg.patch.rotate.arguments
---@return sg.patch
function patch:rotate(arguments) end

---@class (exact) sg.patch.scale.arguments
---factor: for all coordinates, or one for each in a list (a positive number or a list of 2 or 3 numbers)
---@field factor number|[number, number]|[number, number, number]
---center: the fixed point (a list of 2 or 3 numbers; length; by default the origin)
---@field center? [number, number]|[number, number, number]
---@field [string] sg.unknown_argument

---Scales the patch about a center.
---
---```text
---patch:scale{ factor, center }
---```
---
---Example:
---```lua
---patch:scale{ factor = {2, 1} }{1, 1}  --> {6.0, 1.0}
---```
---@param arguments sg.patch.scale.arguments
---@return sg.patch
function patch:scale(arguments) end

---@class (exact) sg.patch.mirror.arguments
---normal: normal of the mirror (a list of 2 or 3 numbers)
---@field normal [number, number]|[number, number, number]
---point: a point on the mirror (a list of 2 or 3 numbers; length; by default the origin)
---@field point? [number, number]|[number, number, number]
---@field [string] sg.unknown_argument

---Returns the mirror image across a line, in 3D across a plane. The parametric direction closest to the normal is
---reversed, so that the image of a body is right-handed again and an obstacle keeps its outside; curves in 3D keep
---their direction.
---
---```text
---patch:mirror{ normal, point }
---```
---
---Example:
---```lua
---patch:mirror{ normal = {1, 0} }{0, 0}  --> {-3.0, 0.0}
---```
---@param arguments sg.patch.mirror.arguments
---@return sg.patch
function patch:mirror(arguments) end

---A list of patches, as sg.shapes.disc, cylinder, ball and torus and sg.nurbs.read return it, with the names of its
---faces: `boundaries`, `interfaces`. sg.body makes a body of all of them. list[1] is a patch.
---
---Methods: translate, rotate, scale, mirror, as of a patch, of all patches; the names of faces are kept.
---@class sg.patch_list
local patch_list = {}

---@class (exact) sg.patch_list.translate.result
---interfaces: faces on each other (a list of entries: each a list of two faces such as '1.east'; optional)
---@field interfaces? [string, string][]
---boundaries: faces by name (a table of names { name = … }; optional)
---@field boundaries? table<string, string[]>
---@field [integer] sg.patch

---Moves all patches by a vector.
---
---Example:
---```lua
---#sg.shapes.disc{ radius = 1 }:translate{1, 0}  --> 5
---```
---@param by [number, number]|[number, number, number] # by: displacement (a list of 2 or 3 numbers; length)
---@return sg.patch_list.translate.result
function patch_list:translate(by) end

---@class (exact) sg.patch_list.rotate.arguments
---angle: counterclockwise (a number; degrees)
---@field angle number
---axis: direction of the axis; needed in 3D, not allowed in 2D (a list of 3 numbers {x, y, z}; optional)
---@field axis? [number, number, number]
---center: the fixed point (a list of 2 or 3 numbers; length; by default the origin)
---@field center? [number, number]|[number, number, number]
---@field [string] sg.unknown_argument

---@class (exact) sg.patch_list.rotate.result
---interfaces: faces on each other (a list of entries: each a list of two faces such as '1.east'; optional)
---@field interfaces? [string, string][]
---boundaries: faces by name (a table of names { name = … }; optional)
---@field boundaries? table<string, string[]>
---@field [integer] sg.patch

---Rotates all patches about a center, in 3D about an axis through it.
---
---```text
---patch_list:rotate{ angle, axis, center }
---```
---
---Example:
---```lua
---sg.shapes.cylinder{ radius = 1, width = 2 }:rotate{ angle = 90, axis = {1, 0, 0} }
---```
---@param arguments sg.patch_list.rotate.arguments
---@return sg.patch_list.rotate.result
function patch_list:rotate(arguments) end

---@class (exact) sg.patch_list.scale.arguments
---factor: for all coordinates, or one for each in a list (a positive number or a list of 2 or 3 numbers)
---@field factor number|[number, number]|[number, number, number]
---center: the fixed point (a list of 2 or 3 numbers; length; by default the origin)
---@field center? [number, number]|[number, number, number]
---@field [string] sg.unknown_argument

---@class (exact) sg.patch_list.scale.result
---interfaces: faces on each other (a list of entries: each a list of two faces such as '1.east'; optional)
---@field interfaces? [string, string][]
---boundaries: faces by name (a table of names { name = … }; optional)
---@field boundaries? table<string, string[]>
---@field [integer] sg.patch

---Scales all patches about a center.
---
---```text
---patch_list:scale{ factor, center }
---```
---
---Example:
---```lua
---sg.shapes.disc{ radius = 1 }:scale{ factor = {2, 1} }
---```
---@param arguments sg.patch_list.scale.arguments
---@return sg.patch_list.scale.result
function patch_list:scale(arguments) end

---@class (exact) sg.patch_list.mirror.arguments
---normal: normal of the mirror (a list of 2 or 3 numbers)
---@field normal [number, number]|[number, number, number]
---point: a point on the mirror (a list of 2 or 3 numbers; length; by default the origin)
---@field point? [number, number]|[number, number, number]
---@field [string] sg.unknown_argument

---@class (exact) sg.patch_list.mirror.result
---interfaces: faces on each other (a list of entries: each a list of two faces such as '1.east'; optional)
---@field interfaces? [string, string][]
---boundaries: faces by name (a table of names { name = … }; optional)
---@field boundaries? table<string, string[]>
---@field [integer] sg.patch

---Returns the mirror images of all patches, see patch:mirror. `boundaries` and `interfaces` name the same faces as
---before, also where a direction was reversed.
---
---```text
---patch_list:mirror{ normal, point }
---```
---
---Example:
---```lua
---sg.shapes.disc{ radius = 1, center = {2, 0} }:mirror{ normal = {1, 0} }
---```
---@param arguments sg.patch_list.mirror.arguments
---@return sg.patch_list.mirror.result
function patch_list:mirror(arguments) end

---Reverses a parametric direction; the shape is unchanged, the two faces at its ends exchange their names. A
---left-handed patch becomes right-handed, as sg.body requires, and for sg.rigid.surface inside and outside are
---exchanged.
---
---Source: as nrbreverse of the NURBS toolbox.
---
---Example:
---```lua
---patch:reverse(1){0, 0}  --> {3.0, 0.0}
---```
---@param dir integer # dir: parametric direction (a whole number from 1 to 3)
---@return sg.patch
function patch:reverse(dir) end

---Exchanges two parametric directions; the shape is unchanged. A right-handed patch becomes left-handed and vice versa;
---patch:reverse undoes this.
---
---Source: as nrbpermute and nrbtransp of the NURBS toolbox for two directions.
---
---Example:
---```lua
---patch:swap(1, 2){1, 0}  --> {0.0, 1.0}
---```
---@param i integer # i: parametric direction (a whole number from 1 to 3)
---@param j integer # j: parametric direction (a whole number from 1 to 3)
---@return sg.patch
function patch:swap(i, j) end

---Converts a flat curve or surface in 3D with constant z to the plane, for plane bodies: programs such as G+Smo write
---flat patches with three coordinates. It is an error if z is not constant; a plane patch is returned unchanged.
---
---Example:
---```lua
---sg.nurbs.line{ from = {0, 0, 4}, to = {3, 1, 4} }:to_plane()(1)  --> {3.0, 1.0}
---```
---@return sg.patch
function patch:to_plane() end

---@class (exact) sg.patch.to_space.arguments
---z: z of all points (a number; length; default 0)
---@field z? number
---@field [string] sg.unknown_argument

---Converts a curve or surface in the plane to 3D.
---
---```text
---patch:to_space{ z = 0 }
---```
---
---Example:
---```lua
---patch:to_space{ z = 2 }{1, 1}  --> {3.0, 1.0, 2.0}
---```
---@param arguments? sg.patch.to_space.arguments
---@return sg.patch
function patch:to_space(arguments) end

---Writes the patch to a file for other programs, as sg.nurbs.write does.
---
---Example:
---```lua
---patch:write "slab.xml"
---```
---@param file string # file: name of the file (a string)
---@param form? "gismo"|"geopdes"|"mfem" # form: format of the file ('gismo', 'geopdes' or 'mfem'; by default by the file's ending)
function patch:write(file, form) end
