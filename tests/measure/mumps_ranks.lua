-- Ironing on several processes: forces, times and memory of MUMPS by the number of ranks.
--
-- Problem: 3D ironing with friction (ironing3d.lua), pressed and dragged for a few steps, by the default solver and by
--          MUMPS on several ranks of mpirun. Each run is a process of its own.
-- Source: P. Amestoy, I. Duff, J.-Y. L'Excellent, J. Koster, SIAM J. Matrix Anal. Appl. 23 (2001) 15-41.
-- Units: s of wall time, MB (10⁶ bytes).
-- Expected: forces of all runs within 1e-10 of the default solver's; the memory of a rank falls with their number.
--           Times fall as long as each rank has a processor of its own.
-- Run: signorini tests/measure/mumps_ranks.lua [ranks=1,2,4] [solvers=mumps] [fineness=2] [mu=0.3] [press=2] [slide=2]
--      [mpirun=mpirun --oversubscribe] [out=out/mumps/ranks]; solvers: also umfpack, mumps-reuse,
--      mumps-low-rank, mumps-single; fineness: multiplies the elements of the mesh coarse per direction; press, slide:
--      steps; mpirun: its command, used for more than one rank (as root also --allow-run-as-root).
--      signorini tests/measure/mumps_ranks.lua once=FILE solvers=mumps … makes one run and writes it to a file.

local sg = require "signorini"
local ironing = require "mumps.ironing"

local solvers = { "auto", "umfpack", "mumps", "mumps-reuse", "mumps-low-rank", "mumps-single" }
local options = sg.arguments{
  ranks = { { 1, 2, 4 }, at_least = 1 }, solvers = { { "mumps" }, choices = solvers },
  fineness = { 2.0, at_least = 0.5 }, mu = { 0.3, at_least = 0 }, press = { 2, at_least = 1 },
  slide = { 2, at_least = 1 }, mpirun = "mpirun --oversubscribe", out = "out/mumps/ranks", once = "",
}

if options.once ~= "" then
  local solver, model = ironing.solvers[options.solvers[1]], ironing.scene(options.fineness, options.mu)
  local run = model:run({ { name = "press", steps = options.press, grip = { 0, 0, -0.2 * options.press } },
                          { name = "slide", steps = options.slide,
                            grip = { 0.3 * options.slide, 0, -0.2 * options.press } } },
    sg.plain{ linear = solver.linear, mumps = solver.mumps, newton = { tolerance = 1e-12 } })
  if run.failed then error(run.failure, 0) end
  local spent, count = model:timings(), model:solver()
  local results = ironing.sizes(model)
  results.fx, results.fz = run:column "grip.fx"[run.steps], run:column "grip.fz"[run.steps]
  results.wall, results.linear, results.iterations = run.wall, spent.linear, run.iterations
  results.factorizations = count.factorizations
  ironing.write(options.once, results)
  return results
end

local files, rows = sg.files(options.out), {}

--- Adds the row of a run, with its distance from `expected` forces. Returns its results.
local function measure(solver, ranks, expected)
  local results, failure = ironing.process("ranks", {
    once = options.out .. "/once.csv", solvers = solver, fineness = options.fineness, mu = options.mu,
    press = options.press, slide = options.slide,
  }, ranks > 1 and ("%s -n %d"):format(options.mpirun, ranks) or "")
  if not results then
    rows[#rows + 1] = { solver, ranks, [12] = failure }
    return nil, failure
  end
  local off = expected and math.max(math.abs(results.fx - expected.fx), math.abs(results.fz - expected.fz))
    / math.abs(expected.fz)
  rows[#rows + 1] = { solver, ranks, results.unknowns, results.iterations, results.factorizations, results.wall,
                      results.linear / results.iterations, results.factors / 1e6, results.rank / 1e6,
                      results.peak / 1e6, off }
  return results
end

local expected, failure = measure("auto", 1)
if not expected then error(failure, 0) end
for _, solver in ipairs(options.solvers) do
  for _, ranks in ipairs(options.ranks) do measure(solver, ranks, expected) end
end

local sheet = {
  columns = { "solver", "ranks", "unknowns", "iterations", "factorizations", "wall", "linear", "factors", "rank",
              "process", "off", "failed" },
  units = { "", "", "", "", "", "s", "s/iteration", "MB", "MB", "MB", "of Fz", "" }, rows = rows,
  formats = { wall = "%.2f", linear = "%.3f", factors = "%.0f", rank = "%.0f", process = "%.0f", off = "%.1e" },
}
print "Runs; factors: of all ranks; rank: what the rank with most used for a factorization; process: peak of rank 0"
print(sg.table(sheet))
sg.csv.write(files "ranks.csv", { columns = sheet.columns, rows = rows })
files:report()

return { rows = rows, files = files }
