-- Hollow shapes, tori and level sets as obstacles: closed forms, the same shapes as NURBS, pictures, files, errors.

require "check"

local nu, E = 0.3, 1000
local elastic, soft = sg.linear_elastic{ E = E, nu = nu }, sg.neo_hookean{ E = 10, nu = nu }

-- ── Hollow shapes ────────────────────────────────────────────────────────────────────────────────────────────────────

--- A quarter of a ring or shell of radii 1 and 2, under an inner pressure of 0.1, in a rigid bore or socket; all points
--- have the same contact pressure.
local function expanded(kind, socket, expected)
  local model = scenes.model{ kind = kind,
    bodies = { ring = { patch = sg.shapes.quarter_annulus{ inner = 1, outer = 2, start = 0 }, elements = { 4, 8 },
        material = elastic } },
    supports = { cut = { on = "west", symmetry = true }, other_cut = { on = "east", symmetry = true } },
    loads = { gas = { on = "north", pressure = 0.1 } },
    contacts = { touch = { slave = "south", penalty = 1e6, master = socket } } }
  check.completed(model:run{ { steps = 1 } })
  for _, pressure in ipairs(model:profile "touch".pressure) do
    check.within("pressure", pressure / expected, 1, 3e-3)
  end
end

check.case("a ring in a bore and a shell in a socket: Lamé", function()
  -- s_r = A - B/r^2, E u = (1 + nu) ((1 - 2 nu) A r + B/r) = 0 at r = 2, s_r = -p at r = 1
  local bore = sg.rigid.cylinder{ center = {0, 0}, radius = 2, inside = true }
  expanded("plane_strain", bore, 0.1 * 2 * (1 - nu) / (1 + 4 * (1 - 2 * nu)))
  -- s_r = A - 2 B/r^3, E u = (1 - 2 nu) A r + (1 + nu) B/r^2
  local part = 2 * (1 - 2 * nu) / (1 + nu)
  local socket = sg.rigid.sphere{ center = {0, 0}, radius = 2, inside = true }
  expanded("axisymmetric", socket, 0.1 * (1 + part) / (1 + 8 * part))
end)

--- The forces on an obstacle that is pressed into a bed and dragged along; `scene`: more of sg.model.
local function forces(obstacle, contact, scene, corner)
  local b = scenes.body{ size = {3, 1}, corner = corner or {0, 0}, elements = {6, 2}, contact = "north",
    order = "N2-N2.1", material = soft }
  local joint = lists.merged({ slave = b:face "north", master = obstacle, points = 6 }, contact)
  local across = scene.kind == "axisymmetric"
  local model = scenes.model{ kind = scene.kind, bodies = { b = b }, contacts = { joint = joint },
    supports = { bed = { on = "south", fix = "xy" }, punch = { on = obstacle, drive = across and "y" or "xy" } } }
  local drag = across and { { steps = 2, punch = -0.1 }, { steps = 2, punch = -0.15 } } or
    { { steps = 2, punch = {0, -0.1} }, { steps = 3, punch = {0.3, -0.1} } }
  local run = check.completed(model:run(drag))
  local list = {}
  for _, name in ipairs{ "joint.fx", "joint.fy" } do table.move(run:column(name), 1, 9, #list + 1, list) end
  return list, model
end
local rubbing = { penalty = 100, friction = { mu = 0.3, penalty = 100 } }

check.case("a torus and a groove are the curves and surfaces that they are made of", function()
  local kind = { kind = "axisymmetric" }
  local torus = forces(sg.rigid.torus{ center = {3.3, 2}, radius = 1 }, rubbing, kind, { 2, 0 })
  local arc = sg.nurbs.arc{ center = {3.3, 2}, radius = 1, from = 180, to = 360 }
  assert(torus[#torus] < -0.1)
  check.near(torus, forces(sg.rigid.surface(arc), rubbing, kind, { 2, 0 }), 1e-6)
  local groove = forces(sg.rigid.torus{ center = {11.5, -3}, radius = 4.29, inside = true }, rubbing, kind, { 10, 0 })
  local hollow = sg.nurbs.arc{ center = {11.5, -3}, radius = 4.29, from = 10, to = 170 }:reverse(1)
  assert(groove[#groove] ~= 0)
  check.near(groove, forces(sg.rigid.surface(hollow), rubbing, kind, { 10, 0 }), 1e-6)
end)

--- The force on an obstacle that is pressed into a block of 2 × 2 × 1.
local function press(obstacle)
  local b = scenes.body{ size = {2, 2, 1}, corner = {1, -1, 0}, elements = {4, 4, 1}, order = { "N2", "N2" },
    contact = "back", material = soft }
  local model = scenes.model{ bodies = { b = b },
    contacts = { joint = { slave = "back", master = obstacle, points = 4, penalty = 100,
                           friction = rubbing.friction } },
    supports = { bed = { on = "front", fix = "xyz" }, tool = { on = obstacle, drive = "xyz" } } }
  check.completed(model:run{ { steps = 1, tool = {0, 0, -0.1} }, { steps = 2, tool = {0.1, 0.05, -0.1} } })
  local found = model:contact_resultant "joint"
  assert(found.fz < -0.1 and found.fx > 0.01)
  return { found.fx, found.fy, found.fz }
end

check.case("in 3D a torus, a ball and their level sets have the same forces", function()
  local tube = sg.nurbs.arc{ center = {2, 1.5}, radius = 0.5, from = 180, to = 360 }
  local torus = press(sg.rigid.torus{ center = {0, 0, 1.5}, axis = {0, 0, 1}, ring = 2, radius = 0.5 })
  local f = function(x, y, z) return (sg.sqrt(x^2 + y^2) - 2)^2 + (z - 1.5)^2 - 0.25 end
  local level = sg.rigid.level_set{ f = f, box = { {0.9, -1.3, 0.9}, {2.7, 1.3, 2.1} } }
  check.near(press(level), torus, 1e-8)
  local sphere = press(sg.rigid.sphere{ center = {2, 0, 2}, radius = 1 })
  local ball = sg.rigid.level_set{ f = function(x, y, z) return (x - 2)^2 + y^2 + (z - 2)^2 - 1 end,
                                   box = { {0.9, -1.1, 0.9}, {3.1, 1.1, 3.1} } }
  check.near(press(ball), sphere, 1e-8)
  assert(tube)
end)

-- ── Level sets ───────────────────────────────────────────────────────────────────────────────────────────────────────

local function disc_formula(x, y) return (x - 1.3)^2 + (y - 2)^2 - 1 end
local disc_box = { {0.2, 0.9}, {2.4, 3.1} }

check.case("a disc as a level set, with all kinds of contact", function()
  local disc = sg.rigid.cylinder{ center = {1.3, 2}, radius = 1 }
  local level = sg.rigid.level_set{ f = disc_formula, box = disc_box }
  for _, contact in ipairs{ rubbing, { penalty = 100, friction = rubbing.friction, method = "mortar" },
                            { friction = { mu = 0.3 }, method = "mortar", enforcement = "multipliers" },
                            { adhesion = { hamaker = 0.05, r0 = 0.1 } } } do
    local expected = forces(disc, contact, {})
    assert(math.abs(expected[#expected]) > 1e-3)
    check.near(forces(level, contact, {}), expected, 1e-8)
  end
end)

check.case("a superellipse: print, pictures, checkpoints, parts of a level set", function()
  local f = function(x, y) return ((x - 1.5) / 0.8)^4 + ((y - 1.5) / 0.5)^4 - 1 end
  local tool = sg.rigid.level_set{ f = f, box = { {0.5, 0.8}, {2.5, 2.2} } }
  check.equal(tostring(tool):match "^rigid level set of f%(x, y%) = ", "rigid level set of f(x, y) = ")
  local list, model = forces(tool, rubbing, {})
  local folder = check.folder()
  sg.picture{ model = model, file = folder .. "/tool.png" }
  model:save(folder .. "/state.sgn")
  local again = sg.load(folder .. "/state.sgn")
  check.equal(again:contact_resultant("joint").fy, model:contact_resultant("joint").fy)
  local run = again:run{ { steps = 1, punch = {0.4, -0.1} } }
  local direct = model:run{ { steps = 1, punch = {0.4, -0.1} } }
  check.equal(run:column "joint.fx", direct:column "joint.fx")
  assert(list[#list] < 0)
  -- Two discs in one formula: each touches.
  local two = sg.rigid.level_set{ box = { {-1, 0.9}, {4, 3} }, f = function(x, y)
    return ((x - 0.5)^2 + (y - 1.8)^2 - 0.64) * ((x - 2.5)^2 + (y - 1.8)^2 - 0.64)
  end }
  local _, pair = forces(two, { penalty = 100 }, {})
  local profile, touched = pair:profile "joint", { 0, 0 }
  for i, pressure in ipairs(profile.pressure) do
    local side = profile.x[i] < 1.5 and 1 or 2
    touched[side] = math.max(touched[side], pressure)
  end
  assert(touched[1] > 0.1 and touched[2] > 0.1)
end)

check.case("a study solves again if the formula of a level set in it has changed", function()
  local folder = check.folder()
  for _, radius in ipairs{ 1, 0.9 } do
    local tool = sg.rigid.level_set{ box = disc_box, f = function(x, y)
      return (x - 1.3)^2 + (y - 2)^2 - radius^2
    end }
    local study = sg.study{ name = "tools", folder = folder, cases = sg.grid{ n = { 2 } },
                            run = function() return { text = tostring(tool) } end }
    study:execute{ jobs = 1 }
    check.equal(study:column("text")[1], tostring(tool))
  end
end)

--- A call that fails with a message that contains a text.
local function wrong(text, f, ...)
  local given = { ... }
  check.fails(function() f(table.unpack(given)) end, text)
end

check.case("wrong shapes are errors with cures", function()
  local set = sg.rigid.level_set
  local function of(f, ...) return { set, { f = f, box = disc_box, ... } } end
  wrong("f must take 2 arguments, x, y, but takes 3", table.unpack(of(function(x, y, z) return x + y + z end)))
  wrong("must return a formula of its arguments, got the number 1", table.unpack(of(function(_, _) return 1 end)))
  wrong("the result of f is missing", table.unpack(of(function(_, _) end)))
  wrong("use sg.sqrt", table.unpack(of(function(x, _) return math.sqrt(x) end)))
  wrong("a symbol has no value", table.unpack(of(function(x, y) return x > y and x or y end)))
  wrong("f must change its sign", table.unpack(of(function(x, _) return x^2 + 1 end)))
  wrong("multiply by the denominator", table.unpack(of(function(x, _) return 1 / (x - 1.3001) end)))
  wrong("gradient", table.unpack(of(function(x, _) return (x - 1.3001)^3 end)))
  wrong("f must be a finite number", table.unpack(of(function(x, _) return sg.log(x - 1) end)))
  wrong("first corner below the second", set, { f = disc_formula, box = { {1, 1}, {0, 2} } })
  wrong("two corners of equal dimension", set, { f = disc_formula, box = { {1, 1}, {0, 2, 3} } })
  wrong("box must be a list of 2", set, { f = disc_formula, box = { {1, 1} } })
  wrong("ring must be greater than radius", sg.rigid.torus,
    { center = {0, 0, 0}, axis = {0, 0, 1}, ring = 1, radius = 2 })
  wrong("omit ring", sg.rigid.torus, { center = {3, 0}, ring = 1, radius = 2 })
  wrong("axis must not be zero", sg.rigid.torus, { center = {0, 0, 0}, axis = {0, 0, 0}, ring = 3, radius = 2 })
  wrong("patch:face \"back\"", sg.rigid.surface, sg.shapes.block{ size = {1, 1, 1} })
  wrong("patch:face \"north\"", sg.rigid.surface, sg.shapes.rectangle{ width = 1, height = 1 })
  wrong("one obstacle per patch", sg.rigid.surface, { sg.nurbs.line{ from = {0, 0}, to = {1, 0} } })
  wrong("use sg.rigid.torus", forces, sg.rigid.sphere{ center = {3, 2}, radius = 1 }, rubbing,
    { kind = "axisymmetric" }, { 2, 0 })
  wrong("must not reach the axis", forces, sg.rigid.torus{ center = {1, 2}, radius = 1 }, rubbing,
    { kind = "axisymmetric" }, { 2, 0 })
  wrong("torus in a plane model", forces, sg.rigid.torus{ center = {1, 2}, radius = 1 }, rubbing, {})
  wrong("sg.rigid.plane with normal {1, 0}", forces, sg.rigid.cylinder{ center = {1, 2}, radius = 1 }, rubbing,
    { kind = "axisymmetric" }, { 2, 0 })
  wrong("change the sign of f", forces,
    sg.rigid.level_set{ f = function(x, y) return -disc_formula(x, y) end, box = disc_box }, rubbing, {})
  wrong("inside = true", forces, sg.rigid.cylinder{ center = {1.5, 0}, radius = 5 }, rubbing, {})
end)
