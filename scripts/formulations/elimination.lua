-- Elimination of Lagrange multipliers: time of the linear solver with multipliers as unknowns, by solver, next to the
-- same contact with a penalty, whose systems have no multipliers.
--
-- Problem: problems=hertz: line contact, linear elastic (hertz2d.lua); plane: ironing with friction, the slab as slave
--          (ironing2d.lua, the first part of its path); solid: 3D ironing with friction (ironing3d.lua, pressing and
--          the begin of the slide); all with N2-N2.2 and equal multipliers, solid with N2 and reduced ones.
--
--            K  Bᵀ   klu, umfpack: factors the whole matrix, multipliers included
--            B  0    condensed: K₀ of linear elastic bodies is factored once, then a dense system of contact unknowns
--                      and multipliers
--                    reuse: the same condensation of an earlier tangent as preconditioner of GMRES
--            K + ε_N BᵀB   without multipliers (penalty): no elimination, also that by dual multipliers, leaves fewer
--                      entries, since those of the slave and the master are coupled as well
--
-- Source: B. Wohlmuth, SIAM J. Numer. Anal. 38 (2000) on dual multipliers; A. Seitz and others, CMAME 301 (2016) with
--         NURBS; share/doc/develop/benchmark.md on the solvers.
-- Units: times in ms of processor time.
-- Expected: the fastest solver takes 1.1 to 1.7 times as long per iteration with multipliers as with a penalty.
-- Run: signorini -q formulations/elimination.lua [problems=hertz,plane,solid] [meshes=m1,m2,m3,m4]
--      [solids=sparse,coarse] [solvers=auto,klu,umfpack,reuse,condensed] [rounds=3] [out=out/formulations/elimination]

local sg = require "signorini"
local formulations = require "formulations.rows"
local hertz = require "problems.hertz2d.problem"
local plane = require "problems.ironing2d.problem"
local solid = require "problems.ironing3d.problem"

local names = { "hertz", "plane", "solid" }
local solvers = { "auto", "klu", "umfpack", "reuse", "condensed" }
local options = sg.arguments{
  problems = { names, choices = names }, meshes = plane.meshes{ "m1", "m2", "m3", "m4" },
  solids = { { "sparse", "coarse" }, choices = solid.mesh_names }, solvers = { solvers, choices = solvers },
  rounds = { 3, at_least = 1 }, out = "out/formulations/elimination",
}

-- ── The problems ─────────────────────────────────────────────────────────────────────────────────────────────────────

local equal = { penalty = formulations.equal, multipliers = formulations["equal-multipliers"] }
local swapped = { penalty = formulations.equal, multipliers = formulations["equal-multipliers-swapped"] }
local reduced = { penalty = formulations.reduced, multipliers = formulations["reduced-multipliers"] }

--- Of each: the meshes, the formulations, and solve(mesh, formulation, linear), which returns the run.
local problems = {
  hertz = {
    meshes = options.meshes, pair = equal,
    solve = function(mesh, formulation, linear)
      local model, stage = hertz.scene{ order = "N2-N2.2", mesh = mesh, load = "displacement", penalty = 1e5,
                                        formulation = formulation }
      stage.steps = 10
      return model:run({ stage }, sg.plain{ linear = linear, step = { adaptive = true } })
    end,
  },
  plane = {
    meshes = options.meshes, pair = swapped,
    solve = function(mesh, formulation, linear)
      local set_up = plane.variants.standard
      return plane.solve{ set_up = set_up, order = "N2-N2.2", mesh = mesh, formulation = formulation,
                          swap = formulation == equal.penalty, linear = linear, step = { adaptive = true },
                          stages = { { name = "press", steps = 46, grip = { 0, -set_up.depth } },
                                     { name = "slide", steps = 20, grip = { 0.12, -set_up.depth } } } }.run
    end,
  },
  solid = {
    meshes = options.solids, pair = reduced,
    solve = function(mesh, formulation, linear)
      return solid.solve{ order = "N2", mesh = mesh, radius = 7.5, depth = 5.4, mu = 0.3, from = 47.3, distance = 3,
                          formulation = formulation, linear = linear }.run
    end,
  },
}

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Milliseconds per iteration of a run in the linear solver.
local function measure(run)
  if run.failed then return nil, run.cause or run.reason end
  return 1e3 * run.timings.linear / run.iterations, nil, run
end

local files, rows = sg.files(options.out), {}
for _, name in ipairs(options.problems) do
  local problem = problems[name]
  for _, mesh in ipairs(problem.meshes) do
    for _, enforcement in ipairs { "multipliers", "penalty" } do
      for _, linear in ipairs(options.solvers) do
        if linear ~= "condensed" or name == "hertz" then
          local times, failure, last = {}, nil, nil
          for i = 1, options.rounds do
            times[i], failure, last = measure(problem.solve(mesh, problem.pair[enforcement], linear))
            collectgarbage() -- Lua does not count the memory of models
          end
          table.sort(times)
          rows[#rows + 1] = { name, mesh, enforcement, linear, times[(#times + 1) // 2],
                              last and last.iterations / last.steps, failure }
        end
      end
    end
  end
end
local columns = { "problem", "mesh", "enforcement", "solver", "linear", "iterations", "failed" }
print "Time of the linear solver per iteration, multipliers as unknowns and a penalty"
print(sg.table{ columns = columns, units = { "", "", "", "", "ms per iteration", "per step", "" }, rows = rows,
                formats = { linear = "%.3f", iterations = "%.2f" } })
sg.csv.write(files "elimination.csv", { columns = columns, rows = rows })
files:report()

return { rows = rows, files = files }
