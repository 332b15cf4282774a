-- The published tables that come with the program.

local core = require "signorini.core"
local csv = require "signorini.csv"

--- A published table by the name of its file in share/reference, as sg.csv.read gives it; its source is the first comment.
return function(name)
  return csv.read(("%s/reference/%s.csv"):format(core.share, name))
end
