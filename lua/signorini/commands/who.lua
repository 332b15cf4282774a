-- %who: the user's variables, one per line.

local core = require "signorini.core"
local counted = require "signorini.counted"
local cut = require "signorini.cut"
local lists = require "signorini.lists"
local pages = require "signorini.pages"
local prompt = require "signorini.prompt"
local show = require "signorini.show"
local table_text = require "signorini.table"

local width = 80 -- of a summary

--- "3 values: fx, fy, fz" of a table without a text of its own.
local function entries_text(value)
  local count, names = 0, {}
  for key in next, value do
    count = count + 1
    if type(key) == "string" then names[#names + 1] = key end
  end
  table.sort(names)
  return counted(count, "value") .. (#names > 0 and ": " or "") .. table.concat(names, ", ")
end

--- A value in one line, with its size where it has one.
local function summary(value)
  if pages.kind(value) == "run" then
    return ("%s, %s, %s"):format(counted(value.steps, "step"), counted(value.iterations, "iteration"), value.reason)
  end
  local own = type(value) == "table" and getmetatable(value)
  local text = type(value) == "table" and not (type(own) == "table" and own.__tostring) and entries_text(value)
    or type(value) == "userdata" and tostring(value) or show.text(value)
  return cut(text:match "^[^\n]*", width)
end

return function()
  local variables, rows = prompt.variables(), {}
  for _, name in ipairs(lists.sorted_names(variables)) do
    rows[#rows + 1] = { name, pages.kind(variables[name]), summary(variables[name]) }
  end
  if #rows == 0 then return print "There are no variables." end
  print(table_text { columns = { "variable", "type", "value" }, rows = rows })
end
