-- Cost of robust solver controls where nothing fails, and iterations saved by predictors.
--
-- Problem: runs that converge without controls: 2D frictional ironing as published (ironing2d.lua) and Hertz
--          line contact under a prescribed load and displacement (hertz2d.lua), each with plain Newton
--          (sg.plain) and with all controls (sg.robust, the default of model:run); then ironing with the four
--          predictors: tangent, constant, linear, quadratic.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, sections 7.1, 6.1 and 7.2, for the problems.
-- Units: Newton iterations; seconds.
-- Expected: with all controls no run takes more iterations than without (limit: 1.05 times as many); ironing takes 0.67
--           to 0.70 times as many, Hertz 0.81 to 1.00. The quadratic predictor saves 27 to 33 % of the iterations of
--           the sliding stage, the linear one 11 to 31 %.
-- Run: signorini stability/cost.lua [orders=N2,N4,N6,N2-N4,N2-N6,N2-N2.1,N2-N2.2,N2-N2.3] [mesh=m1]
--      [hertz=L1,N2,N4,N2-N4,N2-N2.1,N2-N2.2] [rings=m3] [steps=10] [coarser=1] [repeats=3] [out=out/stability/cost];
--      rings, steps: mesh and number of steps of Hertz; coarser: factor on the step size of ironing; times are medians
--      of repeats.

local sg = require "signorini"
local hertz = require "problems.hertz2d.problem"
local ironing = require "problems.ironing2d.problem"

local options = sg.arguments{
  orders = { "N2", "N4", "N6", "N2-N4", "N2-N6", "N2-N2.1", "N2-N2.2", "N2-N2.3" }, mesh = ironing.meshes "m1",
  hertz = { "L1", "N2", "N4", "N2-N4", "N2-N2.1", "N2-N2.2" },
  rings = { "m3", choices = { "m1", "m2", "m3", "m4", "m5", "m6" } }, steps = 10, coarser = { 1.0, above = 0 },
  repeats = 3, out = "out/stability/cost",
}
local predictors = { "tangent", "constant", "linear", "quadratic" }

-- ── Runs ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Runs a case { problem, order, run(controls) } in each of several ways, in turns; returns for each way the last run
--- and the median of the times.
local function solve(case, ways)
  local results = {}
  for i = 1, options.repeats do
    for name, controls in pairs(ways) do
      local run = case.run(controls)
      results[name] = results[name] or { walls = {} }
      results[name].run, results[name].walls[i] = run, run.wall
    end
  end
  for _, result in pairs(results) do result.wall = sg.median(result.walls) end
  return results
end

local function ironing_case(order)
  local set_up = ironing.variants.standard
  return { problem = "ironing at " .. options.mesh, order = order, run = function(controls)
    local model = ironing.scene(set_up, order, ironing.elements(options.mesh))
    return model:run(ironing.path(set_up, options.coarser), controls)
  end }
end

local function hertz_case(load, order)
  return { problem = ("Hertz at %s by %s"):format(options.rings, load), order = order, run = function(controls)
    local model, stage = hertz.scene{ order = order, mesh = options.rings, load = load }
    stage.steps = options.steps
    return model:run({ stage }, controls)
  end }
end

-- ── Controls on and off ──────────────────────────────────────────────────────────────────────────────────────────────

local costs, rows = {}, {}
local function add(case)
  local results = solve(case, { plain = sg.plain{}, controls = sg.robust{} })
  local plain, controls = results.plain, results.controls
  local cost = {
    problem = case.problem, order = case.order, plain = plain.run.iterations, controls = controls.run.iterations,
    ratio = controls.run.iterations / plain.run.iterations, time_ratio = controls.wall / plain.wall,
    failed = plain.run.failed or controls.run.failed,
  }
  costs[#costs + 1] = cost
  rows[#rows + 1] = { cost.problem, cost.order, cost.plain, cost.controls, cost.ratio, cost.time_ratio,
                      cost.failed and "fails" or "" }
end
for _, order in ipairs(options.orders) do add(ironing_case(order)) end
for _, load in ipairs { "force", "displacement" } do
  for _, order in ipairs(options.hertz) do add(hertz_case(load, order)) end
end
print "Iterations with plain Newton and with the controls on; their ratio, and that of the times"
print(sg.table{ columns = { "problem", "order", "plain", "controls", "ratio", "time ratio", "" }, rows = rows,
                formats = { ratio = "%.3f", ["time ratio"] = "%.2f" } })

-- ── Predictors ───────────────────────────────────────────────────────────────────────────────────────────────────────

local guesses = {}
rows = {}
for _, order in ipairs(options.orders) do
  local ways, row = {}, { order }
  for _, predictor in ipairs(predictors) do ways[predictor] = sg.plain{ predictor = predictor } end
  local results, guess = solve(ironing_case(order), ways), { order = order }
  for _, predictor in ipairs(predictors) do
    local run = results[predictor].run
    guess[predictor] = not run.failed and run.stages[2].iterations or nil
    row[#row + 1] = guess[predictor] or run.reason
  end
  guess.saved = guess.tangent and guess.quadratic and 100 * (1 - guess.quadratic / guess.tangent)
  guess.time_saved = 100 * (1 - results.quadratic.wall / results.tangent.wall)
  row[#row + 1], row[#row + 2] = guess.saved or "", guess.time_saved
  guesses[#guesses + 1], rows[#rows + 1] = guess, row
end
print(("\nIroning at %s: iterations of the sliding stage by predictor, and savings by the quadratic one")
  :format(options.mesh))
print(sg.table{ columns = { "order", "tangent", "constant", "linear", "quadratic", "iterations saved", "time saved" },
                units = { "", "", "", "", "", "%", "%" }, rows = rows,
                formats = { ["iterations saved"] = "%.1f", ["time saved"] = "%.1f" } })

local files = sg.files(options.out)
local data = { columns = { "problem", "order", "plain", "controls", "ratio", "time_ratio" }, rows = {} }
for i, c in ipairs(costs) do data.rows[i] = { c.problem, c.order, c.plain, c.controls, c.ratio, c.time_ratio } end
sg.csv.write(files "cost.csv", data)
files:report()

return { costs = costs, guesses = guesses, files = files }
