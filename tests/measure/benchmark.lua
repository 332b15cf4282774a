-- Cost of each part of a solution, and its growth with the mesh.
--
-- Problem: ironing in 2D and in 3D: a few sliding steps after pressing, on meshes from coarse to fine. The time of a
--          Newton iteration is divided into bulk (bodies), contact (of which search: closest-point projection and
--          bounding-box tree), factorization and solution of the linear system, and rest. The times to write a state
--          are also measured (picture, contact profile as CSV, checkpoint). An iteration is one linear solve; the
--          residual evaluation that ends a step is divided among its iterations. Memory is that of the model and the
--          factors. The growth of a cost is the exponent a of cost ~ DOFs^a, a least-squares fit of the logarithms over
--          the larger half of the meshes.
-- Source: models of ironing2d.lua (thesis, section 7.1) and ironing3d.lua (section 7.5). Reference values: 0.38 ms
--         (FEBio) and 2 ms (G+Smo) for the tangent of a solid element with 27 functions. Plain Newton; failed steps are
--         cut.
-- Units: ms per iteration, ms per file, MB; degrees of freedom (DOFs) of both bodies.
-- Expected: bulk grows in proportion to the DOFs (exponent 1); contact with the square root of the DOFs in 2D and with
--           their power 2/3 in 3D; factorization asymptotically with the exponent 1.5 in 2D and 2 in 3D, less on small
--           meshes and where a factorization serves several tangents. The linear solver therefore takes most of the
--           time in 3D.
-- Run: signorini tests/measure/benchmark.lua [plane=m1,m2,m3,m4,m5] [solid=sparse,coarse,middle,fine] [order=N2]
--      [steps=3] [solvers=ironing-m1,…] [repeats=3] [linear=auto] [element=8] [out=out/benchmark] [page=none]; solid:
--      also finest, with 62,058 unknowns, which takes minutes per pass; steps: timed steps; solvers: models on which
--      the linear solvers are compared, or none, also square-220, solid-15k, solid-60k and solid-100k, which take
--      minutes each; repeats: passes, of which the median counts, but one if it takes more than a minute; element:
--      elements along an edge of the block for the reference value; page: folder with benchmark.md, whose generated
--      tables and charts are replaced (share/doc/develop).

local sg = require "signorini"
local measure = require "benchmark.measure"
local growth = require "benchmark.growth"
local report = require "benchmark.report"
local solvers = require "benchmark.solvers"

local problems = measure.problems
local options = sg.arguments{
  plane = { { "m1", "m2", "m3", "m4", "m5" }, choices = problems.plane.meshes, none = true },
  solid = { { "sparse", "coarse", "middle", "fine" }, choices = problems.solid.meshes, none = true },
  solvers = { solvers.usual, choices = solvers.names, none = true },
  order = "N2", steps = 3, repeats = 3, linear = { "auto", choices = { "auto", "klu", "umfpack", "reuse" } },
  element = 8, out = "out/benchmark", page = "none",
}
local files = sg.files(options.out)

local cases, exponents = {}, {}
-- Warm-up: the first picture loads the renderer, the first large factorization starts BLAS.
measure.case({ problem = "plane", order = "N2", mesh = "m1" },
  { steps = 1, repeats = 1, linear = options.linear, out = options.out })
for _, name in ipairs { "plane", "solid" } do
  local sizes, costs, own = {}, {}, {}
  for i, mesh in ipairs(options[name]) do
    local case = measure.case({ problem = name, order = options.order, mesh = mesh }, options)
    own[i], cases[#cases + 1] = case, case
    if i > 1 and case.dofs <= own[i - 1].dofs then error(("%s: meshes must be in increasing order"):format(name), 0) end
  end
  for i, case in ipairs(own) do sizes[i] = case.dofs end
  for _, list in ipairs { measure.accounts, measure.sizes, measure.outputs } do
    for _, account in ipairs(list) do
      for i, case in ipairs(own) do costs[i] = case[account] end
      exponents[name] = exponents[name] or {}
      exponents[name][account] = growth.exponent(sizes, costs)
    end
  end
end
local element = measure.element(options.element, options.repeats)

local compiled = {}
for i, kind in ipairs(measure.elements) do
  compiled[i] = { kind.name, measure.formula_ratio(kind, 10 * options.repeats + 1) }
end

local solver_sheet = solvers.sheet(options.solvers, options.repeats)

print "Time of an iteration by part, ms (search is part of contact); around: all other parts / linear solver"
print(report.iteration_table(cases))
print "\nTime to write a state, ms"
print(report.output_table(cases))
print "\nGrowth: exponent of the degrees of freedom over the larger half of the meshes"
print(report.growth_table(exponents))
print(("\nTangent of a solid element with 27 functions: %.4f ms (FEBio 0.38, G+Smo 2)"):format(element))

print "\nTime of assembly with neo-Hooke as a formula (sg.hyperelastic) / with sg.neo_hookean"
print(sg.table{ columns = { "elements", "ratio" }, rows = compiled, formats = { "%s", "%.2f" } })

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
