-- Checks the `needs` and `excludes` of rows (signorini.pages): arguments that require or exclude others.

local core = require "signorini.core"
local describe = require "signorini.call.describe"
local lists = require "signorini.call.lists"

--- Raises an error about an argument that lacks one it needs, or is given with one it excludes.
return function(row, value, where, prefix)
  if type(row) == "string" or rawget(value, row[1]) == nil then return end
  for _, other in ipairs(row.excludes or {}) do
    if rawget(value, other) ~= nil then
      local why = row.excludes.why and ", " .. row.excludes.why or ""
      core.fail(("%s: %s%s cannot be combined with %s%s. Hint: leave one of them out"):format(where, prefix, row[1],
        other, why))
    end
  end
  if row.needs and not lists.any(row.needs, function(other) return rawget(value, other) ~= nil end) then
    core.fail(("%s: %s%s has no effect without %s. Hint: add it, or leave %s out"):format(where, prefix, row[1],
      describe.alternatives(row.needs), row[1]))
  end
end
