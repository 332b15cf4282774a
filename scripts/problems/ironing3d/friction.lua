-- The variant with friction: composition of the drag, and energy balance. Without friction the mean drag over one
-- element pitch in the slab's middle is zero, so all of it is oscillation.

local sg = require "signorini"
local output = require "problems.ironing3d.output"
local problem = require "problems.ironing3d.problem"

local friction = {}

--- The energy balance of a model: its parts, and the error as a fraction of the work.
local function balance(model)
  local energy = model:energy()
  energy.missing = energy.work - energy.stored - energy.contact - energy.friction
  energy.leak = energy.missing / energy.work
  return energy
end

--- Runs a case along the middle of the slab; adds `energies`, one balance per step of the run, and ratio, the mean of
--- Px over that of Pz in the last pitch of the slab's elements.
function friction.solve(case)
  case.from, case.energies = 50 - case.distance / 2, {}
  case.on_step = function(model) table.insert(case.energies, balance(model)) end
  problem.solve(case)
  local pitch, finish, Px, Pz = 100 / problem.meshes[case.mesh].slab[1], case.x[#case.x], 0, 0
  for i, x in ipairs(case.x) do
    if x > finish - pitch + 1e-9 then Px, Pz = Px + case.Px[i], Pz + case.Pz[i] end
  end
  case.ratio = Pz > 0 and Px / Pz or nil
  case.energy = case.energies[#case.energies] or balance(case.model)
  return case
end

local function result_table(cases)
  local rows = {}
  for i, case in ipairs(cases) do
    local energy, run = case.energy, case.run
    rows[i] = { case.order, case.mu, #case.x, run.iterations, run.cutbacks, case.pressed, case.Pz[#case.Pz], case.ratio,
                energy.work, energy.stored, energy.friction, energy.contact, energy.leak }
  end
  return sg.table{
    columns = { "order", "mu", "slide", "iterations", "cut-backs", "Pz", "Pz", "Px/Pz", "work", "stored", "friction",
                "contact", "missing" },
    units = { "", "", "steps", "", "", "pressed", "at the end", "last pitch", "", "", "", "", "of work" }, rows = rows,
    formats = { "%s", "%.2f", "%d", "%d", "%d", "%.3f", "%.3f", "%.4f", "%.4f", "%.4f", "%.4f", "%.4f", "%.2e" },
  }
end

local function draw_energies(file, case)
  local chart = { file = file, xlabel = "load step", ylabel = "energy",
                  title = ("3D ironing, %s, μ = %g: energy balance"):format(case.order, case.mu) }
  for i, name in ipairs { "work", "stored", "friction", "contact" } do
    local values = {}
    for step, energy in ipairs(case.energies) do values[step] = energy[name] end
    chart[i] = { x = case.run:column "step", y = values, label = name }
  end
  if #case.energies > 0 then sg.chart(chart) end
  return #case.energies > 0
end

local function draw_ratio(file, cases)
  local chart = { file = file, xlabel = "x of the indenter's center", ylabel = "Px/Pz",
                  title = "3D ironing: drag over pressing force" }
  for _, case in ipairs(cases) do
    local ratio = {}
    for i, Px in ipairs(case.Px) do ratio[i] = Px / case.Pz[i] end
    if #ratio > 0 then
      chart[#chart + 1] = { x = case.x, y = ratio, label = ("%s, μ = %g"):format(case.order, case.mu) }
    end
  end
  if #chart > 0 then sg.chart(chart) end
  return #chart > 0
end

--- The study: each order with each mu. Returns { cases }.
function friction.run(options, files)
  local cases, radius, depth = {}, options.radius[1], problem.published_depth - options.gap[1]
  for _, order in ipairs(options.orders) do
    for _, mu in ipairs(options.mu) do
      local case = friction.solve{
        order = order, mesh = "coarse", radius = radius, depth = depth, mu = mu, distance = options.distance,
        cap = options.cap, down = problem.down / options.finer, along = problem.along / options.finer,
        penalty = options.penalty, linear = options.linear,
      }
      local name = ("%s_mu%g"):format(order, mu)
      print(("%s, mu = %g"):format(order, mu))
      print(case.run)
      case.run:csv(files(name .. ".csv"))
      files:draw(("energy_%s.png"):format(name), "an accepted step", function(file)
        return draw_energies(file, case)
      end)
      if case.mu > 0 then
        files:draw(("groove_%s.png"):format(name), "a state that slides", function(file)
          return output.draw_groove(file, case)
        end)
      end
      case.model = nil
      cases[#cases + 1] = case
    end
  end
  print(("\nR = %g, depth %g, dragged by %g through the middle: forces and energies")
    :format(radius, depth, options.distance))
  print(result_table(cases))
  files:draw("ratio.png", "a state that slides", function(file) return draw_ratio(file, cases) end)
  files:draw("forces.png", "a state that slides", function(file)
    return output.draw_forces(file, cases, "3D ironing with friction and without")
  end)
  return { cases = cases }
end

return friction
