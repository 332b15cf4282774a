-- Writes what follows from tables of the program: the definitions for editors, the man page and the completion.
--   signorini share/cmake/generated.lua <folder>

require "signorini" -- defines all types of objects
local core = require "signorini.core"
local folder = arg[1]

local function write(name, text)
  core.mkdir(folder .. "/" .. name:match "^[^/]*")
  core.write_file(folder .. "/" .. name, text)
end

for name, text in pairs(require "signorini.prompt.editor.library"()) do write("library/" .. name, text) end

local function escaped(text) return (text:gsub("%-", "\\-"):gsub("'", "\\(aq")) end

local names, valued, manual = {}, {}, {}
for i, option in ipairs(core.options) do
  local name, value, text, more = table.unpack(option)
  names[i] = name
  if value ~= "" then valued[#valued + 1] = name end
  text = text:gsub("^%l", string.upper):gsub("\n", " ") .. "." .. (more == "" and "" or "\n" .. more)
  manual[i] = escaped((".TP\n.BI %s \" %s\"\n%s"):format(name, value,
    text:gsub("([ (\n])(%-%-?%a[%a-]*)", "%1\\fB%2\\fR")))
end
local texts = { names = table.concat(names, " "), valued = table.concat(valued, " | "),
                options = table.concat(manual, "\n") }
for _, name in ipairs { "completion/signorini", "man/signorini.1" } do
  write(name, (core.read_file(("%s/%s"):format(core.share, name)):gsub("@(%l+)@", texts)))
end
