-- sg.files: what a script writes into its folder, as a list that is printed at the end.

local core = require "signorini.core"
local arguments = require "signorini.arguments"

local Files = {}
Files.__index = Files
Files.__name = "list of files"
core.types.files = Files

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

function Files:__tostring()
  return ("%d file%s in %s%s"):format(#self, #self == 1 and "" or "s", self.folder,
    #self > 0 and ":\n  " .. table.concat(self, "\n  ") or "")
end

core.docs["files"] = [[
files
What sg.files returns: files "name" is a path in its folder, files.folder the folder; a list of what was written.]]

core.docs["files:draw"] = [[
files:draw(name, need, body)
Has a file drawn by body(path), and counts it as written; when body returns false there was nothing to draw, and a line
says what it would need.
Example: files:draw("forces.png", "two steps", function(path) return run.steps > 1 and run:csv(path) == nil end)]]
function Files:draw(name, need, body)
  arguments.string("files:draw", "need", need)
  if body == nil then arguments.reject("files:draw", "body", "a function of the file's path", body) end
  arguments.callback("files:draw", "body", body)
  if body(path_of(self, name)) then self(name) else print(("%s is left out: it needs %s"):format(name, need)) end
end

core.docs["files:report"] = [[
files:report()
Prints the list of what was written; nothing when nothing was.
Example: files:report()]]
function Files:report()
  if #self > 0 then print("\nWritten: " .. table.concat(self, "\n         ")) end
end

core.docs["sg.files"] = [[
sg.files(folder)
Makes the folder and returns a list of the files that a script writes there: files "forces.png" is the path of a file
and adds it to the list; files:draw and files:report, which see. files.folder is the folder.
Example: files = sg.files "out/study"; run:csv(files "N2.csv"); files:report()]]
return function(folder)
  core.mkdir(arguments.string("sg.files", "its argument", folder))
  return setmetatable({ folder = folder }, Files)
end
