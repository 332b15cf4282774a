-- Tables of figures by name that refuse names they do not have.

local core = require "signorini.core"

local named = {}

--- Raises an error about a name that `what` ("a run") does not have, with the one that was probably meant.
function named.missing(what, name, known)
  table.sort(known)
  local meant = type(name) == "string" and core.nearest(name, known)
  core.fail(("%s has no '%s'%s %s"):format(what, tostring(name),
    meant and ("; did you mean '%s'? It has"):format(meant) or ": it has", table.concat(known, ", ")))
end

--- The table itself; from now on what it does not have is an error, not nil.
function named.strict(what, entries)
  return setmetatable(entries, { __index = function(_, name)
    local known = {}
    for key in next, entries do known[#known + 1] = key end
    named.missing(what, name, known)
  end })
end

return named
