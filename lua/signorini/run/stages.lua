-- The stages of model:run: their arguments, checked against the model, and the values that they prescribe. These lead
-- linearly from those at the start of a stage to its targets, or along the values of a function of the stage's fraction
-- at the end of each step, linearly in between.

local core = require "signorini.core"
local check = require "signorini.call.check"
local contact_changes = require "signorini.run.contact_changes"
local counted = require("signorini.call.text").counted
local lists = require "signorini.call.lists"
local pages = require "signorini.pages"
local t = require "signorini.call.types"

local stages = {}

local where = "model:run"

stages.clock = "time of the stage" -- the key of the starting time in `starts`, which is not a name

-- ── Supports and loads ───────────────────────────────────────────────────────────────────────────────────────────────

--- True for the name of a support, driven or not.
function stages.is_support(model, name) return lists.holds(model:support_names(), name) end

--- The components of a target in order: "ux", "uy" and "angle" of a support, "tx", "ty", "pressure", "bx", "by", "px",
--- "py" or "factor" of a load.
function stages.components(model, name)
  local letter = stages.is_support(model, name) and "u" or "t"
  return lists.map(model:driven(name), function(component)
    return #component == 1 and letter .. component or component
  end)
end

--- The names of nonzero loads that no stage changes.
function stages.constant_loads(model, path)
  return lists.filter(model:load_names(), function(load)
    return lists.any(model:target(load), function(value) return value ~= 0 end)
      and not lists.any(path, function(stage) return stage.targets[load] end)
  end)
end

--- The fraction of a stage, of its duration and of the way to its targets, at the fraction `part` of step `number`:
--- each step is `growth` times as long as the one before.
function stages.fraction(stage, number, part)
  local growth = stage.growth
  if not growth or growth == 1 then return (number - 1 + part) / stage.steps end
  local function reached(steps) return (growth ^ steps - 1) / (growth ^ stage.steps - 1) end
  local from = reached(number - 1)
  return from + part * (reached(number) - from)
end

-- ── Arguments ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The rows of a stage of this model: targets, lists by driven component, after the rows of every stage.
local function rows_of(model)
  local rows = lists.filter(pages.rows "stage", function(row) return row[1] ~= "contacts" end)
  rows[#rows + 1] = contact_changes.row(model)
  for _, name in ipairs(model:driven_names()) do
    local components = stages.components(model, name)
    local list = t.numbers(#components)
    list.cure = function() return "one for each driven component" end
    rows[#rows + 1] = { name, #components == 1 and t.either(t.number, list) or list, table.concat(components, ", "),
                        optional = true }
  end
  return rows
end

local function is_finite(value) return type(value) == "number" and value - value == 0 end

--- The values that a function has returned, or nil and what it has returned in words; of a list of the right length its
--- first entry that is not a finite number.
local function values_of(given, count)
  local values = type(given) == "number" and { given } or given
  if lists.length(values) ~= count then return nil, core.describe(given) end
  for i, value in ipairs(values) do
    if not is_finite(value) then
      local entry = core.describe(value)
      return nil, values == given and ("a list with %s as entry %d"):format(entry, i) or entry
    end
  end
  return lists.map(values, function(value) return value + 0.0 end)
end

local function braces(values)
  local words = table.concat(lists.map(values, function(value) return ("%.6g"):format(value) end), ", ")
  return #values == 1 and words or "{" .. words .. "}"
end

local rounding = 1e-9 -- of values that should be equal, relative to the largest of the stage

--- A sentence for a function that does not begin at the values `now` before the stage, so that its first step jumps. A
--- function that has no values at 0, such as a list of those at the ends of steps, may begin anywhere.
local function jump(course, now, path, name, stage)
  local ok, given = pcall(course, 0.0)
  if not ok and core.answer_interrupt() then error(given, 0) end
  local first = ok and values_of(given, #now)
  if not first then return nil end
  local scale, gap = 0, 0
  for _, values in ipairs(lists.joined({ now, first }, path)) do
    for _, value in ipairs(values) do scale = math.max(scale, math.abs(value)) end
  end
  for i, value in ipairs(first) do gap = math.max(gap, math.abs(value - now[i])) end
  if gap <= rounding * scale then return nil end
  return ("stage '%s': the function of '%s' returns %s for s = 0, but the stage begins at %s, so that its first step "
    .. "leads from there to %s. Hint: values are measured from the reference state, not from the previous stage; "
    .. "return the values that hold before the stage for s = 0"):format(stage, name, braces(first), braces(now),
      braces(path[1]))
end

local function values_along(model, course, name, label, stage)
  local components, path = stages.components(model, name), {}
  for k = 1, stage.steps do
    local fraction = stages.fraction(stage, k, 1)
    local values, given = values_of(course(fraction), #components)
    if not values then
      core.fail(("%s: %s.%s must return %s (%s), got %s for the fraction %g. Hint: it is called with the fraction of "
        .. "the stage at the end of each step, as in function(s) return %s end"):format(where, label, name,
          counted(#components, "finite number"), table.concat(components, ", "), given, fraction,
          #components == 1 and "0.1 * s" or "{" .. ("0, "):rep(#components - 1) .. "0.1 * s}"))
    end
    path[k] = values
  end
  return path
end

--- Raises an error where friction needs a duration that the stage does not have, or arc length does not know it.
local function check_duration(model, label, title, duration, options)
  if duration and options.arc_length then
    core.fail(("%s: %s has a duration, but arc_length = true lets the path turn back, which time cannot. Hint: remove "
      .. "one of the two"):format(where, label))
  end
  for _, contact in ipairs(duration and {} or model:contact_names()) do
    local formula = model:contact_law(contact).of_rate
    if formula then
      core.fail(("%s: contacts.%s.%s depends on v, but stage '%s' has no duration. Hint: write duration = its length "
        .. "in time"):format(where, contact, formula, title))
    end
  end
end

--- `now`: the values before the stage by support or load, then those after it.
local function read_stage(model, rows, index, stage, options, now)
  local label = ("stages[%d]"):format(index)
  for key in pairs(stage) do
    if stages.is_support(model, key) and #model:driven(key) == 0 then
      core.fail(("%s: %s: the support '%s' is not driven. Hint: give it drive = \"x\", \"xy\" or the like in sg.model")
        :format(where, label, key))
    end
  end
  local names, plain, targets, paths, jumps = model:driven_names(), lists.merged(stage), {}, {}, {}
  for _, name in ipairs(names) do
    if type(plain[name]) == "function" then plain[name] = nil end
  end
  local values = check.value(t.named(rows), plain, where, label)
  local title = values.name or ("stage %d"):format(index)
  for _, name in ipairs(names) do
    local goal = stage[name]
    if type(goal) == "function" then
      paths[name] = values_along(model, goal, name, label, values)
      jumps[#jumps + 1] = jump(goal, now[name], paths[name], name, title)
      goal = paths[name][values.steps]
    end
    targets[name] = type(goal) == "number" and { goal } or goal and lists.joined(goal)
    for _, reached in ipairs(paths[name] or { targets[name] }) do
      local wrong = core.off_axis(model, name, reached)
      if wrong then core.fail(("%s: %s.%s: %s"):format(where, label, name, wrong)) end
    end
    now[name] = targets[name] or now[name]
  end
  local contacts = lists.merged(values.contacts or {})
  contact_changes.check(model, where, label, contacts, options)
  check_duration(model, label, title, values.duration, options)
  return { name = title, steps = values.steps, duration = values.duration, growth = values.growth, targets = targets,
           paths = paths, contacts = contacts, jumps = jumps }
end

--- The stages, each { name, steps, targets (by support or load), paths (values of functions at the ends of steps),
--- contacts (constants by contact), jumps (warnings about functions) }, and their steps in all.
function stages.read(model, list, options)
  if #model:driven_names() + #model:support_names() + #model:contact_names() == 0 then
    core.fail(where .. ": the model has neither supports nor loads. Hint: name some in sg.model, such as "
      .. "supports = { bed = { on = body:face \"south\", fix = \"xy\" } }")
  end
  local rows, read, total, now = rows_of(model), {}, 0, {}
  for _, name in ipairs(model:driven_names()) do now[name] = model:target(name) end
  for i, stage in ipairs(list) do
    read[i] = read_stage(model, rows, i, stage, options, now)
    total = total + read[i].steps
  end
  contact_changes.check_fits(model, where, read, options)
  return read, total
end

-- ── Prescribed values ────────────────────────────────────────────────────────────────────────────────────────────────

--- The values between which step `number` leads along a function; nil for targets.
local function ends(stage, name, number)
  local path = stage.paths[name]
  if path then return number == 1 and stage.starts[name] or path[number - 1], path[number] end
end

--- The values of a support or load at the fraction `part` of step `number`, exact at its end, in the list `into`.
function stages.at(stage, name, number, part, into)
  local from, to = ends(stage, name, number)
  local share = to and part or stages.fraction(stage, number, part)
  from, to = from or stage.starts[name], to or stage.targets[name]
  for i = 1, #to do into[i] = share == 1 and to[i] or from[i] + (to[i] - from[i]) * share end
  return into
end

--- The time at the fraction `part` of step `number` for model:set_time, nil without a duration.
function stages.time(stage, number, part)
  if not stage.duration then return nil end
  if stage.duration == "relaxed" then return "relaxed" end
  return stage.starts[stages.clock][1] + stage.duration * stages.fraction(stage, number, part)
end

--- The change of component i in step `number`.
function stages.change(stage, name, number, i)
  local from, to = ends(stage, name, number)
  if to then return to[i] - from[i] end
  local whole = stage.targets[name][i] - stage.starts[name][i]
  if not stage.growth or stage.growth == 1 then return whole / stage.steps end
  return whole * (stages.fraction(stage, number, 1) - stages.fraction(stage, number, 0))
end

--- The values one step ahead of the accepted ones: from their actual values, not from those at a fraction of the step.
--- The difference is rounding error, but arc length would multiply it by the fraction of an increment, which may be 10.
function stages.ahead(model, stage, name, number)
  local values = model:target(name)
  for i = 1, #values do values[i] = values[i] + stages.change(stage, name, number, i) end
  return values
end

--- True if step `number` changes a target.
function stages.moves(model, stage, number)
  for name in pairs(stage.targets) do
    local now = model:target(name)
    for i, value in ipairs(stages.ahead(model, stage, name, number)) do
      if value ~= now[i] then return true end
    end
  end
  return false
end

local function varies(stage, name, i)
  return stage.paths[name] ~= nil or stage.targets[name][i] ~= stage.starts[name][i]
end

--- The targets that a stage changes, at the fraction `part` of step `number`, in words: "edge.angle = 69.86".
function stages.places(model, stage, number, part)
  local texts = {}
  for name in pairs(stage.targets) do
    local values = stages.at(stage, name, number, part, {})
    for i, component in ipairs(stages.components(model, name)) do
      if varies(stage, name, i) then texts[#texts + 1] = ("%s.%s = %.6g"):format(name, component, values[i]) end
    end
  end
  table.sort(texts)
  return texts
end

--- The names of the stages of a run's rows, from row number `first` on.
function stages.names(run, first)
  local names, index, last = {}, 1, run.stages[1] and run.stages[1].steps or 0
  for row = 1, run.rows do
    while index < #run.stages and math.ceil(run.step_column[row]) > last do
      index = index + 1
      last = last + run.stages[index].steps
    end
    if row >= first then names[#names + 1] = run.stages[index].name end
  end
  return names
end

return stages
