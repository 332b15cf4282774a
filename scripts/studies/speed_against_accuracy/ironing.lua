-- Ironing in the plane: detrended oscillation of both forces while the die slides (ironing2d/measure.lua).

local measure = require "problems.ironing2d.measure"
local problem = require "problems.ironing2d.problem"
local timed = require "studies.speed_against_accuracy.timed"

--- The detrended oscillation of a force of a row.
local function oscillation(force) return function(row) return measure.oscillation(row[force]).detrended end end

return {
  name = "ironing", title = "Ironing", page = "ironing2d.md",
  about = [[
A stiff half ring is pressed into a soft slab in 46 steps and dragged along it in 250, with friction. The exact forces
are nearly constant during sliding, so the error is the oscillation over one element of m1 in the slab's middle, minus
the best-fit parabola.]],
  orders = { "N2", "N4", "N2-N4", "N2-N2.1", "N2-N2.2", "N2-N2.2x2" },
  meshes = { "m1", "m2", "m3", "m4" }, rounds = 3,
  once = { m4 = true }, -- long runs, on which disturbances have little effect
  errors = {
    { name = "dPx", title = "oscillation of the drag", unit = "N/mm", of = oscillation "Px" },
    { name = "dPy", title = "oscillation of the pressing force", unit = "N/mm", of = oscillation "Py" },
  },
  savings = { -- section 7.1.3
    { "N2-N2.2", "m1", "N2", "m3", 56.62 }, { "N2-N2.2", "m2", "N2", "m4", 72.78 },
    { "N2-N4", "m1", "N4", "m1", 33.74 }, { "N2-N4", "m4", "N4", "m4", 52.44 },
  },
  saved_in = "section 7.1.3",

  run = function(case)
    local solved, spent = timed(function()
      return problem.solve{ set_up = problem.variants.standard, order = case.order, mesh = case.mesh }
    end)
    local run = solved.run
    return { wall = spent.wall, cpu = spent.cpu, iterations = run.iterations,
             dofs = solved.die_dofs.total + solved.slab_dofs.total,
             Px = run:column "grip.fx", Py = run:column "grip.fy",
             failed = run.failed, reason = run.failed and run.failure or nil }
  end,
}
