-- Peeling of an adhesive strip: the oscillation of the moment in 120° to 140° (peeling2d/measure.lua). Runs end there,
-- ten degrees before those of peeling2d.lua. "N2-N2.2 following" has its layer at the peeling front only.

local measure = require "problems.peeling2d.measure"
local problem = require "problems.peeling2d.problem"
local timed = require "studies.speed_against_accuracy.timed"
local way_of = require "studies.speed_against_accuracy.ways"

local window = { 120, 140 }
local ways = { following = { adapt = { tolerance = 0.3, margin = 2, every = 10 } } }

return {
  name = "peeling", title = "Peeling", page = "peeling2d.md",
  about = [[
A strip that adheres to a flat substrate is peeled off by rotating its end to 140° in 1400 steps, with arc length where
rotation control fails. The exact moment is constant from 120° to 140°, so the error is its oscillation. "Following":
the layer is at the peeling front only, `adapt = { tolerance = 0.3, margin = 2, every = 10 }`.]],
  orders = { "N2", "N4", "N2-N4", "N2-N2.1", "N2-N2.1 following", "N2-N2.2", "N2-N2.2 following", "N2-N2.2x2" },
  meshes = { "m0", "m1", "m2", "m3" }, rounds = 1,
  -- N2 needs m3 for the error of N2-N2.2 at m0; the others are not needed on m3.
  affordable = function(order, mesh) return mesh ~= "m3" or order == "N2" end,
  errors = { { name = "dM", title = "oscillation of the moment", unit = "E0 L0³",
               of = function(row) return measure.window(row, window).oscillation end } },
  savings = {},

  run = function(case)
    local order, way = way_of(case.order, ways)
    local solved, spent = timed(function()
      return problem.solve(order, case.mesh, {
        length = problem.length, bonded = problem.bonded, steps = math.floor(window[2] / problem.pitch + 0.5),
        control = "arc", iterations = 30, adapt = way.adapt,
      })
    end)
    local last = solved.arc or solved.rotation
    return { wall = spent.wall, cpu = spent.cpu, iterations = solved.iterations,
             dofs = solved.model:body("strip"):dofs().total, -- at the end
             step = solved.step, angle = solved.angle, moment = solved.moment,
             failed = last.failed, reason = last.failed and last.failure or nil }
  end,
}
