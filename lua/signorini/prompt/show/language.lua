-- How the prompt shows the library: a function by the first line of its help page, a table such as sg.shapes by its
-- names.

local core = require "signorini.core"
local pages = require "signorini.pages"
local lists = require "signorini.call.lists"
local named = require "signorini.call.named"
local wrapped = require("signorini.call.text").wrapped

local width = 100 -- characters of a line

local language = {}

--- Texts separated by commas, in indented lines.
function language.row(texts, indent)
  local words = lists.map(texts, function(text, i) return i < #texts and text .. "," or text end)
  return #texts > 0 and table.concat(wrapped(words, width, indent, indent), "\n") or ""
end

--- The text of a function. `brief`: as an entry of a table.
function language.of_function(f, brief)
  local name, about = core.names[f], debug.getinfo(f, "S")
  local page = name and pages.find(name)
  if not page then
    return about.what == "C" and "function" or ("function (%s:%d)"):format(about.short_src, about.linedefined)
  end
  if brief then return name end
  local head = pages.head(page)
  return ("%s\n  see help%s"):format(head, name:find ":" and (" %q"):format(name) or ("(%s)"):format(name))
end

--- The text of a table of the library.
function language.of_table(entries, name)
  local functions, lines = {}, {}
  for _, key in ipairs(lists.sorted_names(entries)) do
    if type(entries[key]) == "function" then functions[#functions + 1] = key end
    if type(entries[key]) == "table" then
      local names = lists.sorted_names(named.entries(entries[key]))
      lines[#lines + 1] = ("  %s:\n%s"):format(key, language.row(names, "    "))
    end
  end
  table.insert(lines, 1, ("%s: see help(%s)"):format(name, name))
  table.insert(lines, 2, language.row(functions, "  "))
  return table.concat(lines, "\n")
end

return language
