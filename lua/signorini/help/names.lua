-- Which value a page is about: "sg.csv.read", "model:run" and "run" stand for entries of the language and of its types.

local core = require "signorini.core"

local names = {}

--- What a page's name stands for, or nil: a function, or the methods' table of a type.
function names.value(name)
  local type_name, method = name:match "^([%w_]+):([%w_]+)$"
  if type_name or rawget(core.types, name) then
    local methods = rawget(core.types, type_name or name)
    if not method or not methods then return methods end
    return rawget(methods, method)
  end
  local value = { sg = core.sg, help = core.sg.help }
  for part in name:gmatch "[^.]+" do
    value = type(value) == "table" and rawget(value, part)
  end
  return value or nil
end

return names
