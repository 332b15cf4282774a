-- Pages: materials, bodies, rigid obstacles.

local core = require "signorini.core"
local patch_types = require "signorini.patch_types"
local t = require "signorini.types"

local thesis = "V. Agrawal, thesis, IIT Guwahati, 2020"

local cure = "0.5 is incompressible, which a displacement formulation cannot take: try 0.49"
local constants = {
  { "E", t.positive, "Young's modulus", unit = "force per area" },
  { "nu", { kind = "number", above = -1, below = 0.5, cure = cure }, "Poisson's ratio" },
}
local in_2d = "In 2D the material is in plane strain, unless the model is axisymmetric."

local label = t.name({ "N1", "N2", "N3", "N4", "N2-N2.1", "N2-N2.2", "N2-N4", "L1", "L2" }, "label") -- the usual ones

--- A label for all directions that it is about, along the contact face or all, or a list of one for each.
local order = t.by({ kind = "list", of = label, single = true,
                     ending = ", one per direction (along the contact face, if any)" }, function(_, given, raw)
  local directions = core.patch_sizes(given.patch)
  local along = raw.contact and " along the contact face" or ", as there is no contact face"
  return { kind = "list", of = label, single = true, size = raw.contact and directions - 1 or directions,
           ending = ", one per direction" .. along }
end)

local name_of_face = "west, east (ends of xi1), south, north (xi2), front, back (xi3)"
local driven = [[A support drives it: see help "obstacle".]]

return {
  title = "Materials, bodies, obstacles", word = "bodies",
  { "sg.neo_hookean",
    "Returns a compressible neo-Hookean material, W = lambda/2 (ln J)^2 + mu/2 (tr C - 3) - mu ln J. " .. in_2d,
    named = constants,
    more = "Source: (3.29) of " .. thesis .. ".",
    example = "sg.neo_hookean{ E = 1, nu = 0.3 }" },
  { "sg.linear_elastic", [[Returns a linear elastic material (Hooke's law of small strains), sigma = lambda tr(eps) I +
2 mu eps; contact still follows the deformed surface. ]] .. in_2d,
    named = constants,
    more = "Source: linear elasticity; its use: share/doc/theory.md, Bodies.",
    example = "sg.linear_elastic{ E = 1, nu = 0.3 }" },
  { "material", "What sg.neo_hookean and sg.linear_elastic return; print(material) shows the law and its constants." },
  { "sg.body", "Returns a solid body: a patch with a discretization and a material.",
    named = {
      { "patch", t.object "patch", "shape: a surface in the plane, a volume in 3D" },
      { "elements", patch_types.elements, "knot spans" },
      { "order", order, [[discretization label such as "N2-N2.2", help "labels"]] },
      { "contact", t.one_or_more(patch_types.any_face), "face that carries the layer, or two opposite ones",
        otherwise = "none" },
      { "material", { kind = "object", name = "material",
                      cure = "make one, as in material = sg.neo_hookean{ E = 1, nu = 0.3 }" }, "its law" },
      { "through", patch_types.degree, [[Degree in the thickness direction, from the contact face to the opposite one,
at least the geometry's own. Degree 1 takes about half of the unknowns and of the time, as the published studies do, but
locks in bending and for nu near 0.5]], otherwise = "that of the label's bulk" },
      { "grading", patch_types.grading, "where elements crowd; false: nowhere", otherwise = "uniform elements" },
    },
    more = [[Where a patch is folded so that two opposite faces are one, as in a full ring, the body is joined at that
seam. print(body) shows the degrees, and along which direction it is closed.
Source: k-refinement 2.3.3, varying-order layers (5.1) to (5.6) of ]] .. thesis .. ".",
    example = { [[
sg.body{ patch = sg.shapes.rectangle{ width = 3, height = 1 }, elements = {8, 3}, order = "N2-N2.2",
         contact = "north", material = sg.neo_hookean{ E = 1, nu = 0.3 } }]], [[
sg.body{ patch = sg.shapes.block{ size = {4, 4, 2} }, elements = {4, 4, 2}, order = {"N2-N4", "N2"},
         contact = "back", material = sg.neo_hookean{ E = 1, nu = 0.3 } }]] } },
  { "body", [[What sg.body returns, an immutable value. print(body) shows its elements and degrees per direction, of its
rows of control points one after the other where these differ, and its size; tostring(body) the first line of that.]],
    more = "Methods: face, edge, corner, dofs, points." },
  { "body:dofs", [[Returns the numbers of degrees of freedom { interface, bulk, total }: those of the contact faces'
control points, of all others, of all.]],
    example = "slab:dofs().total" },
  { "body:face", "Returns a face for supports, loads and contacts.",
    arguments = { { "name", patch_types.face, name_of_face } },
    example = 'slab:face "north"' },
  { "body:edge", "Returns the control points where two faces of a solid body meet, for supports.",
    arguments = { { "name", patch_types.edge, 'both faces, such as "south-front"' } },
    example = 'cube:edge "south-front"' },
  { "body:corner", "Returns the control point of a corner, for supports.",
    arguments = { { "name", patch_types.corner, 'its faces: "south-west", in 3D "west-south-front"' } },
    example = 'slab:corner "south-west"' },
  { "body:points", [[Returns the control points {{x, y}, …} of the undeformed body, row after row from south to north,
or from west to east where the contact face is west or east; in 3D {{x, y, z}, …}, layer after layer from front to back,
or along the direction of the contact face.]],
    example = "slab:points()[1]  --> {0.0, 0.0}" },
  { "face", "A face, edge or corner of a body, for supports, loads and contacts; print(face) shows which one it is." },
  { "sg.rigid.plane", "Returns a rigid half space in 2D or 3D as an obstacle, the master of a contact. " .. driven,
    named = { { "point", t.point, "a point of the plane", unit = "length" },
              { "normal", t.point_like "point", "direction out of the obstacle, towards the body" } },
    example = { "sg.rigid.plane{ point = {0, -1}, normal = {0, 1} }",
                "sg.rigid.plane{ point = {0, 0, -1}, normal = {0, 0, 1} }" } },
  { "sg.rigid.cylinder", [[Returns a rigid cylinder without ends as an obstacle. In the plane its axis is normal to it,
and it is a disc. ]] .. driven,
    named = { { "center", t.point, "a point of the axis", unit = "length" },
              { "axis", t.space_point, "direction of the axis: needed in 3D, none in 2D", optional = true },
              { "radius", t.positive, "", unit = "length" } },
    example = { "sg.rigid.cylinder{ center = {0, 2}, radius = 1 }",
                "sg.rigid.cylinder{ center = {0, 0, 2}, axis = {0, 1, 0}, radius = 1 }" } },
  { "sg.rigid.sphere",
    "Returns a rigid sphere in 3D, or on the axis of an axisymmetric model, as an obstacle. " .. driven,
    named = { { "center", t.point, "", unit = "length" }, { "radius", t.positive, "", unit = "length" } },
    example = "sg.rigid.sphere{ center = {0, 0, 2}, radius = 1 }" },
  { "sg.rigid.surface", [[Returns an obstacle that any NURBS bounds: a curve in the plane, its outside on the right of
its direction, or a surface in 3D, its outside where the product of its tangents along xi1 and xi2 points.
patch:reverse(1) turns it to the other side. ]] .. driven,
    arguments = { { "patch", t.object "patch", "curve in the plane, or surface in 3D" } },
    example = { "sg.rigid.surface(sg.nurbs.arc{ center = {0, 0}, radius = 1, from = 0, to = 180 })",
                'sg.rigid.surface(sg.shapes.block{ size = {9, 9, 1}, corner = {0, 0, -1} }:face "back")' } },
  { "obstacle", [[What sg.rigid.* return: a rigid master without unknowns; print(obstacle) shows its shape. It stands
still unless a support drives it: supports = { push = { on = obstacle, drive = "y" } }; stages then give its
displacement, push = {-0.1}, and run:column "push.fy" returns the force on it.]],
    example = [[
disc = sg.rigid.cylinder{ center = {1.5, 2}, radius = 1 }
sg.model{ bodies = { slab = slab },
  supports = { bed = { on = slab:face "south", fix = "xy" }, push = { on = disc, drive = "y" } },
  contacts = { touch = { slave = slab:face "north", master = disc, penalty = 100 } } }]] },
}
