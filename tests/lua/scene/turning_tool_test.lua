-- Rigid obstacles that turn: moments, energy, equivalences between shapes and dimensions, ways to solve and to save.

require "check"

local completed, last = check.completed, check.last

local soft = sg.neo_hookean{ E = 10, nu = 0.3 }

--- A slab of width 4 and height 1 below an obstacle, in 3D extruded to a depth of 0.5 in plane strain.
local function slab_under(tool, support, loads, contact, keys)
  keys = keys or {}
  local shape = sg.shapes.rectangle{ width = 4, height = 1 }
  local slab = sg.body{ patch = keys.solid and sg.nurbs.extrude{ patch = shape, along = {0, 0, 0.5} } or shape,
                        elements = keys.solid and {16, 2, 1} or {16, 2}, contact = "north",
                        order = keys.solid and {"N2", "N1"} or "N2", material = keys.material or soft }
  support.on = tool
  for _, load in pairs(loads or {}) do load.on = tool end
  local supports = { bed = { on = slab:face "south", fix = "xy" }, tool = support }
  if keys.solid then supports.sides = { on = { slab:face "front", slab:face "back" }, fix = "z" } end
  local parts = lists.merged({ slave = slab:face "north", master = tool, penalty = 200, points = 9 }, contact)
  return sg.model{ bodies = { slab = slab }, supports = supports, loads = loads, contacts = { press = parts } }
end

local rough = { friction = { mu = 0.5, penalty = 200 } }
local center = {1.5, 1.5}
local disc = sg.rigid.cylinder{ center = center, radius = 0.5 }

--- Columns of a disc of weight 0.4 that rolls by 0.2.
local function roll(tool, keys, depth)
  local rotate = keys and keys.solid and "z" or true
  local support = { free = "y", drive = "x", rotate = rotate, angle = "free", center = keys and keys.center }
  if keys and keys.solid then support.fix = "z" end
  local zero, weight = {0, 0}, {0, -0.4 * (depth or 1)}
  if keys and keys.solid then zero[3], weight[3] = 0, 0 end
  local model = slab_under(tool, support, { weight = { force = zero } }, rough, keys)
  local travel = keys and keys.travel or {0.2}
  local fine = keys and keys.fine or 1
  local run = completed(model:run({ { steps = 2 * fine, tool = {0}, weight = weight },
                                    { steps = 8 * fine, tool = travel, weight = weight } }, keys and keys.options))
  return { last(run, "tool.uy"), last(run, "tool.angle"), last(run, "tool.fx") / (depth or 1) }, model, run
end

check.case("an eccentric disc without friction: the moment of the contact force about its axis", function()
  local support = { fix = "x", free = "y", rotate = true, center = {1.4, 1.6} }
  local model = slab_under(disc, support, { weight = { force = {0, 0} } })
  local run = completed(model:run{ { steps = 3, tool = {0}, weight = {0, -0.5} },
                                   { steps = 9, tool = {90}, weight = {0, -0.5} } })
  -- All forces pass through the disc's center, which is at R(θ) (0.1, -0.1) from the axis.
  for step, angle in ipairs(run:column "tool.angle") do
    local theta, force = math.rad(angle), run:column "press.fy"[step]
    local sideways = run:column "press.fx"[step]
    local x, y = 0.1 * (math.cos(theta) + math.sin(theta)), 0.1 * (math.sin(theta) - math.cos(theta))
    check.within("moment", run:column "tool.moment"[step], x * force - y * sideways, 1e-9)
  end
end)

check.case("a curve, an extruded slab and a NURBS surface roll like the disc", function()
  local expected = roll(disc)
  assert(expected[2] < -20)
  local arc = sg.nurbs.arc{ center = center, radius = 0.5, from = 180, to = 360 }
  check.near(roll(sg.rigid.surface(arc), { center = center }), expected, 1e-7)
  local keys = { solid = true, center = {1.5, 1.5, 0} }
  check.near(roll(sg.rigid.cylinder{ center = {1.5, 1.5, 7}, axis = {0, 0, 1}, radius = 0.5 }, keys, 0.5), expected,
             1e-7)
  local surface = sg.rigid.surface(sg.nurbs.extrude{ patch = arc, along = {0, 0, 0.5} })
  check.near(roll(surface, keys, 0.5), expected, 1e-7)
end)

check.case("the energy of a rolling tool balances", function()
  local function imbalance(fine)
    local _, model = roll(disc, { fine = fine })
    local energy = model:energy()
    local kept = energy.stored + energy.contact + energy.friction
    return math.abs(energy.work + energy.area_growth - kept) / kept
  end
  local coarse, fine = imbalance(4), imbalance(16)
  check.at_most("imbalance", coarse, 4e-3)
  check.at_most("of smaller steps", fine, coarse / 4)
end)

check.case("a disc that touches nothing hangs on springs: displacements F/k, reactions and energy", function()
  local far = sg.rigid.cylinder{ center = {1.5, 5}, radius = 0.5 }
  local model = slab_under(far, { free = "xy", spring = {4, 2} }, { pull = { force = {1, -0.5} } })
  local run = completed(model:run{ { steps = 1, pull = {1, -0.5} } })
  check.near({ last(run, "tool.ux"), last(run, "tool.uy") }, { 0.25, -0.25 }, 1e-12)
  check.near({ last(run, "tool.fx"), last(run, "tool.fy") }, { -1, 0.5 }, 1e-12)
  check.within("energy", model:energy().stored, 0.5 * 4 * 0.25^2 + 0.5 * 2 * 0.25^2, 1e-12)
end)

check.case("linear bodies, other solvers and steps lead to the same state", function()
  local linear = sg.linear_elastic{ E = 10, nu = 0.3 }
  local expected = roll(disc, { material = linear })
  for _, options in ipairs{ { linear = "umfpack" }, { newton = { line_search = "residual" } },
                            { pseudo_transient = true } } do
    check.near(roll(disc, { material = linear, options = options }), expected, 1e-7)
  end
  -- Friction begins where the first guess of a step closes a point: other guesses, of another predictor or of a damped
  -- fall, lead to other angles, by the error of the step.
  check.near(roll(disc, { material = linear, options = { predictor = "tangent" } }), expected, 1e-4)
  check.near(roll(disc, { material = linear, options = { damping = true } }), expected, 0.1)
end)

check.case("snapshots and files hold the free motion", function()
  local expected, model = roll(disc)
  local file = check.file "model"
  local snapshot = model:snapshot()
  model:save(file)
  local stages = { { steps = 2, tool = {0.3}, weight = {0, -0.4} } }
  local run = completed(model:run(stages))
  local after = { last(run, "tool.uy"), last(run, "tool.angle"), last(run, "tool.fx") }
  assert(after[2] < expected[2])
  model:restore(snapshot)
  local again, loaded = completed(model:run(stages)), completed(sg.load(file):run(stages))
  for _, other in ipairs{ again, loaded } do
    check.near({ last(other, "tool.uy"), last(other, "tool.angle"), last(other, "tool.fx") }, after, 1e-12)
  end
  check.holds(tostring(model), "frees an obstacle: tool")
end)
