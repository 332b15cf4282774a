-- The stages that model:run is given: read and checked against the model.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local drives = require "signorini.drives"
local run_options = require "signorini.run_options"

local where = "model:run"

--- The target of a support or a load at the end of a stage, as a list by driven component.
local function read_target(model, stage, drive, value)
  local components = drives.components(model, drive)
  local name = ("%s.%s"):format(stage, drive)
  if type(value) == "number" and #components == 1 then value = { value } end
  local expected = ("a list of %d value%s (%s)"):format(#components, #components == 1 and "" or "s",
    table.concat(components, ", "))
  if type(value) ~= "table" then arguments.reject(where, name, expected, value) end
  if #value ~= #components then arguments.reject(where, name, expected, value, "one for each driven component") end
  for i, component in ipairs(components) do
    arguments.number(where, ("%s[%d] (%s)"):format(name, i, component), value[i])
  end
  return table.move(value, 1, #components, 1, {})
end

local function read_stage(model, index, stage, known)
  local label = ("stage %d"):format(index)
  if type(stage) ~= "table" then arguments.reject(where, label, "a table { steps = …, <support> = {…} }", stage) end
  local name = arguments.string(where, label .. ".name", stage.name, label)
  for key in pairs(stage) do
    if type(key) ~= "string"
      or not (known[key] or key == "name" or key == "steps" or drives.is_support(model, key)) then
      arguments.unknown(where, key, ("stage '%s'"):format(name), table.move(known, 1, #known, 3, { "name", "steps" }))
    end
  end
  local read = { name = name, steps = arguments.count(where, name .. ".steps", stage.steps), targets = {} }
  for key, value in pairs(stage) do
    if type(key) == "string" and known[key] then
      read.targets[key] = read_target(model, name, key, value)
    elseif drives.is_support(model, key) then
      core.fail(("%s: the support '%s' of stage '%s' is not driven: give it drive = \"x\", \"xy\" or the like in "
        .. "sg.model"):format(where, key, name))
    end
  end
  return read
end

--- Options, or the parts of a stage, that stand among the stages, where they would be without effect.
local function check_keys(stages, known)
  for key in pairs(stages) do
    if math.type(key) ~= "integer" or key < 1 or key > #stages then
      local name, cure = tostring(key), "stages are counted from 1 without gaps"
      if type(key) == "string" then cure = "write model:run({ { steps = …, … } }, { … }): a list, then the options" end
      if known[key] or key == "name" then cure = ("put it into a stage, { steps = 10, %s = … }"):format(name) end
      for _, option in ipairs(run_options.keys) do
        if key == option then cure = ("options are the second argument, model:run({ … }, { %s = … })"):format(name) end
      end
      core.fail(("%s: unknown key '%s' in the list of stages: %s"):format(where, name, cure))
    end
  end
end

--- The stages, each { name, steps, targets (by support or load) }, and their steps in all.
return function(model, stages)
  if type(stages) ~= "table" or #stages == 0 or stages.steps then
    arguments.reject(where, "stages", "a list of stages", stages, "write model:run{ { steps = 10, grip = {0, -1} } }")
  end
  local known = model:driven_names()
  if #known + #model:support_names() + #model:contact_names() == 0 then
    core.fail(where .. ": nothing holds, moves or loads the model: name supports or loads in sg.model, such as "
      .. "supports = { bed = { on = body:face \"south\", fix = \"xy\" } }")
  end
  for _, name in ipairs(known) do known[name] = true end
  check_keys(stages, known)
  local read, total = {}, 0
  for i, stage in ipairs(stages) do
    read[i] = read_stage(model, i, stage, known)
    total = total + read[i].steps
  end
  return read, total
end
