-- Columns of a run's record: what each accepted step appends.

local lists = require "signorini.call.lists"
local stages = require "signorini.run.stages"

local recorders = {}

local axes = { "x", "y", "z" }
local contact_columns = { "fx", "fy", "fz", "area", "max_pressure", "max_penetration", "slip", "debonded",
                          "worn_volume" }

--- Registers a column and returns its list of values.
function recorders.add_column(run, name)
  local values = {}
  run.names[#run.names + 1], run.values[name] = name, values
  return values
end

local function add_columns(run, name, keys)
  return lists.map(keys, function(key) return recorders.add_column(run, name .. "." .. key) end)
end

local function record_list(run, columns, read)
  run.recorders[#run.recorders + 1] = function(row)
    local list = read()
    for i, values in ipairs(columns) do values[row] = list[i] end
  end
end

--- The force of a support or a load, with the moment last where it rotates.
local function record_force(run, model, name)
  local driven, keys = model:driven(name), {}
  local turns = driven[#driven] == "angle"
  for i = 1, #model:reaction(name) - (turns and 1 or 0) do keys[i] = "f" .. axes[i] end
  if turns then keys[#keys + 1] = "moment" end
  record_list(run, add_columns(run, name, keys), function() return model:reaction(name) end)
end

local function record_target(run, model, name)
  record_list(run, add_columns(run, name, stages.components(model, name)), function() return model:target(name) end)
end

local function record_motion(run, model, name)
  local free = model:free_motion(name)
  local keys = lists.filter({ "ux", "uy", "uz", "angle" }, function(key) return free[key] ~= nil end)
  if #keys == 0 then return end
  record_list(run, add_columns(run, name, keys), function()
    local motion = model:free_motion(name)
    return lists.map(keys, function(key) return motion[key] end)
  end)
end

local function record_contact(run, model, contact)
  local columns, resultant = {}, model:contact_resultant(contact)
  for _, key in ipairs(contact_columns) do
    if rawget(resultant, key) then columns[key] = recorders.add_column(run, contact .. "." .. key) end
  end
  local between, of_pairs = {}, rawget(resultant, "pairs") or {} -- of the bodies of a set of faces
  for _, pair in ipairs(lists.sorted_names(of_pairs)) do
    between[pair] = {}
    for _, key in ipairs(lists.sorted_names(of_pairs[pair])) do
      between[pair][key] = recorders.add_column(run, ("%s.%s.%s"):format(contact, pair, key))
    end
  end
  local counted = { unsettled = resultant.unsettled, flawed = rawget(resultant, "flawed") }
  run.recorders[#run.recorders + 1] = function(row)
    local now = model:contact_resultant(contact)
    for key, values in pairs(columns) do values[row] = now[key] end
    for pair, forces in pairs(between) do
      for key, values in pairs(forces) do values[row] = now.pairs[pair][key] end
    end
    for key, before in pairs(counted) do
      if now[key] > before then
        local found = run[key][contact] or { count = 0 }
        local at, flaw = now[key .. "_at"], rawget(now, "flaw")
        run[key][contact] = { count = found.count + now[key] - before, at = at, flaw = flaw }
        counted[key] = now[key]
      end
    end
  end
end

--- Creates the columns once, so that a step only appends numbers.
function recorders.start(run, model, path)
  run.step_column, run.increment_column = recorders.add_column(run, "step"), recorders.add_column(run, "increments")
  run.iteration_column, run.wall_column = recorders.add_column(run, "iterations"), recorders.add_column(run, "wall")
  if lists.any(path, function(stage) return stage.duration ~= nil end) then
    record_list(run, { recorders.add_column(run, "time") }, function() return { model:time() } end)
  end
  for _, support in ipairs(model:support_names()) do record_force(run, model, support) end
  for _, load in ipairs(model:load_names()) do record_force(run, model, load) end
  for _, name in ipairs(model:driven_names()) do record_target(run, model, name) end
  for _, support in ipairs(model:support_names()) do record_motion(run, model, support) end
  for _, contact in ipairs(model:contact_names()) do record_contact(run, model, contact) end
end

return recorders
