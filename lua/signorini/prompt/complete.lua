-- Completion at the prompt: of the last path of names on the line ("sg.shapes.rec", "p:ref"), and in sg.body{ … of
-- named arguments that are not given yet.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local place = require "signorini.prompt.complete.place"
local pages = require "signorini.pages"
local rows = require "signorini.prompt.complete.rows"

local words = { "and", "break", "do", "else", "elseif", "end", "false", "for", "function", "goto", "if", "in", "local",
  "nil", "not", "or", "repeat", "return", "then", "true", "until", "while" }

local function begins(text, beginning) return text:sub(1, #beginning) == beginning end

--- The methods of a value whose type is written in Lua, such as a run; none for others.
local function type_of(value)
  local own = type(value) == "table" and getmetatable(value)
  return type(own) == "table" and core.names[own] and own or nil
end

--- The tables in which a value is indexed: itself, and the methods of its type.
local function entries_of(value)
  local tables = { type(value) == "table" and value or nil }
  if type(value) == "userdata" then tables[#tables + 1] = rawget(core.types, core.kind(value)) end
  local own = type(value) ~= "userdata" and value ~= _G and getmetatable(value)
  local methods = type_of(value) or type(own) == "table" and own.__index
  if type(methods) == "table" then tables[#tables + 1] = methods end
  return tables
end

local function field(tables, name)
  for _, entries in ipairs(tables) do
    local value = rawget(entries, name)
    if value ~= nil then return value end
  end
end

local function follow(path)
  local tables, value = { _G }, nil
  for name in path:gmatch "[%w_]+" do
    value = field(tables, name)
    tables = entries_of(value)
  end
  return value, tables
end

--- True if an entry of a table is public: it has a page.
local function offered(entries, name, value, sign)
  local methods = type_of(entries)
  if methods then
    local page = pages.find(core.names[methods])
    return sign == "." and page.fields ~= nil and pages.row(page.fields, name) ~= nil
  end
  local own = core.names[entries]
  return not own or name:find "^__" == nil and type(value) == "function"
    and pages.find(("%s:%s"):format(own, name)) ~= nil
end

local function candidates(path)
  local owner, sign, beginning = path:match "^(.-)([.:]?)([%w_]*)$"
  local _, tables = follow(owner)
  local found = {}
  for _, entries in ipairs(tables) do
    for name, value in next, entries do
      if type(name) == "string" and begins(name, beginning) and (sign ~= ":" or type(value) == "function")
        and offered(entries, name, value, sign) then
        found[#found + 1] = owner .. sign .. name
      end
    end
  end
  if owner == "" and sign == "" then
    found = lists.joined(found, lists.filter(words, function(word) return begins(word, beginning) end))
  end
  table.sort(found)
  return found
end

--- The name of the function that a path denotes, and the object of the call: that of a method, otherwise the first
--- argument.
local function page_of(call)
  local owner = call.path:match "^(.*)[.:]"
  local name = core.names[(follow(call.path))]
  return name, name and name:find ":" and owner and (follow(owner)) or (follow(call.first))
end

--- Named arguments that begin like this, if one is possible here: after the brace of a call or a comma.
local function arguments(beginning, before)
  local call = place.of(before)
  if not call or not call.in_braces or not (call.behind:find "^%s*$" or call.behind:find "[,;]%s*$") then return {} end
  local name, owner = page_of(call)
  local free = lists.filter(name and rows.names(name, call.argument, call.keys, owner) or {}, function(key)
    return begins(key, beginning) and not (";" .. call.behind):find("[,;%s]" .. key .. "%s*=")
  end)
  return lists.map(free, function(key) return key .. " = " end)
end

--- Strings that begin like this, after a quotation mark.
local function texts(beginning, before)
  local call = place.of(before)
  if not call or not call.quoted then return {} end
  local name, owner = page_of(call)
  if not name then return {} end
  local key = call.behind:match "([%a_][%w_]*)%s*=%s*$"
  local listed, list = pcall(rows.texts, name, call.argument, lists.joined(call.keys, { key }), owner)
  return lists.filter(listed and list or {}, function(text) return begins(text, beginning) end)
end

--- The completions of a word after a text, a list: of a path of names or, inside quotes, of a string. Where a named
--- argument is possible and one begins like this, only those are offered.
return function(word, before)
  if before:find "%f[^\n\0]%s*[%%!?][^\n]*$" then
    local found = require "signorini.prompt.complete.commands"(word, before, function() return candidates(word) end)
    if found then return found end
  end
  if before:find "[\"']$" and place.is_open(before) then return texts(word, before) end
  local divided, path = word:match "^(.*/)(.*)$"
  path = path or word
  local found = word:find "[.:/]" and {} or arguments(path, before)
  if #found == 0 then found = candidates(path) end
  return lists.map(found, function(name) return (divided or "") .. name end)
end
