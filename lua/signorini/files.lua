-- sg.files: what a script writes into its folder, as a list that is printed at the end.

local core = require "signorini.core"
local arguments = require "signorini.arguments"

local Files = {}
Files.__index = Files
Files.__name = "list of files"

local function path_of(files, name)
  return ("%s/%s"):format(files.folder, arguments.string("sg.files", "the name of a file", name))
end

--- The path of a file of this name in the folder, which counts as written from now on.
function Files:__call(name)
  local path = path_of(self, name)
  for _, known in ipairs(self) do
    if known == path then return path end
  end
  self[#self + 1] = path
  return path
end

--- Has a file drawn by body(path), which returns whether there was anything to draw; says what it needs if there was
--- not.
function Files:draw(name, need, body)
  if body(path_of(self, name)) then self(name) else print(("%s is left out: it needs %s"):format(name, need)) end
end

--- Prints what was written; nothing when nothing was.
function Files:report()
  if #self > 0 then print("\nWritten: " .. table.concat(self, "\n         ")) end
end

return function(folder)
  core.mkdir(arguments.string("sg.files", "its argument", folder))
  return setmetatable({ folder = folder }, Files)
end
