-- Pages: bodies, rigid obstacles.

local core = require "signorini.core"
local patch_types = require "signorini.call.patch_types"
local t = require "signorini.call.types"

local thesis = "V. Agrawal, thesis, IIT Guwahati, 2020"

local label = t.name({ "N1", "N2", "N3", "N4", "N2-N2.1", "N2-N2.2", "N2-N4", "L1", "L2" }, "label") -- the usual ones
label.cure = 'a label is a text such as "N2"'

--- One label for all directions (along the contact face, if any), or a list with one per direction.
local order = t.by({ kind = "list", of = label, single = true,
                     ending = ", one per direction (along the contact face, if any)" }, function(_, given, raw)
  local directions = core.patch_sizes(given.patch)
  local along = raw.contact and " along the contact face" or ", as there is no contact face"
  return { kind = "list", of = label, single = true, size = raw.contact and directions - 1 or directions,
           ending = ", one per direction" .. along }
end)

--- One type for bodies in the plane, one in space.
local function by_dimension(general, plane, space)
  return t.by(general, function(_, given)
    local directions, dimension = core.patch_sizes(given.patch)
    if directions ~= dimension then return nil end -- not a body's shape, which is the better message
    return dimension == 2 and plane or space
  end)
end

local is_layer = t.callback_of({ { "X", t.point } }, t.flag)
local per_direction = t.worded(t.list(t.interval, 2), "a list of 2 ranges {{low, high}, {low, high}}")
local layer = by_dimension(t.either(t.interval, per_direction, is_layer), t.either(t.interval, is_layer),
  t.either(per_direction, is_layer))

local parts = t.integer(1, 1000)
local knots = t.either(parts, t.numbers())
local layer_knots = by_dimension(t.either(parts, t.list(t.either(t.number, t.numbers()))), knots,
  t.either(parts, t.list(knots, 2)))

--- A place of a part of a body of several patches.
local function part_place(count, noun)
  return t.name(function(body) return require("signorini.scene.compound").place_names(body, count) end, noun)
end

local name_of_face = "west, east (ends of xi1), south, north (xi2), front, back (xi3)"
local driven = [[A support can move it: see help "obstacle".]]
--- A curve or surface as a tool.
local boundary = { kind = "object", name = "patch", cure = function(value)
  if type(value) == "table" and rawlen(value) > 0 then
    return "make one obstacle per patch of the list; sg.nurbs.read(file)[1] is the first patch of a file"
  end
end }
local inside = { "inside", t.flag, "hollow: the body is inside, as in a bore, a socket or a groove", default = false }

return {
  title = "Materials, bodies, obstacles", word = "bodies",
  { "sg.body", "Returns a solid body: a patch with a discretization and a material.",
    named = {
      { "patch", t.by(t.either(t.object "patch", patch_types.several), function() return t.object "patch" end),
        "shape: a surface in the plane, a volume in 3D, or a list of these, see help \"compound\"" },
      { "elements", patch_types.elements, [[numbers of elements; with a list of patches also a list with an entry per
patch. Peak pressures need at least 7 across a contact with order N2, 3 with N2-N2.2 (penalty in help "contact"); a run
warns if a contact has fewer]] },
      { "order", order, [[discretization label such as "N2-N2.2", help "orders"]] },
      { "contact", t.one_or_more(patch_types.any_face), [[face that carries the layer, or two opposite ones; required
for orders with a layer. Any face can be slave or master of a contact]], otherwise = "none" },
      { "layer", layer, [[where the layer is, with elements that overlap it: parameters along the contact face; in
space a range per direction, whose strips both have the layer's degree along them; or a function of the undeformed
position X. With the degree the continuity changes: that of the bulk at the borders]], otherwise = "the whole face",
        needs = { "contact", example = 'contact = "south"' } },
      { "layer_knots", layer_knots, [[knots of the contact rows only: the number of equal parts of each element of the
layer, or a list of knots; in space also a list with one of these per direction]], optional = true,
        needs = { "contact", example = 'contact = "south"' } },
      { "material", { kind = "object", name = "material",
                      cure = "for example material = sg.neo_hookean{ E = 1, nu = 0.3 }" }, "the material" },
      { "thickness_degree", patch_types.degree, [[Degree in the thickness direction, from the contact face to the
opposite one, at least the geometry's own. Degree 1, as in the published studies, has fewer unknowns and takes
about half of the time, but locks in bending and for nu near 0.5]], otherwise = "that of the label's bulk" },
      { "volumetric", t.choice { "pointwise", "projected" }, [[Volume change of each point, or its projection on
polynomials of one degree less in macro-elements of p elements per direction: nothing locks for nu near 0.5, at
the cost of larger coupled groups. Not for plane stress]], otherwise = '"pointwise"' },
      { "density", t.positive, [[mass per volume of the undeformed body, for model:modes; in the plane per unit
depth]], default = 1, unit = "mass per volume" },
      { "grading", patch_types.grading, "where elements are concentrated; false: uniform",
        otherwise = "uniform elements" },
    },
    more = [[Where two opposite faces of the patch coincide, as in a full ring, the body is joined at this seam.
print(body) shows the degrees and the closed directions.
Source: k-refinement 2.3.3, varying-order layers (5.1) to (5.6) of ]] .. thesis .. ".",
    returns = t.either(t.object "body", t.object "compound"), example = { [[
sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = {8, 3}, order = "N2-N2.2",
         contact = "north", material = sg.neo_hookean{ E = 1, nu = 0.3 } }]], [[
sg.body{ patch = sg.shapes.block{ size = {4, 4, 2} }, elements = {4, 4, 2}, order = {"N2-N4", "N2"},
         contact = "back", material = sg.neo_hookean{ E = 1, nu = 0.3 } }]], [[
sg.body{ patch = sg.shapes.block{ size = {9, 6, 2} }, elements = {9, 6, 2}, order = "N2-N2.2", contact = "back",
         layer = function(X) return (X[1] - 4) ^ 2 + (X[2] - 3) ^ 2 < 1 end,
         material = sg.neo_hookean{ E = 1, nu = 0.3 } }]] } },
  { "body", [[The result of sg.body, an immutable value. print(body) shows elements and degrees per direction (per row
of control points where these differ) and the size; tostring(body) shows the first line only.]],
    more = "Methods: face, edge, corner, dofs, points." },
  { "compound", [[The result of sg.body for a list of patches, such as sg.nurbs.read returns: a body of several patches,
whose parts are single bodies. In a model the parts of `ball` are "ball.1", "ball.2", …, in the order of the list; as
`bodies` of a picture "ball" means all of them.]],
    more = [[
Faces of two parts that lie on each other are joined; where their meshes do not match they are tied, and so are faces up
to 10 % of an element's length apart, with a warning. print(model) shows what happened. If the list has `interfaces`,
only the faces in it are joined: { { "1.east", "2.west" }, … }. Parts that nothing connects with others are an error.
`boundaries` of the list names faces: { outer = { "1.south", "2.south" } }; compound:face "outer" then returns these.
Arguments of sg.body: order is one label for all; contact lists faces such as "1.south", or boundaries; parts without
such a face have the label's bulk, N2 of N2-N4; layer is a function if several parts have contact faces. Methods: face,
edge, corner, part.]],
    example = [[
square = sg.shapes.rectangle
pair = sg.body{ patch = { square{ width = 1, height = 1 }, square{ width = 1, height = 1, corner = {1, 0} },
                          boundaries = { top = { "1.north", "2.north" } } },
                elements = {2, 2}, order = "N2", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
beam = sg.model{ bodies = { pair = pair }, supports = { lid = { on = pair:face "top", fix = "xy" } } }]] },
  { "compound:corner", "Returns the control point of a corner of a part, for supports.",
    arguments = { { "name", part_place(0, "corner name"), 'part and corner: "2.south-west"' } },
    returns = t.object "face", example = 'pair:corner "1.south-west"' },
  { "compound:edge", "Returns the control points of an edge of a part of a solid body, for supports.",
    arguments = { { "name", part_place(2, "edge name"), 'part and edge: "2.south-front"' } },
    returns = t.object "face", example = 'cubes:edge "1.south-front"' },
  { "compound:face", [[Returns a face of a part, or the list of the faces of a boundary, for supports, loads, contacts,
ties and joins. As slave or master the faces of a list must be adjacent.]],
    arguments = { { "name", part_place(1, "face name"), 'part and face, "2.north", or a boundary' } },
    returns = t.any, example = 'pair:face "top"' },
  { "compound:part", "Returns a part as a body.",
    arguments = { { "number", t.count, "from 1, in the order of the patches" } },
    returns = t.object "body", example = "pair:part(2):dofs().total" },
  { "body:dofs", [[Returns the numbers of degrees of freedom { interface, bulk, total }: those of the contact faces'
control points, of all others, of all.]],
    returns = t.record("interface bulk total", t.integer(0)), example = "slab:dofs().total" },
  { "body:face", "Returns a face for supports, loads and contacts.",
    arguments = { { "name", patch_types.face, name_of_face } },
    returns = t.object "face", example = 'slab:face "north"' },
  { "body:edge", "Returns the control points where two faces of a solid body meet, for supports.",
    arguments = { { "name", patch_types.edge, 'both faces, such as "south-front"' } },
    returns = t.object "face", example = 'cube:edge "south-front"' },
  { "body:corner", "Returns the control point of a corner, for supports.",
    arguments = { { "name", patch_types.corner, 'its faces: "south-west", in 3D "west-south-front"' } },
    returns = t.object "face", example = 'slab:corner "south-west"' },
  { "body:points", [[Returns the control points {{x, y}, …} of the undeformed body, row after row from south to north,
or from west to east where the contact face is west or east; in 3D {{x, y, z}, …}, layer after layer from front to back,
or along the direction of the contact face.]],
    returns = t.points, example = "slab:points()[1]  --> {0.0, 0.0}" },
  { "face", "A face, edge or corner of a body, for supports, loads and contacts; print(face) shows which one it is." },
  { "sg.rigid.plane", "Returns a rigid half space in 2D or 3D as an obstacle, the master of a contact. " .. driven,
    named = { { "point", t.point, "a point of the plane", unit = "length" },
              { "normal", t.point_like "point", "direction out of the obstacle, towards the body" } },
    returns = t.object "obstacle", example = { "sg.rigid.plane{ point = {0, -1}, normal = {0, 1} }",
                "sg.rigid.plane{ point = {0, 0, -1}, normal = {0, 0, 1} }" } },
  { "sg.rigid.cylinder", [[Returns a rigid cylinder of infinite length as an obstacle; in the plane, a
disc. ]] .. driven,
    named = { { "center", t.point, "a point of the axis", unit = "length" },
              { "axis", t.space_point, "direction of the axis; needed in 3D, not allowed in 2D", optional = true },
              { "radius", t.positive, "", unit = "length" }, inside },
    returns = t.object "obstacle", example = { "sg.rigid.cylinder{ center = {0, 2}, radius = 1 }",
                "sg.rigid.cylinder{ center = {0, 0, 2}, axis = {0, 1, 0}, radius = 1 }",
                "sg.rigid.cylinder{ center = {0, 0}, radius = 3, inside = true }" } },
  { "sg.rigid.sphere",
    "Returns a rigid sphere in 3D, or on the axis of an axisymmetric model, as an obstacle. " .. driven,
    named = { { "center", t.point, "", unit = "length" }, { "radius", t.positive, "", unit = "length" }, inside },
    returns = t.object "obstacle", example = { "sg.rigid.sphere{ center = {0, 0, 2}, radius = 1 }",
                "sg.rigid.sphere{ center = {0, 0, 0}, radius = 3, inside = true }" } },
  { "sg.rigid.torus", [[Returns a rigid torus as an obstacle: in an axisymmetric model a disc off the axis, in 3D a
circle revolved about an axis. A groove is a hollow one, inside = true. ]] .. driven,
    named = { { "center", t.point, "in 2D {r, z}, of the circle; in 3D of the torus", unit = "length" },
              { "axis", t.space_point, "direction of the axis; needed in 3D, not allowed in 2D", optional = true },
              { "ring", t.positive, "distance of the circle's center from the axis; needed in 3D, not allowed in 2D",
                unit = "length", optional = true },
              { "radius", t.positive, "of the circle", unit = "length" }, inside },
    returns = t.object "obstacle", example = { "sg.rigid.torus{ center = {4, 1}, radius = 0.5 }",
                "sg.rigid.torus{ center = {0, 0, 1}, axis = {0, 0, 1}, ring = 4, radius = 0.5 }" } },
  { "sg.rigid.level_set", [[Returns an obstacle bounded by the curve or surface f = 0 of a formula, with f > 0 outside.
The function is called once with symbols for the coordinates, to read its formula; in an axisymmetric model x is the
radius. ]] .. driven,
    named = { { "f", t.callback_of({ { "x", t.object "symbol" }, { "y", t.object "symbol" },
                                     { "z", t.object "symbol" } }, t.object "symbol"),
                "positive outside, negative inside" },
              { "box", t.list(t.point, 2), "{corner, opposite corner}: where contact occurs", unit = "length" } },
    more = [[Closest points are searched from points of the surface in the box, found on a lattice of 160 (in 3D 40)
cells along its longest side, so that details must be larger; pictures show that part. The surface does not end at the
box. It may have several parts. f must be finite in the box and have a gradient where it is zero: use one obstacle per
surface where surfaces cross. Corners and edges, as of sg.abs, have no closest points that Newton's method finds: round
them, as in the superellipse below. A formula has + - * / ^ and the functions in help "formulas"; write no if.
Checkpoints and studies hold the formula.]],
    returns = t.object "obstacle", example = { [[
sg.rigid.level_set{ f = function(x, y) return x^4 + (y / 2)^4 - 1 end, box = { {-2, -3}, {2, 3} } }]], [[
sg.rigid.level_set{ f = function(x, y, z) return z - 0.1 * sg.cos(x) * sg.cos(y) end,
  box = { {-5, -5, -1}, {5, 5, 1} } }]] } },
  { "sg.rigid.surface", [[Returns an obstacle bounded by a NURBS: a curve in the plane, whose outside is on the right of
its direction, or a surface in 3D, whose outward normal is the cross product of its tangents along xi1 and xi2.
patch:reverse(1) exchanges inside and outside. ]] .. driven,
    arguments = { { "patch", boundary, "curve in the plane, or surface in 3D" } },
    more = [[The patch may come from a file, sg.rigid.surface(sg.nurbs.read("tool.xml")[1]); of a body's shape take a
face, patch:face "north".
Rounding errors are those of its largest coordinate: an arc of radius 4e6 on a layer 0.25 thick gives a force 2e-4 off.
Planes, cylinders, spheres and tori have no such limit.]],
    returns = t.object "obstacle",
    example = { "sg.rigid.surface(sg.nurbs.arc{ center = {0, 0}, radius = 1, from = 0, to = 180 })",
                'sg.rigid.surface(sg.shapes.block{ size = {9, 9, 1}, corner = {0, 0, -1} }:face "back")' } },
  { "obstacle", [[The result of sg.rigid.*: a rigid master; print(obstacle) shows its shape. It is fixed unless a
support drives, rotates or frees it: supports = { push = { on = obstacle, drive = "y" } }; stages then give its
displacement, push = {-0.1}, and run:column "push.fy" returns the force that the support exerts
on the obstacle, which equals the contact force on the slave, run:column "touch.fy".]],
    example = [[
disc = sg.rigid.cylinder{ center = {1.5, 2}, radius = 1 }
sg.model{ bodies = { slab = slab },
  supports = { bed = { on = slab:face "south", fix = "xy" }, push = { on = disc, drive = "y" } },
  contacts = { touch = { slave = slab:face "north", master = disc, penalty = 100 } } }]] },
}
