-- The published tables that come with the program.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local csv = require "signorini.csv"

core.docs["sg.reference"] = [[
sg.reference "ironing2d_oscillation_table7_3"
A published table that comes with the program, as sg.csv.read gives it; the first comment says where it was printed and
what was corrected. The names are those of the files in share/reference.
Example: #sg.reference("ironing2d_dofs_table7_2").rows  --> 8]]
return function(name)
  arguments.string("sg.reference", "name", name)
  return csv.read(("%s/reference/%s.csv"):format(core.share, name))
end
