-- Runs have the fields that their page names, and no others: a misspelt one is an error, not nil.

local core = require "signorini.core"
local named = require "signorini.named"

-- What some runs have, or have while they go on. All else that is not there is misspelt.
local may_be_missing = { cause = true, report = true, timings = true, recorders = true, before = true, step = true }

--- Makes the type of runs strict.
return function(Run)
  setmetatable(Run, { __index = function(_, name)
    if may_be_missing[name] or type(name) == "string" and name:find "^__" then return nil end
    local pages = require "signorini.pages"
    local known = pages.keys(pages.find("run").fields) -- and methods
    for method in next, Run do
      if pages.find("run:" .. method) then known[#known + 1] = method end
    end
    named.missing("a run", name, known)
  end })

  function Run:__newindex(name, value)
    if not (rawget(self, "recorders") or may_be_missing[name]) then -- it has ended
      core.fail(("a run is a record, it takes no '%s': keep your own values in a variable, or return them from "
        .. "on_step as columns"):format(tostring(name)))
    end
    rawset(self, name, value)
  end
end
