-- The values of page names such as "sg.csv.read", "model:run" and "run".

local core = require "signorini.core"
local named = require "signorini.call.named"

local names = {}

--- The value with a page's name, or nil: a function, or the table of methods of a type.
function names.value(name)
  local type_name, method = name:match "^([%w_]+):([%w_]+)$"
  if type_name or core.types[name] then
    local methods = core.types[type_name or name]
    if not method or not methods then return methods end
    return rawget(methods, method)
  end
  local value = { sg = core.sg, help = core.sg.help }
  for part in name:gmatch "[^.]+" do
    value = type(value) == "table" and rawget(named.entries(value), part)
  end
  return value or nil
end

return names
