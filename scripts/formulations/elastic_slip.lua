-- Elastic slip and Coulomb's law: what a tangential penalty changes, and how it vanishes with its stiffness.
--
-- Problem: partial_slip.lua: two equal blocks with parabolic faces, pressed together and sheared by 0.7 of mu P. The
--          normal penalty is 10 E over the length of an element; the tangential one varies. Coulomb's law is the limit
--          of a rigid spring. Mortar contact with multipliers solves it without a spring, on the same mesh.
--          Sticking points slip elastically by q/ε_T, at most by mu p/ε_T.
--          Held: the largest displacement of a contact point in 10 further steps in which nothing moves.
-- Source: partial_slip.lua; penalty regularization of Coulomb's law: P. Wriggers, Computational Contact Mechanics,
--         Springer, 2006, section 5.2.
-- Units: any consistent units; lengths relative to the radius R, tractions to Young's modulus.
-- Expected: slip of the sticking points inversely proportional to the penalty, as is the distance of Q/(mu P) from its
--           value with the stiffest one; the stick zone tends to that of multipliers; nothing moves while held. Stiffer
--           springs than 10 E/h change forces by less than 1e-3, and take more iterations.
-- Run: signorini -q formulations/elastic_slip.lua [order=N2-N2.2] [count=8] [formulations=equal,reduced]
--      [penalties=0.1,1,10,100,1000] [steps=10] [out=out/formulations/elastic_slip]; penalties: tangential, in
--      multiples of E over the length of an element; formulations: with mortar multipliers.

local sg = require "signorini"
local deviation = require "formulations.deviation"
local formulations = require "formulations.rows"
local measures = require "formulations.partial_slip.measures"
local problem = require "formulations.partial_slip.problem"

local options = sg.arguments{
  order = "N2-N2.2", count = { 8, at_least = 2 },
  formulations = { { "equal", "reduced" }, choices = { "equal", "reduced" } },
  penalties = { { 0.1, 1.0, 10.0, 100.0, 1000.0 }, above = 0 }, steps = { 10, at_least = 1 },
  out = "out/formulations/elastic_slip",
}
local along, hold = 1.255e-4, 10

--- The largest distance between the points of two profiles.
local function largest_move(before, after)
  local largest = 0
  for i, x in ipairs(before.x) do
    largest = math.max(largest, math.sqrt((after.x[i] - x) ^ 2 + (after.y[i] - before.y[i]) ^ 2))
  end
  return largest
end

--- Presses, shears and holds: measures.compare's state, with iterations of the shear, steps halved, held; or reason.
local function solve(formulation, penalty)
  local model = problem.scene{ order = options.order, count = options.count, penalty = 10,
                               friction_penalty = penalty, formulation = formulation }
  local function run(stage)
    local done = model:run({ stage }, sg.plain{ step = { adaptive = true } })
    return done, done.failed and (done.cause or done.reason) or nil
  end
  local _, reason = run(problem.press)
  if reason then return { reason = reason } end
  local opposites = measures.opposite(model, model:profile "joint")
  local shear
  shear, reason = run(problem.shear(options.steps, along))
  if reason then return { reason = reason } end
  local state, before = measures.compare(model, opposites), model:profile "joint"
  state.iterations, state.halved = shear.iterations, shear.cutbacks
  _, reason = run(problem.shear(hold, along))
  state.held = not reason and largest_move(before, model:profile "joint") / problem.half_width or nil
  state.reason = reason
  return state
end

-- ── Cases ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local cases, rows = {}, {}
for _, name in ipairs(options.formulations) do
  local limit = solve(formulations[name .. "-multipliers"])
  local list = { name = name, label = formulations[name].label, limit = limit }
  for i, penalty in ipairs(options.penalties) do
    local state = solve(formulations[name], penalty)
    state.penalty = penalty
    if state.s and limit.s then
      state.difference = deviation.l2(state.s, state.traction, deviation.interpolant(limit.s, limit.traction), 1.3)
    end
    list[i] = state
  end
  -- Multipliers have no normal penalty either, and with it another pressing force: the limit is the stiffest spring.
  local stiffest = list[#list]
  for i = 1, #list - 1 do
    if list[i].ratio and stiffest.ratio then list[i].force_error = list[i].ratio / stiffest.ratio - 1 end
  end
  for i = 1, #list + 1 do
    local state = list[i] or limit
    rows[#rows + 1] = { list.label, state.penalty and ("%g"):format(state.penalty) or "multipliers", state.c,
                        state.mean_slip, state.largest_slip, state.ratio, state.force_error, state.difference,
                        state.error, state.held, state.iterations, state.halved, state.reason }
  end
  cases[#cases + 1], cases[name] = list, list
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

print "Elastic slip: slip of the sticking points; force and traction (L2) against multipliers and the closed form"
print(sg.table{
  columns = { "formulation", "penalty", "c/a", "mean", "largest", "Q/(mu P)", "to stiffest", "to multipliers",
              "to Mindlin", "held", "iterations", "halved", "failed" },
  units = { "", "E/h", "", "slip / a", "slip / a", "", "relative", "of mu p_0", "of mu p_0",
            "of a", "", "", "" }, rows = rows,
  formats = { ["c/a"] = "%.3f", mean = "%.1e", largest = "%.1e", ["Q/(mu P)"] = "%.5f", ["to stiffest"] = "%.1e",
              ["to multipliers"] = "%.1e", ["to Mindlin"] = "%.1e",
              held = "%.0e" } })

local files = sg.files(options.out)
local data = { columns = { "formulation", "penalty", "c", "mean_slip", "largest_slip", "force_error", "difference",
                           "error", "held", "iterations", "halved" }, rows = {} }
for _, list in ipairs(cases) do
  for i = 1, #list + 1 do
    local state = list[i] or list.limit
    data.rows[#data.rows + 1] = { list.name, state.penalty or "multipliers", state.c, state.mean_slip,
                                  state.largest_slip, state.force_error, state.difference, state.error, state.held,
                                  state.iterations, state.halved }
  end
end
sg.csv.write(files "states.csv", data)

files:draw("elastic_slip.png", "a case that converged", function(file)
  local drawing = { file = file, log = "xy", xlabel = "tangential penalty (E/h)", ylabel = "relative",
                    title = "Elastic slip: convergence to Coulomb's law" }
  for k, list in ipairs(cases) do
    local slip = { x = {}, y = {}, label = list.label .. ": mean slip / a", markers = true, color = k }
    local force = { x = {}, y = {}, label = list.label .. ": Q to the stiffest", markers = true, dashed = true,
                    color = k }
    for _, state in ipairs(list) do
      if state.force_error then
        local n = #slip.x + 1
        slip.x[n], slip.y[n] = state.penalty, state.mean_slip
        force.x[n], force.y[n] = state.penalty, math.abs(state.force_error)
      end
    end
    if #slip.x > 0 then
      drawing[#drawing + 1], drawing[#drawing + 2] = slip, force
    end
  end
  if #drawing > 0 then sg.chart(drawing) end
  return #drawing > 0
end)
files:report()

return { cases = cases, files = files }
