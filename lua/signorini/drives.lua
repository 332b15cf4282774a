-- What stages move: driven supports and loads, and how their components are called in messages and columns.

local holds = require("signorini.lists").holds

local drives = {}

--- Whether a name is that of a support, driven or not.
function drives.is_support(model, name) return holds(model:support_names(), name) end

--- The components of a target in order: "ux", "uy" and "angle" of a support, "tx", "ty" or "pressure" of a load.
function drives.components(model, name)
  local letter, components = drives.is_support(model, name) and "u" or "t", {}
  for i, component in ipairs(model:driven(name)) do
    components[i] = #component == 1 and letter .. component or component
  end
  return components
end

return drives
