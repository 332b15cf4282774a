-- Completion at the prompt: the last path of names on the line ("sg.shapes.rec", "p:ref") and what can follow.

local core = require "signorini.core"

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

local function candidates(path)
  local tables = { _G }
  local owner, sign, beginning = path:match "^(.-)([.:]?)([%w_]*)$"
  for name in owner:gmatch "[%w_]+" do
    tables = entries_of(field(tables, name))
  end
  local found = {}
  for _, entries in ipairs(tables) do
    for name, value in next, entries do
      if type(name) == "string" and name:sub(1, #beginning) == beginning and
         (sign ~= ":" or type(value) == "function") then
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

--- The n-th completion of a path of names, or nil behind the last.
return function(path, n)
  return candidates(path)[n]
end
