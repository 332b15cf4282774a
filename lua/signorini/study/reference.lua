-- The published tables that are installed with the program.

local core = require "signorini.core"
local csv = require "signorini.output.csv"
local meant = require("signorini.call.text").meant
local holds = require("signorini.call.lists").holds

local reference = {}

--- The names of the tables, sorted.
function reference.names()
  local names = {}
  for _, file in ipairs(core.list_folder(core.share .. "/reference")) do
    names[#names + 1] = file:match "^(.*)%.csv$"
  end
  return names
end

function reference.read(name)
  local names = reference.names()
  if not holds(names, name) then
    core.fail(("sg.reference: there is no table '%s'%s; there are %s"):format(name, meant(name, names),
      table.concat(names, ", ")))
  end
  return csv.read(("%s/reference/%s.csv"):format(core.share, name))
end

return reference
