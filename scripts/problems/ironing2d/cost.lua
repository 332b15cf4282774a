-- The validation variant at least cost: oscillation and mean of the forces over the processor time of a run, by
-- discretization and number of steps, next to GetFEM's.

local sg = require "signorini"
local in_turns = require "studies.in_turns"
local problem = require "problems.ironing2d.problem"
local validation = require "problems.ironing2d.validation"

local cost = {}

--- Processor time of GetFEM in seconds, and its oscillations in % of the mean forces: 110 steps of the same path on one
--- thread, 48 × 12 elements, share/peers/getfem/ironing2d.py 48.
cost.getfem = { time = 52, Px = 0.60, Py = 0.39 }

--- Half of the slab's elements in the upper 35 % of its height, next to the contact.
local graded = { false, { elements = 0.5, length = 0.35, at = "end" } }

--- The first is the one that the others have to beat. The arc of the stiff die needs no layer, and few elements; below
--- the slab's layer degree 2 replaces elements in the thickness direction.
cost.discretizations = {
  { name = "N2-N2.2, 24 × 6", order = "N2-N2.2", die = {18, 2}, slab = {24, 6}, points = 15 },
  { name = "N2-N2.2, 24 × 6, 10 points", order = "N2-N2.2", die = {18, 2}, slab = {24, 6}, points = 10 },
  { name = "N2-N2.2, 22 × 2", order = "N2-N2.2", die = {8, 1}, slab = {22, 2}, points = 12, die_order = "N2",
    slab_degree = 2, grading = graded, tolerance = 1e-6 },
  { name = "N2-N2.1, 26 × 2", order = "N2-N2.1", die = {8, 1}, slab = {26, 2}, points = 12, die_order = "N2",
    slab_degree = 2, grading = graded, tolerance = 1e-6 },
}

--- One run; `wall` is the processor time of scene and run.
local function solve(case)
  local set_up = {}
  for key, value in pairs(problem.variants.validation) do set_up[key] = value end
  set_up.press_steps, set_up.slide_steps = case.steps // 11, case.steps * 10 // 11
  local one, began = case.discretization, os.clock()
  local model, die, slab = problem.scene(set_up, one.order, one, one.points, 1, one)
  local run = model:run(problem.path(set_up, 1), sg.robust{ newton = { tolerance = one.tolerance } })
  local solved = { name = one.name, steps = case.steps, run = run, wall = os.clock() - began,
                   dofs = die:dofs().total + slab:dofs().total }
  validation.add_forces(solved, set_up)
  if solved.mean then
    solved.percent = {}
    for _, force in ipairs { "Px", "Py" } do
      solved.percent[force] = 100 * solved.oscillation[force] / math.abs(solved.mean[force])
    end
  end
  return solved
end

local function rows_of(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local mean, percent = case.mean or {}, case.percent or {}
    rows[i] = { case.name, case.dofs, case.steps, case.run.iterations, case.run.cutbacks, mean.Py, mean.Px, percent.Py,
                percent.Px, case.times.wall, case.times.wall / cases[1].times.wall }
  end
  return rows
end

local function result_table(rows)
  return sg.table{
    columns = { "discretization", "DOFs", "steps", "iterations", "cut-backs", "mean Py", "mean Px", "osc. Py",
                "osc. Px", "processor time", "time" },
    units = { "", "", "", "", "", "N/mm", "N/mm", "%", "%", "s", "of the first" }, rows = rows,
    formats = { "%s", "%d", "%d", "%d", "%d", "%.5f", "%.5f", "%.3f", "%.3f", "%.3f", "%.2f" },
  }
end

--- One force: a curve per discretization, a point per number of steps.
local function draw(file, cases, force)
  local chart = { file = file, xlabel = "processor time (s)",
                  ylabel = ("oscillation of %s (%% of its mean)"):format(force),
                  title = ("Ironing for validation: oscillation of %s over time"):format(force),
                  hlines = { { cost.getfem[force], ("GetFEM, %g s"):format(cost.getfem.time) } } }
  local curves = {}
  for _, case in ipairs(cases) do
    if case.percent then
      local curve = curves[case.name]
      if not curve then
        curve = { x = {}, y = {}, label = case.name, markers = true }
        curves[case.name], chart[#chart + 1] = curve, curve
      end
      curve.x[#curve.x + 1], curve.y[#curve.y + 1] = case.times.wall, case.percent[force]
    end
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

--- Runs all discretizations with all numbers of steps in turns, `repeat` times over. Returns { cases }, also by
--- "name, steps".
function cost.run(options, files)
  local list = {}
  for _, steps in ipairs(options.steps) do
    if steps % 11 ~= 0 then error(("steps=%d: not a multiple of 11, 1 to press and 10 to slide"):format(steps), 0) end
    for _, one in ipairs(cost.discretizations) do list[#list + 1] = { discretization = one, steps = steps } end
  end
  local cases = in_turns(list, options["repeat"], solve)
  print(("medians of %d runs in turns; means and oscillations (max − min, detrended) in the middle of the sliding")
    :format(options["repeat"]))
  local rows = rows_of(cases)
  print(result_table(rows))
  sg.csv.write(files "cost.csv", {
    columns = { "discretization", "dofs", "steps", "iterations", "cutbacks", "mean_Py", "mean_Px", "oscillation_Py",
                "oscillation_Px", "time", "relative_time" },
    comments = { "forces in N/mm, oscillations in % of the mean, processor time in s" }, rows = rows })
  for _, case in ipairs(cases) do cases[("%s, %d"):format(case.name, case.steps)] = case end
  for _, force in ipairs { "Px", "Py" } do
    files:draw(force .. "_over_time.png", "runs that reach the middle of the sliding", function(file)
      return draw(file, cases, force)
    end)
  end
  return { cases = cases }
end

return cost
