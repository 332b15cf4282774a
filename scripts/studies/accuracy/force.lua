-- Mean and oscillation of a force while bodies slide or peel: one definition for problems in the plane and in space.

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

return force
