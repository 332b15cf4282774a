-- The supports and loads that stages move, and the names of their components in messages and columns.

local lists = require "signorini.call.lists"

local drives = {}

--- True for the name of a support, driven or not.
function drives.is_support(model, name) return lists.holds(model:support_names(), name) end

--- The components of a target in order: "ux", "uy" and "angle" of a support, "tx", "ty", "pressure", "bx", "by", "px",
--- "py" or "factor" of a load.
function drives.components(model, name)
  local letter = drives.is_support(model, name) and "u" or "t"
  return lists.map(model:driven(name), function(component)
    return #component == 1 and letter .. component or component
  end)
end

--- The names of nonzero loads that no stage changes.
function drives.constant_loads(model, stages)
  return lists.filter(model:load_names(), function(load)
    return lists.any(model:target(load), function(value) return value ~= 0 end)
      and not lists.any(stages, function(stage) return stage.targets[load] end)
  end)
end

return drives
