-- Slave and master swapped by formulation: how much the forces of ironing depend on the choice, over meshes.
--
-- Problem: ironing2d.lua: a half ring is pressed into a slab and dragged along it, with friction, once with the die and
--          once with the slab as slave.
--
--              (   )        die: half annulus, radii 0.3 and 0.5, E = 1000, both flat ends driven: pressed by 0.23 in
--        _______\_/_______   23 steps, dragged by 0.4 in 40 steps
--       |   ------->      |
--       |  slab: 3 × 1, E = 1, bottom clamped; plane strain, neo-Hooke, nu = 0.3, mu = 0.2, both penalties 100
--
--          Difference: the root mean square over the slide of the difference of a force, relative to that of the force.
-- Source: R. A. Sauer and L. De Lorenzis, CMAME 253 (2013) and IJNME 101 (2015) on unbiased contact; the scene: V.
--         Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.1.
-- Units: mm, N, N/mm².
-- Expected: no difference for two half passes. Otherwise the difference falls with the mesh, to a rest that is due to
--           the penalty. With the slab as slave its elements are as long as the contact (m1) or half as long (m2),
--           which mortar, with as few multipliers, resolves less than Gauss points.
-- Run: signorini -q formulations/swapped_faces.lua [orders=N2,N2-N2.2] [meshes=m1,m2,m3] [formulations=…]
--      [out=out/formulations/swapped_faces]

local sg = require "signorini"
local chart = require "formulations.chart"
local formulations = require "formulations.rows"
local ironing = require "problems.ironing2d.problem"

local options = sg.arguments{
  orders = { "N2", "N2-N2.2" }, meshes = ironing.meshes{ "m1", "m2", "m3" },
  formulations = formulations.argument(formulations.names), out = "out/formulations/swapped_faces",
}
local set_up = ironing.variants.standard
local press = { name = "press", steps = 23, grip = { 0, -set_up.depth } }
local slide = { name = "slide", steps = 40, grip = { 0.4, -set_up.depth } }

--- The forces during the slide, or nil and why it failed.
local function forces(case, swap)
  local run = ironing.solve{ set_up = set_up, order = case.order, mesh = case.mesh, formulation = case.formulation,
                             swap = swap, step = { adaptive = true }, stages = { press, slide } }.run
  if run.failed then return nil, run.cause or run.reason end
  case.iterations = (case.iterations or 0) + run.iterations
  local function slid(column) return table.move(run:column(column), press.steps + 1, run.steps, 1, {}) end
  return { slid "grip.fx", slid "grip.fy" }
end

--- The root mean square of a − b over that of a.
local function difference(a, b)
  local sum, size = 0, 0
  for i, value in ipairs(a) do sum, size = sum + (value - b[i]) ^ 2, size + value ^ 2 end
  return math.sqrt(sum / size)
end

local cases, rows = {}, {}
for _, order in ipairs(options.orders) do
  for _, formulation in ipairs(formulations.of(options.formulations)) do
    for _, mesh in ipairs(options.meshes) do
      local case = { order = order, formulation = formulation, mesh = mesh }
      local one, other
      one, case.reason = forces(case, false)
      if one then other, case.reason = forces(case, true) end
      if other then case.drag, case.press = difference(one[1], other[1]), difference(one[2], other[2]) end
      cases[#cases + 1], cases[("%s %s %s"):format(order, mesh, formulation.name)] = case, case
      rows[#rows + 1] = { order, formulation.label, mesh, case.drag, case.press, case.iterations, case.reason }
      collectgarbage() -- Lua does not count the memory of models
    end
  end
end
print "Slave and master swapped in ironing with friction: relative difference of the forces"
print(sg.table{ columns = { "order", "formulation", "mesh", "drag", "press", "iterations", "failed" }, rows = rows,
                formats = { drag = "%.1e", press = "%.1e" } })

local files, ticks, numbers = sg.files(options.out), {}, {}
sg.csv.write(files "swapped.csv", { columns = { "order", "formulation", "mesh", "drag", "press", "iterations",
                                                "failed" }, rows = rows })
for i, mesh in ipairs(options.meshes) do ticks[i], numbers[i] = { i, mesh }, i end
for _, order in ipairs(options.orders) do
  chart(files, order .. ".png", formulations.of(options.formulations), numbers,
    function(formulation, i) return cases[("%s %s %s"):format(order, options.meshes[i], formulation.name)].drag end,
    { log = "y", xlabel = "mesh", xticks = ticks, ylabel = "relative difference of the drag",
      title = ("Ironing with friction, %s: slave and master swapped"):format(order) })
end
files:report()

return { cases = cases, files = files }
