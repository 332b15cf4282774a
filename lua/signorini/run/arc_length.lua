-- Arc-length continuation: follows the path where a step with prescribed targets fails at a turning point (snap-back of
-- peeling, snap-through under a load), and finds out whether a turning point is the reason of a failure.

local steps = require "signorini.run.steps"

local arc_length = {}

local first_share = 0.3     -- of the last accepted step's length: the first increment
local easy, hard = 4, 7     -- iterations up to which increments grow, and from which they shrink
local growth, shrinkage = 1.5, 0.7
local most_iterations = 12  -- an increment that needs more is repeated shorter
local smallest = 2 ^ -10    -- of the first increment
local most_arcs = 2000      -- in one step of the path

--- The next length, from the iterations of the last increment.
local function adapt(length, result, longest)
  if result.iterations <= easy then return math.min(longest, length * growth) end
  return result.iterations >= hard and length * shrinkage or length
end

-- ── The policy ───────────────────────────────────────────────────────────────────────────────────────────────────────

local Switch = {}
Switch.__index = Switch

--- Takes each step as `inner` does. Where that fails, arc-length increments follow the path until the end of the step
--- is passed; there the targets are prescribed again, and the next step begins with `inner`. Before the first accepted
--- step there is neither a length nor a direction, and in a step that changes no target (but constants of contacts)
--- there is no path, so the result of `inner` is returned.
function arc_length.policy(inner) return setmetatable({ inner = inner, memory = inner.memory }, Switch) end

function Switch:shorten(step) return self.inner:shorten(step) end

function Switch:take(step)
  local result = self.inner:take(step)
  if result.converged or steps.is_asked_for(result) or not step:changes_targets() then return result end
  local first = first_share * step.model:last_length()
  if not (first > 0) then return result end
  step:switch_control("arc length", result.reason)
  local length, longest = first, 4 * first / first_share
  for _ = 1, most_arcs do
    local arc, to = step:attempt_arc(length, most_iterations)
    if arc.reason == "interrupted" then return arc end
    if arc.converged and to < 1 then
      length = adapt(length, arc, longest)
    else
      if arc.converged then
        result = step:attempt(1)
        if result.converged then
          step:switch_control("targets", "the end of the step is passed")
          return result
        end
      end
      length = length / 2
      if length < smallest * first then return arc end
    end
  end
  return result
end

-- ── The diagnosis ────────────────────────────────────────────────────────────────────────────────────────────────────

local probe_arcs = 60
local least_reach = 0.02 -- as a fraction of the step

--- True if the present state, from which an arc-length increment of a given length led backward, is a turning point: no
--- equilibrium close by lies `reach` farther on. Where contact states cycle (stick and slip, open and closed),
--- increments can also lead backward although there is one.
local function turns_back(step, length, reach)
  local model = step.model
  local saved = model:snapshot()
  local result = step:probe(step.done + math.max(reach, least_reach))
  local near = result.converged and model:last_length() <= 4 * length
  model:restore(saved)
  return not near
end

--- Follows the path by arc-length increments from where a step failed, then restores that state. Returns the fraction
--- of the step at which the turning point lies; nil if none was found within reach.
function arc_length.turning_point(step)
  local model, done = step.model, step.done
  local first = first_share * model:last_length()
  if not (first > 0) then return nil end
  local start, length, reach, found = model:snapshot(), first, 0, nil
  for _ = 1, probe_arcs do
    local arc, to, before = step:solve_arc(length, most_iterations)
    if arc.reason == "interrupted" then break end
    if not arc.converged then
      length = length / 2
      if length < smallest * first then break end
    elseif to < step.done then
      model:restore(before)
      if turns_back(step, length, reach) then found = step.done end
      break
    else
      step.done, reach = to, to - step.done
      length = math.min(first, adapt(length, arc, first))
      if to > 1 then break end
    end
  end
  step.done = done
  model:restore(start)
  return found
end

return arc_length
