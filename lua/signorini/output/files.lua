-- sg.files: the files that a script writes into its folder, as a list that is printed at the end.

local check = require "signorini.call.check"
local counted = require("signorini.call.text").counted
local core = require "signorini.core"
local holds = require("signorini.call.lists").holds
local on_behalf_of = require "signorini.call.on_behalf_of"
local types = require "signorini.call.types"

local Files = {}
Files.__index = Files
Files.__name = "list of files"
core.types.files = Files

--- The path of a file of this name in the folder, which is then listed as written.
function Files:__call(name)
  local path = ("%s/%s"):format(self.folder, check.value(types.text, name, "sg.files", "the name of a file"))
  if not holds(self, path) then self[#self + 1] = path end
  return path
end

function Files:__tostring()
  return ("%s in %s%s"):format(counted(#self, "file"), self.folder,
    #self > 0 and ":\n  " .. table.concat(self, "\n  ") or "")
end

function Files:draw(name, need, body)
  if body(("%s/%s"):format(self.folder, name)) then
    self(name)
  else
    print(("%s is left out: it needs %s"):format(name, need))
  end
end

function Files:report()
  if #self > 0 then print("\nWritten: " .. table.concat(self, "\n         ")) end
end

return function(folder)
  on_behalf_of("sg.files", "core.mkdir", core.mkdir, folder)
  return setmetatable({ folder = folder }, Files)
end
