-- Turning points: a strip that peels with snap-backs under prescribed rotation, an arch that snaps through under a dead
-- load. Without arc length plain Newton ends there and reports it; with arc length the run continues and records the
-- changes of control. The default controls jump over a snap-back and warn.

require "check"
local strip = require "strip"

local film, equilibrium = strip.film, strip.equilibrium

-- ── Snap-back: a strip of 40 × 2 elements, so coarse that it peels element by element ────────────────────────────────

--- Turns a strip's edge by 76°. No step needs more than five iterations, unless it jumps over a snap-back.
local function peel(steps, arc_length, pseudo_transient)
  local model = strip.model()
  local run = model:run({ { name = "peel", steps = steps, edge = 76 } },
    sg.plain{ arc_length = arc_length, newton = { iterations = 10 }, pseudo_transient = pseudo_transient })
  return run, model
end

--- Energy per area of the film: V(r_eq) = −W, V′ = −T.
local function potential(r)
  local strength = film.hamaker / (2 * math.pi * film.r0 ^ 3)
  local q = film.r0 / math.max(r, equilibrium)
  local energy = strength * film.r0 * (q ^ 8 / 360 - q ^ 2 / 6)
  if r >= equilibrium then return energy end
  return energy + strength * (q ^ 9 / 5 - q ^ 3) / equilibrium * (r - equilibrium) ^ 2 / 2
end

--- What bodies and film store; the film acts on the reference area, the area before the first step.
local function stored(model)
  local sum, areas = model:energy().stored, strip.model():profile "film".area
  for i, gap in ipairs(model:profile "film".gap) do sum = sum + areas[i] * potential(gap) end
  return sum
end

--- The moments at whole steps by angle.
local function moments(run)
  local step, angle, moment, found = run:column "step", run:column "edge.angle", run:column "edge.moment", {}
  for i = 1, #step do
    if step[i] % 1 == 0 then found[#found + 1] = { angle[i], moment[i] } end
  end
  return found
end

check.case("rotation control ends at a turning point, and the report names the angle", function()
  local run = peel(152, false)
  check.equal({ run.failed, run.reason, run.steps }, { true, "turning_point", 144 })
  check.holds(run.failure, "step 145 (stage 'peel', 145 of 152) was not reached",
    "The model is at its last accepted step, 144", "arc_length = true")
  check.near(tonumber(run.failure:match "turning point at edge%.angle = ([%d.]+)"), 72.33, 0.1)
  check.equal(#run.controls, 0)
end)

check.case("arc length follows the snap-back; the run records both changes of control", function()
  local run = peel(152, true)
  check.equal({ run.failed, run.reason, run.steps, #run.controls }, { false, "completed", 152, 2 })
  local there, back = run.controls[1], run.controls[2]
  check.equal({ there.step, there.to, there.place, there.reason },
    { 145, "arc length", "edge.angle = 72", "iterations" })
  check.equal({ back.step, back.to, back.place, back.reason },
    { 145, "targets", "edge.angle = 72.5", "the end of the step is passed" })
  check.holds(tostring(run), "control: arc length from edge.angle = 72 in step 145", "targets from edge.angle = 72.5")
  -- Rows between the steps: the angle goes up to the turning point, more than two degrees back, and up again.
  local step, angle, turns = run:column "step", run:column "edge.angle", {}
  for i = 2, #angle - 1 do
    if (angle[i] - angle[i - 1]) * (angle[i + 1] - angle[i]) < 0 then turns[#turns + 1] = angle[i] end
    check.near(step[i], angle[i] * 2, 1e-6)
  end
  check.equal(#turns, 2)
  check.near(turns, { 72.3, 69.9 }, 0.15)
end)

check.case("after the snap-back the states are those of smaller steps and of a jump", function()
  local reference = moments((peel(152, true)))
  for _, other in ipairs { moments((peel(304, true))), moments((peel(152, false, true))) } do
    local by_angle = {}
    for _, state in ipairs(other) do by_angle[math.floor(state[1] * 4 + 0.5)] = state[2] end
    for _, state in ipairs(reference) do check.near(state[2], by_angle[math.floor(state[1] * 4 + 0.5)], 1e-9) end
  end
end)

check.case("the moment's work along the path equals the energy stored in body and adhesion", function()
  local before, errors = stored(strip.model()), {}
  for i, steps in ipairs { 76, 152 } do
    local run, model = peel(steps, true)
    local angle, moment, work = run:column "edge.angle", run:column "edge.moment", 0
    angle[0], moment[0] = 0, 0
    for row = 1, #angle do work = work + (moment[row] + moment[row - 1]) / 2 * math.rad(angle[row] - angle[row - 1]) end
    errors[i] = math.abs(work / (stored(model) - before) - 1)
  end
  print(("energy balance through a snap-back: off by %.1e and %.1e"):format(errors[1], errors[2]))
  assert(errors[1] < 2e-4 and errors[2] < 2e-4)
end)

check.case("arc length stays on the path through deep snap-backs, one per element, for any step", function()
  for _, length in ipairs { 1, 0.5, 0.25, 0.1 } do
    local steps = math.floor(118 / length + 0.5)
    local run = strip.model():run({ { name = "peel", steps = steps, edge = 118 } }, { arc_length = true })
    check.equal({ run.failed, run.steps }, { false, steps })
    local step, angle, moment = run:column "step", run:column "edge.angle", run:column "edge.moment"
    for i = 1, #step do
      check.near(angle[i], step[i] * length, 1e-6)
      assert(angle[i] < 60 or moment[i] > 0.93 and moment[i] < 1.25) -- never back to where the strip was bonded
    end
  end
end)

check.case("after a failure by an inverted element the report also names the turning point", function()
  -- Turning the edge by 46° at once folds the elements next to it before the first iteration.
  local run = strip.model():run({ { name = "peel", steps = 144, edge = 72 }, { name = "far", steps = 1, edge = 118 } },
    sg.plain{ predictor = "constant" })
  check.equal({ run.reason, run.steps }, { "turning_point", 144 })
  check.holds(run.failure, "is inverted")
  check.near(tonumber(run.failure:match "turning point at edge%.angle = ([%d.]+)"), 72.33, 0.1)
end)

-- ── Snap-through: a shallow arch with clamped ends under a dead load ─────────────────────────────────────────────────

local arch = { modulus = 1000, radius = 40, half_angle = math.rad(10), thickness = 0.3 }

local function arch_model()
  local degrees = math.deg(arch.half_angle)
  local function line(offset)
    return sg.nurbs.arc{ center = {0, -arch.radius}, radius = arch.radius + offset,
                         from = 90 + degrees, to = 90 - degrees }
  end
  return scenes.model{
    bodies = { arch = { patch = sg.nurbs.ruled{ a = line(-arch.thickness / 2), b = line(arch.thickness / 2) },
        elements = {16, 1}, order = "N3", thickness_degree = 2, contact = "north", E = arch.modulus, nu = 0 } },
    supports = { left = { on = "west", fix = "xy" }, right = { on = "east", fix = "xy" } },
    loads = { push = { on = "north", traction = {0, 0} } } }
end

--- The two limit loads of a shallow arch. With N = EI m² the axial force, half span L, EI w⁗ + N w″ = q − N/R has the
--- symmetric solution w = A ŵ, ŵ = f cos mx + x²/(2m²) + c, A = (q − N/R)/EI, which is clamped where f = L/(m³ sin mL)
--- and ŵ(L) = 0. The length of the arch gives N/(Et) = A ∫ŵ dx/(LR) − A² ∫ŵ′² dx/(2L) over the half span: two loads for
--- each m, one on the way to the upper limit, one past the lower one.
local function limit_loads()
  local E, R, t, L = arch.modulus, arch.radius, arch.thickness, arch.radius * math.sin(arch.half_angle)
  local EI, upper, lower, pieces = E * t ^ 3 / 12, 0, math.huge, 200
  for i = 1, 1300 do
    local m = math.pi * (i - 0.5) / 1000 / L
    local f = L / (m ^ 3 * math.sin(m * L))
    local c = -f * math.cos(m * L) - L ^ 2 / (2 * m ^ 2)
    local mean, square = 0, 0
    for k = 0, pieces do -- Simpson
      local x, weight = L * k / pieces, (k == 0 or k == pieces) and 1 or k % 2 == 1 and 4 or 2
      mean = mean + weight / (3 * pieces) * (f * math.cos(m * x) + x ^ 2 / (2 * m ^ 2) + c)
      square = square + weight / (3 * pieces) * (-f * m * math.sin(m * x) + x / m ^ 2) ^ 2
    end
    local N = EI * m ^ 2
    local root = (mean / R) ^ 2 - 2 * square * N / (E * t)
    if root >= 0 then
      local one, other = (mean / R - root ^ 0.5) / square * EI + N / R, (mean / R + root ^ 0.5) / square * EI + N / R
      -- At mL = π the two change sides.
      if m * L > math.pi then one, other = other, one end
      upper, lower = math.max(upper, one), math.min(lower, other)
    end
  end
  return upper, lower
end

local function push(arc_length)
  return arch_model():run({ { name = "push", steps = 20, push = {0, -0.02} } },
    sg.plain{ arc_length = arc_length, newton = { iterations = 8 } })
end

check.case("a dead load ends at the upper limit load of a shallow arch", function()
  local upper = limit_loads()
  local run = push(false)
  check.equal({ run.failed, run.reason, run.steps }, { true, "turning_point", 13 })
  check.near(tonumber(run.failure:match "turning point at push%.ty = %-([%d.]+)") / upper, 1, 0.01)
end)

check.case("with arc length the arch snaps through past the lower limit load, and carries more", function()
  local upper, lower = limit_loads()
  local run = push(true)
  check.equal({ run.failed, run.steps, run.controls[1].to, run.controls[2].to }, { false, 20, "arc length", "targets" })
  check.holds(run.controls[1].place, "push.ty = -0.013")
  local step, load, most, least = run:column "step", run:column "push.ty", 0, math.huge
  for i = 1, #step do
    if step[i] % 1 ~= 0 then most, least = math.max(most, -load[i]), math.min(least, -load[i]) end
  end
  print(("arch: limit loads %.5f and %.5f, analytic %.5f and %.5f"):format(most, least, upper, lower))
  check.near({ most / upper, least / lower }, { 1, 1 }, 0.02)
  check.near(load[#load], -0.02)
end)
