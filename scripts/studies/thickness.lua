-- Degree in the thickness direction, linear or that of the bulk: error over time of both.
--
-- Problem: the order label of a body applies along its contact face. In the thickness direction, from the contact face
--          to the opposite one, the functions have the degree of the bulk (default) or another one
--          (`thickness_degree`); the thesis uses 1.
--
--          ironing of ironing2d.lua: oscillation of the drag, and means of drag and pressing force in the same window;
--          Hertz line contact of hertz2d.lua: L2 error of the pressure against N2-N2.2 at m6 with degree 2 in the
--          thickness direction; a cantilever 10 × 1, clamped at one end, with a shear traction at the other, bottom
--          face named as contact face: error of the deflection against N4 on 160 × 16 elements.
--
--          |=============== |     ny elements in thickness direction (m1: 1, m2: 2, m3: 4, m4: 8) and 10 ny along it;
--          |_______________ v     nu = 0.3, and 0.49, where linear functions lock
-- Source: ironing and Hertz: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for
--         Isogeometric Analysis of Contact Problems, PhD thesis, IIT Guwahati, 2020, sections 7.1 and 7.2. Locking:
--         T. J. R. Hughes, The Finite Element Method, Dover, 2000, chapter 4.
-- Units: oscillation in N/mm; errors of pressure and deflection in 1; times in s.
-- Expected: ironing and Hertz: degree 1 takes 0.4 to 0.7 of the time at equal error (ironing: 2.8 at the largest common
--           error of N2, where the oscillation does not yet decrease monotonically); Hertz on m4 and finer: the linear
--           elements in the thickness direction leave an error of 4e-3. Cantilever: degree 1 needs about six times as
--           many elements in the thickness direction for the same deflection at nu = 0.3; at nu = 0.49 it loses 91 % of
--           the deflection with one element and 16 % with eight.
-- Run: signorini thickness.lua [problems=ironing,hertz,cantilever,cantilever49] [orders=N2,N2-N2.2]
--      [thickness_degree=1,2] [meshes=m1,m2,m3] [rounds=1] [time=cpu] [out=out/thickness]; rounds: runs per case, for
--      medians; time: cpu, or wall on a machine without other load. Finished cases are saved in `out`.

local sg = require "signorini"
local measure = require "problems.ironing2d.measure"
local hertz = require "problems.hertz2d.problem"
local ironing = require "problems.ironing2d.problem"
local timed = require "studies.speed_against_accuracy.timed"

-- ── Problems: solve(case) → results; error(row, reference) ───────────────────────────────────────────────────────────

--- A cantilever's mean deflection at its loaded end. `case` as in a study: order, thickness_degree, mesh.
local function deflection(case, nu)
  local ny = 1 << (math.tointeger(case.mesh:sub(2)) - 1)
  local beam = sg.body{
    patch    = sg.shapes.rectangle{ width = 10, height = 1 }, elements = { 10 * ny, ny }, order = case.order,
    contact  = "south", thickness_degree = case.thickness_degree, material = sg.linear_elastic{ E = 1, nu = nu },
  }
  local model = sg.model{ bodies = { beam = beam }, supports = { wall = { on = beam:face "west", fix = "xy" } },
                          loads = { tip = { on = beam:face "east", traction = { 0, -1e-4 } } } }
  local run = model:run{ { steps = 1 } }
  return { value = model:sample("beam", "uy", { 1, 0.5 }), iterations = run.iterations, dofs = beam:dofs().total }
end

local function bending(title, nu)
  return {
    title = title, error = "error of the deflection", reference = { order = "N4", thickness_degree = 4, mesh = "m5" },
    solve = function(case) return deflection(case, nu) end,
    of = function(row, reference) return math.abs(row.value / reference.value - 1) end,
  }
end

local problems = {
  ironing = {
    title = "Ironing", error = "oscillation of the drag", unit = "N/mm", means = { "drag", "pressing" },
    solve = function(case)
      local solved = ironing.solve{ set_up = ironing.variants.standard, order = case.order, mesh = case.mesh,
                                    thickness_degree = case.thickness_degree }
      local run = solved.run
      return { oscillation = measure.oscillation(run:column "grip.fx").detrended, iterations = run.iterations,
               drag = measure.mean(run:column "grip.fx"), pressing = measure.mean(run:column "grip.fy"),
               dofs = solved.die_dofs.total + solved.slab_dofs.total,
               failed = run.failed, reason = run.failed and run.failure or nil }
    end,
    of = function(row) return row.oscillation end,
  },
  hertz = {
    title = "Hertz", error = "L₂ error of the pressure", reference = { order = "N2-N2.2", thickness_degree = 2,
    mesh = "m6" },
    solve = function(case)
      local model, stage, ring = hertz.scene{ order = case.order, mesh = case.mesh,
                                              thickness_degree = case.thickness_degree,
                                              load = "displacement" }
      stage.steps = 10
      local run = model:run{ stage }
      local profile = model:profile "ground"
      return { profile = { x = profile.x, pressure = profile.pressure, gap = profile.gap },
               iterations = run.iterations, dofs = ring:dofs().total,
               failed = run.failed, reason = run.failed and run.failure or nil }
    end,
    of = function(row, reference)
      local width = sg.profile_edges{ profile = reference.profile }.to
      return (sg.profile_error{ profile = row.profile, reference = reference.profile, normalize = "max",
                                coordinate = function(point) return point.x / width end })
    end,
  },
  cantilever = bending("Cantilever, nu = 0.3", 0.3),
  cantilever49 = bending("Cantilever, nu = 0.49", 0.49),
}
local names = { "ironing", "hertz", "cantilever", "cantilever49" }

-- ── Study ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local options = sg.arguments{
  problems = { names, choices = names }, orders = { "N2", "N2-N2.2" }, thickness_degree = { 1, 2 },
  meshes = { { "m1", "m2", "m3" }, choices = { "m1", "m2", "m3", "m4", "m5" } }, rounds = 1,
  time = { "cpu", choices = { "cpu", "wall" } }, out = "out/thickness",
}
local files = sg.files(options.out)

--- "N2, thickness degree 1"
local function space_of(row) return ("%s, thickness degree %d"):format(row.order, row.thickness_degree) end

local function measured(name)
  local problem = problems[name]
  local list = {}
  for round = 1, options.rounds do
    list[round] = sg.grid({ round = { round } }, { mesh = options.meshes }, { order = options.orders },
      { thickness_degree = options.thickness_degree })
  end
  local wanted = problem.reference
  if wanted then
    list[#list + 1] = { { round = 0, mesh = wanted.mesh, order = wanted.order,
                          thickness_degree = wanted.thickness_degree } }
  end
  local study = sg.study{
    name = "thickness: " .. name, cases = list, sequential = true, folder = ("%s/%s"):format(options.out, name),
    units = { cpu = "s" },
    run = function(case)
      local results, spent = timed(function() return problem.solve(case) end)
      results.wall, results.cpu = spent.wall, spent.cpu
      return results
    end,
  }:execute{}
  local reference = wanted and study:row{ round = 0 }
  local medians = study:where(function(row) return row.round > 0 end):median "round"
  medians = medians:with("error", function(row)
    return not row.failed and problem.of(row, reference) or nil
  end, problem.unit)
  return medians:with("space", space_of)
end

for _, name in ipairs(options.problems) do
  local problem, cases = problems[name], measured(name)
  print(("\n── %s: %s ──\n"):format(problem.title, problem.error))
  local columns = { "order", "thickness_degree", "mesh", "dofs", "iterations", options.time, "error" }
  table.move(problem.means or {}, 1, 2, #columns + 1, columns)
  print(cases:table{ columns = columns,
                     sort = { "order", "thickness_degree", "mesh" } })
  local comparison = sg.work_precision(cases, {
    time = options.time, error = "error", series = "space", marker = "mesh", size = { 1600, 1000 },
    files = { files(name .. ".svg"), files(name .. ".png") },
    title = ("%s: %s over time"):format(problem.title, problem.error),
    ylabel = problem.unit and ("%s (%s)"):format(problem.error, problem.unit) or problem.error,
    xlabel = options.time == "cpu" and "processor time (s)" or "time (s)",
  })
  print(comparison)
  cases:report{ file = files(name .. ".html"), title = problem.title }
end
files:report()
