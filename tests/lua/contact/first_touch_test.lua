-- First touch: friction acts from where a point closes in its step, with every formulation.

require "check"
local rows = require "formulations.rows"

-- ── A block that sticks where it lands ───────────────────────────────────────────────────────────────────────────────

local function block_2d(at) return scenes.body{ corner = at, contact = "south", E = 10 } end

local function slab_2d()
  return scenes.body{ size = {3, 1}, corner = {-1, -1}, elements = {6, 2}, contact = "north", E = 10 }
end

local function block_3d(at)
  return scenes.body{ size = {1, 1, 1}, corner = at, elements = {2, 2, 1}, contact = "front", E = 10 }
end

local function slab_3d()
  return scenes.body{ size = {3, 3, 1}, corner = {-1, -1, -1}, elements = {3, 3, 1}, contact = "back", E = 10 }
end

local cases = {
  plane = { down = "south", up = "north", at = {0, 0.1}, block = block_2d, drive = "xy", goal = { 0.02, -0.2 },
            normal = {0, 1} },
  slab = { down = "south", up = "north", at = {0, 0.1}, block = block_2d, slab = slab_2d, drive = "xy",
           goal = { 0.02, -0.2 } },
  plane_3d = { down = "front", up = "back", at = {0, 0, 0.1}, block = block_3d, drive = "xyz",
               goal = { 0.02, 0.01, -0.2 }, normal = {0, 0, 1} },
  slab_3d = { down = "front", up = "back", at = {0, 0, 0.1}, block = block_3d, slab = slab_3d, drive = "xyz",
              goal = { 0.02, 0.01, -0.2 } },
}

local function landing(kind, formulation)
  local block = kind.block(kind.at)
  local bodies, supports = { block = block }, { grip = { on = block:face(kind.up), drive = kind.drive } }
  local master
  if kind.slab then
    bodies.slab = kind.slab()
    master = bodies.slab:face(kind.up)
    supports.bed = { on = bodies.slab:face(kind.down), fix = kind.drive }
  else
    master = sg.rigid.plane{ point = kind.normal[3] and {0, 0, 0} or {0, 0}, normal = kind.normal }
  end
  return sg.model{ bodies = bodies, supports = supports,
    contacts = { touch = rows.contact(rows[formulation], { slave = block:face(kind.down), master = master,
      penalty = 100, friction = { mu = 1, penalty = 100 } }) } }
end

--- The tangential force on the grip of a block that is lowered by 0.2 onto a master 0.1 below it, where it sticks, and
--- moves sideways all the while: half of that in the air. `fractions`: of the path, at the ends of the steps.
local function landed(kind, formulation, fractions)
  local stages = {}
  for i, fraction in ipairs(fractions) do
    local goal = {}
    for k, value in ipairs(kind.goal) do goal[k] = fraction * value end
    stages[i] = { steps = 1, grip = goal }
  end
  local options = { newton = { tolerance = 1e-13 } }
  local run = check.completed(landing(kind, formulation):run(stages, options))
  return run:column "grip.fx"[run.rows]
end

--- n equal steps; with `touch` the middle one, in which the gap closes, is divided there.
local function equal_steps(n, touch)
  local fractions = {}
  for i = 1, n do
    if touch and 2 * i == n + 1 then fractions[#fractions + 1] = 0.5 end
    fractions[#fractions + 1] = i / n
  end
  return fractions
end

for _, name in ipairs{ "plane", "slab", "plane_3d", "slab_3d" } do
  local kind = cases[name]
  local space = kind.drive == "xyz"
  for _, formulation in ipairs(rows.choices) do
    local fits = (kind.slab or not rows[formulation].two_faces) and
      (not space or formulation == "gpts" or formulation == "equal" or formulation == "equal-multipliers")
    if fits then
      check.case(("%s, %s: friction as if the step ended where the block touches"):format(name, formulation), function()
        for _, steps in ipairs(space and { 1 } or { 1, 3, 9 }) do
          local right = landed(kind, formulation, equal_steps(steps, true))
          check.within(steps .. " steps", landed(kind, formulation, equal_steps(steps)) / right, 1, 1e-10)
        end
      end)
    end
  end
end

check.case("Gauss points and a plane: friction does not depend on the number of steps", function()
  local limit = landed(cases.plane, "gpts", { 0.5, 1 })
  for _, steps in ipairs { 1, 3, 5, 9, 33 } do
    check.within(steps .. " steps", landed(cases.plane, "gpts", equal_steps(steps)) / limit, 1, 1e-10)
  end
end)

check.case("a block that moves back to where it touched has no friction, whatever the steps", function()
  for _, formulation in ipairs{ "gpts", "equal", "equal-multipliers" } do
    for _, steps in ipairs{ 1, 3 } do
      local run = landing(cases.plane, formulation):run{ { name = "land", steps = steps, grip = { 0.02, -0.2 } },
                                                          { name = "return", steps = 2, grip = { 0.01, -0.2 } } }
      local fx = run:column "grip.fx"
      check.within(("%s, %d steps"):format(formulation, steps), fx[run.rows] / fx[steps], 0, 1e-8)
    end
  end
end)

-- ── A tool that turns as it is pressed in ────────────────────────────────────────────────────────────────────────────

--- The model of a rigid cylinder above a slab, both turned by an angle (degrees), mirrored for side = -1. The cylinder
--- is above the slab's middle, where two multipliers touch almost at once, or `off` to the right of it.
local function indented(formulation, side, angle, off)
  local c, s = math.cos(math.rad(angle or 0)), math.sin(math.rad(angle or 0))
  local function turned(x, y) return { c * side * x - s * y, s * side * x + c * y } end
  local patch = sg.shapes.rectangle{ width = 3, height = 1, corner = {-1.5, -1} }
  local slab = scenes.body{ patch = patch:rotate{ angle = angle or 0, center = {0, 0} }, elements = {30, 3},
    contact = "north", E = 10 }
  local tool = sg.rigid.cylinder{ center = turned(off or 0, 1.02), radius = 1 }
  local model = scenes.model{ bodies = { slab = slab },
    supports = { bed = { on = "south", fix = "xy" }, tool = { on = tool, drive = "xy" } },
    contacts = { touch = rows.contact(rows[formulation], { slave = "north", master = tool, penalty = 300,
                                                           friction = { mu = 2, penalty = 300 } }) } }
  return model, function(t) return turned(0.02 * t * t, -0.12 * t) end, turned
end

--- Its tangential force at the end; `straight`: of a path without a turn, with the given options.
local function dragged(formulation, steps, case)
  local model, path, turned = indented(formulation, case.side or 1, case.angle, case.off)
  local run = model:run({ { name = "press", steps = steps, tool = case.straight and path(1) or path } }, case.options)
  check.equal(run.failed, false)
  local force, along = model:reaction "tool", turned(1, 0)
  return force.fx * along[1] + force.fy * along[2]
end

local off = { off = 0.025 }

check.case("a load that turns: friction has an error of second order in the step", function()
  for _, formulation in ipairs{ "gpts", "equal", "reduced", "equal-multipliers", "reduced-multipliers" } do
    local limit = (4 * dragged(formulation, 128, off) - dragged(formulation, 64, off)) / 3
    local coarse = math.abs(dragged(formulation, 2, off) / limit - 1)
    local fine = math.abs(dragged(formulation, 32, off) / limit - 1)
    -- Points of a multiplier that touch after one another share its slip.
    local order = formulation:find "multipliers" and 1.1 or 1.8
    check.at_most(("%s: order %g over four halvings: error in 32 steps over that in 2"):format(formulation, order),
      fine / coarse, 2 ^ (-4 * order))
  end
end)

--- The force along chords of the path, as many as steps, each followed in many steps.
local function along_chords(formulation, chords)
  local model, path = indented(formulation, 1, 0, off.off)
  local stages = {}
  for i = 1, chords do stages[i] = { steps = 64 // chords, tool = path(i / chords) } end
  model:run(stages, sg.plain{})
  return model:reaction "tool".fx
end

check.case("most of the error of long steps is that a step follows the chord of the path", function()
  for _, formulation in ipairs{ "gpts", "equal" } do
    local limit = dragged(formulation, 64, off)
    for _, steps in ipairs{ 1, 2, 4 } do
      local force = dragged(formulation, steps, off)
      check.at_most(("%s, %d steps: the rest"):format(formulation, steps), force - along_chords(formulation, steps),
        0.5 * math.abs(force - limit))
    end
  end
end)

check.case("mirrored and turned scenes have the same friction", function()
  for _, formulation in ipairs{ "gpts", "equal", "equal-multipliers" } do
    local fx = dragged(formulation, 3, {})
    check.within_share(formulation .. ", mirrored", dragged(formulation, 3, { side = -1 }), fx, 1e-9)
    check.within_share(formulation .. ", turned", dragged(formulation, 3, { angle = 30 }), fx, 1e-9)
  end
end)

--- The force along x of a rigid sphere that is pressed into a slab and turns as the cylinder does.
local function dragged_in_space(formulation, steps)
  local slab = scenes.body{ size = {2, 2, 1}, corner = {-1, -1, -1}, elements = {7, 7, 1}, contact = "back", E = 10 }
  local tool = sg.rigid.sphere{ center = {0.03, 0.02, 1.02}, radius = 1 }
  local model = scenes.model{ bodies = { slab = slab },
    supports = { bed = { on = "front", fix = "xyz" }, tool = { on = tool, drive = "xyz" } },
    contacts = { touch = rows.contact(rows[formulation], { slave = "back", master = tool, penalty = 100,
                                                           friction = { mu = 2, penalty = 100 } }) } }
  model:run{ { steps = steps, tool = function(t) return { 0.02 * t * t, 0.01 * t * t, -0.12 * t } end } }
  return model:reaction "tool".fx
end

check.case("and in space", function()
  for _, formulation in ipairs{ "gpts", "equal" } do
    local limit = (4 * dragged_in_space(formulation, 32) - dragged_in_space(formulation, 16)) / 3
    check.at_most(formulation .. ": order 1.6 over two halvings", (dragged_in_space(formulation, 8) / limit - 1) /
      (dragged_in_space(formulation, 2) / limit - 1), 2 ^ (-2 * 1.6))
  end
end)

check.case("a step in which contact begins is not extrapolated: touches as with the tangent predictor", function()
  for _, steps in ipairs{ 30, 31, 36 } do
    local function force(options)
      return dragged("equal", steps, { off = 0.025, straight = true, options = options })
    end
    check.within_share(steps .. " steps", force(sg.robust{}), force(sg.plain{}), 3e-4)
  end
end)

check.case("an attempt that is rolled back leaves nothing of its forecast", function()
  for _, formulation in ipairs{ "gpts", "equal", "equal-multipliers" } do
    local function first(attempts)
      local model, path = indented(formulation, 1)
      for i, part in ipairs(attempts) do
        if i > 1 then model:rollback() end
        model:set_target("tool", path(part))
        check.equal(model:solve_step().converged, true)
      end
      model:accept()
      return model:displacements()
    end
    check.near(first{ 0.5, 0.25 }, first{ 0.25 }, 1e-13)
  end
end)
