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

--- Gives what is written in Lua the names of the pages that stand above it; the bindings have done so with their rows.
function names.give()
  for name in pairs(core.docs) do
    local value = names.value(name)
    if value and not core.names[value] then core.names[value] = name end
  end
end

return names
