-- The runs that have led a model to its present state, which companions of a further run repeat.

local lists = require "signorini.call.lists"

local history = {}

local known = setmetatable({}, { __mode = "k" }) -- by model: { runs, energy, targets }

local function targets(model)
  return lists.map(model:driven_names(), function(name) return model:target(name) end)
end

local function is_at(record, model)
  local energy = model:energy()
  for key, value in pairs(record.energy) do
    if key ~= "sudden" and rawget(energy, key) ~= value then return false end
  end
  for i, values in ipairs(targets(model)) do
    for k, value in ipairs(values) do
      if value ~= record.targets[i][k] then return false end
    end
  end
  return true
end

--- The runs { stages, options } before the present state of a model; nil if it was reached in another way.
function history.of(model)
  local record = known[model]
  if record and is_at(record, model) then return record.runs end
  return model:last_length() == 0 and {} or nil
end

--- Notes a run that has ended; `before`: the runs before it. A path that on_step has ended cannot be repeated.
function history.note(model, before, list, options, run)
  known[model] = before and run.reason == "completed" and {
    runs = lists.joined(before, { { list, options } }), energy = run.energies[#run.energies],
    targets = targets(model) } or nil
end

return history
