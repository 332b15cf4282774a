-- Ten problems on coarse meshes: functions that return the model and its path; the result that is asked for, and the
-- factors of the reference.

local remade = require "signorini.errors.remade"
local sg = require "signorini"

local scenes = {}

--- Adds a problem: its goal, the tolerances in % of it, and the factors of the reference on the given scene.
local function add(name, goal, tolerances, reference, make)
  scenes[#scenes + 1] = { name = name, goal = goal, tolerances = tolerances, reference = reference, make = make }
end

--- A scene with other elements, so that the first level is far from the tolerances.
local function coarse(factor, model, path) return remade.model(model, { elements = factor }), path end

local plane, solid = { 5, 2, 0.5 }, { 5, 2 }

add("ironing", "grip.fx", plane, { elements = 10, row = true, penalty = 100, steps = 12 }, function()
  return (sg.scenes.ironing{ order = "N2", mu = 0.3 }),
    { { name = "press", steps = 4, grip = { 0, -0.1 } }, { name = "slide", steps = 6, grip = { 0.2, -0.1 } } }
end)

add("line", "ground.max_pressure", plane, { elements = 36, row = true, penalty = 100, steps = 1 }, function()
  return coarse(1 / 3, sg.scenes.hertz{ order = "N2" })
end)

add("sphere", "ground.max_pressure", plane, { elements = 24, row = true, penalty = 100, steps = 1 }, function()
  return coarse(1 / 2, sg.scenes.hertz{ body = "ball", order = "N2" })
end)

-- A pin that is pressed by 2 % of its radius into a bore, which is wider by 1 %: half of both.
add("pin", "joint.max_pressure", plane, { elements = 20, row = true, penalty = 100, steps = 4 }, function()
  local function ring(inner, outer, elements, contact, E)
    return sg.body{ patch = sg.shapes.quarter_annulus{ inner = inner, outer = outer, start = 270 },
                    elements = elements, order = "N2", contact = contact, material = sg.neo_hookean{ E = E, nu = 0.3 } }
  end
  local pin, plate = ring(0.3, 1, { 6, 2 }, "south", 3), ring(1.01, 2, { 5, 2 }, "north", 1)
  return sg.model{
    bodies   = { pin = pin, plate = plate },
    supports = { symmetry = { on = { pin:face "west", plate:face "west" }, fix = "x" },
                 grip = { on = pin:face "east", fix = "x", drive = "y" },
                 bed = { on = plate:face "south", fix = "xy" } },
    contacts = { joint = { slave = pin:face "south", master = plate:face "north", penalty = 100 } } },
    { { name = "press", steps = 4, grip = -0.04 } }
end)

add("seal", "seal.max_pressure", plane, { elements = 12, row = true, penalty = 30, steps = 2 }, function()
  local function side(points)
    return sg.nurbs.curve{ degree = 2, points = points, knots = { 0, 0, 0, 1/3, 2/3, 1, 1, 1 } }
  end
  local inner = side{ {14, 0}, {11.2, 1}, {9.6, 4}, {9.9, 5.2}, {10.6, 5.6} }
  local outer = side{ {14, 2}, {12.2, 2.2}, {11.2, 4.4}, {10.9, 5.1}, {10.8, 5.5} }
  local lip = sg.body{ patch = sg.nurbs.ruled{ a = outer, b = inner }, elements = { 12, 2 }, order = "N2",
                       contact = "north", volumetric = "projected",
                       material = sg.mooney_rivlin{ c10 = 0.8, c01 = 0.2, K = 100 } }
  return sg.model{
    kind = "axisymmetric", bodies = { lip = lip }, supports = { root = { on = lip:face "west", fix = "xy" } },
    loads = { oil = { on = lip:face "south", pressure = 0, follower = true } },
    contacts = { seal = { slave = lip:face "north", penalty = 100, overlap = "interference",
                          master = sg.rigid.plane{ point = { 10, 0 }, normal = { 1, 0 } } } } },
    { { name = "fit", steps = 3 }, { name = "pressurize", steps = 3, oil = 0.3 } }
end)

add("rings", "grip.fy", plane, { elements = 12, row = true, penalty = 50, steps = 4 }, function()
  return coarse(1 / 2, sg.scenes.rings{ order = "N2" }, { { name = "press", steps = 5, grip = -1 } })
end)

add("peeling", "edge.moment", plane, { elements = 12, row = true, penalty = 1, steps = 1 }, function()
  return coarse(1 / 2, sg.scenes.peeling{ order = "N2", bonded = 20, angle = 20 })
end)

-- Two bonded beams that are opened by moments.
add("cohesive", "up.moment", plane, { elements = 6, row = true, penalty = 50, steps = 4 }, function()
  local function beam(y, contact)
    return sg.body{ patch = sg.shapes.rectangle{ width = 32, height = 2, corner = { 0, y } }, elements = { 16, 1 },
                    order = "N2", contact = contact, material = sg.neo_hookean{ E = 70000, nu = 0.3 } }
  end
  local upper, lower = beam(0, "south"), beam(-2, "north")
  return sg.model{
    bodies   = { upper = upper, lower = lower },
    supports = { up = { on = upper:face "west", rotate = true }, down = { on = lower:face "west", rotate = true },
                 wall = { on = { upper:face "east", lower:face "east" }, fix = "xy" } },
    contacts = { glue = { slave = upper:face "south", master = lower:face "north", penalty = 1e4,
                          cohesive = { strength = 20, energy = 0.3, where = function(X) return X[1] >= 8 end } } } },
    { { name = "open", steps = 20, up = { -1.2 }, down = { 1.2 } } }
end)

add("cylinder", "grip.fz", solid, { elements = 3, row = true, penalty = 30, steps = 1 }, function()
  local slab = sg.body{ patch = sg.shapes.block{ size = { 1.5, 0.5, 0.6 } }, elements = { 6, 2, 2 }, order = "N2",
                        contact = "back", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local die = sg.body{ patch = sg.shapes.half_cylinder_shell{ inner = 0.4, outer = 0.5, width = 0.3,
                                                              center = { 0.7, 0.2, 1.1 } },
                       elements = { 6, 1, 1 }, order = "N2", contact = "front",
                       material = sg.neo_hookean{ E = 100, nu = 0.3 } }
  return sg.model{
    bodies   = { die = die, slab = slab },
    supports = { bed  = { on = slab:face "front", fix = "xyz" },
                 mirror = { on = { slab:face "north", die:face "north" }, symmetry = true },
                 grip = { on = { die:face "west", die:face "east" }, drive = "xz", fix = "y" } },
    contacts = { interface = { slave = die:face "front", master = slab:face "back", penalty = 30 } } },
    { { name = "press", steps = 2, grip = { 0, -0.1 } }, { name = "slide", steps = 2, grip = { 0.1, -0.1 } } }
end)

add("block", "grip.fz", solid, { elements = 3, row = true, penalty = 10, steps = 1 }, function()
  return (sg.scenes.block{ order = "N2" }),
    { { name = "press", steps = 2, grip = { 0, -0.3 } }, { name = "slide", steps = 2, grip = { 0.5, -0.3 } } }
end)

return scenes
