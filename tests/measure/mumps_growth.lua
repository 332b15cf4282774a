-- Growth of factorizations: time, memory, operations and entries over the number of unknowns, and an estimate for 10⁶.
--
-- Problem: 3D ironing with friction (ironing3d.lua), the first three Newton iterations of pressing, on finer and finer
--          meshes; each mesh and solver is a process of its own. The growth of a quantity q is the exponent a of
--          q ~ unknowns^a, a least-squares fit over the larger half of the meshes.
-- Source: A. George, SIAM J. Numer. Anal. 10 (1973) 345-363; R. Lipton, D. Rose, R. Tarjan, SIAM J. Numer. Anal. 16
--         (1979) 346-358: with nested dissection, operations grow as unknowns^2 in 3D, entries as unknowns^(4/3).
-- Units: s of wall time, MB (10⁶ bytes), 10⁹ operations.
-- Expected: exponents of operations and entries near 2 and 4/3; on slender meshes they are less.
--           The estimate extrapolates the operations and entries that MUMPS counts to 10⁶ unknowns. Time is operations
--           over the rate of one core here times the number of cores, once with the whole rate and once with 30 % of
--           it; memory per core is that of the factors and of what MUMPS used here in addition, evenly distributed.
--           Rank 0 also needs the model: tangent, pattern and bodies.
-- Run: signorini tests/measure/mumps_growth.lua [fineness=1,1.6,2,2.5,3.2] [solvers=mumps] [ranks=1] [cores=16,64,256]
--      [unknowns=1e6] [mu=0.3] [mpirun=mpirun --oversubscribe] [out=out/mumps/growth]; fineness: multiplies the
--      elements of the mesh coarse per direction, in increasing order; solvers: also umfpack, mumps-low-rank,
--      mumps-single; the last two factor once, so that their times include the analysis; cores, unknowns: of the
--      estimate.
--      signorini tests/measure/mumps_growth.lua once=FILE solvers=mumps fineness=2 measures one mesh.

local sg = require "signorini"
local growth = require "benchmark.growth"
local ironing = require "mumps.ironing"

local solvers = { "umfpack", "mumps", "mumps-low-rank", "mumps-single" }
local options = sg.arguments{
  fineness = { { 1, 1.6, 2, 2.5, 3.2 }, at_least = 0.5 }, solvers = { { "mumps" }, choices = solvers },
  ranks = { 1, at_least = 1 }, cores = { { 16, 64, 256 }, at_least = 1 }, unknowns = { 1e6, at_least = 1 },
  mu = { 0.3, at_least = 0 }, mpirun = "mpirun --oversubscribe", out = "out/mumps/growth", once = "",
}

-- ── One mesh ─────────────────────────────────────────────────────────────────────────────────────────────────────────

if options.once ~= "" then
  local solver, model = ironing.solvers[options.solvers[1]], ironing.scene(options.fineness[1], options.mu)
  model:set_target("grip", { 0, 0, -0.2 })
  -- The first tangent may be symmetric, and a new pattern is analyzed: the last factorization counts.
  local factorization, solution, done = 0, math.huge, 0
  for _ = 1, 3 do
    local before = model:timings()
    model:iterate{ linear = solver.linear, mumps = solver.mumps }
    local after, count = model:timings(), model:solver().factorizations
    if count > done then factorization, done = after.factorization - before.factorization, count end
    solution = math.min(solution, after.solution - before.solution)
  end
  local results = ironing.sizes(model)
  results.factorization, results.solution = factorization, solution
  ironing.write(options.once, results)
  return results
end

-- ── All meshes ───────────────────────────────────────────────────────────────────────────────────────────────────────

local files = sg.files(options.out)
local names = { "factorization", "solution", "operations", "factors", "rank", "model", "peak" }
local scale = { operations = 1e-9, factors = 1e-6, rank = 1e-6, model = 1e-6, peak = 1e-6 }

--- The results of a solver on all meshes that it could factor; of the others a sentence is printed.
local function measure(solver)
  local all = {}
  for _, fineness in ipairs(options.fineness) do
    local results, failure = ironing.process("growth", {
      once = options.out .. "/once.csv", solvers = solver, fineness = fineness, mu = options.mu,
    }, options.ranks > 1 and ("%s -n %d"):format(options.mpirun, options.ranks) or "")
    if not results then
      print(("%s, fineness %g: %s"):format(solver, fineness, failure))
      break
    end
    for name, factor in pairs(scale) do results[name] = factor * results[name] end
    all[#all + 1] = results
  end
  return all
end

local function column(list, name)
  local values = {}
  for i, entry in ipairs(list) do values[i] = entry[name] end
  return values
end

local rows, exponents, measured = {}, {}, {}
for _, solver in ipairs(options.solvers) do
  local all = measure(solver)
  measured[solver] = all
  for _, results in ipairs(all) do
    local row = { solver, results.unknowns }
    for k, name in ipairs(names) do row[2 + k] = results[name] end
    rows[#rows + 1] = row
  end
  local sizes, row = column(all, "unknowns"), { solver }
  for k, name in ipairs(names) do row[1 + k] = growth.exponent(sizes, column(all, name)) end
  exponents[#exponents + 1] = row
end
if #rows == 0 then error("no mesh was factored", 0) end

local sheet = { columns = { "solver", "unknowns", table.unpack(names) }, rows = rows, formats = { "%s", "%d" },
                units = { "", "", "s", "s", "10⁹", "MB", "MB", "MB", "MB" } }
local slopes = { columns = { "solver", table.unpack(names) }, rows = exponents, formats = { "%s" } }
for k = 1, #names do sheet.formats[2 + k], slopes.formats[1 + k] = "%.3g", "%.2f" end
print(("A factorization on %d ranks; rank: what the rank with most used; model: tangent, pattern and bodies; peak: of "
  .. "rank 0 in all"):format(options.ranks))
print(sg.table(sheet))
print "\nExponents of the unknowns over the larger half of the meshes"
print(sg.table(slopes))
sg.csv.write(files "growth.csv", { columns = sheet.columns, rows = rows })
sg.csv.write(files "exponents.csv", { columns = slopes.columns, rows = exponents })

-- ── The estimate ─────────────────────────────────────────────────────────────────────────────────────────────────────

--- What a solver is expected to need, from its largest mesh: a row per number of cores.
local function estimate(solver, all)
  local last, rows = all[#all], {}
  local times, sizes = options.unknowns / last.unknowns, column(all, "unknowns")
  local function extrapolated(name) return last[name] * times ^ growth.exponent(sizes, column(all, name)) end
  local operations, factors = extrapolated "operations", extrapolated "factors"
  local rate = last.operations / last.factorization / options.ranks -- 10⁹ operations per second and core
  local beyond = options.ranks * last.rank / last.factors           -- memory over that of the factors
  for _, cores in ipairs(options.cores) do
    local seconds = operations / (rate * cores)
    rows[#rows + 1] = { solver, cores, operations / 1e3, factors / 1e3, beyond * factors / cores / 1e3,
                        last.model * times / 1e3, seconds, seconds / 0.3 }
  end
  return rows
end

local estimates = {}
for _, solver in ipairs(options.solvers) do
  local all = measured[solver]
  local counted = #all > 1 and all[#all].operations > 0 and all[#all].rank > 0
  if counted and growth.exponent(column(all, "unknowns"), column(all, "operations")) then
    table.move(estimate(solver, all), 1, #options.cores, #estimates + 1, estimates)
  end
end
if #estimates > 0 then
  local columns = { "solver", "cores", "operations", "factors", "per core", "rank 0", "whole rate", "30 %" }
  print(("\nEstimate for a factorization with %.3g unknowns, not measured"):format(options.unknowns))
  print(sg.table{ columns = columns, units = { "", "", "10¹²", "GB", "GB", "GB more", "s", "s" }, rows = estimates,
                  formats = { "%s", "%d", "%.3g", "%.3g", "%.3g", "%.3g", "%.3g", "%.3g" } })
  sg.csv.write(files "estimate.csv", { columns = columns, rows = estimates })
end

files:draw("growth.png", "two meshes", function(file)
  local chart = { file = file, log = "xy", xlabel = "unknowns", ylabel = "time of a factorization (s)",
                  title = "Factorization of the tangent of 3D ironing" }
  for _, solver in ipairs(options.solvers) do
    local all = measured[solver]
    if #all > 1 then
      chart[#chart + 1] = { x = column(all, "unknowns"), y = column(all, "factorization"), label = solver,
                            markers = true }
    end
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end)
files:report()

return { rows = rows, exponents = exponents, estimates = estimates, files = files }
