-- The validation variant (section 6.2): forces over the steps for N2 and N4, as a whole and magnified.

local sg = require "signorini"
local page = require "page.tables"
local measure = require "problems.ironing2d.measure"
local output = require "problems.ironing2d.output"
local problem = require "problems.ironing2d.problem"

local validation = {}

--- Steps whose states are drawn: end of the pressing, middle and end of the sliding.
local picture_steps = { [10] = true, [60] = true, [110] = true, [210] = true }

--- Steps of the sliding's middle, with the die's center between x = 1.1 and x = 1.7, far from both ends of the slab.
local function middle(set_up)
  return set_up.press_steps + set_up.slide_steps * 3 // 10, set_up.press_steps + set_up.slide_steps * 6 // 10
end

local function mean(values, first, last)
  local sum = 0
  for i = first, last do sum = sum + values[i] end
  return sum / (last - first + 1)
end

--- Adds to a case its forces at the end of the pressing and their means and oscillations in the middle of the sliding.
function validation.add_forces(case, set_up)
  local run, first, last = case.run, middle(set_up)
  if run.steps < last then return end
  local Px, Py = run:column "grip.fx", run:column "grip.fy"
  for i = 1, run.steps do Py[i] = -Py[i] end
  case.pressed = { Px = Px[set_up.press_steps], Py = Py[set_up.press_steps] }
  case.mean = { Px = mean(Px, first, last), Py = mean(Py, first, last) }
  case.oscillation = { Px = measure.oscillation(Px, first, last).detrended,
                       Py = measure.oscillation(Py, first, last).detrended }
end

local function force_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local pressed, average, oscillation = case.pressed or {}, case.mean or {}, case.oscillation or {}
    rows[i] = { case.order, case.die_dofs.total + case.slab_dofs.total, case.run.iterations, case.run.cutbacks,
                pressed.Py, pressed.Px, average.Py, average.Px, case.mean and average.Px / average.Py,
                oscillation.Py, oscillation.Px }
  end
  return {
    columns = { "order", "DOFs", "iterations", "cut-backs", "Py pressed", "Px pressed", "mean Py", "mean Px",
                "Px/Py", "oscillation Py", "oscillation Px" },
    units = { "", "", "", "", "N/mm", "N/mm", "N/mm", "N/mm", "", "N/mm", "N/mm" }, rows = rows,
    formats = { "%s", "%d", "%d", "%d", "%.5f", "%.5f", "%.5f", "%.5f", "%.4f", "%.1e", "%.1e" },
  }
end

--- One force over the steps of the sliding, magnified, as in Figure 6.5 (c) to (f).
local function draw_magnified(file, cases, set_up, column, sign, name)
  local first, last = middle(set_up)
  local chart = { file = file, xlabel = "load step", ylabel = ("%s per unit depth (N/mm)"):format(name),
                  title = ("Ironing for validation: %s in the middle of the sliding"):format(name) }
  for i, case in ipairs(cases) do
    local values, steps = case.run:column(column), {}
    if #values >= last then
      for k = first, last do steps[#steps + 1], values[k] = k, sign * values[k] end
      chart[#chart + 1] = { x = steps, y = table.move(values, first, last, 1, {}), label = case.order, color = i }
    end
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

--- The whole study. Returns { mesh, cases }.
function validation.run(options, files)
  local set_up, mesh, cases = problem.variants.validation, options.mesh, {}
  local keep, draw_states = output.record_states(picture_steps)
  for i, order in ipairs(options.orders) do
    print(("%s at %s elements"):format(order, mesh))
    local case = problem.solve{ set_up = set_up, order = order, mesh = mesh, linear = options.linear,
                                step = { adaptive = true }, on_step = i == 1 and keep or nil }
    print(case.run)
    case.run:csv(files(order .. ".csv"))
    validation.add_forces(case, set_up)
    cases[i], cases[order] = case, case
  end
  local first, last = middle(set_up)
  print(("\nForces on the die; means and oscillations (max − min, detrended) over steps %d to %d; mu is %g")
    :format(first, last, set_up.mu))
  local forces = force_table(cases)
  print(sg.table(forces))
  page.fill(options, "ironing2d", "ironing2d_validation", { validation = page.pick(forces,
    { 1, 2, 5, 6, 7, 8, 9, 10, 11 }, { "discretization" }) })
  files:draw("states.png", "an accepted step", function(file)
    return draw_states(file, ("Ironing for validation, %s at %s elements"):format(options.orders[1], mesh), 2)
  end)
  files:draw("forces.png", "an accepted step", function(file)
    return output.draw_forces(file, cases, ("Ironing for validation, %s elements"):format(mesh))
  end)
  files:draw("Py.png", "runs that reach the middle of the sliding", function(file)
    return draw_magnified(file, cases, set_up, "grip.fy", -1, "pressing force Py")
  end)
  files:draw("Px.png", "runs that reach the middle of the sliding", function(file)
    return draw_magnified(file, cases, set_up, "grip.fx", 1, "drag Px")
  end)
  return { mesh = mesh, cases = cases }
end

return validation
