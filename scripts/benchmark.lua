-- What does each part of a solve cost, and how does that grow with the mesh?
--
-- Problem: ironing in the plane and in space, a few steps of sliding after a press, on meshes from coarse to fine. The
--          clock tells apart what an iteration of Newton's method consists of (bulk: bodies; contact, of which search:
--          closest points and the tree of boxes; factorisation and solution of the linear system; rest: all else) and
--          what it takes to write the state (picture, contact profile as CSV, checkpoint). Iterations are linear
--          solves; the evaluation that ends a step is shared out to them. The growth of a cost is the exponent a of
--          cost ~ DOFs^a, by least squares of the logarithms over the larger half of the meshes.
-- Source: scenes of ironing2d.lua (thesis, section 7.1) and ironing3d.lua (section 7.5). Yardsticks: 0.38 ms (FEBio)
--         and 2 ms (G+Smo) for the tangent of a solid element with 27 functions. Solved with plain Newton; steps that
--         fail are cut.
-- Units: ms per iteration, ms per file; DOFs are degrees of freedom of both bodies.
-- Expected: bulk grows in proportion to the DOFs (exponent 1), contact in the plane with the square root of the DOFs,
--           in space with their power 2/3; the factorisation with 1.5 in the plane and 2 in space in the end, less on
--           small meshes; so the linear solver takes most of the time in space.
-- Run: signorini scripts/benchmark.lua [plane=m1,m2,m3,m4,m5] [solid=sparse,coarse,middle,fine] [label=N2] [steps=3]
--      [solvers=ironing-m1,…] [repeats=3] [linear=umfpack] [element=8] [out=out/benchmark] [page=none]; steps: that are
--      timed; solvers: scenes on which the linear solvers are compared, or none;
--      repeats: passes, of which the median counts; element: elements along an edge of the block for the yardstick;
--      page: a folder with benchmark.md, whose table between two marks and charts are replaced (share/doc).

local sg = require "signorini"
local measure = require "benchmark.measure"
local growth = require "benchmark.growth"
local report = require "benchmark.report"
local solvers = require "benchmark.solvers"

local problems = measure.problems
local options = sg.arguments{
  plane = { { "m1", "m2", "m3", "m4", "m5" }, choices = problems.plane.meshes, none = true },
  solid = { { "sparse", "coarse", "middle", "fine" }, choices = problems.solid.meshes, none = true },
  solvers = { solvers.names, choices = solvers.names, none = true },
  label = "N2", steps = 3, repeats = 3, linear = { "umfpack", choices = { "auto", "klu", "umfpack", "kept" } },
  element = 8, out = "out/benchmark", page = "none",
}
local files = sg.files(options.out)

local cases, exponents = {}, {}
-- The first picture loads the renderer, the first large factorisation starts BLAS: not on the clock.
measure.case({ problem = "plane", label = "N2", mesh = "m1" },
  { steps = 1, repeats = 1, linear = "umfpack", out = options.out })
for _, name in ipairs { "plane", "solid" } do
  local sizes, costs, own = {}, {}, {}
  for i, mesh in ipairs(options[name]) do
    local case = measure.case({ problem = name, label = options.label, mesh = mesh }, options)
    own[i], cases[#cases + 1] = case, case
    if i > 1 and case.dofs <= own[i - 1].dofs then error(("%s: meshes must come in rising order"):format(name), 0) end
  end
  for i, case in ipairs(own) do sizes[i] = case.dofs end
  for _, list in ipairs { measure.accounts, measure.outputs } do
    for _, account in ipairs(list) do
      for i, case in ipairs(own) do costs[i] = case[account] end
      exponents[name] = exponents[name] or {}
      exponents[name][account] = growth.exponent(sizes, costs)
    end
  end
end
local element = measure.element(options.element, options.repeats)

local solver_sheet = solvers.sheet(options.solvers, options.repeats)

print "Time of an iteration by its parts, ms (search is part of contact); around: all but the linear solver, over it"
print(report.iteration_table(cases))
print "\nTime to write a state, ms"
print(report.output_table(cases))
print "\nGrowth: exponent of the degrees of freedom over the larger half of the meshes"
print(report.growth_table(exponents))
print(("\nTangent of a solid element with 27 functions: %.4f ms (FEBio 0.38, G+Smo 2)"):format(element))

print "\nSeconds of processor time in the linear solver"
print(sg.table(solver_sheet))

sg.csv.write(files "benchmark.csv", report.sheet(cases, options))
sg.csv.write(files "growth.csv", report.growth_sheet(exponents))
for _, chart in ipairs(report.charts) do
  files:draw(chart.file, "two meshes of " .. chart.needs, function(file) return chart.draw(file, cases) end)
end
if options.page ~= "none" then report.page(options.page, cases, exponents, element, solver_sheet) end
for _, name in ipairs { "state.png", "state.csv", "state.sgn" } do os.remove(options.out .. "/" .. name) end
files:report()

return { cases = cases, exponents = exponents, element = element, solvers = solver_sheet }
