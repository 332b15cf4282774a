-- Cattaneo and Mindlin's problem by formulation: partial slip of two bodies that are pressed together and sheared.
--
-- Problem: two equal elastic blocks with parabolic faces are pressed together and then sheared, with friction. A stick
--          zone |x| < c remains inside the contact |x| < a, between two zones that slip.
--
--         ┌────────────────┐  both displacement components of the top are prescribed: down by 4e-4 in 16 steps,
--         │                │  then along by 5.2e-5, 1.255e-4, 1.75e-4 (Q about 0.3, 0.7, 0.95 of mu P)
--         │____        ____│
--          ____‾‾‾‾‾‾‾‾____   faces y = ± x²/(2 R), R = 1
--         │    ‾‾‾‾‾‾‾‾    │  blocks 0.6 wide (61 a) and 0.3 high, linear elastic, E = 1, nu = 0.3, plane strain
--         └────────────────┘  mu = 0.3; bottom clamped
--
--          Elements: `counts` per half-width a at the slave (upper) face and 0.77 times as many at the master, uniform
--          up to 1.4 a. Both penalties are `penalty` times E over the length of an element. Q/(mu P) is the quotient of
--          the integrals of both tractions over the contact, which turns slightly. Slip of the sticking points: their
--          displacement relative to the point of the master opposite to them since the end of the pressing, over |x| <
--          0.8 c, mean and largest, in units of a.
-- Source: C. Cattaneo, 1938; R. D. Mindlin, 1949; K. L. Johnson, Contact Mechanics, Cambridge, 1985, sections 4.2(c)
--         and 7.2(d).
-- Units: any consistent units; lengths relative to the radius R, tractions to Young's modulus.
-- Expected: c/a = √(1 − Q/(mu P)) within the length of an element; the L2 error of the traction over x/a falls with the
--           mesh; sticking points slip by the traction over the tangential penalty.
-- Run: signorini -q formulations/partial_slip.lua [orders=N2,N2-N2.2] [counts=4,8,16] [formulations=…]
--      [penalty=10] [press=16] [steps=10] [out=out/formulations/partial_slip]; press, steps: number of steps of the
--      pressing and of each shear; pressed: the integral of |q| over the contact after the pressing, which should
--      cause no friction.

local sg = require "signorini"
local chart = require "formulations.chart"
local formulations = require "formulations.rows"
local measures = require "formulations.partial_slip.measures"
local problem = require "formulations.partial_slip.problem"

local options = sg.arguments{
  orders = { "N2", "N2-N2.2" }, counts = { { 4, 8, 16 }, at_least = 2 },
  formulations = formulations.argument(formulations.names), penalty = { 10.0, above = 0 },
  press = { 16, at_least = 1 }, steps = { 10, at_least = 1 }, out = "out/formulations/partial_slip",
}
local along = { 5.2e-5, 1.255e-4, 1.75e-4 }

-- ── Solving ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Solves a case { order, count, formulation }; adds states (after each shear), iterations, and reason if it failed.
local function solve(case)
  case.states, case.iterations = {}, 0
  local model = problem.scene{ order = case.order, count = case.count, penalty = options.penalty,
                               formulation = case.formulation }
  local function run(stage)
    local done = model:run({ stage }, sg.plain{ step = { adaptive = true } })
    case.iterations = case.iterations + done.iterations
    if done.failed then case.reason = done.cause or done.reason end
    return not done.failed
  end
  if not run(problem.pressed(options.press)) then return case end
  case.pressed = measures.pressed(model)
  local opposites = measures.opposite(model, model:profile "joint")
  for i, length in ipairs(along) do
    if not run(problem.shear(options.steps, length)) then return case end
    case.states[i] = measures.compare(model, opposites)
  end
  return case
end

local cases = {}
for _, order in ipairs(options.orders) do
  for _, count in ipairs(options.counts) do
    for _, formulation in ipairs(formulations.of(options.formulations)) do
      local case = solve{ order = order, count = count, formulation = formulation }
      cases[#cases + 1] = case
      cases[("%s %d %s"):format(order, count, formulation.name)] = case
      collectgarbage() -- Lua does not count the memory of models
    end
  end
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local rows, formats = {}, { ["Q/(mu P)"] = "%.3f", ["c/a"] = "%.3f", expected = "%.3f", ["element"] = "%.3f",
                            ["L2 error"] = "%.1e", mean = "%.1e", largest = "%.1e", pressed = "%.1e" }
for _, case in ipairs(cases) do
  for i = 1, #along do
    local state = case.states[i] or {}
    rows[#rows + 1] = { case.order, case.formulation.label, case.count, state.ratio, state.c, state.expected,
                        1 / case.count, state.error, state.mean_slip, state.largest_slip,
                        i == 1 and case.pressed or nil,
                        i == 1 and case.iterations or nil, not case.states[i] and case.reason or nil }
  end
end
print "Partial slip against Cattaneo and Mindlin: stick zone, L2 error of the traction, slip of the sticking points"
print(sg.table{
  columns = { "order", "formulation", "elements", "Q/(mu P)", "c/a", "expected", "element", "L2 error", "mean",
              "largest", "pressed", "iterations", "failed" },
  units = { "", "", "per a", "", "", "", "a", "of mu p_0", "slip / a", "slip / a", "of mu P", "", "" }, rows = rows,
  formats = formats })

local files = sg.files(options.out)
local data = { columns = { "order", "formulation", "elements", "ratio", "c", "expected", "error", "mean_slip",
                           "largest_slip", "iterations" }, rows = {} }
for _, case in ipairs(cases) do
  for _, state in ipairs(case.states) do
    data.rows[#data.rows + 1] = { case.order, case.formulation.name, case.count, state.ratio, state.c, state.expected,
                                  state.error, state.mean_slip, state.largest_slip, case.iterations }
  end
end
sg.csv.write(files "states.csv", data)

--- The traction of all formulations after the second shear less that of the closed form: the curves alone coincide.
local function draw_tractions(order, count, file)
  local drawing = { file = file, xlabel = "x / a", ylabel = "(q − closed form) / (μ p_0)", xrange = { -1.2, 1.2 },
                    title = ("Partial slip, %s, %d elements per half-width"):format(order, count) }
  for _, formulation in ipairs(formulations.of(options.formulations)) do
    local state = cases[("%s %d %s"):format(order, count, formulation.name)].states[2]
    if state then
      local _, traction = problem.mindlin(state.ratio)
      local line = { x = state.s, y = {}, label = formulation.label, marker = "none" }
      for i, s in ipairs(state.s) do line.y[i] = state.traction[i] - traction(s) end
      drawing[#drawing + 1] = line
    end
  end
  if #drawing > 0 then sg.chart(drawing) end
  return #drawing > 0
end

for _, order in ipairs(options.orders) do
  files:draw(order .. "_traction.png", "a case that converged", function(file)
    return draw_tractions(order, options.counts[#options.counts], file)
  end)
  chart(files, order .. "_error.png", formulations.of(options.formulations), options.counts,
    function(formulation, i)
      return (cases[("%s %d %s"):format(order, options.counts[i], formulation.name)].states[2] or {}).error
    end,
    { log = "xy", xlabel = "elements per half-width", ylabel = "L₂ error of q / (μ p_0)",
      title = ("Partial slip, %s: error of the traction"):format(order) })
end
files:report()

return { cases = cases, files = files }
