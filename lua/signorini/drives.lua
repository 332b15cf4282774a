-- What a stage can move: driven supports and loads, and how their components are called in messages and columns.

local core = require "signorini.core"

local drives = {}

local function is_support(model, name)
  for _, support in ipairs(model:support_names()) do
    if support == name then return true end
  end
  return false
end

--- The names of the supports and loads of a model.
function drives.names(model)
  local loads_exist = type(model) == "table" or rawget(core.types.model, "driven_names")
  return loads_exist and model:driven_names() or model:support_names()
end

--- The components of a target in order: "ux", "uy" and "angle" of a support, "tx", "ty" or "pressure" of a load.
function drives.components(model, name)
  local letter, components = is_support(model, name) and "u" or "t", {}
  for i, component in ipairs(model:driven(name)) do
    components[i] = #component == 1 and letter .. component or component
  end
  return components
end

return drives
