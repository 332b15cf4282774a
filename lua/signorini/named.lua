-- Tables of figures by name that refuse names they do not have.

local core = require "signorini.core"

local named = {}

--- Raises an error about a name that `what` ("a run") does not have, with the one that was probably meant. `entries`:
--- what it has instead of entries by number, in words.
function named.missing(what, name, known, entries)
  table.sort(known)
  if entries and type(name) ~= "string" then
    core.fail(("%s has no entry %s: it has %s; they are %s"):format(what, core.describe(name), entries,
      table.concat(known, ", ")))
  end
  local meant = type(name) == "string" and core.nearest(name, known)
  core.fail(("%s has no '%s'%s %s"):format(what, tostring(name),
    meant and ("; did you mean '%s'? It has"):format(meant) or ": it has", table.concat(known, ", ")))
end

--- The table itself; from now on what it does not have is an error, not nil. `by_number`: see named.missing.
function named.strict(what, entries, by_number)
  return setmetatable(entries, { __name = what:match "^an? (.*)", __index = function(_, name)
    local known = {}
    for key in next, entries do known[#known + 1] = key end
    named.missing(what, name, known, by_number)
  end })
end

return named
