-- The states that a run stores, for pictures of the path: model:run(stages, { states = … }) and run:states().

local check = require "signorini.call.check"
local core = require "signorini.core"
local t = require "signorini.call.types"

local State = {}
State.__index = State
State.__name = "state"
core.types.state = State

function State:__tostring() return ("state at %s"):format(self.title) end

local function set_of(where, list, total)
  local set, a_step = {}, t.worded(t.integer(0, total), ("a step from 0 (the start) to %d"):format(total))
  for i, step in ipairs(list) do
    set[math.tointeger(check.value(a_step, step, where, ("options.states[%d]"):format(i)))] = true
  end
  return set
end

--- The steps of a number of states, evenly distributed from the start to the end.
local function spread(count, total)
  local set = {}
  for i = 0, count - 1 do set[(i * total + (count - 1) // 2) // (count - 1)] = true end
  return set
end

local function ends(path)
  local set, step = { [0] = true }, 0
  for _, stage in ipairs(path) do
    step = step + stage.steps
    set[step] = true
  end
  return set
end

local states = {}

--- What the option requests: a function of a step and of a function that returns its `info`, and whether the very last
--- state is stored in any case.
function states.read(where, wanted, path, total)
  if type(wanted) == "function" then
    return { wants = function(step, info) return step > 0 and wanted(info()) end, last = false }
  end
  local set = wanted == nil and ends(path) or type(wanted) == "table" and set_of(where, wanted, total)
    or spread(math.tointeger(wanted), total)
  return { wants = function(step) return set[step] end, last = type(wanted) ~= "table" }
end

--- The model's present state as an entry of run:states().
function states.store(model, step, stage)
  local title = step == 0 and "start" or ("%s, step %d"):format(stage, step)
  return setmetatable({ step = step, stage = stage, title = title, snapshot = model:snapshot() }, State)
end

return states
