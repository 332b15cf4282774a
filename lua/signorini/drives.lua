-- The supports and loads that stages move, and the names of their components in messages and columns.

local lists = require "signorini.lists"

local drives = {}

--- Whether a name is that of a support, driven or not.
function drives.is_support(model, name) return lists.holds(model:support_names(), name) end

--- The components of a target in order: "ux", "uy" and "angle" of a support, "tx", "ty" or "pressure" of a load.
function drives.components(model, name)
  local letter = drives.is_support(model, name) and "u" or "t"
  return lists.map(model:driven(name), function(component)
    return #component == 1 and letter .. component or component
  end)
end

--- The targets that a stage moves, at a fraction of it, in words: "edge.angle = 69.86".
function drives.places(model, stage, part)
  local texts = {}
  for name, goal in pairs(stage.targets) do
    local start = stage.starts[name]
    for i, component in ipairs(drives.components(model, name)) do
      local value = start[i] + (goal[i] - start[i]) * part
      if goal[i] ~= start[i] then texts[#texts + 1] = ("%s.%s = %.6g"):format(name, component, value) end
    end
  end
  table.sort(texts)
  return texts
end

--- The names of nonzero loads that no stage changes.
function drives.constant_loads(model, stages)
  return lists.filter(model:load_names(), function(load)
    return lists.any(model:target(load), function(value) return value ~= 0 end)
      and not lists.any(stages, function(stage) return stage.targets[load] end)
  end)
end

return drives
