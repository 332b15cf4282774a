-- What named arguments need next to them, and what they exclude, as their rows say (signorini.pages).

local core = require "signorini.core"
local describe = require "signorini.describe"
local lists = require "signorini.lists"

--- Raises an error about an argument that lacks what it belongs to, or has what it cannot be combined with.
return function(row, value, where, prefix)
  if type(row) == "string" or rawget(value, row[1]) == nil then return end
  for _, other in ipairs(row.excludes or {}) do
    if rawget(value, other) ~= nil then
      local why = row.excludes.why and ", " .. row.excludes.why or ""
      core.fail(("%s: %s%s cannot be combined with %s%s: leave one of them out"):format(where, prefix, row[1], other,
        why))
    end
  end
  if row.needs and not lists.any(row.needs, function(other) return rawget(value, other) ~= nil end) then
    core.fail(("%s: %s%s has no meaning without %s: add it, or leave %s out"):format(where, prefix, row[1],
      describe.alternatives(row.needs), row[1]))
  end
end
