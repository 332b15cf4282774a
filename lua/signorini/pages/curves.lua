-- Pages: NURBS curves, surfaces and volumes, made or read from files.

local patch_types = require "signorini.call.patch_types"
local t = require "signorini.call.types"

local points = { "points", t.points, "control points, fastest in xi1", unit = "length" }
local weights = { "weights", t.numbers(), "one per control point", otherwise = "1 each" }
local radius = { "radius", t.positive, "", unit = "length" }
local center = { "center", t.point, "center of the circle", default = { 0, 0 }, unit = "length" }
local file = { "file", t.text, "name of the patch file" }

local function tensor(directions)
  return { { "degrees", t.list(patch_types.degree, directions), "polynomial degrees, one per direction" },
           { "knots", t.list(t.numbers(), directions), "open knot vectors, one per direction" }, points, weights }
end

local patch = t.object "patch"

return {
  title = "Shapes and patches", word = "patches",
  { "sg.nurbs.curve", "Returns a NURBS curve in 2D or 3D.",
    named = { { "degree", patch_types.degree, "polynomial degree" },
              { "knots", t.numbers(), "open knot vector" }, points, weights },
    more = "The ends of an open knot vector are repeated degree + 1 times; it has points + degree + 1 knots in all.",
    returns = patch,
    example = "sg.nurbs.curve{ degree = 2, knots = {0, 0, 0, 1, 1, 1}, points = {{0, 0}, {1, 2}, {2, 0}} }" },
  { "sg.nurbs.surface", "Returns a tensor-product NURBS surface in 2D or 3D.",
    named = tensor(2),
    returns = patch, example = [[
sg.nurbs.surface{ degrees = {1, 1}, knots = {{0, 0, 1, 1}, {0, 0, 1, 1}},
                  points = {{0, 0}, {1, 0}, {0, 1}, {1, 1}} }]] },
  { "sg.nurbs.volume", "Returns a tensor-product NURBS volume; points run fastest in xi1, then in xi2.",
    named = tensor(3),
    returns = patch, example = [[
sg.nurbs.volume{ degrees = {1, 1, 1}, knots = {{0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}},
                 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                           {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}} }]] },
  { "sg.nurbs.line", "Returns a straight line of degree 1.",
    named = { { "from", t.point, "first end", unit = "length" },
              { "to", t.point_like "from", "other end", unit = "length" } },
    returns = patch, example = "sg.nurbs.line{ from = {0, 0}, to = {3, 0} }" },
  { "sg.nurbs.arc", [[Returns an exact circular arc of degree 2, one segment per 90 degrees or part of them;
counterclockwise if the angle increases. A center in 3D gives an arc parallel to the x-y plane.]],
    named = { radius, { "from", t.number, "first angle", unit = "degrees" },
              { "to", t.number, "last angle", unit = "degrees" }, center },
    returns = patch, example = "sg.nurbs.arc{ radius = 0.5, from = 180, to = 360 }" },
  { "sg.nurbs.circle", "Returns a full circle of four exact quarter arcs of degree 2.",
    named = { radius, center },
    returns = patch, example = "sg.nurbs.circle{ radius = 1 }" },
  { "sg.nurbs.ruled", [[Returns the ruled surface between two curves, or the ruled volume between two surfaces, which
are first brought to common degrees and knots; the new direction is the last one.]],
    named = { { "a", patch, "start" }, { "b", patch, "end" } },
    returns = patch,
    example = "sg.nurbs.ruled{ a = sg.nurbs.circle{ radius = 2 }, b = sg.nurbs.circle{ radius = 1 } }" },
  { "sg.nurbs.extrude", "Extrudes a curve or a surface along a vector; the new direction is the last one, of degree 1.",
    named = { { "patch", patch, "curve or surface to extrude" },
              { "along", t.point, "extrusion vector; if it has 3 numbers, a plane patch is placed in z = 0",
                unit = "length" } },
    returns = patch,
    example = { "sg.nurbs.extrude{ patch = sg.nurbs.line{ from = {0, 0}, to = {1, 0} }, along = {0, 2} }",
                "sg.nurbs.extrude{ patch = sg.shapes.quarter_annulus{ inner = 1, outer = 2 }, along = {0, 0, 1} }" } },
  { "sg.nurbs.revolve", "Revolves a curve or a surface about an axis, exactly; the new direction is the last one.",
    named = { { "patch", patch, "curve or surface to revolve; a plane patch is placed in z = 0" },
              { "point", patch_types.vector_or_space, "a point of the axis",
                otherwise = "the origin", unit = "length" },
              { "axis", patch_types.vector_or_space, "direction of the axis",
                otherwise = "{0, 0, 1}, for a plane patch {0, -1, 0}" },
              { "angle", t.number, "", default = 360, unit = "degrees" } },
    more = [[With the default axis of a plane patch, x is the radius as in axisymmetric models, and a right-handed patch
at x > 0 gives a right-handed volume.]],
    returns = patch, example = {
      "sg.nurbs.revolve{ patch = sg.nurbs.line{ from = {1, 0, 0}, to = {1, 0, 2} }, angle = 180 }",
      "sg.nurbs.revolve{ patch = sg.shapes.rectangle{ width = 1, height = 2, corner = {3, 0} }, angle = 90 }" } },
  { "sg.nurbs.coons", [[Returns a Coons patch: the surface between four boundary curves, or the volume between six
boundary surfaces, whose corners meet. west and east run along xi2, south and north along xi1.]],
    named = { { "west", patch, "where xi1 starts" }, { "east", patch, "where xi1 ends" },
              { "south", patch, "where xi2 starts" }, { "north", patch, "where xi2 ends" },
              { "front", patch, "where xi3 starts; for volumes", optional = true },
              { "back", patch, "where xi3 ends; for volumes", optional = true } },
    returns = patch, example = [[
line = sg.nurbs.line
sg.nurbs.coons{ west = line{ from = {0, 0}, to = {0, 1} }, east = line{ from = {1, 0}, to = {1, 2} },
                south = line{ from = {0, 0}, to = {1, 0} }, north = line{ from = {0, 1}, to = {1, 2} } }]],
  },
  { "sg.nurbs.read", [[Returns all patches of a file as a list, in the file's order; sg.body takes the list as a body of
several patches. The format is detected from the beginning of the file:]],
    arguments = { file },
    more = [[
  G+Smo's XML: geometries BSpline, Nurbs, TensorBSpline2 and 3, TensorNurbs2 and 3
  the text file of GeoPDEs and the NURBS toolbox, versions 0.7, 1.0 and 2.1, one or several patches
  MFEM NURBS mesh v1.0 with a section `patches`
The list has the fields `interfaces`, { { "1.east", "2.west" }, … }, and `boundaries`, { name = { "1.north", … } }, as
far as the file has them; in MFEM's files the name of a boundary is its attribute. Errors in a file are reported with
file and line.]],
    returns = patch_types.several, example = [=[
sg.shapes.half_annulus{ inner = 1, outer = 2 }:write "bracket.xml"
bracket = sg.nurbs.read("bracket.xml")[1]]=] },
  { "sg.nurbs.write", [[Writes a patch or a list of patches to a file, atomically; knots, weights and control points are
read back bitwise identical. Written, too, are interfaces (those of the list, otherwise all faces of two patches that
match point by point) and boundaries.]],
    arguments = { file, { "patches", t.either(patch, patch_types.several), "patches to write" }, patch_types.form },
    more = [[
  "gismo":   .xml, G+Smo's XML
  "geopdes": .txt, text file of GeoPDEs, version 2.1
  "mfem":    .mesh, MFEM NURBS mesh v1.0; neighbors must run along their common edges in the same direction. The
             attributes of the sides of one patch are west 1, east 2, south 3, north 4, front 5, back 6; of several the
             numbers of the boundaries by name, other faces the next number]],
    example = 'sg.nurbs.write("annulus.txt", sg.shapes.half_annulus{ inner = 1, outer = 2 })' },
}
