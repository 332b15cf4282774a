-- Queries of bodies and models; and the most frequent invalid inputs.

require "check"

local soft = sg.neo_hookean{ E = 1, nu = 0.3 }

--- A block above another, 0.1 apart.
local function two_blocks(friction)
  local low = scenes.body{ size = {2, 1}, elements = {4, 2}, contact = "north", material = soft }
  local high = scenes.body{ corner = {0.5, 1.1}, elements = {3, 2}, order = "N2-N2.1", contact = "south",
    material = soft }
  return scenes.model{ bodies = { low = low, high = high },
    supports = { bed = { on = "low.south", fix = "xy" }, lid = { on = "high.north", drive = "xy" } },
    contacts = {
      joint = { slave = "high.south", master = "low.north", penalty = 50, friction = friction } } }, low, high
end

check.case("bodies report their degrees of freedom, faces and corners", function()
  local _, low, high = two_blocks()
  local dofs = high:dofs()
  -- N2.1 on 3 elements: 4 + 2·2 functions on the face; N2: 5 in each of the three other rows
  check.equal({ dofs.interface, dofs.bulk, dofs.total }, { 16, 30, 46 })
  check.holds(low:face "west", "face 'west' of a body, 4 control points")
  check.holds(low:corner "south-west", "corner 'south-west' of a body, 1 control point")
  check.holds(low, "4 x 2 elements, degree 2 x 2, 48 degrees of freedom")
  check.equal(scenes.body{ order = "N3", material = soft }:dofs().total, 2 * 5 * 5)
end)

check.case("reactions, contact resultant, profile, energy and samples of a pressed pair agree", function()
  local model, low = two_blocks()
  check.completed(model:run{ { name = "press", steps = 4, lid = {0, -0.2} } })
  local lid, bed, joint = model:reaction "lid", model:reaction "bed", model:contact_resultant "joint"
  check.near(lid, { -bed[1], -bed[2] }, 1e-9)
  check.near({ joint.fx, joint.fy }, { -lid[1], -lid[2] }, 1e-9)
  local profile, pressed = model:profile "joint", 0
  for i, pressure in ipairs(profile.pressure) do
    pressed = math.max(pressed, pressure)
    check.equal(pressure > 0, profile.state[i] ~= "open")
    check.near(pressure, math.max(0, -50 * profile.gap[i]), 1e-12)
  end
  check.equal(pressed, joint.max_pressure)
  check.near(model:sample("low", "uy", {0.5, 0}), 0)
  check.near(model:sample(low, "F11", {0.5, 0}), 1)
  -- The work of the lid's force over 0.1 is at least half stored, and none is won.
  local stored = model:energy().stored
  assert(stored > 0 and stored < 0.1 * -lid[2])
  check.near(model:target "lid", { 0, -0.2 })
end)

check.case("a failed step leaves the accepted state", function()
  local model = two_blocks{ mu = 0.3, penalty = 50 }
  model:run{ { name = "press", steps = 4, lid = {0, -0.2} } }
  local before = model:reaction "lid"
  local run = model:run({ { name = "crush", steps = 1, lid = {0, -1.9} } }, sg.plain{})
  check.equal(run.failed, true)
  check.holds(run.failure, "crush")
  check.near(model:reaction "lid", before, 1e-10)
  check.near(model:target "lid", { 0, -0.2 })
end)

check.case("a face that turns may say that its translation is free", function()
  local function turned(free)
    local strip = scenes.body{ size = {3, 1}, elements = {3, 2}, material = sg.linear_elastic{ E = 1, nu = 0.3 } }
    local model = scenes.model{ bodies = { strip = strip }, supports = {
      wall = { on = "west", fix = "xy" }, edge = { on = "east", rotate = true, free = free } } }
    model:run{ { steps = 1, edge = 5 } }
    return model:reaction "edge"
  end
  check.equal(turned "xy", turned(nil))
  check.near({ turned "xy"[1], turned "xy"[2] }, { 0, 0 }, 1e-12)
end)

-- Each ends with status 1 and a message that names the script's line, the argument, the value and the hint.
check.refusals([[
local b = sg.body{ patch = r:translate{0, 1}, elements = {4, 2}, order = "N2", contact = "south", material = soft }
]], 2, {
  { [[sg.neo_hookean{ E = 5, nu = 0.5 }]], "nu must be a number above -1 and below 0.5", "got the number 0.5",
    "use 0.49" },
  { [[sg.body{ patch = r, elements = {4, 2}, order = "Q2", contact = "north", material = soft }]],
    "sg.body: order must be a discretization label, got 'Q2'", "Np (N2)" },
  { [[sg.body{ patch = sg.shapes.half_annulus{ inner = 1, outer = 2,
      center = {0, 0} }, elements = {4, 2}, order = "N2", contact = "west", thickness_degree = 1, material = soft }]],
    "sg.body: thickness_degree must be at least the geometry's own degree, 2, got 1" },
  { [[sg.body{ patch = r, elements = {4, 2}, order = "N2", contact = "top", material = soft }]],
    "did you mean 'north'?", "sg.body: contact must be", "'north'", "got the string 'top'" },
  { [[sg.model{ bodies = { a = a, b = b },
      contacts = { i = { slave = a:face "north", master = a:face "north", penalty = 100 } } }]],
    "sg.model: contacts.i.master is the same face as contacts.i.slave", "write among" },
  { [[sg.model{ bodies = { a = a, b = b },
      supports = { bed = { on = a:face "south", fix = "xy" }, push = { on = a:face "south", drive = "y" } } }]],
    "sg.model: supports.push drives y of a control point that supports.bed fixes already",
    "remove it from one of the two" },
  { [[sg.model{ bodies = { a = a },
      supports = { bed = { on = a:face "south", fix = "xy", drive = "y" } } }]],
    "supports.bed: it both fixes and drives y", "either fixed or driven" },
  { [[sg.model{ bodies = { a = a },
      supports = { bed = { on = a:face "south", drive = "xy", free = "y" } } }]],
    "supports.bed: it frees y, which it also drives", "free is for components that are in neither fix nor drive" },
  { [[sg.model{ bodies = { a = a },
      supports = { bed = { on = a:face "south", fix = "x", free = "xy" } } }]],
    "supports.bed: it frees x, which it also fixes" },
  { [[sg.model{ bodies = { a = a }, supports = { s = { on = a:face "south", free = "xy" } } }]],
    "supports.s: it must constrain at least one component" },
  { [[sg.model{ bodies = { a = a }, supports = { s = { on = 3, fix = "x" } } }]],
    "supports.s.on must be a face or a list of faces, an edge, a corner or an obstacle", "got the number 3" },
  { [[sg.model{ bodies = { a = a, b = b }, contacts = { i = { penalty = 100,
      slave = a:face "north", master = b:face "north", where = function() return nil end } } }]],
    "contacts.i.where must return true or false, got nothing" },
  { [[sg.body{ patch = r, elements = {4, 2}, order = "N02", contact = "north", material = soft }]],
    "order must be a discretization label, got 'N02'" },
  { [[sg.body{ patch = r, elements = {20000, 20000}, order = "N2", contact = "north", material = soft }]],
    "sg.body: elements = {20000, 20000} make at least 800080002 unknowns, more than the maximum of 20000000" },
  { [[sg.body{ patch = r, elements = {4, 2}, order = "N2-N4", material = soft }]],
    "'N2-N4' has a layer, but the body has no contact face", [[contact = "south"]] },
  { [[sg.body{ patch = r, elements = {4, 2}, order = "N2-N2.2x9", contact = "north", material = soft }]],
    "order 'N2-N2.2x9' has a layer of 9 rows, but the body has only 4 rows of control points" },
  { [[sg.body{ elements = {1, 1}, order = "N1", contact = "north", material = soft,
      patch = sg.nurbs.surface{ degrees = {1, 1}, knots = { {0, 0, 1, 1}, {0, 0, 1, 1} },
                                points = { {1, 0}, {0, 0}, {1, 1}, {0, 1} } } }]], "not right-handed",
    "reverse one parametric direction" },
  { [[sg.model{ bodies = { a = a }, supports = { s = { on = b:face "south", fix = "x" } } }]],
    "is on a body that is not in bodies: add the body" },
  { [[sg.model{ bodies = { a = a }, supports = { s = { on = a:face "south" } } }]],
    "supports.s: it must constrain at least one component",
    [[add fix = "xy", drive = "xy", rotate = true or symmetry = true]] },
  { [[sg.picture{ model = sg.model{ bodies = { a = a } }, file = "a.png", field = "uu" }]], "sg.picture",
    "unknown field 'uu'", "known: ux, uy" },
})
