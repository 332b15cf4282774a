-- Calls a function on behalf of another one, so that errors name the function that the user has called.

local core = require "signorini.core"

--- Calls a function with the further arguments; an error of `inner`, such as "sg.csv.write", becomes one of `outer`.
return function(outer, inner, call, ...)
  local result = table.pack(pcall(call, ...))
  if result[1] then return table.unpack(result, 2, result.n) end
  local reason = type(result[2]) == "string" and result[2]:match(("^.-%s: (.*)$"):format(inner:gsub("%p", "%%%0")))
  if not reason then error(result[2], 0) end
  core.fail(("%s: %s"):format(outer, reason))
end
