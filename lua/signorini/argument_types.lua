-- What a script says of one of its arguments: a default, from which follow its type and how a word is read, and what
-- restricts it. See sg.arguments.

local core = require "signorini.core"
local arguments = require "signorini.arguments"
local number_text = require "signorini.number_text"

local where = "sg.arguments"
local restrictions = { "choices", "at_least", "above", "at_most", "below", "check", "expected", "none", "variants" }

local argument_types = {}

-- ── Types ────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function read_number(text)
  local value = tonumber(text)
  if value and value == value and math.abs(value) < math.huge then return value + 0.0 end
end

local function read_whole(text)
  local value = read_number(text)
  return value and math.tointeger(value)
end

local function read_flag(text)
  if text == "yes" or text == "no" then return text == "yes" end
end

local function read_text(text) return text end

--- By name: one of it and several of it in words, and the value of a word (nil when it has none).
local types = {
  text = { one = "a text", several = "texts", read = read_text },
  whole = { one = "a whole number", several = "whole numbers", read = read_whole },
  number = { one = "a number", several = "numbers", read = read_number },
  flag = { one = "yes or no", read = read_flag },
}

--- The name of a value's type; nil when it has none.
local function type_of(value)
  if type(value) == "string" then return "text" end
  if type(value) == "boolean" then return "flag" end
  return math.type(value) and (math.type(value) == "integer" and "whole" or "number")
end

--- The type of a list's entries: numbers when there are both whole ones and others, texts when the list is empty.
local function type_of_entries(list)
  local found
  for _, entry in ipairs(list) do
    local one = type_of(entry)
    if not one or one == "flag" then return nil end
    if found and found ~= one then
      if found == "text" or one == "text" then return nil end
      one = "number"
    end
    found = one
  end
  return found or "text"
end

-- ── In words ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A value as it would stand on the command line.
function argument_types.text(value)
  if type(value) == "boolean" then return value and "yes" or "no" end
  if type(value) == "number" then return number_text(value) end
  if type(value) == "string" then return value end
  local texts = {}
  for i, entry in ipairs(value) do texts[i] = argument_types.text(entry) end
  return #texts > 0 and table.concat(texts, ",") or "none"
end

--- "a, b or c".
local function series(texts, conjunction)
  local first = table.concat(texts, ", ", 1, #texts - 1)
  return #texts > 1 and ("%s %s %s"):format(first, conjunction, texts[#texts]) or texts[1]
end

--- What the restrictions leave of a type, "numbers above 0", or which choices there are, "among m1 and m2".
local function restricted(argument)
  if argument.choices then
    local texts = {}
    for i, choice in ipairs(argument.choices) do texts[i] = argument_types.text(choice) end
    return argument.list and "among " .. series(texts, "and") or series(texts, "or")
  end
  local kind, limits = types[argument.type], {}
  for _, limit in ipairs { { "above", "above" }, { "at_least", "of at least" }, { "at_most", "of at most" },
                           { "below", "below" } } do
    local number = argument[limit[1]]
    if number then limits[#limits + 1] = ("%s %s"):format(limit[2], number_text(number)) end
  end
  local words = argument.list and kind.several or kind.one
  return #limits > 0 and words .. " " .. table.concat(limits, " and ") or words
end

--- What an argument must be.
local function in_words(argument)
  local words = argument.expected or restricted(argument)
  return argument.none and words .. ", or none" or words
end

-- ── What a script says of an argument ────────────────────────────────────────────────────────────────────────────────

--- Whether a value, or an entry of a list, keeps to the choices and limits.
local function is_allowed(argument, value)
  for _, choice in ipairs(argument.choices or { value }) do
    if choice == value then
      return argument.type == "text" or argument.type == "flag"
        or value >= (argument.at_least or value) and value <= (argument.at_most or value)
        and not (argument.above and value <= argument.above) and not (argument.below and value >= argument.below)
    end
  end
  return false
end

local function read_choices(name, argument)
  local choices = argument.choices
  if type(choices) ~= "table" or #choices == 0 then
    arguments.reject(where, name .. ".choices", "a list of values", choices)
  end
  for i, choice in ipairs(choices) do
    local one = type_of(choice)
    if one ~= argument.type and not (one == "whole" and argument.type == "number") then
      arguments.reject(where, ("%s.choices[%d]"):format(name, i), "of the type of the default", choice)
    end
  end
end

local function check_restrictions(name, argument)
  for _, key in ipairs { "at_least", "above", "at_most", "below" } do
    if argument[key] ~= nil then
      arguments.number(where, ("%s.%s"):format(name, key), argument[key])
      if argument.type ~= "whole" and argument.type ~= "number" then
        core.fail(("%s: %s.%s is for numbers, and %s is not one"):format(where, name, key, name))
      end
    end
  end
  if argument.choices ~= nil then read_choices(name, argument) end
  arguments.callback(where, name .. ".check", argument.check)
  if argument.expected ~= nil then arguments.string(where, name .. ".expected", argument.expected) end
  if (argument.check == nil) ~= (argument.expected == nil) then
    core.fail(("%s: %s needs both check, a function, and expected, what it asks for in words"):format(where, name))
  end
  if arguments.flag(where, name .. ".none", argument.none, false) and not argument.list then
    core.fail(("%s: %s.none is for lists, and the default is not one"):format(where, name))
  end
end

--- The default, and the restrictions, of what a script gives for an argument.
local function split(name, given)
  if type(given) == "table" and next(given) == nil then
    core.fail(("%s: the default of %s is an empty table: write { {}, none = true } for a list of texts that may be "
      .. "empty"):format(where, name))
  end
  local named, restricted = {}, false
  for key, value in pairs(type(given) == "table" and given or {}) do
    if math.type(key) ~= "integer" then named[key], restricted = value, true end
  end
  if not restricted then return given, {} end
  if #given > 1 then
    core.fail(("%s: %s has a list as default and restrictions: write { { %s, … }, … }"):format(where, name,
      argument_types.text(given[1])))
  end
  return given[1], arguments.table(where, name, named, restrictions)
end

--- The names of the variants, the default first.
local function variant_names(name, default, variants)
  if type(default) ~= "string" then
    arguments.reject(where, "the default of " .. name, "the name of a variant", default)
  end
  if type(variants) ~= "table" then
    arguments.reject(where, name .. ".variants", "a table of arguments by variant", variants)
  end
  local names = {}
  for key in pairs(variants) do names[#names + 1] = key end
  table.sort(names, function(a, b) return a == default or b ~= default and tostring(a) < tostring(b) end)
  return names
end

--- The argument { name, default, type, list (whether it is one), words (what it must be), … its restrictions } of a
--- default, or of a table whose first entry is the default and whose other keys restrict it.
function argument_types.argument(name, given)
  local default, named = split(name, given)
  local argument = { name = name, default = default, list = type(default) == "table" }
  for key, value in pairs(named) do argument[key] = value end
  argument.type = argument.list and type_of_entries(default) or type_of(default)
  if not argument.type then
    arguments.reject(where, "the default of " .. name,
      "a text, a number, true, false, or a list of texts or of numbers", default)
  end
  if argument.variants ~= nil then argument.choices = variant_names(name, default, argument.variants) end
  check_restrictions(name, argument)
  if argument.type == "whole" and not (argument.at_least or argument.above or argument.choices) then
    argument.at_least = 1
  end
  argument.none = argument.none or argument.list and #default == 0
  argument.words = in_words(argument)
  for _, value in ipairs(argument.list and default or { default }) do
    if not is_allowed(argument, value) then
      core.fail(("%s: the default of %s must be %s, got %s"):format(where, name, argument.words, core.describe(value)))
    end
  end
  return argument
end

--- The value that a text means for an argument; nil and the part that is wrong when it means none.
function argument_types.read(argument, text)
  local read = types[argument.type].read
  local function one(part)
    local value = read(part)
    if value ~= nil and is_allowed(argument, value) then return value end
  end
  if text == "" then return nil, text end
  if not argument.list then
    local value = one(text)
    return value, value == nil and text or nil
  end
  local list = {}
  if argument.none and text == "none" then return list end
  for part in text:gmatch "[^,]+" do
    local value = one(part)
    if value == nil then return nil, part end
    list[#list + 1] = value
  end
  if #list == 0 then return nil, text end
  return list
end

return argument_types
