-- Peeling of an adhesive strip (peeling2d.lua), of which 50 of 60 nm are bonded, to 47°: the steady moment from 36° on.
-- Plain Newton goes on with arc length where the prescribed rotation fails.

local force = require "studies.accuracy.force"
local problem = require "problems.peeling2d.problem"
local settings = require "studies.accuracy.settings"

local peeling = {
  name = "peeling", title = "Peeling", unit = "E_0 L_0^3",
  force = "moment", second = { "oscillation", "oscillation of the moment (% of its mean)" },
}

function peeling.scene(o)
  local model = problem.scene(o.order, o.mesh, o.long and 120 or 60, o.long and 110 or 50,
    o.thickness_degree or math.tointeger(o.order:match "%d"))
  local angle = 47
  return model, { { name = "rotate", steps = settings.steps(o, angle / problem.pitch), edge = angle } },
    function(run)
      local angles, moments, inside = run:column "edge.angle", run:column "edge.moment", {}
      local whole = run:column "step"
      for i, value in ipairs(angles) do
        if value > 36 and whole[i] == math.floor(whole[i]) then
          inside[#inside + 1] = moments[i] / problem.moment_unit
        end
      end
      local mean, oscillation = force.mean_and_oscillation(inside)
      return { force = mean, oscillation = 100 * oscillation / math.abs(mean) }
    end, { newton = { iterations = 30 }, arc_length = o.arc,
           adapt = o.follow and { tolerance = 0.3, margin = 2, every = 10 } or nil }
end

peeling.meshes = { "m0", "m1", "m2" }
peeling.series = {
  { "default", "L1", "L2", "N2", "N3", "N2-N2.1", "N2-N2.2" }, { "published", "N2", "N2-N2.2" },
  { "following layer", "N2-N2.2" },
}
peeling.affordable = function(order, mesh) return mesh ~= "m2" or order ~= "N3" and order ~= "L2" end
peeling.once = { m0 = true, m1 = true, m2 = true }
peeling.reference = { order = "N2-N2.2", setting = "default", mesh = "m3" }
peeling.checks = { { order = "N2-N2.2", setting = "default", mesh = "m2" },
                   { order = "N2-N2.1", setting = "default", mesh = "m2" } }
peeling.base = { order = "N2-N2.2", setting = "default", mesh = "m0" }
peeling.levers = { "longer strip", "m1", "N2", "N3", "N2-N2.1", "following layer", "thickness degree 1",
                   "half the steps" }

return peeling
