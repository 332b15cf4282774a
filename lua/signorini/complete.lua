-- Completion at the prompt: the last path of names on the line ("sg.shapes.rec", "p:ref") and what can follow.

local core = require "signorini.core"

local words = { "and", "break", "do", "else", "elseif", "end", "false", "for", "function", "goto", "if", "in", "local",
  "nil", "not", "or", "repeat", "return", "then", "true", "until", "while" }

--- The table of entries behind a value: itself, or the methods of an object.
local function entries_of(value)
  if type(value) == "table" then return value end
  if type(value) == "userdata" then return rawget(core.types, core.kind(value)) end
  if type(value) == "string" then return string end
end

local function candidates(path)
  local entries = _G
  local owner, sign, beginning = path:match "^(.-)([.:]?)([%w_]*)$"
  for name in owner:gmatch "[%w_]+" do
    entries = entries and entries_of(rawget(entries, name))
  end
  local found = {}
  for name, value in next, entries or {} do
    if type(name) == "string" and name:sub(1, #beginning) == beginning and
       (sign ~= ":" or type(value) == "function") then
      found[#found + 1] = owner .. sign .. name
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
