-- The definitions for editors, made from the tables of the functions; the build writes them to its folder
-- generated/library. They are Lua files with annotations, one per subject, which a Lua language server reads to
-- complete and check scripts; the program does not load them.

local annotation = require "signorini.prompt.editor.annotation"
local core = require "signorini.core"
local lists = require "signorini.call.lists"
local names = require "signorini.prompt.help.names"
local page_text = require "signorini.prompt.help.page_text"
local pages = require "signorini.pages"
local prose = require "signorini.prompt.editor.prose"
local named = require "signorini.call.named"

local function add(lines, ...)
  for _, line in ipairs { ... } do lines[#lines + 1] = line end
end

-- ── Classes and aliases ──────────────────────────────────────────────────────────────────────────────────────────────

local function add_fields(lines, fields)
  for _, field in ipairs(fields) do
    local key, type, row = table.unpack(field)
    if row and not row.hidden and (row[3] or row.unit) then prose.add_text(lines, page_text.row(row)) end
    add(lines, ("---@field %s %s"):format(key, type))
  end
end

local function add_class(lines, one)
  add(lines, ("---@class %s%s"):format(one.exact and "(exact) " or "", one.class))
  add_fields(lines, one.fields)
end

--- Adds what types have defined; `made`: the definitions so far, by name.
local function add_found(lines, found, made)
  for _, one in ipairs(found) do
    local name, own = one.class or one.alias, { "" }
    if one.class then add_class(own, one) else add(own, ("---@alias %s %s"):format(one.alias, one.text)) end
    local text = table.concat(own, "\n")
    if made[name] and made[name] ~= text then error("two types have the name " .. name) end
    if not made[name] then add(lines, table.unpack(own)) end
    made[name] = text
  end
end

-- ── Functions ────────────────────────────────────────────────────────────────────────────────────────────────────────

local function add_help(lines, page)
  prose.add_text(lines, page.text)
  if page.named or page.head and page.head ~= page.name then
    add(lines, "---")
    prose.add_head(lines, pages.head(page))
  end
  if page.more then
    add(lines, "---")
    prose.add_text(lines, page.more:gsub("^\n", ""))
  end
  local examples = page_text.examples(page)
  if #examples == 0 then return end
  add(lines, "---", "---Example:")
  prose.add_code(lines, table.concat(examples, "\n"), "lua")
end

local function may_be_omitted(row)
  if not row[2].last then return not pages.is_needed(row) end
  return not lists.any(pages.rows(row[2].rows), function(one) return type(one) == "table" and pages.is_needed(one) end)
end

--- The parameters of a page: { name, type, text, optional = }.
local function parameters(page, place, found)
  if page.named then
    local of = { kind = "named", rows = page.named, rest = page.rest, entries = page.entries }
    return { { "arguments", annotation.of(of, place .. ".arguments", found), optional = page.may_be_empty } }
  end
  local list = lists.map(page.arguments or {}, function(row)
    return { row[1], annotation.of(row[2], place .. "." .. row[1], found),
             row[3] ~= "" and page_text.row(row) or nil, optional = may_be_omitted(row) }
  end)
  if page.repeats then list[#list + 1] = { "...", list[#list][2] } end
  return list
end

local function results(page, place, found)
  local own = { are_results = true }
  local types = lists.map(pages.results(page), function(of, i)
    return annotation.of(of, i == 1 and place .. ".result" or ("%s.result%d"):format(place, i), own)
  end)
  table.move(own, 1, #own, #found + 1, found)
  return types
end

--- Adds the definition of a function with what it needs. `name`: as Lua writes it, sg.f or run:csv.
local function add_function(lines, page, name, made)
  local place, found = annotation.place(page.name), {}
  local takes, gives = parameters(page, place, found), results(page, place, found)
  add_found(lines, found, made)
  add(lines, "")
  add_help(lines, page)
  for _, one in ipairs(takes) do
    local text = one[3] and " # " .. prose.line(one[3]) or ""
    add(lines, ("---@param %s%s %s%s"):format(one[1], one.optional and "?" or "", one[2], text))
  end
  for _, type in ipairs(gives) do add(lines, "---@return " .. type) end
  local heads = lists.map(takes, function(one) return one[1] end)
  add(lines, ("function %s(%s) end"):format(name, table.concat(heads, ", ")))
end

--- Adds the class of a type with its fields and calls.
local function add_type(lines, page, made)
  local class = annotation.place(page.name)
  local found = {}
  local of = annotation.class(class, { rows = page.fields or {}, is_result = true }, found)
  local call
  if page.arguments then
    local takes = lists.map(parameters(page, class, found), function(one) return ("%s: %s"):format(one[1], one[2]) end)
    call = ("---@overload fun(%s): %s"):format(table.concat(takes, ", "), results(page, class, found)[1])
  end
  add_found(lines, found, made)
  add(lines, "")
  add_help(lines, page)
  add(lines, "---@class " .. class)
  add_fields(lines, of.fields)
  add(lines, call)
  add(lines, ("local %s = {}"):format(page.name))
end

--- Adds the class of rows that other pages use, such as those of a contact.
local function add_part(lines, page, made)
  local found = {}
  local class = annotation.class(annotation.place(page.name), { rows = page.named, rest = page.rest }, found)
  add_found(lines, found, made)
  add(lines, "")
  add_help(lines, page)
  add_class(lines, class)
end

-- ── Files ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local note = "-- Generated from the help pages by the build; read by editors, not by the program."

--- The table that a function or method belongs to, sg.csv or run; nil of globals.
local function owner(name) return name:match "^(.*)[.:]" end

--- The file of a subject. `made`: the classes and aliases defined so far.
local function subject(group, made)
  local lines, declared = { "---@meta _", note, "-- " .. group.title }, {}
  local function declare(name)
    if not name or declared[name] then return end
    declare(owner(name))
    declared[name] = true
    local is_local = not name:find("[.:]")
    add(lines, "", "---@class " .. annotation.place(name), ("%s%s = {}"):format(is_local and "local " or "", name))
  end
  for _, page in ipairs(group) do
    local value = names.value(page.name)
    if type(value) == "function" then
      declare(owner(page.name))
      add_function(lines, page, page.name, made)
    elseif page.named then
      add_part(lines, page, made)
    elseif value then
      declared[page.name] = true
      add_type(lines, page, made)
    end
  end
  return table.concat(lines, "\n") .. "\n"
end

local module = [[
---@meta signorini
%s

---Isogeometric contact mechanics: what `require "signorini"` returns.
---@class sg
%s
local sg = {}

---No value is of this class: it marks arguments that a function does not have, such as misspelled ones.
---@class sg.unknown_argument

return sg
]]

local prompt = [[
---@meta _
%s
-- Globals of the prompt and of code given by -e; scripts begin with: local sg = require "signorini"

sg = require "signorini"

]]

--- The texts of all files by name.
return function()
  local files, made, globals = {}, {}, { prompt:format(note) }
  for _, group in ipairs(pages.groups()) do files[group.word .. ".lua"] = subject(group, made) end
  local fields = {}
  for _, name in ipairs(lists.sorted_names(named.entries(core.sg))) do
    if type(core.sg[name]) == "table" then fields[#fields + 1] = ("---@field %s sg.%s"):format(name, name) end
  end
  files["signorini.lua"] = module:format(note, table.concat(fields, "\n"))
  add_function(globals, pages.find "sg.help", "help", made)
  add_function(globals, pages.find "traceback", "traceback", made)
  files["prompt.lua"] = table.concat(globals, "\n") .. "\n"
  return files
end
