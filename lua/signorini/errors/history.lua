-- The runs that have led a model to its present state, which companions of a further run repeat.

local core = require "signorini.core"
local lists = require "signorini.call.lists"

local history = {}

local known = setmetatable({}, { __mode = "k" }) -- by model: { runs, state }

--- What distinguishes states of a model: the length of the last step, targets, and constants of contacts.
local function state_of(model)
  return core.pack { model:last_length(),
    lists.map(model:driven_names(), function(name) return model:target(name) end),
    lists.map(model:contact_names(), function(name) return lists.merged(model:contact_law(name)) end) }
end

--- Notes a model that has just been made.
function history.begin(model) known[model] = { runs = {}, state = state_of(model) } end

--- The runs { stages, options } before the present state of a model; nil if it was reached in another way.
function history.of(model)
  local record = known[model]
  return record and record.state == state_of(model) and record.runs or nil
end

--- Notes a run that has ended; `before`: the runs before it. A path that on_step has ended cannot be repeated.
function history.note(model, before, list, options, run)
  known[model] = nil
  if not before or run.reason ~= "completed" then return end
  before[#before + 1] = { list, options } -- in place: a script may run a model many thousand times
  known[model] = { runs = before, state = state_of(model) }
end

return history
