-- help(): the pages that stand beside the functions, in C++ (rows of src/bind) and in Lua (core.docs["sg.study"] = …),
-- and a few on whole subjects.

local core = require "signorini.core"
local sorted = require("signorini.lists").sorted_names
local subjects = require "signorini.help.subjects"
local texts = require "signorini.help.texts"

--- The first line of a page: how to call it. One that goes on in the next line ends with … and what is open.
local function head(name)
  local line = core.docs[name]:match "^[^\n]*"
  local open = {}
  for bracket in line:gmatch "[(){}]" do
    if bracket == "(" or bracket == "{" then open[#open + 1] = bracket else open[#open] = nil end
  end
  if #open == 0 then return line end
  local ends = ""
  for _, bracket in ipairs(open) do ends = (bracket == "(" and ")" or " }") .. ends end
  return line:gsub("[%s,]*$", "") .. ", …" .. ends
end

--- Pages by the name that their first line calls by: "m:iterate" for "model:iterate".
local function page_by_head(word)
  for _, name in ipairs(sorted(core.docs)) do
    if core.docs[name]:match "^[%w_.:]+" == word then return core.docs[name] end
  end
end

--- "model:run" for "m:run", by the letters that pages use.
local letters = { b = "body", m = "model", p = "patch" }
local function spelt_out(word)
  local letter, method = word:match "^(%a):([%w_]+)$"
  return letters[letter] and letters[letter] .. ":" .. method
end

local function list(title, names)
  local lines = { title }
  for _, name in ipairs(names) do lines[#lines + 1] = "  " .. head(name) end
  return table.concat(lines, "\n")
end

--- The pages of what a table holds, such as sg.nurbs.
local function table_page(value)
  local names = {}
  local function collect(entries, depth)
    for _, entry in next, entries do
      local name = core.names[entry]
      if name then names[name] = true elseif type(entry) == "table" and depth < 2 then collect(entry, depth + 1) end
    end
  end
  collect(value, 1)
  if next(names) == nil then return "This table has no help page. help() shows where to begin." end
  return list("It holds:", sorted(names))
end

local function word_page(word)
  local exact = texts[word] or core.docs[word] or core.docs["sg." .. word] or core.docs[spelt_out(word) or ""]
    or page_by_head(word)
  if exact then return exact end
  local group = subjects.group(word)
  if group then return list(group.title .. ":", subjects.pages(group)) end
  local names, last = {}, {}
  for name, page in pairs(core.docs) do
    if (name .. "\n" .. page):lower():find(word:lower(), 1, true) then names[name] = true end
    last[name], last[name:match "[^.:]+$"] = true, true
  end
  if next(names) then
    local found, own = list(("Pages with '%s':"):format(word), sorted(names)), {}
    for name in pairs(names) do
      if name:match "[^.:]+$" == word then own[#own + 1] = name end
    end
    return #own == 1 and ("%s\n\n%s"):format(core.docs[own[1]], found) or found
  end
  for subject in pairs(texts) do last[subject] = true end
  for _, each in ipairs(subjects.groups) do last[each.word] = true end
  local meant = core.nearest(word, sorted(last))
  return ("There is no page on '%s'%s"):format(word, meant and ("; did you mean '%s'?"):format(meant)
    or ". help() shows where to begin.")
end

local function value_page(value)
  local methods = type(value) == "table" and getmetatable(value) or nil
  local name = core.names[value] or core.names[methods] or core.kind(value)
  if core.docs[name] then return core.docs[name] end
  if type(value) == "table" then return table_page(value) end
  return ("There is no help page for a %s."):format(core.kind(value))
end

local help = {}

core.docs["help"] = [[
help(), help(sg.nurbs.arc), help "patch:refine", help "labels"
Shows what a function does, its arguments with units and defaults, and an example; a word finds all pages that hold it.
At the prompt ?sg.nurbs.arc and ?refine do the same.
Example: help(sg.nurbs.arc)]]
function help.show(...)
  local value = ...
  if select("#", ...) == 0 then return print(texts.start) end
  if value == nil then return print "help(nil): this name stands for nothing. help() shows where to begin." end
  print(type(value) == "string" and word_page(value) or value_page(value))
end

--- What a path of names such as "sg.shapes", "run:column" or "x.y" stands for among the globals, or nil.
local function look_up(path)
  local value = _G
  for name in path:gmatch "[^.:]+" do
    local found, entry = pcall(function() return value == _G and rawget(_G, name) or value ~= _G and value[name] end)
    if not found or not entry then return nil end
    value = entry
  end
  return value
end

--- What ?query at the prompt shows: the page of that name, else of the value that it stands for, else a search.
function help.ask(query)
  local word = query:match "^%s*(.-)[%s()]*$"
  if word == "" then return help.show() end
  if core.docs[word] or texts[word] then return help.show(word) end
  local value = word:find "^[%a_][%w_.:]*$" and look_up(word)
  local known = value and (core.names[value] or type(value) == "table" or type(value) == "userdata")
  help.show(known and type(value) ~= "string" and value or word)
end

return help
