-- The tables with which bodies and models were made, so that they can be made again with changes (errors/remade.lua).

local recipes = {}

local tables = setmetatable({}, { __mode = "k" }) -- by body or model

--- A copy of the plain tables in a value; objects and functions remain. A script may change its tables after the call.
local function copy(value)
  if type(value) ~= "table" or getmetatable(value) then return value end
  local own = {}
  for key, entry in next, value do own[key] = copy(entry) end
  return own
end

--- Keeps the named arguments of the call that made an object; returns the object.
function recipes.keep(object, values)
  tables[object] = copy(values)
  return object
end

--- The named arguments of the call that made an object; nil if it was made otherwise.
function recipes.of(object) return tables[object] end

return recipes
