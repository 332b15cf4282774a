-- Calls a function without the warnings of the scenes and models that it makes, which are variants of the user's.

local core = require "signorini.core"

--- The results of f(...); its errors pass.
return function(f, ...)
  local before = core.mute_warnings(true)
  local results = table.pack(pcall(f, ...))
  core.mute_warnings(before)
  if not results[1] then error(results[2], 0) end
  return table.unpack(results, 2, results.n)
end
