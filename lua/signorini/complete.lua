-- Completion at the prompt: the last path of names on the line ("sg.shapes.rec", "p:ref") and what can follow, in
-- sg.body{ … also the named arguments that are not there yet.

local core = require "signorini.core"
local keys_of = require "signorini.help.keys"

local words = { "and", "break", "do", "else", "elseif", "end", "false", "for", "function", "goto", "if", "in", "local",
  "nil", "not", "or", "repeat", "return", "then", "true", "until", "while" }

--- The tables of entries behind a value: its own, and the methods of its type.
local function entries_of(value)
  local tables = { type(value) == "table" and value or nil }
  if type(value) == "userdata" then tables[#tables + 1] = rawget(core.types, core.kind(value)) end
  local own = type(value) ~= "userdata" and value ~= _G and getmetatable(value)
  if type(own) == "table" and type(own.__index) == "table" then tables[#tables + 1] = own.__index end
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

--- Whether users may call what stands in a table: methods that only the library calls have no help page.
local function offered(entries, name, value)
  local own = core.names[entries]
  return not (own and type(value) == "function") or core.docs[own .. ":" .. name] ~= nil
end

local function candidates(path)
  local owner, sign, beginning = path:match "^(.-)([.:]?)([%w_]*)$"
  local _, tables = follow(owner)
  local found = {}
  for _, entries in ipairs(tables) do
    for name, value in next, entries do
      if type(name) == "string" and name:sub(1, #beginning) == beginning and
         (sign ~= ":" or type(value) == "function") and offered(entries, name, value) then
        found[#found + 1] = owner .. sign .. name
      end
    end
  end
  if owner == "" and sign == "" then
    for _, word in ipairs(words) do
      if word:sub(1, #beginning) == beginning then found[#found + 1] = word end
    end
  end
  table.sort(found)
  return found
end

--- The brace that is open at the end of a text: the path of names before it and the text behind it; or nothing.
local function open_call(text)
  text = text:gsub('\\.', ""):gsub('"[^"\n]*"', "0"):gsub("'[^'\n]*'", "0"):gsub("%b{}", "0"):gsub("%b()", "0")
  local before, behind = text:match "^(.*){(.-)$"
  local path = before and (before:match "([%a_][%w_.:]*)%s*$" or before:match "([%a_][%w_.:]*)%s*%([^(){}]*$")
  return path, behind
end

--- Named arguments that begin like this, where one may stand: behind the brace of a call or a comma.
local function arguments(beginning, before)
  local path, behind = open_call(before)
  if not path or not behind:find "^%s*$" and not behind:find "[,;]%s*$" then return {} end
  local page, found = core.docs[core.names[(follow(path))] or ""], {}
  for _, key in ipairs(page and keys_of(page) or {}) do
    local taken = (";" .. behind):find("[,;%s]" .. key .. "%s*=")
    if key:sub(1, #beginning) == beginning and not taken then found[#found + 1] = key .. " = " end
  end
  return found
end

--- The n-th completion of a word, a path of names, that stands behind a text, or nil behind the last. Where a named
--- argument may stand and one begins like this, those are all that is offered.
return function(word, before, n)
  local divided, path = word:match "^(.*/)(.*)$"
  path = path or word
  local found = word:find "[.:/]" and {} or arguments(path, before)
  if #found == 0 then found = candidates(path) end
  return found[n] and (divided or "") .. found[n]
end
