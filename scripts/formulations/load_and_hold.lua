-- Load and hold with friction by formulation: creep of force and slip while nothing moves, and halving of steps.
--
-- Problem: ironing2d.lua: a stiff half ring is pressed into a slab and dragged along it, with friction. Then it is held
--          for many steps in which nothing moves, so that nothing should change.
--
--              (   )        die: half annulus, radii 0.3 and 0.5, E = 1000, both flat ends driven: pressed by 0.23,
--        _______\_/_______   dragged by 0.3, held for 50 steps
--       |   ------->      |
--       |  slab: 3 × 1, E = 1, bottom clamped; plane strain, neo-Hooke, nu = 0.3, mu = 0.2, both penalties 100
--
--          Creep: the largest change of a force during the hold, relative to its value before; that of the first step
--          and that of all following ones. Moved: the largest displacement of a contact point during the hold. Step:
--          the drag at the end of the slide with twice as many steps, relative difference, and the order of convergence
--          from three numbers of steps.
-- Source: of the scene: V. Agrawal, An
--         Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of Contact
--         Problems, PhD thesis, IIT Guwahati, 2020, section 7.1.
-- Units: mm, N, N/mm².
-- Expected: no creep with mortar (below 1e-8), and the same drag for any step. With Gauss points the first step of the
--           hold changes the forces by 4e-5, the residual that slip on a curved master leaves ("Coulomb friction" in
--           share/doc/reference/theory.md), of first order in the step; the others nothing. Two half passes change by
--           5e-3 in the first step and creep by 8e-5 in the others.
-- Run: signorini -q formulations/load_and_hold.lua [orders=N2,N2-N2.2] [formulations=…] [mesh=m1]
--      [steps=25,50,100] [hold=50] [out=out/formulations/load_and_hold]; steps: of the slide, the press takes half as
--      many.

local sg = require "signorini"
local chart = require "formulations.chart"
local formulations = require "formulations.rows"
local ironing = require "problems.ironing2d.problem"

local options = sg.arguments{
  orders = { "N2", "N2-N2.2" }, formulations = formulations.argument(formulations.names), mesh = ironing.meshes "m1",
  steps = { { 25, 50, 100 }, at_least = 2 }, hold = { 50, at_least = 2 }, out = "out/formulations/load_and_hold",
}
local set_up, distance = ironing.variants.standard, 0.3

-- ── Solving ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The largest distance between the points of two profiles in contact.
local function largest_move(before, after)
  local largest = 0
  for i, area in ipairs(before.area) do
    if area > 0 then
      largest = math.max(largest, math.sqrt((after.x[i] - before.x[i]) ^ 2 + (after.y[i] - before.y[i]) ^ 2))
    end
  end
  return largest
end

--- The largest relative changes of a force from one step to another: after the first step of the hold, and from there.
local function creep(force, from)
  local first, later = math.abs(force[from + 1] / force[from] - 1), 0
  for i = from + 2, #force do later = math.max(later, math.abs(force[i] / force[from + 1] - 1)) end
  return first, later
end

--- Solves a case { order, formulation, steps }; adds drag and pressing force at the end of the slide, creep, moved; or
--- reason if it failed.
local function solve(case)
  local steps = case.steps
  local press, slide = { 0, -set_up.depth }, { distance, -set_up.depth }
  local before
  local solved = ironing.solve{
    set_up = set_up, order = case.order, mesh = options.mesh, formulation = case.formulation,
    step = { adaptive = true },
    stages = { { name = "press", steps = math.ceil(steps / 2), grip = press },
               { name = "slide", steps = steps, grip = slide }, { name = "hold", steps = options.hold, grip = slide } },
    on_step = function(model, info)
      if info.stage == "slide" then before = model:profile "interface" end
    end,
  }
  local run = solved.run
  case.iterations = run.iterations
  if run.failed then
    case.reason = run.cause or run.reason
    return case
  end
  local fx, fy, from = run:column "grip.fx", run:column "grip.fy", #run:column "grip.fx" - options.hold
  case.drag, case.press = fx[from], fy[from]
  local first_x, later_x = creep(fx, from)
  local first_y, later_y = creep(fy, from)
  case.first, case.later = math.max(first_x, first_y), math.max(later_x, later_y)
  case.moved = largest_move(before, solved.model:profile "interface")
  return case
end

--- One row per order and formulation: cases by number of steps.
local series = {}
for _, order in ipairs(options.orders) do
  for _, formulation in ipairs(formulations.of(options.formulations)) do
    local one = { order = order, formulation = formulation }
    for i, steps in ipairs(options.steps) do
      one[i] = solve{ order = order, formulation = formulation, steps = steps }
      collectgarbage() -- Lua does not count the memory of models
    end
    series[#series + 1], series[order .. " " .. formulation.name] = one, one
  end
end

-- ── Output ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local rows, data = {}, { columns = { "order", "formulation", "steps", "drag", "press", "first", "later", "moved" },
                         rows = {} }
for _, one in ipairs(series) do
  for i, case in ipairs(one) do
    local finer, finest = one[i + 1], one[i + 2]
    if case.drag and finer and finer.drag then
      case.change = math.abs(case.drag / finer.drag - 1)
      if finest and finest.drag then
        case.rate = math.log(math.abs((case.drag - finer.drag) / (finer.drag - finest.drag)))
                  / math.log(finer.steps / case.steps)
      end
    end
    rows[#rows + 1] = { case.order, case.formulation.label, case.steps, case.drag, case.first, case.later, case.moved,
                        case.change, case.rate, case.iterations, case.reason }
    data.rows[#data.rows + 1] = { case.order, case.formulation.name, case.steps, case.drag, case.press, case.first,
                                  case.later, case.moved }
  end
end
print(("Load and hold, %s: change of the forces in the first of %d steps without motion and in the others")
  :format(options.mesh, options.hold))
print(sg.table{
  columns = { "order", "formulation", "steps", "drag", "first", "later", "moved", "halved", "rate", "iterations",
              "failed" },
  units = { "", "", "of the slide", "N/mm", "", "", "mm", "of the drag", "", "", "" }, rows = rows,
  formats = { drag = "%.6f", first = "%.1e", later = "%.1e", moved = "%.1e", halved = "%.1e", rate = "%.1f" } })

local files = sg.files(options.out)
sg.csv.write(files "hold.csv", data)
for _, order in ipairs(options.orders) do
  chart(files, order .. "_steps.png", formulations.of(options.formulations), options.steps,
    function(formulation, i) return series[order .. " " .. formulation.name][i].change end,
    { log = "xy", xlabel = "steps of the slide", ylabel = "change of the drag by halved steps",
      title = ("Ironing with friction, %s at %s: halved steps"):format(order, options.mesh) })
end
files:report()

return { series = series, files = files }
