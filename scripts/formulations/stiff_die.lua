-- Ironing without the error of a penalty: multipliers on a stiff die or on the soft slab below it.
--
-- Problem: the half ring of ironing2d.lua, variant validation, is pressed into a slab and dragged along it; mortar
--          contact with multipliers and default controls. Rows: slabs, dies, and which of the two is the slave.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 6.2, for the problem.
-- Units: mm, N, N/mm²; times in s of the processor.
-- Expected: 3.1 to 4 iterations per step without cuts on slabs of 24 × 6 and 32 × 8 elements, for all dies and either
--           slave. Px and Py approach 0.01595 and 0.0550.
-- Run: signorini formulations/stiff_die.lua [orders=N2-N2.2] [slabs=24,32,48] [dies=9,12,18,24,36]
--      [slaves=die,slab] [steps=110] [out=out/formulations/stiff_die]; slabs: elements along the slab, a fourth of them
--      across; dies: elements along the die, 2 across; steps: a multiple of 11, 1 to press and 10 to slide.

local sg = require "signorini"
local measure = require "problems.ironing2d.measure"
local problem = require "problems.ironing2d.problem"

local options = sg.arguments{
  orders = { "N2-N2.2" }, slabs = { { 24, 32, 48 }, at_least = 8 }, dies = { { 9, 12, 18, 24, 36 }, at_least = 2 },
  slaves = { { "die", "slab" }, choices = { "die", "slab" } }, steps = { 110, at_least = 11 },
  out = "out/formulations/stiff_die",
}
if options.steps % 11 ~= 0 then error(("steps=%d: not a multiple of 11"):format(options.steps), 0) end
local files = sg.files(options.out)
local press, slide = options.steps // 11, options.steps // 11 * 10

--- A run's row: iterations, means and detrended oscillations (in % of them) from 30 to 80 % of the slide.
local function row_of(order, slab, die, slave)
  local set_up = {}
  for key, value in pairs(problem.variants.validation) do set_up[key] = value end
  set_up.press_steps, set_up.slide_steps = press, slide
  local model = problem.scene(set_up, order, { die = { die, 2 }, slab = { slab, slab // 4 } }, nil, 2, {
    formulation = { keys = { method = "mortar", enforcement = "multipliers" }, swapped = slave == "slab" },
  })
  local began = os.clock()
  local run = model:run(problem.path(set_up, 1))
  local row = { order, slab, die, slave, run.iterations / math.max(1, run.steps), run.cutbacks, os.clock() - began }
  local first, last = press + math.ceil(0.3 * slide), press + math.floor(0.8 * slide)
  for i, name in ipairs { "grip.fx", "grip.fy" } do
    local values, sum = run:column(name), 0
    if #values >= last then
      for k = first, last do sum = sum + values[k] / (last - first + 1) end
      local oscillation = measure.oscillation(values, first, last).detrended
      row[7 + i], row[9 + i] = math.abs(sum), oscillation and 100 * oscillation / math.abs(sum)
    end
  end
  return row
end

local rows = {}
for _, order in ipairs(options.orders) do
  for _, slab in ipairs(options.slabs) do
    for _, slave in ipairs(options.slaves) do
      for _, die in ipairs(options.dies) do rows[#rows + 1] = row_of(order, slab, die, slave) end
    end
  end
end
print(sg.table{
  columns = { "order", "slab", "die", "slave", "iterations", "cuts", "time", "Px", "Py", "osc. Px", "osc. Py" },
  units = { "", "", "", "", "per step", "", "s", "N/mm", "N/mm", "%", "%" }, rows = rows,
  formats = { "%s", "%d", "%d", "%s", "%.2f", "%d", "%.2f", "%.5f", "%.5f", "%.2f", "%.2f" },
})
sg.csv.write(files "stiff_die.csv", {
  columns = { "order", "slab", "die", "slave", "iterations", "cuts", "time", "Px", "Py", "osc_Px", "osc_Py" },
  comments = { "forces in N/mm, oscillations in % of the mean, processor time in s" }, rows = rows })
files:report()
return { rows = rows, files = files }
