-- Ironing with friction by formulation: oscillation of the forces over time, iterations per step.
--
-- Problem: problems=plane: a half ring is pressed into a slab and dragged along it (ironing2d.lua); problems=solid: a
--          block with a spherical bottom, R = 7.5, is pressed into a slab by 5.4 and dragged along it (ironing3d.lua).
--
--         error |  o
--               |   \ o         one curve per formulation, one marker per mesh; lower left is better
--               |____\____ time
--
--          Error: max − min of a force over about one element of the coarsest slab in its middle, minus the best-fit
--          parabola (plane); solid: the same over the second of two elements of the sparse slab through which the
--          indenter slides. The time of failed attempts counts.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, sections 7.1 and 7.4; mortar ironing: L. De Lorenzis and
--         others, IJNME 87 (2011); two half passes: R. A. Sauer and L. De Lorenzis, IJNME 101 (2015).
-- Units: mm, N, N/mm² (plane), any consistent units (solid); times in s.
-- Expected: plane, N2-N2.2 on m1 to m3: mortar with a penalty and equal multipliers takes at most as many iterations
--           per step as Gauss points, 1.0 to 1.3 times the time from m2 on, and has 0.4 to 0.6 of the oscillation; two
--           half passes have 1.6 to 6 times the oscillation. Multipliers as unknowns on the stiff die take 0.8 to 4
--           times the iterations, and fail on m3; with the slab as slave 0.8 to 1 times, except where the lowest
--           point of the die, a jump of curvature, passes element borders of the slab.
-- Run: signorini -q formulations/ironing_cost.lua [problems=plane,solid] [orders=N2,N2-N2.2]
--      [meshes=m1,m2,m3,m4] [solids=sparse,coarse] [formulations=…] [mu=0.3] [penalty=100] [rounds=1]
--      [controls=robust] [out=out/formulations/ironing_cost]; meshes: of the plane problem; solids: of the solid one,
--      whose friction is mu and whose penalties are penalty; rounds: runs per case, for medians of the times; controls:
--      those of sg.robust, or halving of failed steps alone. Finished cases are saved in `out` and not run again.

local sg = require "signorini"
local formulations = require "formulations.rows"
local measure = require "problems.ironing2d.measure"
local plane = require "problems.ironing2d.problem"
local solid = require "problems.ironing3d.problem"

local usual = formulations.where(function() return true end)
table.move({ "equal-multipliers-swapped", "reduced-multipliers-swapped" }, 1, 2, #usual + 1, usual)
local options = sg.arguments{
  problems = { { "plane", "solid" }, choices = { "plane", "solid" } }, orders = { "N2", "N2-N2.2" },
  meshes = plane.meshes{ "m1", "m2", "m3", "m4" },
  solids = { { "sparse", "coarse" }, choices = solid.mesh_names },
  formulations = formulations.argument(usual), mu = { 0.3, at_least = 0 }, penalty = { 100.0, above = 0 },
  rounds = { 1, at_least = 1 }, controls = { "robust", choices = { "robust", "halving" } },
  out = "out/formulations/ironing_cost",
}

--- All controls, the default of model:run, or halving of failed steps alone.
local function controls(overrides)
  if options.controls == "robust" then return sg.robust(overrides) end
  overrides.step = { adaptive = true }
  return sg.plain(overrides)
end

-- ── The problems ─────────────────────────────────────────────────────────────────────────────────────────────────────

--- What a study keeps of a run with these times: iterations, forces of the grip along and across the slide.
local function results(run, dofs, wall, cpu, across)
  return { wall = wall, cpu = cpu, dofs = dofs, steps = run.steps, iterations = run.iterations,
           per_step = run.iterations / math.max(1, run.steps), cutbacks = run.cutbacks,
           drag = run:column "grip.fx", press = run:column(across),
           failed = run.failed, reason = run.failed and run.failure or nil }
end

local problems = {
  plane = {
    title = "Ironing", meshes = options.meshes,
    run = function(case)
      local wall, cpu = sg.wall_time(), os.clock()
      local solved = plane.solve{ set_up = plane.variants.standard, order = case.order, mesh = case.mesh,
                                  formulation = formulations[case.formulation], controls = controls }
      return results(solved.run, solved.die_dofs.total + solved.slab_dofs.total, sg.wall_time() - wall,
        os.clock() - cpu, "grip.fy")
    end,
    oscillation = function(force) return measure.oscillation(force).detrended end,
  },
  solid = {
    title = "Ironing in 3D", meshes = options.solids,
    constants = { mu = { options.mu }, penalty = { options.penalty } },
    run = function(case)
      local wall, cpu, element = sg.wall_time(), os.clock(), 100 / 9
      local solved = solid.solve{ order = case.order, mesh = case.mesh, radius = 7.5, depth = 5.4, down = 0.2,
                                  mu = case.mu, penalty = case.penalty, from = 50 - 1.5 * element,
                                  distance = 2 * element, along = 0.3, formulation = formulations[case.formulation],
                                  controls = controls }
      return results(solved.run, solved.dofs.indenter.total + solved.dofs.slab.total, sg.wall_time() - wall,
        os.clock() - cpu, "grip.fz")
    end,
    oscillation = function(force)
      local press = math.floor(5.4 / 0.2 + 0.5)
      return measure.oscillation(force, press + math.floor((#force - press) / 2 + 0.5), #force).detrended
    end,
  },
}

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Executes the missing cases of a problem; returns medians over the rounds, with both errors.
local function study_of(name)
  local problem, rounds = problems[name], {}
  for i = 1, options.rounds do rounds[i] = i end
  -- Rounds vary slowest, so that a disturbance does not affect one formulation alone.
  local parameters = { { round = rounds }, { mesh = problem.meshes }, { order = options.orders },
                       { formulation = options.formulations }, problem.constants }
  local study = sg.study{
    name = "formulations: " .. name, run = problem.run, sequential = true, units = { cpu = "s" },
    folder = ("%s/%s"):format(options.out, name),
    cases = sg.grid(table.unpack(parameters)),
  }
  study:execute()
  local medians = study:median "round"
  for _, force in ipairs { "drag", "press" } do
    medians = medians:with("d" .. force, function(row)
      return not row.failed and problem.oscillation(row[force]) or nil
    end)
  end
  return medians
end

--- Iterations per step and time of every case, also relative to Gauss points, and both oscillations.
local function table_of(medians)
  local points, rows = {}, {}
  for _, row in ipairs(medians.rows) do
    if row.formulation == "gpts" and not row.failed then points[row.order .. row.mesh] = row end
  end
  for i, row in ipairs(medians.rows) do
    local other = not row.failed and points[row.order .. row.mesh] or nil
    rows[i] = { row.order, row.mesh, formulations[row.formulation].label, row.dofs, row.per_step,
                other and row.per_step / other.per_step, row.cutbacks, row.cpu, other and row.cpu / other.cpu,
                row.ddrag, row.dpress, row.failed and (row.reason or "failed"):sub(1, 40) or nil }
  end
  return sg.table{
    columns = { "order", "mesh", "formulation", "DOFs", "iterations", "ratio", "cuts", "time", "time ratio", "drag",
                "press", "failed" },
    units = { "", "", "", "", "per step", "", "", "s", "", "oscillation", "oscillation", "" }, rows = rows,
    formats = { DOFs = "%.0f", iterations = "%.2f", ratio = "%.2f", cuts = "%.0f", time = "%.2f",
                ["time ratio"] = "%.2f", drag = "%.2e", press = "%.2e" } }
end

local files, found = sg.files(options.out), {}
for _, name in ipairs(options.problems) do
  local problem, medians = problems[name], study_of(name)
  found[name] = medians
  print(("\n%s: iterations, processor time and oscillation of the forces"):format(problem.title))
  print(table_of(medians))
  medians:csv(files(name .. ".csv"))
  medians:report{ file = files(name .. ".html"), title = problem.title }
  for _, error in ipairs { "ddrag", "dpress" } do
    for _, order in ipairs(options.orders) do
      local part = medians:where(function(row) return row.order == order and row[error] ~= nil end)
      if #part.rows > 0 then
        local what = error == "ddrag" and "drag" or "pressing force"
        local comparison = sg.work_precision(part, {
          time = "cpu", error = error, marker = "mesh",
          series = function(row) return formulations[row.formulation].label end,
          file = files(("%s_%s_%s.png"):format(name, order, error)), xlabel = "processor time (s)",
          ylabel = "oscillation of the " .. what, title = ("%s, %s: oscillation of the %s"):format(problem.title, order,
            what) })
        print(("\n%s, %s, %s: ratios of time at equal oscillation; Pareto front"):format(problem.title, order, what))
        print(comparison:table())
        print(comparison:front())
      end
    end
  end
end
files:report()

return { studies = found, files = files }
