-- How the prompt shows values: numbers and strings as in code, tables two levels deep and shortened if long.

local core = require "signorini.core"
local counted = require("signorini.call.text").counted
local language = require "signorini.prompt.show.language"
local object_text = require "signorini.prompt.show.objects"

local show = {}

local width = 100   -- characters of a line
local most = 40     -- entries of a table
local levels = 2    -- of nested tables
local longest = 1000 -- characters of a text in quotes

local function is_name(key) return type(key) == "string" and key:find "^[%a_][%w_]*$" ~= nil end

local function sorted_keys(value)
  local keys = {}
  for key in next, value do
    if not (math.type(key) == "integer" and key >= 1 and key <= #value) then keys[#keys + 1] = key end
  end
  table.sort(keys, function(a, b)
    if type(a) == type(b) and (type(a) == "string" or type(a) == "number") then return a < b end
    return tostring(a) < tostring(b)
  end)
  return keys
end

--- A text in quotes, shortened if very long, at the end of a character.
local function quoted(value)
  if #value <= longest then return (("%q"):format(value):gsub("\\\n", "\\n")) end
  local most = longest
  while most > 0 and (value:byte(most + 1) or 0) & 0xC0 == 0x80 do most = most - 1 end
  return ("%s… %d more bytes"):format(quoted(value:sub(1, most)), #value - most)
end

local text

local function table_text(value, level, indent)
  if level > levels then return next(value) == nil and "{}" or "{…}" end
  local inner = indent .. "  "
  local entries, left_out = {}, 0
  local function add(make)
    if #entries < most then entries[#entries + 1] = make() else left_out = left_out + 1 end
  end
  for i = 1, #value do add(function() return text(rawget(value, i), level + 1, inner) end) end
  local keys = sorted_keys(value)
  for _, key in ipairs(keys) do
    add(function()
      local label = is_name(key) and key or ("[%s]"):format(text(key, levels + 1, inner))
      return label .. " = " .. text(rawget(value, key), level + 1, inner)
    end)
  end
  if left_out > 0 then entries[#entries + 1] = ("… %d more"):format(left_out) end
  if #entries == 0 then return "{}" end
  local line = table.concat(entries, ", ")
  if #indent + #line + 2 <= width and not line:find "\n" then return "{" .. line .. "}" end
  if #keys == 0 and not line:find "\n" then return "{\n" .. language.row(entries, inner) .. "\n" .. indent .. "}" end
  return "{\n" .. inner .. table.concat(entries, ",\n" .. inner) .. "\n" .. indent .. "}"
end

--- An object in one line: the outcome of a run, the first line of others.
function show.line(value)
  if getmetatable(value) == core.types.run then
    return ("%s, %s, %s"):format(counted(value.steps, "step"), counted(value.iterations, "iteration"), value.reason)
  end
  return (tostring(value):match "^[^\n]*":gsub(":$", ""))
end

--- One value; tables and objects with __tostring use that.
function text(value, level, indent)
  if type(value) == "string" then return level == 1 and value:find "\n" and value or quoted(value) end
  if value ~= value then return "nan" end -- without the sign that the C library may print
  if type(value) == "function" then return language.of_function(value, level > 1) end
  local own = type(value) == "table" and getmetatable(value)
  if type(value) == "table" and not (type(own) == "table" and own.__tostring) then
    return table_text(value, level, indent)
  end
  return level == 1 and tostring(value) or show.line(value)
end

--- The text of a value as the prompt shows it.
function show.text(value) return object_text(value) or (text(value, 1, "")) end

--- Prints values one below the other.
function show.print(...)
  for i = 1, select("#", ...) do print(show.text((select(i, ...)))) end
end

return show
