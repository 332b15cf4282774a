-- Error about a column that does not exist.

local core = require "signorini.core"
local meant = require "signorini.call.meant"

--- Raises an error of the function `where` about a name that is none of the columns.
return function(where, name, columns)
  local hint = meant(name, columns)
  core.fail(("%s: there is no column '%s'%s known: %s"):format(where, name, hint == "" and ";" or hint,
    table.concat(columns, ", ")))
end
