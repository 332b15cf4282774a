-- Warnings of a run that are not about the resolution of its contacts: tests of other subjects use coarse meshes.

local lists = require "signorini.call.lists"

return function(run)
  return lists.filter(run.warnings, function(warning)
    return not (warning:find("elements of the slave face wide", 1, true)
      or warning:find("of the approach of the faces", 1, true))
  end)
end
