-- A search for the values of parameters with the least merit. Each move is the best one of a model of the results
-- within a box, the trust region; it counts only by what the results of a run at its end say, since slopes hold between
-- kinks alone. Gradients of contact are exact, but one point that begins to slip changes them.

local parameters = require "signorini.inverse.parameters"
local progress = require "signorini.run.progress"
local vectors = require "signorini.inverse.vectors"

-- The first moves change no parameter by more than a factor of two, later ones by a factor of ten.
local first_radius, largest_radius = math.log(2), math.log(10)
-- A trust region that rejected moves have made smaller than this contains a kink, where points change their state.
local smallest_radius = 3e-4
-- A move counts if it brings this part of what the model promises.
local enough = 1e-3
-- Shares of the promise below and above which the trust region shrinks and grows.
local poor, good = 0.25, 0.75
-- Factors on the length of a move that brought too little, or whose run failed.
local shorter, much_shorter = 0.5, 0.25

--- Searches from a point. `problem`: { name, free, fixed, most (runs), smallest (moves that end the search) } with
---   evaluate(z): the point { z, values, … } there; or nil, and why there is none;
---   merit(point), which may depend on what `move` has learned;
---   move(point, low, high): the best move within limits, what the merit falls by its model, and whether that is too
---     little to go on afterwards;
---   accepted(point, radius): called for each point that becomes the best one.
--- `radius`: of the first trust region. Returns the best point, why the search has ended ("converged", "stalled",
--- "runs", "interrupted"), and all tries as { values, merit, outcome, taken, failed (why, if the run failed) }.
return function(problem, point, radius)
  local display, free = progress(problem.most), problem.free
  radius = radius or first_radius
  local tries = {}
  local function note(values, merit, outcome, taken, failed)
    tries[#tries + 1] = { values = values, merit = merit, outcome = outcome, taken = taken, failed = failed }
    display:step(problem.name)
    display:line(("%s: run %d: %s: %s"):format(problem.name, #tries, parameters.text(free, values), outcome))
  end
  note(point.values, problem.merit(point), problem.describe(point), true)
  while true do
    local low, high = parameters.room(free, point.z, radius)
    local d, promise, is_last = problem.move(point, low, high)
    local length = vectors.norm(d)
    if length < problem.smallest or promise <= 0 then return point, "converged", tries end
    if radius < smallest_radius then
      return point, is_last and not tries[#tries].failed and "converged" or "stalled", tries
    end
    if #tries >= problem.most then return point, "runs", tries end
    local z = vectors.sum(point.z, d)
    local new, why = problem.evaluate(z)
    if new == nil and why == "interrupted" then return point, "interrupted", tries end
    local gain = new and (problem.merit(point) - problem.merit(new)) / promise or -1
    local taken = gain > enough
    note(new and new.values or parameters.values(free, problem.fixed, z), new and problem.merit(new),
      new and problem.describe(new) .. (taken and "" or ", not taken") or "not taken: " .. why,
      taken, why)
    if taken then
      point = new
      problem.accepted(point, radius)
    end
    if is_last and new then return point, "converged", tries end
    if gain < poor then
      radius = length * (new and shorter or much_shorter)
    elseif gain > good and length > 0.9 * radius then
      radius = math.min(2 * radius, largest_radius)
    end
  end
end
