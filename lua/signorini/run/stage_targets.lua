-- The values that a stage prescribes: they lead linearly from those at its start to its targets, or along the values of
-- a function of the stage's fraction at the end of each step, linearly in between.

local drives = require "signorini.run.drives"

local stage_targets = {}

--- The values between which step `number` leads along a function; nil for targets.
local function ends(stage, name, number)
  local path = stage.paths[name]
  if path then return number == 1 and stage.starts[name] or path[number - 1], path[number] end
end

--- The values of a support or load at the fraction `part` of step `number`, exact at its end, in the list `into`.
function stage_targets.at(stage, name, number, part, into)
  local from, to = ends(stage, name, number)
  local share = to and part or (number - 1 + part) / stage.steps
  from, to = from or stage.starts[name], to or stage.targets[name]
  for i = 1, #to do into[i] = share == 1 and to[i] or from[i] + (to[i] - from[i]) * share end
  return into
end

--- The change of component i in step `number`.
function stage_targets.change(stage, name, number, i)
  local from, to = ends(stage, name, number)
  if to then return to[i] - from[i] end
  return (stage.targets[name][i] - stage.starts[name][i]) / stage.steps
end

--- The values one step ahead of the accepted ones: from their actual values, not from those at a fraction of the step.
--- The difference is rounding error, but arc length would multiply it by the fraction of an increment, which may be 10.
function stage_targets.ahead(model, stage, name, number)
  local values = model:target(name)
  for i = 1, #values do values[i] = values[i] + stage_targets.change(stage, name, number, i) end
  return values
end

--- True if step `number` changes a target.
function stage_targets.moves(model, stage, number)
  for name in pairs(stage.targets) do
    local now = model:target(name)
    for i, value in ipairs(stage_targets.ahead(model, stage, name, number)) do
      if value ~= now[i] then return true end
    end
  end
  return false
end

--- True if a stage changes component i at all.
local function varies(stage, name, i)
  return stage.paths[name] ~= nil or stage.targets[name][i] ~= stage.starts[name][i]
end

--- The targets that a stage changes, at the fraction `part` of step `number`, in words: "edge.angle = 69.86".
function stage_targets.places(model, stage, number, part)
  local texts = {}
  for name in pairs(stage.targets) do
    local values = stage_targets.at(stage, name, number, part, {})
    for i, component in ipairs(drives.components(model, name)) do
      if varies(stage, name, i) then texts[#texts + 1] = ("%s.%s = %.6g"):format(name, component, values[i]) end
    end
  end
  table.sort(texts)
  return texts
end

return stage_targets
