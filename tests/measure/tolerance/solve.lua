-- Solutions of the problems: by levels to a tolerance, of a study, and the reference.

local companions = require "signorini.errors.companions"
local remade = require "signorini.errors.remade"

local solve = {}

-- ── Cost ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

local children, levels = { time = 0, work = 0 }, { work = 0 } -- of all companions; of levels in this process

--- Companions run in processes of their own, which pass on their cost with their record.
local record, solve_all = companions.record, companions.solve_all
function companions.record(model, run, list)
  local result = record(model, run, list)
  result.time, result.work = os.clock(), #model:unknowns() * run.iterations
  levels.work = levels.work + result.work
  return result
end
function companions.solve_all(scene, changes, records, bar)
  solve_all(scene, changes, records, bar)
  for _, change in ipairs(changes) do
    local one = records[change.name]
    children.time, children.work = children.time + (one.time or 0), children.work + (one.work or 0)
  end
end

-- ── Runs ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The values of a goal at the ends of the steps of all stages: { values, counts }; nil if the run has failed.
local function curve_of(run, goal)
  if run.failed or run.rows == 0 then return nil end
  local counts = {}
  for i, stage in ipairs(run.outline) do counts[i] = stage.steps end
  return { values = run:column(goal), counts = counts }
end

--- Solves a problem with factors { elements, row, penalty, steps } on its scene: a curve, processor time and work.
function solve.with(problem, factors)
  local began = os.clock()
  local model, path = problem.make()
  local again, stages = remade.model(model, factors), {}
  for i, stage in ipairs(path) do
    local own = {}
    for key, value in pairs(stage) do own[key] = value end
    own.steps = math.max(1, math.ceil(stage.steps * factors.steps))
    stages[i] = own
  end
  local run = again:run(stages, { verbose = false })
  return curve_of(run, problem.goal), os.clock() - began, #again:unknowns() * run.iterations
end

--- Solves a problem to a tolerance in %: the run, its curve, processor time and work of everything that it solved.
function solve.to(problem, tolerance, limit)
  local began, time, work = os.clock(), children.time, children.work + levels.work
  local model, path = problem.make()
  local run = model:run(path, { tolerance = ("%g %% of %s"):format(tolerance, problem.goal), limit = limit,
                               verbose = false })
  return { run = run, curve = curve_of(run, problem.goal), time = os.clock() - began + children.time - time,
           work = children.work + levels.work - work }
end

-- ── Errors ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The largest difference of a curve and the reference at the ends of the steps that both have, in % of its largest
--- value.
function solve.error(curve, reference)
  local most, largest, row, before = 0, 0, 0, 0
  for s, m in ipairs(curve.counts) do
    local n = reference.counts[s]
    for k = 1, m do
      row = row + 1
      if k * n % m == 0 then
        most = math.max(most, math.abs(curve.values[row] - reference.values[before + k * n // m]))
      end
      largest = math.max(largest, math.abs(curve.values[row]))
    end
    before = before + n
  end
  return 100 * most / largest
end

return solve
