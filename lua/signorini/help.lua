-- help(): the pages that stand beside the functions, in C++ (rows of src/bind) and in Lua (core.docs["sg.study"] = …),
-- a few on whole subjects, and the headers of the scripts that come along.

local core = require "signorini.core"
local pages = require "signorini.help.pages"
local scripts = require "signorini.help.scripts"
local sorted = require("signorini.lists").sorted_names
local subjects = require "signorini.help.subjects"
local texts = require "signorini.help.texts"

--- Pages by the name that their first line calls by: "m:iterate" for "model:iterate".
local function page_by_head(word)
  for _, name in ipairs(sorted(core.docs)) do
    if core.docs[name]:match "^[%w_.:]+" == word then return core.docs[name] end
  end
end

--- "model:run" for "m:run", by the letters that pages use, and for "model.run".
local letters = { b = "body", m = "model", p = "patch" }
local function spelt_out(word)
  local owner, method = word:match "^([%a_]+)[.:]([%w_]+)$"
  return owner and (letters[owner] or owner) .. ":" .. method
end

local function list(title, names) return title .. "\n" .. pages.list(names) end

--- A list of scripts.
local function script_list(title, found)
  local entries = {}
  for i, script in ipairs(found) do entries[i] = { script.name, script.title } end
  return title .. "\n" .. pages.lines(entries)
end

--- Every script, with how to run them.
local function all_scripts()
  return script_list("Scripts that come along; signorini <name> runs one, signorini <name> help lists its arguments,\n"
    .. "help \"<name>\" shows what it solves:", scripts.all())
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

--- Everything with a word in it: pages, the one that is called so in full, and scripts.
local function search(word)
  local names, own, parts = {}, {}, {}
  for name, page in pairs(core.docs) do
    if subjects.is_public(name) and (name .. "\n" .. page):lower():find(word:lower(), 1, true) then
      names[#names + 1] = name
      if name:match "[^.:]+$" == word then own[#own + 1] = name end
    end
  end
  table.sort(names)
  if #own == 1 then parts[#parts + 1] = core.docs[own[1]] end
  if #names > 0 then parts[#parts + 1] = list(("Pages with '%s':"):format(word), names) end
  local found = scripts.with(word)
  if #found > 0 then parts[#parts + 1] = script_list(("Scripts with '%s':"):format(word), found) end
  return #parts > 0 and table.concat(parts, "\n\n") or nil
end

--- What to say of a word that nothing has.
local function no_page(word)
  local known = {}
  for name in pairs(core.docs) do
    if subjects.is_public(name) then known[name], known[name:match "[^.:]+$"] = true, true end
  end
  for subject in pairs(texts) do known[subject] = true end
  for _, each in ipairs(subjects.groups) do known[each.word] = true end
  for _, script in ipairs(scripts.all()) do known[script.name] = true end
  known.gallery = true
  local meant = core.nearest(word, sorted(known))
  return ("There is no page on '%s'%s"):format(word, meant and ("; did you mean '%s'?"):format(meant)
    or ". help() shows where to begin.")
end

local function word_page(word)
  if not word:find "%w" or word == "exit" or word == "quit" then return texts.prompt end -- also ?_
  local exact = texts[word] or core.docs[word] or core.docs["sg." .. word] or core.docs[spelt_out(word) or ""]
    or page_by_head(word)
  if exact then return exact end
  if word == "gallery" then return all_scripts() end
  local group = subjects.group(word)
  if group then
    local pages_of_group = list(group.title .. ":", subjects.pages(group))
    return word == "scripts" and pages_of_group .. "\n\n" .. all_scripts() or pages_of_group
  end
  local script = scripts.of(word)
  if script then return ("%s\n\n%s"):format(script.path, script.header) end
  return search(word) or no_page(word)
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
Shows what a function does, its arguments with units and defaults, and an example; a word finds all pages and scripts
that hold it. help "scripts" lists the scripts that come along, help "hertz2d.lua" shows what one of them solves.
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
