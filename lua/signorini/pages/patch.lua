-- Pages: patches and their methods.

local core = require "signorini.core"
local patch_types = require "signorini.call.patch_types"
local t = require "signorini.call.types"

local a_patch = t.object "patch"
local xi = { "xi", patch_types.parameters, "parametric coordinates" }
local dir = { "dir", patch_types.direction, "parametric direction" }
local axis = { "axis", t.space_point, "direction of the axis; needed in 3D, not allowed in 2D", optional = true }

--- A point that is the origin by default.
local function point(key, text)
  return { key, patch_types.vector, text, otherwise = "the origin", unit = "length" }
end

-- Motions of a patch and of all patches of a list.
local translation = { { "by", patch_types.vector, "displacement", unit = "length" } }
local center = point("center", "the fixed point")
local rotation = { { "angle", t.number, "counterclockwise", unit = "degrees" }, axis, center }
local scaling = { { "factor", patch_types.factor, "for all coordinates, or one for each in a list" }, center }
local mirroring = { { "normal", patch_types.vector, "normal of the mirror" }, point("point", "a point on the mirror") }

return {
  title = "Shapes and patches", word = "patches",
  { "patch", [[A NURBS curve, surface or volume, an immutable value: methods that change something return a new patch.
sg.shapes.* and sg.nurbs.* make patches. Called as a function, a patch returns the point at xi, {x, y} or {x, y, z}.]],
    head = "patch(xi)",
    arguments = { xi },
    more = [[Methods: evaluate, derivatives, basis, insert, elevate, refine, face, degrees, elements, knots, points,
weights, translate, rotate, scale, mirror, reverse, swap, to_plane, to_space, write; see for example help
"patch:refine".]],
    returns = t.point, example = "sg.shapes.rectangle{ width = 3, height = 1 }{0.5, 0.5}  --> {1.5, 0.5}" },
  { "patch:evaluate", "Returns the point at xi, {x, y} or {x, y, z}, as patch(xi) does.",
    arguments = { xi },
    returns = t.point, example = "patch:evaluate{0.5, 0.5}  --> {1.5, 0.5}" },
  { "patch:derivatives", [[Returns all partial derivatives of the map at xi up to total order n: a list of { orders =
{1, 0}, value = {x, y} }, sorted by total order, then by decreasing order in xi1.]],
    arguments = { xi, { "n", t.integer(0, core.max_degree), "highest total order" } },
    more = "Source: Piegl & Tiller, The NURBS Book, eq. (4.20).",
    returns = t.list(t.record("orders", t.list(t.integer(0)), "value", t.point)),
    example = "patch:derivatives({0.5, 0.5}, 1)[2].value  --> {3.0, 0.0}" },
  { "patch:basis", [[Returns the rational basis functions that are nonzero at xi, as a list of { index, value }; index
is the number of the control point from 1, fastest in xi1. The values add up to 1.]],
    arguments = { xi },
    returns = t.list(t.record("index", t.count, "value", t.number)),
    example = "patch:basis({0.5, 0.5})[1].value  --> 0.25" },
  { "patch:insert", "Inserts knots in one direction; the shape is unchanged.",
    arguments = { dir, { "knots", t.numbers(), "knots to insert, with repetitions" } },
    returns = a_patch, example = "patch:insert(1, {0.25, 0.5}):elements()  --> {3, 1}" },
  { "patch:elevate", "Raises the degree in one direction and keeps the continuity; the shape is unchanged.",
    arguments = { dir, { "times", patch_types.degree, "by how much", default = 1 } },
    returns = a_patch, example = "patch:elevate(1, 2):degrees()  --> {3, 1}" },
  { "patch:refine", [[Applies k-refinement: raises the degrees first, then inserts knots until each direction has the
given number of elements (nonempty knot spans); existing knots and the shape are unchanged. For a curve, arguments are
values instead of lists.]],
    named = { { "elements", patch_types.elements, "numbers of elements", otherwise = "the patch's own" },
              { "degree", patch_types.per_direction(patch_types.degree), "polynomial degrees",
                otherwise = "the patch's own" },
              { "grading", patch_types.grading, "where elements are concentrated; false: uniform",
                otherwise = "uniform elements", needs = { "elements" } } },
    more = [[grading = { { elements = 0.8, length = 0.1, at = "start" }, false } puts 80 % of the elements of the first
direction into the first tenth of its length and leaves the second direction uniform.]],
    returns = a_patch, example = "patch:refine{ elements = {8, 3}, degree = {2, 2} }" },
  { "patch:face", "Returns a side as a patch of one direction less.",
    arguments = { { "name", patch_types.face, "west, east (ends of xi1), south, north (xi2), front, back (xi3)" } },
    returns = a_patch, example = 'patch:face "south"' },
  { "patch:degrees", "Returns the list of the polynomial degrees, one per direction.",
    returns = t.list(t.count), example = "patch:degrees()  --> {1, 1}" },
  { "patch:elements", "Returns the list of the numbers of elements (nonempty knot spans), one per direction.",
    returns = t.list(t.count), example = "patch:elements()  --> {1, 1}" },
  { "patch:knots", "Returns the knot vector of a direction.",
    arguments = { dir },
    returns = t.numbers(), example = "patch:knots(1)  --> {0.0, 0.0, 1.0, 1.0}" },
  { "patch:points", "Returns the control points {{x, y}, …}, fastest in xi1.",
    returns = t.points, example = "patch:points()[4]  --> {3.0, 1.0}" },
  { "patch:weights", "Returns the weights of the control points, in the order of patch:points().",
    returns = t.numbers(), example = "patch:weights()[1]  --> 1.0" },
  { "patch:translate", "Moves the patch by a vector.",
    arguments = translation,
    returns = a_patch, example = "patch:translate{1, 0}{0, 0}  --> {1.0, 0.0}" },
  { "patch:rotate", "Rotates the patch about a center, in 3D about an axis through it.",
    named = rotation,
    returns = a_patch, example = "patch:rotate{ angle = 30, center = {1.5, 0.5} }" },
  { "patch:scale", "Scales the patch about a center.",
    named = scaling,
    returns = a_patch, example = "patch:scale{ factor = {2, 1} }{1, 1}  --> {6.0, 1.0}" },
  { "patch:mirror", [[Returns the mirror image across a line, in 3D across a plane. The parametric direction closest to
the normal is reversed, so that the image of a body is right-handed again and an obstacle keeps its outside; curves in
3D keep their direction.]],
    named = mirroring,
    returns = a_patch, example = "patch:mirror{ normal = {1, 0} }{0, 0}  --> {-3.0, 0.0}" },
  { "patch_list", [[A list of patches, as sg.shapes.disc, cylinder, ball and torus and sg.nurbs.read return it, with
the names of its faces: `boundaries`, `interfaces`. sg.body makes a body of all of them. list[1] is a patch.]],
    more = "Methods: translate, rotate, scale, mirror, as of a patch, of all patches; the names of faces are kept." },
  { "patch_list:translate", "Moves all patches by a vector.",
    arguments = translation,
    returns = patch_types.several, example = "#sg.shapes.disc{ radius = 1 }:translate{1, 0}  --> 5" },
  { "patch_list:rotate", "Rotates all patches about a center, in 3D about an axis through it.",
    named = rotation,
    returns = patch_types.several,
    example = "sg.shapes.cylinder{ radius = 1, width = 2 }:rotate{ angle = 90, axis = {1, 0, 0} }" },
  { "patch_list:scale", "Scales all patches about a center.",
    named = scaling,
    returns = patch_types.several, example = "sg.shapes.disc{ radius = 1 }:scale{ factor = {2, 1} }" },
  { "patch_list:mirror", [[Returns the mirror images of all patches, see patch:mirror. `boundaries` and `interfaces`
name the same faces as before, also where a direction was reversed.]],
    named = mirroring,
    returns = patch_types.several,
    example = "sg.shapes.disc{ radius = 1, center = {2, 0} }:mirror{ normal = {1, 0} }" },
  { "patch:reverse", [[Reverses a parametric direction; the shape is unchanged, the two faces at its ends exchange their
names. A left-handed patch becomes right-handed, as sg.body requires, and for sg.rigid.surface inside and outside are
exchanged.]],
    arguments = { dir },
    more = "Source: as nrbreverse of the NURBS toolbox.",
    returns = a_patch, example = "patch:reverse(1){0, 0}  --> {3.0, 0.0}" },
  { "patch:swap", [[Exchanges two parametric directions; the shape is unchanged. A right-handed patch becomes
left-handed and vice versa; patch:reverse undoes this.]],
    arguments = { { "i", patch_types.one_of_two, "parametric direction" },
                  { "j", patch_types.one_of_two, "parametric direction" } },
    more = "Source: as nrbpermute and nrbtransp of the NURBS toolbox for two directions.",
    returns = a_patch, example = "patch:swap(1, 2){1, 0}  --> {0.0, 1.0}" },
  { "patch:to_plane", [[Converts a flat curve or surface in 3D with constant z to the plane, for plane bodies: programs
such as G+Smo write flat patches with three coordinates. It is an error if z is not constant; a plane patch is returned
unchanged.]],
    returns = a_patch, example = "sg.nurbs.line{ from = {0, 0, 4}, to = {3, 1, 4} }:to_plane()(1)  --> {3.0, 1.0}" },
  { "patch:to_space", "Converts a curve or surface in the plane to 3D.",
    named = { { "z", t.number, "z of all points", default = 0, unit = "length" } },
    may_be_empty = true,
    returns = a_patch, example = "patch:to_space{ z = 2 }{1, 1}  --> {3.0, 1.0, 2.0}" },
  { "patch:write", "Writes the patch to a file for other programs, as sg.nurbs.write does.",
    arguments = { { "file", t.text, "name of the file" }, patch_types.form },
    example = 'patch:write "slab.xml"' },
}
