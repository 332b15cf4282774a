-- Types of the functions' tables (signorini.types) as types of annotations, which the Lua language server of an editor
-- reads: "number", "x"|"y", sg.body[]. Tables of named arguments become classes, long lists of strings become aliases;
-- both are named by their place, sg.picture.arguments.inset, and are added to the list `found`. found.are_results: they
-- are those of results, which scripts read, not write.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local pages = require "signorini.pages"

--- unknown: the class of named arguments that a function does not have; no value is of this class.
local annotation = { unknown = "sg.unknown_argument" }

local most_literals = 6 -- in a line; more become an alias

--- The type, ready to be followed by [] or joined to others.
local function enclosed(text)
  local outside = text:gsub("%b()", ""):gsub("%b<>", ""):gsub("%b[]", "")
  local is_function = text:find "^fun%(" and true or false
  return (outside:find("|", 1, true) or is_function) and ("(%s)"):format(text) or text
end

local function union(texts)
  local parts = lists.map(lists.unique(texts), function(text) return text:find "^fun%(" and enclosed(text) or text end)
  return table.concat(parts, "|")
end

local function literal(value) return type(value) == "string" and ("%q"):format(value) or tostring(value) end

--- One of a list of values, or of `others`.
local function one_of(values, place, found, others)
  local texts = lists.map(values, literal)
  if others then texts[#texts + 1] = others end
  if #texts <= most_literals then return union(texts) end
  local alias = place .. ".choice"
  found[#found + 1] = { alias = alias, text = union(texts) }
  return alias
end

--- The place of a page: sg.body, sg.model.run.
function annotation.place(name)
  return (name == "sg" or name:find "^sg%.") and name or "sg." .. name:gsub(":", ".")
end

--- The class of the rows that other pages use by the name of a page; nil if these are not those of its arguments.
local function class_of_page(name)
  local page = pages.find(name)
  if type(page.named) == "string" then return class_of_page(page.named) end
  if page.named and page.rows then return nil end
  local place = annotation.place(name)
  for _, row in ipairs(page.arguments or {}) do
    if row[2].rows == page.rows then return place .. "." .. row[1] end
  end
  return name:find "[.:]" and place .. ".arguments" or place
end

local texts = {}

local function text_of(of, place, found)
  of = of.every or of
  local text = texts[of.kind](of, place, found)
  return of.may_be_nil and union { enclosed(text), "nil" } or text
end
annotation.of = text_of

function texts.any() return "any" end
function texts.flag() return "boolean" end
function texts.number() return "number" end
function texts.integer() return "integer" end
function texts.only(of) return literal(of.value) end
function texts.choice(of, place, found) return one_of(of.of, place, found) end
function texts.object(of) return "sg." .. pages.of_objects(of.name) end
texts["table"] = function() return "table" end

--- A string; those known without a call are offered.
function texts.text(of, place, found)
  local known = core.kind(of.of) == "table" and #of.of > 0 and of.of
  return known and one_of(known, place, found, "string") or "string"
end

function texts.data() return "number|string|boolean|table" end
function texts.cells() return "(number|string|boolean)[]" end
function texts.rows() return "table<integer|string, (number|string|boolean)[]>" end

local coordinates = { "[number]", "[number, number]", "[number, number, number]" }
function texts.point(of) return union(table.move(coordinates, of.low, of.high, 1, {})) end
function texts.points() return ("(%s|%s)[]"):format(coordinates[2], coordinates[3]) end

function texts.list(of, place, found)
  if of.fields then
    found[#found + 1] = annotation.class(place, { rows = of.fields, entries = { "entry", of.of } }, found)
    return of.single and union { text_of(of.of, place, found), place } or place
  end
  local one = text_of(of.of, place, found)
  if of.flat then return union { one, enclosed(union { one, enclosed(one) .. "[]" }) .. "[]" } end
  local list = of.size and of.size <= 3 and ("[%s]"):format((one .. ", "):rep(of.size):sub(1, -3))
    or enclosed(one) .. "[]"
  return of.single and union { one, list } or list
end

function texts.tuple(of, place, found)
  local parts, lengths = {}, {}
  for i, one in ipairs(of.of) do
    parts[i] = text_of(one, place, found)
    if i >= of.least then lengths[#lengths + 1] = ("[%s]"):format(table.concat(parts, ", ")) end
  end
  return union(lengths)
end

function texts.map(of, place, found) return ("table<string, %s>"):format(text_of(of.of, place, found)) end
function texts.switch(of, place, found) return union { "boolean", text_of(of.of, place, found) } end

function texts.either(of, place, found)
  return union(lists.map(of, function(one) return text_of(one, place, found) end))
end

--- Parameters and results of a function, if they are known.
texts["function"] = function(of, place, found)
  if not of.takes then return "function" end
  local takes = lists.map(of.takes, function(row)
    return ("%s: %s"):format(row[1], text_of(row[2], place .. "." .. row[1], found))
  end)
  local gives = lists.map(of.gives, function(one) return enclosed(text_of(one, place .. ".result", found)) end)
  return ("fun(%s)%s"):format(table.concat(takes, ", "), #gives > 0 and ": " .. table.concat(gives, ", ") or "")
end

function texts.named(of, place, found)
  local class = type(of.rows) == "string" and class_of_page(of.rows) or place
  if class == place then
    local whole = annotation.class(place, of, found) -- which adds to `found`, too
    found[#found + 1] = whole
  end
  if of.or_result_of then return union { class, annotation.place(of.or_result_of) .. ".result" } end
  return of.short and union { text_of(of.short[2], place, found), class } or class
end

--- The class of a table of named arguments: { class = name, exact =, fields = { { key, type, row }, … } }; exact ones
--- have no other fields.
function annotation.class(name, of, found)
  local class = { class = name, exact = not of.rest, fields = {} }
  local function add(key, type, row) class.fields[#class.fields + 1] = { key, type, row } end
  for _, row in ipairs(pages.rows(of.rows)) do
    if type(row) == "table" then
      local type = text_of(row[2], name .. "." .. row[1], found)
      add(row[1] .. (pages.is_needed(row) and "" or "?"), type, row)
    end
  end
  if of.entries then
    local noun, entry = table.unpack(of.entries)
    add("[integer]", text_of(entry, ("%s.%s"):format(name, noun), found), of.entries)
  end
  if of.rest then
    add("[string]", text_of(of.rest, name .. ".other", found))
  elseif not (of.is_result or found.are_results) then
    add("[string]", annotation.unknown) -- so that editors mark other keys, which they would accept in silence
  end
  return class
end

return annotation
