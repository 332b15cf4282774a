-- An unconstrained body: damped motion to contact, its load, and sliding off where friction ends.

require "check"
local other_warnings = require "other_warnings"

local mu, press, width = 0.3, 0.1, 2

--- A block above a rigid plane, loaded from above.
local function falling(gap)
  return scenes.model{
    bodies = { block = { size = {width, 1}, corner = {0, gap}, elements = {4, 2}, contact = "south", E = 10 } },
    supports = {}, loads = { push = { on = "north", traction = {0, 0} } },
    contacts = {
      floor = { slave = "south", master = scenes.floor(), penalty = 100, friction = { mu = mu, penalty = 100 } } } }
end

check.case("plain Newton's tangent is singular; damping leads to the same equilibrium from any height", function()
  check.equal(falling(0.5):unconstrained_bodies(), { "block" })
  local run = falling(0.5):run({ { steps = 1, push = {0, -press} } }, sg.plain{})
  check.equal({ run.reason, run.places[1].body }, { "singular", "block" })
  local penetration
  for _, gap in ipairs { 1e-6, 1e-2, 0.5 } do
    for _, controls in ipairs { sg.plain{ damping = true }, sg.robust{} } do
      local model = falling(gap)
      run = model:run({ { steps = 2, push = {0, -press} } }, controls)
      check.equal({ run.reason, run.steps }, { "completed", 2 })
      check.near(run:column "floor.fy"[2], press * width, 1e-9)
      local deepest = run:column "floor.max_penetration"[2]
      penetration = penetration or deepest
      check.near(deepest, penetration, 1e-7)
    end
  end
end)

--- A ball of linear elastic material that just touches two plates, one of them driven.
check.case("damping as a fallback also holds a ball between plates", function()
  local half = sg.nurbs.ruled{ a = sg.nurbs.line{ from = {0, -1}, to = {0, 1} },
                               b = sg.nurbs.arc{ radius = 1, from = -90, to = 90 } }:swap(1, 2)
  local ball = scenes.body{ patch = half, elements = {4, 16}, thickness_degree = 2, contact = "east",
    material = sg.linear_elastic{ E = 1, nu = 0.3 } }
  local force
  for _, controls in ipairs { sg.plain{ damping = true }, sg.robust{}, sg.robust{ predictor = "constant" } } do
    local top = scenes.ceiling(1)
    local bottom = scenes.floor(-1)
    local model = scenes.model{ kind = "axisymmetric", bodies = { ball = ball },
      supports = { axis = { on = "west", fix = "x" }, press = { on = top, drive = "y" } },
      contacts = { above = { slave = "east", master = top, penalty = 500 },
        below = { slave = "east", master = bottom, penalty = 500 } } }
    local run = model:run({ { steps = 4, press = {-0.02} } }, controls)
    check.equal({ run.reason, run.steps }, { "completed", 4 })
    force = force or run:column "press.fy"[4]
    check.near(run:column "press.fy"[4] / force, 1, 1e-8)
    check.near(run:column "below.fy"[4], -run:column "press.fy"[4], 1e-9)
  end
end)

check.case("pushed sideways it stays as long as friction suffices, and the run reports what follows", function()
  local model, steps, most = falling(0.01), 8, 1.7 * mu * press
  local run = model:run({
    { name = "press", steps = 2, push = {0, -press} }, { name = "shove", steps = steps, push = {most, -press} },
  }, sg.robust{})
  check.equal(run.failed, true)
  -- No equilibrium carries more than mu times the load; the increments come as near as the shortest of them, 1/64 step.
  local reached, limit = model:target("push")[1], mu * press
  if reached > limit * (1 + 1e-9) or reached < limit - 2 * most / steps / 64 then
    error(("the body held up to %g of the limit"):format(reached / limit))
  end
  print(("held up to %.4f of the limit; %s"):format(reached / limit, run.reason))
  check.holds(run.failure, "friction of contact 'floor', which alone holds body 'block', is exhausted")
end)

--- A block on a rigid obstacle without friction, which alone holds it.
local function resting(obstacle, friction)
  local block = scenes.body{ size = {1, 0.5}, corner = {-0.5, 0}, elements = {8, 2}, contact = "south", E = 10 }
  return scenes.model{
    bodies = { block = block }, supports = {}, loads = { push = { on = "north", traction = {0, 0} } },
    contacts = { rest = { slave = "south", master = obstacle, penalty = 100, friction = friction } } }
end

check.case("a completed run tells whether contacts alone hold a body, and stably", function()
  local round = sg.rigid.cylinder{ center = {0, -0.4}, radius = 0.4 }
  local flat = scenes.floor()
  local cup = sg.rigid.cylinder{ center = {0, 2.96}, radius = 3, inside = true }
  local function warnings(obstacle, controls, friction)
    local model = resting(obstacle, friction)
    local run = check.completed(model:run({ { steps = 1, push = {0, -0.01} } }, controls))
    check.equal(model:reaction("push").fy, run:column "push.fy"[1]) -- the state is as it was
    return other_warnings(run)
  end
  local damped = sg.plain{ damping = true }
  -- On a cylinder any motion to the side lowers the load; in a cup it lifts it.
  local found = warnings(round, damped)
  check.equal(#found, 1)
  check.holds(found[1], "'block'", "is in unstable equilibrium", "Hint: add a support, or a weak spring")
  found = warnings(flat, damped)
  check.equal(#found, 1)
  check.holds(found[1], "nothing determines the position of 'block'", "but rounding errors", "Hint: add a support")
  check.equal(warnings(cup, damped), {})
  check.equal(warnings(flat, damped, { mu = 0.3, penalty = 100 }), {})
  found = warnings(flat, {})
  check.equal(#found, 1)
  check.holds(found[1], "damping alone determines the position in step 1")
end)

check.case("friction holds a block that has landed by damping", function()
  local block = scenes.body{ size = {10, 2}, corner = {-5, 0.05}, elements = {8, 2}, contact = "south", E = 210000 }
  local base = scenes.body{ size = {14, 2}, corner = {-7, -2}, elements = {10, 2}, contact = "north", E = 210000 }
  for _, friction in ipairs { { mu = 0.2, penalty = 2e6 }, false } do
    local model = scenes.model{ bodies = { block = block, base = base },
      supports = { bed = { on = "base.south", fix = "xy" }, push = { on = "block.north", drive = "y" } },
      contacts = { c = { slave = "block.south", master = "base.north", penalty = 2e6, friction = friction or nil } } }
    local text = table.concat(model:run{ { steps = 4, push = {-0.055} } }.warnings, " ")
    check.equal(text:find "position" ~= nil, not friction)
  end
end)

check.case("contact without friction holds a tool that has landed by damping", function()
  local block = scenes.body{ size = {2, 1}, corner = {-1, -1}, elements = {16, 4}, contact = "north" }
  local tool = sg.rigid.cylinder{ center = {0, 2.05}, radius = 2 }
  local function landed(obstacle, free)
    local model = scenes.model{ bodies = { block = block }, contacts = { c = { slave = "north", master = obstacle } },
      supports = { bed = { on = "south", fix = "xy" },
        grip = { on = obstacle, free = free, fix = free == "y" and "x" or nil } },
      loads = { weight = { on = obstacle, force = {0, 0} } } }
    local run = model:run{ { steps = 1, weight = {0, -0.01} } }
    check.equal({ run.reason, run.fallbacks.damping }, { "completed", 1 })
    check.near(model:contact_resultant("c").fy, -0.01, 1e-9)
    return table.concat(run.warnings, " "):find("damping alone", 1, true) ~= nil
  end
  check.equal(landed(tool, "y"), false)
  check.equal(landed(tool, "xy"), false)
  check.equal(landed(scenes.ceiling(), "xy"), true)
end)
