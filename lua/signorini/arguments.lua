-- Checks of what a user gives to a function written in Lua, with the same kind of message as those written in C++:
-- function, argument, what came, what was expected, cure.

local core = require "signorini.core"

local arguments = {}

--- Raises an error at the user's line: "model:run: steps must be …, got …: cure".
function arguments.reject(where, name, expected, value, cure)
  local what = value == nil and ("%s is missing: it must be %s"):format(name, expected)
    or ("%s must be %s, got %s"):format(name, expected, core.describe(value))
  core.fail(("%s: %s%s"):format(where, what, cure and ": " .. cure or ""))
end

--- Raises an error about a key that is none of the known ones (a list), with the one that was probably meant.
function arguments.unknown(where, key, name, known)
  local meant = type(key) == "string" and core.nearest(key, known)
  local place = name ~= "its argument" and " in " .. name or ""
  core.fail(("%s: unknown argument '%s'%s; %s%s"):format(where, tostring(key), place,
    meant and ("did you mean '%s'? Known: "):format(meant) or "known: ", table.concat(known, ", ")))
end

--- The table itself, with no other keys than the known ones (a list). Absent means empty.
function arguments.table(where, name, value, known)
  if value == nil then return {} end
  if type(value) ~= "table" then arguments.reject(where, name, "a table of named arguments", value) end
  local allowed = {}
  for _, key in ipairs(known) do allowed[key] = true end
  for key in pairs(value) do
    if not allowed[key] then arguments.unknown(where, key, name, known) end
  end
  return value
end

local function is_finite(value)
  return type(value) == "number" and value == value and math.abs(value) < math.huge
end

--- What to do about a number in quotes.
local function unquote(value) return type(value) == "string" and tonumber(value) and "remove the quotes" or nil end

--- A finite number.
function arguments.number(where, name, value)
  if not is_finite(value) then arguments.reject(where, name, "a finite number", value, unquote(value)) end
  return value
end

--- A finite number above zero, or the default when absent.
function arguments.positive(where, name, value, default)
  if value == nil and default then return default end
  if not is_finite(value) or value <= 0 then
    arguments.reject(where, name, "a positive number", value, unquote(value))
  end
  return value
end

--- A finite number from `least`, or the default when absent.
function arguments.at_least(where, name, value, least, default)
  if value == nil and default then return default end
  if not is_finite(value) or value < least then
    arguments.reject(where, name, ("a number of at least %g"):format(least), value, unquote(value))
  end
  return value
end

--- A number above zero and at most `most`, or the default when absent.
function arguments.share(where, name, value, most, default)
  if value == nil and default then return default end
  if not is_finite(value) or value <= 0 or value > most then
    arguments.reject(where, name, ("a number above 0 and at most %g"):format(most), value, unquote(value))
  end
  return value
end

--- true or false, or the default when absent.
function arguments.flag(where, name, value, default)
  if value == nil then return default end
  if type(value) ~= "boolean" then arguments.reject(where, name, "true or false", value) end
  return value
end

--- A whole number of at least 1, and at most `most` where that is given, or the default when absent.
function arguments.count(where, name, value, default, most)
  if value == nil and default then return default end
  local whole = type(value) == "number" and math.tointeger(value)
  if not whole or whole < 1 or whole > (most or whole) then
    arguments.reject(where, name, most and ("a whole number from 1 to %d"):format(most)
      or "a whole number of at least 1", value, unquote(value))
  end
  return whole
end

--- A string, or the default when absent.
function arguments.string(where, name, value, default)
  if value == nil and default then return default end
  if type(value) ~= "string" then arguments.reject(where, name, "a string", value) end
  return value
end

--- "'a', 'b' or 'c'" of a list of words.
local function one_of(words)
  local quoted = {}
  for i, word in ipairs(words) do quoted[i] = ("'%s'"):format(word) end
  local last = table.remove(quoted)
  return #quoted > 0 and table.concat(quoted, ", ") .. " or " .. last or last
end

--- One of a list of words, or the default when absent.
function arguments.choice(where, name, value, words, default)
  if value == nil and default then return default end
  for _, word in ipairs(words) do
    if value == word then return value end
  end
  local meant = type(value) == "string" and core.nearest(value, words)
  arguments.reject(where, name, one_of(words), value, meant and ("did you mean '%s'?"):format(meant))
end

--- A function or nothing.
function arguments.callback(where, name, value)
  if value ~= nil and type(value) ~= "function" then arguments.reject(where, name, "a function", value) end
  return value
end

return arguments
