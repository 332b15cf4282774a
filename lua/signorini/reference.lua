-- The published tables that come with the program.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local csv = require "signorini.csv"
local holds = require("signorini.lists").holds

--- The names of the tables, sorted.
local function table_names(folder)
  local names = {}
  for _, file in ipairs(core.list_folder(folder)) do names[#names + 1] = file:match "^(.*)%.csv$" end
  return names
end

core.docs["sg.reference"] = [[
sg.reference "ironing2d_oscillation_table7_3"
A published table that comes with the program, as sg.csv.read gives it; the first comment says where it was printed and
what was corrected. The names are those of the files in share/reference; a name that is none of them lists them.
Example: #sg.reference("ironing2d_dofs_table7_2").rows  --> 8]]
return function(name)
  arguments.string("sg.reference", "name", name)
  local folder = core.share .. "/reference"
  local names = table_names(folder)
  if not holds(names, name) then
    local meant = core.nearest(name, names)
    core.fail(("sg.reference: there is no table '%s'%s; there are %s"):format(name,
      meant and ("; did you mean '%s'?"):format(meant) or "", table.concat(names, ", ")))
  end
  return csv.read(("%s/%s.csv"):format(folder, name))
end
