-- How a step of the path is solved: the policies of model:run. A policy is an object with two functions: take(step),
-- which returns the result of the last attempt: converged if the step was reached. `step` is made by run.lua:
--   step.done          the fraction of the step that is accepted so far, 0 to 1
--   step.solver        the arguments of model:solve_step
--   step:attempt(to, shorter)  solves for the targets at the fraction `to` of the step; accepts, or rolls back; returns
--                      the result. `shorter`: a shorter attempt follows a failure
--   step:attempt_from_start()  solves for the whole step from the state before it; after a failure nothing has changed
--   step:moves()       true if anything that is prescribed changes in the step
--   step:changes_targets() true if a target does
--   step:is_spent()    true if failed attempts from the present state have used up their iterations
--   step:has_fallbacks() true if there are fallbacks for a failed attempt
--   step:cut_back()    counts a failed attempt that is repeated with a shorter one
-- and shorten(step), which halves the length of the next attempts at this step and returns whether that is possible.
-- Data that a policy keeps from one step to the next is in its table `memory`, as plain data, which checkpoints save.
-- A policy can continue where another one has failed: it starts at step.done.

local steps = {}

local rounding = 1e-9 -- fractions of a step closer than this are the same

-- ── Equal steps ──────────────────────────────────────────────────────────────────────────────────────────────────────

local Plain = {}
Plain.__index = Plain

--- Each step in one increment; a failure ends the run.
function steps.plain() return setmetatable({}, Plain) end

function Plain:take(step) return step:attempt(1) end

function Plain:shorten() return false end

-- ── Cutting in half ──────────────────────────────────────────────────────────────────────────────────────────────────

local Halving = {}
Halving.__index = Halving

--- Increments of at most `max` steps: a failed one is halved, down to `min`; after an easy one the next may be `growth`
--- times as long. The length carries over from step to step, so that in a difficult part of the path not every step
--- begins with failures.
function steps.halving(options)
  return setmetatable({ memory = { length = options.max }, min = options.min, max = options.max,
                        growth = options.growth }, Halving)
end

--- True if the user ended an attempt.
function steps.is_asked_for(result) return result.reason == "interrupted" or result.reason == "stopped" end

--- True if an attempt was ended on request and did not fail: then there is no diagnosis and no fallback.
function steps.is_wanted(result) return result.reason == "cut" or steps.is_asked_for(result) end

--- True if an attempt failed at targets for which no equilibrium exists, so that only shorter attempts can succeed.
function steps.is_hopeless(result)
  return result.diagnosis ~= nil and result.diagnosis.reason == "friction_exhausted"
end

--- Newton has converged in half of the allowed iterations.
local function is_easy(result, solver) return 2 * result.iterations <= solver.iterations end

--- The last resort if the smallest increment fails: the rest of the step at once, with all fallbacks; then the whole
--- step from its start, because its accepted increments may have led to a state without a neighboring equilibrium.
local function leap(step, failed)
  if not step:has_fallbacks() then return failed end
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
    local moves = step:moves() -- otherwise a shorter attempt solves the same equations
    local last = not moves or length / 2 < self.min - rounding
    result = step:attempt(length == rest and 1 or step.done + length, not last)
    if result.converged then
      if is_easy(result, step.solver) then
        local longest = step.longest or self.max
        memory.length = math.max(memory.length, math.min(longest, self.growth * length))
      end
    elseif steps.is_asked_for(result) then
      return result
    elseif not moves or step:is_spent() then
      return result
    elseif last then
      result.shortest = length
      if not (steps.is_wanted(result) or steps.is_hopeless(result)) then result = leap(step, result) end
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
