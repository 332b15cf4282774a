-- The stages of model:run, checked against the model.

local core = require "signorini.core"
local check = require "signorini.check"
local contact_changes = require "signorini.contact_changes"
local counted = require "signorini.counted"
local drives = require "signorini.drives"
local list_shape = require "signorini.list_shape"
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

--- The values of a function at the end of each step.
local function values_along(model, course, name, label, steps)
  local components, path = drives.components(model, name), {}
  for k = 1, steps do
    local given = course(k / steps)
    local values = type(given) == "number" and { given } or given
    local fits = list_shape.length(values) == #components
      and not lists.any(values, function(value) return type(value) ~= "number" or value - value ~= 0 end)
    if not fits then
      core.fail(("%s: %s.%s must return %s (%s), got %s for the fraction %g. Hint: it is called with the fraction of "
        .. "the stage at the end of each step, as in function(s) return %s end"):format(where, label, name,
          counted(#components, "finite number"), table.concat(components, ", "), core.describe(given), k / steps,
          #components == 1 and "0.1 * s" or "{" .. ("0, "):rep(#components - 1) .. "0.1 * s}"))
    end
    path[k] = lists.map(values, function(value) return value + 0.0 end)
  end
  return path
end

local function read_stage(model, rows, index, stage, options)
  local label = ("stages[%d]"):format(index)
  for key in pairs(stage) do
    if drives.is_support(model, key) and #model:driven(key) == 0 then
      core.fail(("%s: %s: the support '%s' is not driven. Hint: give it drive = \"x\", \"xy\" or the like in sg.model")
        :format(where, label, key))
    end
  end
  local names, plain, targets, paths = model:driven_names(), lists.merged(stage), {}, {}
  for _, name in ipairs(names) do
    if type(plain[name]) == "function" then plain[name] = nil end
  end
  local values = check.value(t.named(rows), plain, where, label)
  for _, name in ipairs(names) do
    local goal = stage[name]
    if type(goal) == "function" then
      paths[name] = values_along(model, goal, name, label, values.steps)
      goal = paths[name][values.steps]
    end
    targets[name] = type(goal) == "number" and { goal } or goal and lists.joined(goal)
  end
  local contacts = lists.merged(values.contacts or {})
  contact_changes.check(model, where, label, contacts, options)
  return { name = values.name or ("stage %d"):format(index), steps = values.steps, targets = targets,
           paths = paths, contacts = contacts }
end

--- The stages, each { name, steps, targets (by support or load), paths (values of functions at the ends of steps),
--- contacts (constants by contact) }, and their steps in all.
return function(model, stages, options)
  if #model:driven_names() + #model:support_names() + #model:contact_names() == 0 then
    core.fail(where .. ": the model has neither supports nor loads. Hint: name some in sg.model, such as "
      .. "supports = { bed = { on = body:face \"south\", fix = \"xy\" } }")
  end
  local rows, read, total = rows_of(model), {}, 0
  for i, stage in ipairs(stages) do
    read[i] = read_stage(model, rows, i, stage, options)
    total = total + read[i].steps
  end
  contact_changes.check_fits(model, where, read, options)
  return read, total
end
