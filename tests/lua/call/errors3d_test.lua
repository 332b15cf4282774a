-- Messages about invalid input in 3D name the user's line, the function, the argument, its value, and a hint.

require "check"

-- Each ends with status 1 and a message that names the script's line, the argument, the value and the hint.
local start = [[
local sg = require "signorini"
local soft = sg.neo_hookean{ E = 1, nu = 0.3 }
local unit = sg.shapes.block{ size = {1, 1, 1} }
local square = sg.shapes.rectangle{ width = 1, height = 1 }
local flat = sg.body{ patch = square, elements = {1, 1}, order = "N1", material = soft }
local b = sg.body{ patch = unit, elements = {2, 2, 2}, order = "N2", contact = "back", material = soft }
local function with(order, contact, patch)
  return { patch = patch or unit, elements = {2, 2, 2}, order = order, contact = contact, material = soft }
end
local function supported(support) return { bodies = { b = b }, supports = { s = support } } end
local function touching(master)
  return { bodies = { b = b }, contacts = { c = { slave = b:face "back", master = master, penalty = 1 } } }
end
]]
check.refusals(start, 14, {
  -- Shapes
  { [[sg.body(with("N2", nil, unit:face "back"))]], "sg.body: patch must be a surface in the plane, or a volume in 3D",
    "this one is a surface in 3D", "sg.nurbs.extrude" },
  { [[sg.body(with("N2", nil, sg.nurbs.line{ from = {0, 0}, to = {1, 0} }))]], "this one is a curve in the plane" },
  { [[sg.body{ patch = unit, elements = {2, 2}, order = "N2", material = soft }]],
    "sg.body: elements must be a list of 3 whole numbers from 1 to 1000000, one per direction",
    "got a list of 2 values" },
  { [[sg.body(with("N1", "back", sg.nurbs.ruled{ a = unit:face "back", b = unit:face "front" }))]],
    "sg.body: the patch's map is not right-handed (Jacobian -1", "near (0.", "reverse one parametric direction" },
  { [[
      local p = unit:points()
      p[7], p[8] = p[8], p[7]
      local u = {0, 0, 1, 1}
      sg.body(with("N1", "back", sg.nurbs.volume{ degrees = {1, 1, 1}, knots = {u, u, u}, points = p }))]],
    "sg.body: the patch's map is not right-handed (Jacobian -", "untangle the control points", line = 17 },
  -- Labels
  { [[sg.body(with({"N2"}, "back"))]],
    "sg.body: order must be a label or a list of 2 labels, one per direction along the contact face",
    "got a list of 1 value" },
  { [[sg.body(with({"N2", "N2", "N2"}, "back"))]], "a list of 2 labels", "got a list of 3 values" },
  { [[sg.body(with({"N2", "N2"}))]], "a label or a list of 3 labels, one per direction, as there is no contact face",
    "got a list of 2 values" },
  { [[sg.body{ patch = square, elements = {1, 1},
      order = {"N2", "N4"}, contact = "south", material = soft }]],
    "order must be a label, one per direction along the contact face", "got a list of 2 values" },
  { [[sg.body(with({"N2", 4}, "back"))]], "sg.body: order[2] must be a label", "got the number 4" },
  { [[sg.body(with({"N2", "Q2"}, "back"))]], "order must be a discretization label, got 'Q2'" },
  { [[sg.body(with({"N2", "N2-N4", "N2"}))]], "'N2-N4' has a layer, but the body has no contact face" },
  { [[sg.body(with({"N2-N4x2", "N2-N4"}, "back"))]], "N2-N4x2", "give both the same xr" },
  { [[sg.body(with({"L2", "N2"}, "back"))]], "'L2' and 'N2' cannot be combined" },
  -- Faces, edges, corners
  { [[flat:face "front"]],
    "body:face: face must be one of west, east, south, north, the ends of xi1 and xi2, got 'front'" },
  { [[sg.body{ patch = square, elements = {1, 1},
      order = "N2", contact = "front", material = soft }]],
    "sg.body: contact must be 'west', 'east', 'south' or 'north'", "got the string 'front'" },
  { [[b:face "top"]],
    "face must be one of west, east, south, north, front, back, the ends of xi1, xi2 and xi3, got 'top'.",
    "Hint: did you mean 'back'?" },
  { [[sg.model(supported{ on = b:face "front", fix = "x" }):sample("b", "uz", 0.5)]],
    "model:sample: xi must be a list of 2 numbers {xi1, xi2}, in 3D of 3 (parametric coordinates), got the number 0.5",
    "braces" },
  { [[sg.model(supported{ on = b:face "front", fix = "x" }):set_target("s", {0})]],
    "model:set_target: name 's': this support has no driven component", "drive = \"x\"" },
  { [[sg.picture{ model = sg.model(supported{ on = b:face "front", fix = "x" }), field = "ux",
      range = 0.1, file = "none.png" }]],
    "sg.picture: range must be a list of 2 increasing numbers {low, high}, got the number 0.1", "braces" },
  { [[flat:edge "south-west"]], "body:edge: a plane body has faces and corners, but no edges",
    [[b:corner "south-west"]] },
  { [[b:edge "south-north"]], "body:edge: name must be 'west-south', 'west-north'", "got the string 'south-north'" },
  { [[b:corner "south-west"]], "body:corner: name must be 'west-south-front'", "got the string 'south-west'" },
  { [[flat:corner "west-south-front"]], "name must be 'south-west', 'south-east', 'north-west' or 'north-east'" },
  { [[sg.model{ bodies = { b = b }, loads = { f = { on = b:edge "south-front", pressure = 1 } } }]],
    "loads.f.on must be a face, got the edge 'south-front': an edge has no surface" },
  -- Supports
  { [[sg.model{ bodies = { a = flat }, supports = { s = { on = flat:face "south", fix = "xyz" } } }]],
    "supports.s.fix must be 'x', 'y' or 'xy'", "got the string 'xyz'", "the bodies are plane" },
  { [[sg.model(supported{ on = b:face "front", fix = "w" })]],
    "supports.s.fix must be 'x', 'y', 'z', 'xy', 'xz', 'yz' or 'xyz'", "got the string 'w'" },
  { [[sg.model(supported{ on = b:face "front", fix = "xyz", drive = "z" })]],
    "supports.s: it both fixes and drives z" },
  { [[sg.model(supported{ on = b:face "front" })]], [[add fix = "xy", drive = "xy", rotate = "z" or symmetry = true]] },
  { [[sg.model{ bodies = { a = flat }, supports = { s = { on = flat:face "south", rotate = "z" } } }]],
    "supports.s.rotate must be true or false", "got the string 'z'", "write rotate = true" },
  { [[sg.model(supported{ on = b:face "front", rotate = true })]],
    "supports.s.rotate must be 'x', 'y', 'z', or a vector {x, y, z}", "got true", [[as in rotate = "z"]] },
  { [[sg.model(supported{ on = b:face "front", rotate = {0, 0, 0} })]], "supports.s.rotate must be",
    "a zero vector has no direction" },
  { [[sg.model(supported{ on = b:face "front", rotate = {0, 1} })]], "supports.s.rotate must be a list of 3 numbers" },
  { [[sg.model(supported{ on = b:edge "south-front", rotate = "z" })]],
    "supports.s.on must be a face, or a list of faces, got the edge 'south-front'", "only faces of bodies can rotate" },
  { [[sg.model{ bodies = { b = b }, loads = { f = { on = b:face "back", traction = {0, 1} } } }]],
    "loads.f.traction must be a list of 3 numbers {tx, ty, tz}", "got a list of 2 values" },
  { [[sg.model{ bodies = { b = b }, loads = { f = { on = b:face "back" } } }]],
    "one of traction = {tx, ty} ({tx, ty, tz} in 3D) and pressure = p" },
  { [[sg.model(supported{ on = b:face "front", drive = "xyz", rotate = "z" }):run{ { steps = 1, s = {0, 0, 1} } }]],
    "stages[1].s must be a list of 4 numbers (ux, uy, uz, angle), got a list of 3 values" },
  -- Plane and 3D mixed
  { [[sg.model{ bodies = { b = b, c = flat } }]], "sg.model: bodies.c must be a body in 3D, got one in the plane",
    "all parts of a model must be in the plane, or all in 3D" },
  { [[sg.model{ bodies = { a = flat, b = b } }]], "bodies.b must be a body in the plane, got one in 3D" },
  { [[sg.model(touching(flat:face "south"))]], "contacts.c.master must be a face in 3D, got one in the plane" },
  { [[sg.model(touching(sg.rigid.sphere{ center = {0, 2}, radius = 1 }))]],
    "contacts.c.master must be an obstacle in 3D, got one in the plane" },
  { [[sg.model(supported{ on = flat:face "south", fix = "x" })]],
    "supports.s.on must be a face in 3D, got one in the plane" },
  { [[sg.model{ bodies = { b = b }, kind = "plane_strain" }]], "kind is for plane models", "omit it" },
  { [[sg.model(supported{ on = b:face "front", fix = "x" }):sample(flat, "ux", {0, 0})]],
    "model:sample: body must be a body in 3D" },
  { [[sg.model(supported{ on = b:face "front", fix = "x" }):sample(b, "ux", {0, 0})]],
    "model:sample: xi must be a list of 3 numbers {xi1, xi2, xi3}", "got a list of 2 values" },
  { [[sg.model{ bodies = { b = b } }:run{ { steps = 1 } }]], "model:run: the model has neither supports nor loads",
    "neither supports nor loads" },
  { [[sg.picture{ model = sg.model(supported{ on = b:face "front", fix = "x" }),
      field = "contact_pressure", file = "none.png" }]], "sg.picture: field 'contact_pressure' needs a contact" },
  { [[local a = sg.model{ bodies = { a = flat } }
      sg.model{ bodies = { b = b } }:restore(a:snapshot())]],
    "model:restore: snapshot must be a snapshot in 3D, got one in the plane", line = 15 },
  { [[b.dofs(soft)]], "body:dofs must be called on a body, not on a material" },
  { [[b:dof()]], "a body has no method 'dof'; did you mean 'dofs'?" },
  -- Obstacles
  { [[sg.rigid.plane{ point = {0, 0, 0}, normal = {0, 1} }]],
    "sg.rigid.plane: normal must be a list of 3 numbers {x, y, z}", "got a list of 2 values" },
  { [[sg.rigid.cylinder{ center = {0, 0, 0}, radius = 1 }]],
    "sg.rigid.cylinder: axis is missing: it must be a list of 3 numbers {x, y, z}, its direction" },
  { [[sg.rigid.cylinder{ center = {0, 0}, axis = {0, 0, 1}, radius = 1 }]], "axis is for cylinders in 3D",
    "omit axis" },
  { [[sg.rigid.cylinder{ center = {0, 0, 0}, axis = {0, 0, 0}, radius = 1 }]], "sg.rigid.cylinder", "axis" },
  { [[sg.rigid.surface(unit)]], "sg.rigid.surface: patch must be a curve in the plane, or a surface in 3D" },
  { [[sg.rigid.surface(sg.nurbs.line{ from = {0, 0, 0}, to = {1, 0, 0} })]],
    "a curve in the plane, or a surface in 3D" },
})
