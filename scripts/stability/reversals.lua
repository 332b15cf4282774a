-- Many reversals of the sliding direction: ironing back and forth, with plain Newton and with the default controls.
--
-- Problem: the die of published ironing (ironing2d.lua) is pressed by 0.1 in 20 steps and dragged by 0.5 and
--          back, in 100 steps each way, 15 times. After a step in which all points have slipped they all lie on
--          Coulomb's cone, and the first guess of the next step decides between stick and slip.
-- Source: the problem of V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for
--         Isogeometric Analysis of Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.1; the path is chosen
--         here.
-- Units: mm, N, N/mm²; Newton iterations.
-- Expected: all 15 cycles with both; the default controls take 0.68 to 0.69 times as many iterations as plain Newton,
--           no fallback, and give the same drag at the end to 1e-8.
-- Run: signorini stability/reversals.lua [cases=N2:m1,N2-N2.2:m1,N2:m2] [cycles=15] [steps=100]
--      [out=out/stability/reversals]; cases: order:mesh; steps: of each way.

local sg = require "signorini"
local ironing = require "problems.ironing2d.problem"

local function is_case(text)
  local order, mesh = text:match "^([^:]+):([^:]+)$"
  return order ~= nil and ironing.elements(mesh) ~= nil
end

local options = sg.arguments{
  cases = { { "N2:m1", "N2-N2.2:m1", "N2:m2" }, check = is_case, expected = "order:mesh, such as N2:m1" },
  cycles = { 15, at_least = 1 }, steps = { 100, at_least = 1 }, out = "out/stability/reversals",
}

local stages = { { name = "press", steps = 20, grip = { 0, -0.1 } } }
for cycle = 1, options.cycles do
  for way, x in ipairs { 0.5, 0 } do
    stages[#stages + 1] = { name = ("%s %d"):format(way == 1 and "forth" or "back", cycle), steps = options.steps,
                            grip = { x, -0.1 } }
  end
end

local columns = { "order", "mesh", "controls", "cycles", "iterations", "fallbacks", "drag", "reason" }
local results = { columns = columns, rows = {} }
for _, case in ipairs(options.cases) do
  local order, mesh = case:match "^([^:]+):([^:]+)$"
  for _, controls in ipairs { "plain", "robust" } do
    local run = ironing.solve{ set_up = ironing.variants.standard, order = order, mesh = mesh, stages = stages,
                               controls = sg[controls] }.run
    local drag = run:column "grip.fx"
    results.rows[#results.rows + 1] = { order, mesh, controls, (#run.stages - (run.failed and 2 or 1)) // 2,
                                        run.iterations, run.fallback_steps, drag[#drag], run.reason or "" }
  end
end
print(("Back and forth, %d times in %d steps each way: cycles completed, iterations, steps by fallbacks, last drag")
  :format(options.cycles, options.steps))
print(sg.table{ columns = columns, rows = results.rows, formats = { drag = "%.8f" } })

local files = sg.files(options.out)
sg.csv.write(files "reversals.csv", results)
files:report()
return { results = results, files = files }
