-- sg.arguments: the arguments name=value after a script's name on the command line.

local check = require "signorini.call.check"
local core = require "signorini.core"
local describe = require "signorini.call.describe"
local lists = require "signorini.call.lists"
local meant = require("signorini.call.text").meant
local types = require "signorini.call.types"

local map, sorted = lists.map, lists.sorted_names
local where = "sg.arguments"

-- ── Words ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The arguments of the calling script: those of its chunk, which the program or another script passes; without any,
--- those of the program.
local function words_of_script()
  for level = 2, math.huge do
    local frame = debug.getinfo(level, "S")
    if not frame then return arg end
    local caller = debug.getinfo(level + 1, "f")
    if frame.what == "main" and not (caller and caller.func == require) then
      local words = {}
      while debug.getlocal(level, -1 - #words) do
        words[#words + 1] = select(2, debug.getlocal(level, -1 - #words))
      end
      return #words > 0 and words or arg
    end
  end
end

--- Ends the script with a message of one line for the person at the command line, without a traceback
--- (src/repl/interpreter.cpp).
local Refusal = { __name = "refused argument", without_traceback = true }
function Refusal.__tostring(refusal) return refusal.message end
local function refuse(message) error(setmetatable({ message = message }, Refusal), 0) end

-- ── Values on the command line ───────────────────────────────────────────────────────────────────────────────────────

--- The kind of a value's type (signorini.types); nil if an argument cannot have it.
local function kind_of(value)
  if type(value) == "string" then return "text" end
  if type(value) == "boolean" then return "flag" end
  return math.type(value) and (math.type(value) == "integer" and "integer" or "number")
end

--- The kind of a list's entries: numbers if there are both whole and other numbers, text if the list is empty.
local function kind_of_entries(list)
  local function all(a, b)
    return not lists.any(list, function(entry) return kind_of(entry) ~= a and kind_of(entry) ~= (b or a) end)
  end
  return all "text" and "text" or all "integer" and "integer" or all("integer", "number") and "number" or nil
end

local function text_of(value)
  if type(value) == "boolean" then return value and "yes" or "no" end
  if type(value) == "number" then return core.number_text(value) end
  if type(value) == "string" then return value end
  return #value > 0 and table.concat(map(value, text_of), ",") or "none"
end

--- The value of a text; nil if the text is not valid. Numbers are never integers, because products of integers can
--- overflow.
local function parse(kind, text)
  if kind == "text" then return text end
  if kind == "flag" then
    if text == "yes" or text == "no" then return text == "yes" end
    return nil
  end
  local number = tonumber(text)
  if kind == "integer" then return number and math.tointeger(number) end
  return number and number + 0.0
end

-- ── What a script declares ───────────────────────────────────────────────────────────────────────────────────────────

--- The default of an argument, and its restrictions.
local function split(name, given)
  if type(given) == "table" and next(given) == nil then
    core.fail(("%s: the default of %s is an empty table. Hint: write { {}, none = true } for a list of strings "
      .. "that may be empty"):format(where, name))
  end
  local restrictions = {}
  for key, value in pairs(type(given) == "table" and given or {}) do
    if math.type(key) ~= "integer" then restrictions[key] = value end
  end
  if next(restrictions) == nil then return given, {} end
  if #given > 1 then
    core.fail(("%s: %s has a list as default and restrictions. Hint: write { { %s, … }, … }"):format(where, name,
      text_of(given[1])))
  end
  return given[1], check.value(types.named "argument", restrictions, where, name)
end

local function variant_names(name, default, variants)
  check.value(types.text, default, where, "the default of " .. name)
  local names = sorted(variants)
  table.sort(names, function(a, b) return a == default or b ~= default and a < b end)
  return names
end

--- Checks the restrictions that depend on the default.
local function check_restrictions(argument)
  local name, kind = argument.name, argument.kind
  for _, limit in ipairs { "at_least", "above", "at_most", "below" } do
    if argument[limit] and kind ~= "integer" and kind ~= "number" then
      core.fail(("%s: %s.%s is allowed only for numbers, and %s is not a number"):format(where, name, limit, name))
    end
  end
  for i, choice in ipairs(argument.choices or {}) do
    local one = kind_of(choice)
    if one ~= kind and not (one == "integer" and kind == "number") then
      check.reject(where, ("%s.choices[%d]"):format(name, i), "of the type of the default", choice)
    end
  end
  if (argument.check == nil) ~= (argument.expected == nil) then
    core.fail(("%s: %s needs both check, a function, and expected, its condition in words"):format(where, name))
  end
  if argument.none and not argument.list then
    core.fail(("%s: %s.none is allowed only for lists, and the default is not a list"):format(where, name))
  end
end

local function type_of(argument)
  if argument.choices then return types.choice(argument.choices) end
  local low = argument.at_least or argument.kind == "integer" and not argument.above and 1 or nil
  return { kind = argument.kind, low = low, above = argument.above, high = argument.at_most, below = argument.below }
end

local function in_words(argument)
  local words = argument.expected or argument.list and describe.several(argument.type)
    or argument.kind == "flag" and "yes or no" or describe.one(argument.type)
  return argument.none and words .. ", or none" or words
end

--- The argument { name, default, kind, list (whether it is one), type, words (what it must be), … its restrictions } of
--- a default, or of a table whose first entry is the default and whose other keys restrict it.
local function declare_one(name, given)
  local default, argument = split(name, given)
  argument.name, argument.default, argument.list = name, default, type(default) == "table"
  argument.kind = argument.list and kind_of_entries(default) or kind_of(default)
  if not argument.kind then
    check.reject(where, "the default of " .. name,
      "a string, a number, true, false, or a list of strings or of numbers", default)
  end
  if argument.variants then argument.choices = variant_names(name, default, argument.variants) end
  check_restrictions(argument)
  argument.type = type_of(argument)
  argument.none = argument.none or argument.list and #default == 0
  argument.words = in_words(argument)
  for _, value in ipairs(argument.list and default or { default }) do
    check.value(argument.type, value, where, "the default of " .. name)
  end
  return argument
end

--- The arguments of a table of defaults by name.
local function declare(defaults)
  local known = {}
  for name, given in pairs(defaults) do
    if not name:find "^%a[%w_]*$" or name == "help" then
      core.fail(("%s: %s cannot be the name of an argument"):format(where, core.describe(name)))
    end
    known[name] = declare_one(name, given)
  end
  return known
end

--- The argument that selects a variant; nil if there is none.
local function chooser_of(known)
  local found = lists.filter(sorted(known), function(name) return known[name].variants end)
  if #found > 1 then core.fail(("%s: both %s and %s have variants"):format(where, found[1], found[2])) end
  return known[found[1]]
end

--- The further arguments by variant; empty without variants.
local function declare_variants(chooser)
  local further = {}
  for variant, defaults in pairs(chooser and chooser.variants or {}) do
    further[variant] = declare(defaults)
    if further[variant][chooser.name] or chooser_of(further[variant]) then
      core.fail(("%s: the variant %s has variants itself"):format(where, variant))
    end
  end
  return further
end

-- ── Help ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- "name=default" of all arguments, sorted.
local function listed(known)
  return map(sorted(known), function(name) return name .. "=" .. text_of(known[name].default) end)
end

--- One line per argument: its default and its condition, aligned unless a default is very long.
local function page_of(known)
  local most, texts = 54, listed(known)
  local width = math.max(0, table.unpack(map(texts, function(text) return math.min(utf8.len(text), most) end)))
  return map(sorted(known), function(name, i)
    return ("  %s%s  %s"):format(texts[i], (" "):rep(width - utf8.len(texts[i])), known[name].words)
  end)
end

local function help(common, chooser, further)
  local script = arg and arg[0] and arg[0] ~= "" and arg[0] or "the script"
  local lines = lists.joined({ ("Arguments of %s, with their defaults:"):format(script) }, page_of(common))
  for _, variant in ipairs(chooser and chooser.choices or {}) do
    lines = lists.joined(lines, { ("with %s=%s also:"):format(chooser.name, variant) }, page_of(further[variant]))
  end
  print(table.concat(lines, "\n") .. "\nSeparate several values by commas: a,b,c.")
  os.exit(true, true)
end

-- ── Reading ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local function refuse_value(argument, text, part)
  refuse(("%s must be %s, got %s%s"):format(argument.name, argument.words,
    text == "" and "nothing" or part == text and ("'%s'"):format(text) or ("'%s' in '%s'"):format(part, text),
    argument.kind == "text" and meant(part, argument.choices or {}) or ""))
end

local function value_of(argument, text)
  local list, default = {}, argument.default
  if text == nil then return argument.list and lists.joined(default) or default end
  if argument.none and text == "none" then return list end
  for part in text:gmatch(argument.list and "[^,]+" or ".+") do
    local value = parse(argument.kind, part)
    if value == nil or not check.fits(argument.type, value) then refuse_value(argument, text, part) end
    list[#list + 1] = value
  end
  if #list == 0 then refuse_value(argument, text, text) end
  if argument.list then return list end
  return list[1]
end

local function check_words(texts, odd, known, chooser, further)
  local scope = chooser and (" with %s=%s"):format(chooser.name, chooser.chosen) or ""
  local function refuse_word(word, hint)
    refuse(("unknown argument '%s'%sknown%s: %s"):format(word, hint, scope, table.concat(listed(known), ", ")))
  end
  if odd then refuse_word(odd, ": arguments look like name=value; ") end
  for _, name in ipairs(sorted(texts)) do
    if not known[name] then
      local others = lists.filter(chooser and chooser.choices or {}, function(other) return further[other][name] end)
      local also = map(others, function(other) return ("%s=%s"):format(chooser.name, other) end)
      local hint = meant(name, sorted(known))
      refuse_word(("%s=%s"):format(name, texts[name]), #also > 0
        and (", which belongs to %s; "):format(table.concat(also, ", ")) or hint ~= "" and hint .. " " or "; ")
    end
  end
end

return function(defaults, words)
  local common, texts, odd = declare(defaults), {}, nil
  local chooser = chooser_of(common)
  local further = declare_variants(chooser)
  words = words or words_of_script()
  for i = 1, rawlen(words) do
    local word = words[i]
    if word == "help" or word == "--help" then help(common, chooser, further) end
    local name, text = word:match "^([%w_]+)=(.*)$"
    if name then texts[name] = text else odd = odd or word end -- of repeated arguments the last counts
  end
  local options = {}
  if chooser then chooser.chosen = value_of(chooser, texts[chooser.name]) end
  local known = lists.merged(common, chooser and further[chooser.chosen])
  check_words(texts, odd, known, chooser, further)
  for _, name in ipairs(sorted(known)) do options[name] = value_of(known[name], texts[name]) end
  for _, name in ipairs(sorted(known)) do
    local argument, value = known[name], options[name]
    for _, entry in ipairs(argument.check and (argument.list and value or { value }) or {}) do
      if not argument.check(entry, options) then
        refuse_value(argument, texts[name] or text_of(value), text_of(entry))
      end
    end
  end
  return options
end
