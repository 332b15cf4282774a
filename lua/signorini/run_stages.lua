-- The stages of model:run, checked against the model.

local core = require "signorini.core"
local check = require "signorini.check"
local contact_changes = require "signorini.contact_changes"
local drives = require "signorini.drives"
local lists = require "signorini.lists"
local pages = require "signorini.pages"
local t = require "signorini.types"

local where = "model:run"

--- The rows of a stage of this model: targets, lists by driven component, after the rows of every stage.
local function rows_of(model)
  local rows = lists.filter(pages.rows "stage", function(row) return row[1] ~= "contacts" end)
  rows[#rows + 1] = contact_changes.row(model)
  for _, name in ipairs(model:driven_names()) do
    local components = drives.components(model, name)
    local list = t.numbers(#components)
    list.cure = function() return "one for each driven component" end
    rows[#rows + 1] = { name, #components == 1 and t.either(t.number, list) or list, table.concat(components, ", "),
                        optional = true }
  end
  return rows
end

local function read_stage(model, rows, index, stage, options)
  local label = ("stages[%d]"):format(index)
  for key in pairs(stage) do
    if drives.is_support(model, key) and #model:driven(key) == 0 then
      core.fail(("%s: %s: the support '%s' is not driven. Hint: give it drive = \"x\", \"xy\" or the like in sg.model")
        :format(where, label, key))
    end
  end
  local values, targets = check.value(t.named(rows), stage, where, label), {}
  for _, name in ipairs(model:driven_names()) do
    local goal = values[name]
    targets[name] = type(goal) == "number" and { goal } or goal and lists.joined(goal)
  end
  local contacts = lists.merged(values.contacts or {})
  contact_changes.check(model, where, label, contacts, options)
  return { name = values.name or ("stage %d"):format(index), steps = values.steps, targets = targets,
           contacts = contacts }
end

--- The stages, each { name, steps, targets (by support or load), contacts (constants by contact) }, and their steps in
--- all.
return function(model, stages, options)
  if #model:driven_names() + #model:support_names() + #model:contact_names() == 0 then
    core.fail(where .. ": the model has neither supports nor loads. Hint: name some in sg.model, such as "
      .. "supports = { bed = { on = body:face \"south\", fix = \"xy\" } }")
  end
  contact_changes.check_fits(model, where, options)
  local rows, read, total = rows_of(model), {}, 0
  for i, stage in ipairs(stages) do
    read[i] = read_stage(model, rows, i, stage, options)
    total = total + read[i].steps
  end
  return read, total
end
