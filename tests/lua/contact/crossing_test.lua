-- Increments in which points pass through the master of a contact fail and are cut; equilibria behind it are not
-- accepted.

require "check"

--- A cantilever with a load at its tip, and a stop 0.5 below it near the tip. Without the stop the tip sinks by 12,
--- farther than the stop and the beam are thick.
local L, h, E, gap, P, a = 100, 4, 210000, 0.5, 40, 99
local function cantilever()
  local stop = sg.rigid.cylinder{ center = { a, -1 - gap }, radius = 1 }
  return scenes.model{ bodies = { beam = { size = {L, h}, elements = { 20, 2 }, contact = "south", E = E, nu = 0 } },
    supports = { wall = { on = "west", fix = "xy" } }, loads = { tip = { on = "east", traction = { 0, 0 } } },
    contacts = { c = { slave = "south", master = stop, penalty = 1e4 } } }
end
local load = { name = "load", steps = 4, tip = { 0, -P / h } }
--- Force of the stop by beam theory: P a² (3L − a)/6 − R a³/3 = E I gap.
local exact = (P * a ^ 2 * (3 * L - a) / 6 - E * h ^ 3 / 12 * gap) * 3 / a ^ 3

check.case("a beam that a stop holds: the increment in which it passes through the stop is cut", function()
  local model = cantilever()
  local run = model:run({ load }, { newton = { line_search = "none" } })
  check.equal({ run.reason, run.cutbacks > 0, run:attempts(1)[1].reason }, { "completed", true, "crossed" })
  check.near(model:contact_resultant "c".fy, exact, 5e-3 * exact)
  check.equal(model:contact_resultant "c".crossed, 0)
  check.equal(table.concat(run.warnings):find("passed through", 1, true), nil)
end)

check.case("without cutting the run fails, with the reason and the places", function()
  local model = cantilever()
  local run = model:run({ load }, sg.plain{})
  check.equal({ run.failed, run.reason, run.cause, run.steps }, { true, "crossed", "crossed", 0 })
  check.holds(run.failure, "points of the slave face of contact 'c' passed through the master without contact",
    "points of contact 'c', the first in slave element", "behind the master", "Hint: take smaller steps")
  local place = run.places[1]
  check.equal({ place.kind, place.contact, place.element }, { "contact point", "c", 20 })
  check.equal(place.value > gap, true)
  check.equal(model:contact_resultant "c".crossed, 0) -- rolled back
  run = cantilever():run({ load }, sg.plain{ step = { adaptive = true, min = 1 } })
  check.equal({ run.reason, run.cause }, { "minimum_step", "crossed" })
end)

check.case("a user's own loop does not accept such a state", function()
  local model = cantilever()
  model:set_target("tip", { 0, -P / h / 4 })
  local result = model:solve_step {}
  check.equal({ result.converged, result.reason }, { false, "crossed" })
  check.equal(model:contact_resultant "c".crossed > 0, true)
  check.near(model:contact_resultant "c".crossed_at[2], 0, 1e-12)
  check.fails(function() model:accept() end, "the step has failed (crossed), so its state cannot be accepted")
  model:rollback()
  check.equal(model:contact_resultant "c".crossed, 0)
  repeat result = model:iterate {} until result.reason ~= "iterating"
  check.equal(result.reason, "converged") -- of no change
  model:accept()
  -- The same by moves
  model:set_target("tip", { 0, -P / h / 4 })
  local zeros = {}
  for i = 1, #model:residual() do zeros[i] = 0 end
  model:move(zeros)
  model:set_contact("c", { active = false })
  check.equal(model:solve_step {}.converged, true)
  local far = model:displacements()
  model:rollback()
  model:set_target("tip", { 0, -P / h / 4 })
  model:move(far)
  check.fails(function() model:accept() end, "crossed")
end)

check.case("arc-length increments fail likewise", function()
  local model = cantilever()
  check.equal(model:run({ { steps = 1, tip = { 0, -0.01 } } }).reason, "completed") -- a direction, still above the stop
  model:set_target("tip", { 0, -P / h })
  local result = model:solve_arc { length = 300 * model:last_length() }
  check.equal({ result.converged, result.reason }, { false, "crossed" })
  model:rollback()
end)

check.case("a strip bent by a pin: the same force with every predictor, penalty and number of steps", function()
  local function bend(steps, options, penalty)
    local strip = scenes.body{ size = {20, 1}, elements = { 40, 2 }, contact = "north", E = 100 }
    local pin = sg.rigid.cylinder{ center = { 12, 3 }, radius = 2 }
    local model = scenes.model{ bodies = { strip = strip },
      supports = { grip = { on = "west", fix = "xy" }, pin = { on = pin, drive = "y" } },
      contacts = { c = { slave = "north", master = pin, penalty = penalty or 500 } } }
    check.completed(model:run({ { name = "bend", steps = steps, pin = { -7 } } }, options))
    return -model:reaction "pin".fy
  end
  local force = bend(80)
  for _, case in ipairs { { 20 }, { 20, { predictor = "linear" } }, { 20, { predictor = "tangent" } }, { 10 } } do
    check.near(bend(table.unpack(case)), force, 1e-6 * force)
  end
  check.near(bend(20, {}, 5000), bend(80, {}, 5000), 1e-6 * force)
end)

check.case("sliding off an end of the master is not crossing", function()
  local function slide(drop)
    local block = scenes.body{ corner = { 0, 1 }, elements = { 4, 4 }, contact = "south", E = 100 }
    local shelf = scenes.body{ size = {2, 1}, corner = { -1, 0 }, elements = { 8, 4 }, contact = "north", E = 100 }
    local model = scenes.model{ bodies = { block = block, shelf = shelf },
      supports = { bed = { on = "shelf.south", fix = "xy" }, grip = { on = "block.north", drive = "xy" } },
      contacts = { c = { slave = "block.south", master = "shelf.north", penalty = 1000 } } }
    return model:run { { steps = 1, grip = { 0, -0.02 } }, { steps = 4, grip = { 1.6, -0.02 } },
                       { steps = 1, grip = { 1.6, drop } }, { steps = 1, grip = { 5, drop } } }
  end
  for _, drop in ipairs { -0.5, -3.5 } do -- next to the shelf and below it
    local run = slide(drop)
    check.equal({ run.reason, run.cutbacks }, { "completed", 0 })
  end
end)
