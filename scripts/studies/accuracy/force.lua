-- Mean and oscillation of a force while bodies slide or peel, and the error of a pressure where they do not: one
-- definition for all problems.

local sg = require "signorini"
local measure = require "problems.ironing2d.measure"

local force = {}

--- The mean of a list of at least four values, and max − min after subtraction of their best-fit parabola.
function force.mean_and_oscillation(values)
  local sum = 0
  for _, value in ipairs(values) do sum = sum + value end
  return sum / #values, measure.oscillation(values, 1, #values).detrended
end

--- The values of a column in the last stage, from a fraction of it on; from = 0: including its first state.
function force.window(run, column, from)
  local slide = run.stages[#run.stages].steps
  return table.move(run:column(column), run.steps - slide + math.floor(from * slide + 0.5), run.steps, 1, {})
end

--- The profile of a contact as plain data.
function force.profile(model, contact)
  local profile = model:profile(contact)
  return { x = profile.x, pressure = profile.pressure, gap = profile.gap }
end

--- The L₂ error of p/max p_ref over x/a_ref in %, a_ref: where the contact of the reference ends.
function force.pressure_error(row, reference)
  local width = sg.profile_edges{ profile = reference.profile }.to
  return 100 * sg.profile_error{ profile = row.profile, reference = reference.profile, normalize = "max",
                                 coordinate = function(point) return point.x / width end }
end

return force
