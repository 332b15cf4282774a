-- %who: the user's variables, one per line.

local counted = require("signorini.call.text").counted
local cut = require("signorini.call.text").cut
local lists = require "signorini.call.lists"
local pages = require "signorini.pages"
local prompt = require "signorini.prompt.prompt"
local show = require "signorini.prompt.show"
local table_text = require("signorini.output.table").text

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
  local own = type(value) == "table" and getmetatable(value)
  local has_text = type(own) == "table" and own.__tostring
  if type(value) == "table" and not has_text then return cut(entries_text(value), width) end
  if type(value) == "table" or type(value) == "userdata" then return cut(show.line(value), width) end
  return cut(show.text(value):match "^[^\n]*", width)
end

return function()
  local variables, rows = prompt.variables(), {}
  for _, name in ipairs(lists.sorted_names(variables)) do
    rows[#rows + 1] = { name, pages.kind(variables[name]), summary(variables[name]) }
  end
  if #rows == 0 then return print "There are no variables." end
  print(table_text { columns = { "variable", "type", "value" }, rows = rows })
end
