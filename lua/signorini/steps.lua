-- How a step of the user's is reached: the policies of model:run. A policy is an object with two functions: take(step),
-- which ends with the result of the last attempt: converged when the step was reached. `step` is made by run.lua:
--   step.done          the part of the step that is accepted so far, 0 to 1
--   step.solver        what model:solve_step takes
--   step:attempt(to, shorter)  solves for the targets at the part `to` of the step; accepts, or rolls back; returns the
--                      result. `shorter`: where it fails a shorter one will follow
--   step:attempt_from_start()  solves for the whole step from the state before it; where that fails it is as it was
--   step:moves()       says whether anything that is prescribed changes in the step
--   step:has_rescues() says whether something is tried where an attempt has failed
--   step:cut_back()    says that a failed attempt is tried again, shorter
-- and another, shorten(step), which makes the next attempts at this step half as long and says whether it could.
-- What a policy carries from one step to the next stands in its table `memory`, as plain data: checkpoints keep it.
-- A policy may be asked to go on where another one has given up: it starts at step.done.

local steps = {}

local rounding = 1e-9 -- parts of a step closer than this are the same

-- ── Equal steps ──────────────────────────────────────────────────────────────────────────────────────────────────────

local Plain = {}
Plain.__index = Plain

--- Each step at once; one that fails ends the run.
function steps.plain() return setmetatable({}, Plain) end

function Plain:take(step) return step:attempt(1) end

--- Whether a step can be taken in attempts half as long.
function Plain:shorten() return false end

-- ── Cutting in half ──────────────────────────────────────────────────────────────────────────────────────────────────

local Halving = {}
Halving.__index = Halving

--- Increments of at most `max` steps: one that fails is cut in half, down to `min`; after an easy one the next may be
--- `growth` times as long. Its length outlives the step, so that a rough stretch of the path is not begun with failures
--- at each of its steps.
function steps.halving(options)
  return setmetatable({ memory = { length = options.max }, min = options.min, max = options.max,
                        growth = options.growth }, Halving)
end

--- Whether an attempt ended because somebody wants the run to end.
function steps.is_asked_for(result) return result.reason == "interrupted" or result.reason == "stopped" end

--- Whether an attempt ended because somebody wanted it to, not because it failed: there is nothing to diagnose or
--- rescue.
function steps.is_wanted(result) return result.reason == "cut" or steps.is_asked_for(result) end

--- Newton has converged in half of the iterations that it may take.
local function is_easy(result, solver) return 2 * result.iterations <= solver.iterations end

--- The last resort where the shortest step fails: all that is left of the step at once, with all that may carry it
--- through; then all of it from its start, since its accepted increments may have led to where nothing goes on.
local function leap(step, failed)
  if not step:has_rescues() then return failed end
  local result = step:attempt(1)
  if step.done > 0 and not result.converged and not steps.is_asked_for(result) then
    result = step:attempt_from_start()
  end
  return (result.converged or steps.is_asked_for(result)) and result or failed
end

function Halving:take(step)
  local memory, result = self.memory, nil
  repeat
    local rest = 1 - step.done
    local length = memory.length < rest - rounding and memory.length or rest
    local moves = step:moves() -- where nothing does a shorter attempt solves the same equations
    local last = not moves or length / 2 < self.min - rounding
    result = step:attempt(length == rest and 1 or step.done + length, not last)
    if result.converged then
      if is_easy(result, step.solver) then
        local longest = step.longest or self.max
        memory.length = math.max(memory.length, math.min(longest, self.growth * length))
      end
    elseif steps.is_asked_for(result) then
      return result
    elseif not moves then
      return result
    elseif last then
      result.shortest = length
      if not steps.is_wanted(result) then result = leap(step, result) end
      if not result.converged then return result end
    else
      memory.length = length / 2
      step:cut_back()
    end
  until step.done == 1
  return result
end

function Halving:shorten(step)
  local memory = self.memory
  local length = math.min(memory.length, step.longest or self.max) / 2
  if length < self.min - rounding then return false end
  memory.length, step.longest = length, length
  return true
end

return steps
