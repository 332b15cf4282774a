-- Types of arguments in words: "a positive number", "a list of 2 numbers {x, y}", for messages and help pages.

local lists = require "signorini.call.lists"
local number_text = require("signorini.core").number_text

local describe = {}

--- "a patch", "an obstacle".
function describe.with_article(noun) return (noun:find "^[aeio]" and "an " or "a ") .. noun end

--- "a, b or c".
function describe.alternatives(words)
  local first = table.concat(words, ", ", 1, #words - 1)
  return #words > 1 and first .. " or " .. words[#words] or words[1]
end

--- A noun with its limits.
local function limited(noun, type)
  local low, above, high = type.low, type.above, type.high
  if above == 0 and not high and not type.below then return noun:gsub("(%a+)$", "positive %1") end
  local parts = {}
  if low and high then return ("%s from %s to %s"):format(noun, number_text(low), number_text(high)) end
  if low then parts[1] = number_text(low) .. " or more" end
  if above then parts[1] = "above " .. number_text(above) end
  if high then parts[#parts + 1] = "at most " .. number_text(high) end
  if type.below then parts[#parts + 1] = "below " .. number_text(type.below) end
  if #parts == 0 then return noun end
  return noun .. (low and ", " or " ") .. table.concat(parts, " and ")
end

local shapes = { "{x}", "{x, y}", "{x, y, z}" }

local words, plurals = {}, {}

--- What a value of a type is: "a whole number from 1 to 40".
function describe.one(type) return type.words or words[type.kind](type) end

--- What several are: "whole numbers from 1 to 40".
function describe.several(type)
  local plural = not type.words and plurals[type.kind]
  return type.several or plural and plural(type) or "entries: each " .. describe.one(type)
end

function words.any() return "any value" end
function words.flag() return "true or false" end
function words.text(type) return type.noun and describe.with_article(type.noun) or "a string" end
function words.data() return "a value (a finite number, a string, true, false, or a table of these)" end
function words.rows() return "a list of rows: each " .. words.cells() end
function words.cells() return "a list of numbers, strings, true or false" end
words["function"] = function() return "a function" end
function words.number(type) return limited("a number", type) end
function words.integer(type) return limited("a whole number", type) end
function words.only(type) return tostring(type.value) end
function words.object(type) return describe.with_article(type.name) end
function words.points() return "a list of points {{x, y}, …}" end

function words.point(type)
  if type.low ~= type.high then return "a list of 2 or 3 numbers" end
  return ("a list of %d numbers %s"):format(type.low, shapes[type.low])
end

function words.choice(type)
  return describe.alternatives(lists.map(type.of, function(word)
    return (math.type(word) and "%s" or "'%s'"):format(word)
  end))
end

--- A list in words, without its alternatives. `ending`: text of its type.
local function list_words(type)
  local one = describe.one(type.of):gsub("^an?y? ", "")
  if type.size == 1 then return "a list of 1 " .. one end
  if type.size then return ("a list of %d %s"):format(type.size, describe.several(type.of)) end
  if type.least == 1 then return "a list of at least one " .. one end
  if type.least then return ("a list of at least %d %s"):format(type.least, describe.several(type.of)) end
  return "a list of " .. describe.several(type.of)
end

function words.list(type)
  local ending = type.ending or ""
  if not type.single then return list_words(type) .. ending end
  return describe.one(type.of) .. (type.size == 1 and "" or " or " .. list_words(type)) .. ending
end

function words.tuple(type) return ("a list of %d values"):format(#type.of) end
function words.named(type)
  return (type.short and describe.one(type.short[2]) .. " or " or "") .. "a table of named arguments"
end
function words.switch(type) return "true, false or " .. describe.one(type.of) end
words["table"] = function() return "a table" end
function words.map() return "a table of names { name = … }" end

function words.either(type)
  return describe.alternatives(lists.unique(lists.map(type, describe.one)))
end

function plurals.number(type) return limited("numbers", type) end
function plurals.integer(type) return limited("whole numbers", type) end
function plurals.text(type) return type.noun and type.noun .. "s" or "strings" end
function plurals.choice(type) return "values among " .. words.choice(type):gsub(" or ", " and ") end
function plurals.any() return "values" end
function plurals.point() return "points" end
function plurals.named() return "tables of named arguments" end
function plurals.object(type)
  local name = type.name
  return name:find "ch$" and name .. "es" or name:find "[^aeiou]y$" and name:gsub("y$", "ies") or name .. "s"
end
function plurals.list(type) return "lists of " .. describe.several(type.of) end

--- A value as a script would write it.
function describe.literal(value)
  if type(value) == "string" then return ('"%s"'):format(value) end
  if type(value) == "number" then return number_text(value) end
  if type(value) ~= "table" then return tostring(value) end
  local parts = lists.map(value, describe.literal)
  for key, entry in next, value do
    if type(key) == "string" then parts[#parts + 1] = ("%s = %s"):format(key, describe.literal(entry)) end
  end
  return "{" .. table.concat(parts, ", ") .. "}"
end

return describe
