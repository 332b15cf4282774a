-- Filters of a study's rows: study:where and study:row.

local check = require "signorini.call.check"
local lists = require "signorini.call.lists"
local meant = require("signorini.call.text").meant
local values = require "signorini.study.values"

local any = lists.any
local filter = {}

--- True if a value matches; a table with a name also matches by its name.
local function is_meant(wanted, value)
  return values.same(wanted, value) or (type(value) == "table" and value.name ~= nil and value.name == wanted)
end

--- True if a value matches a filter of a column: a value or a list of values.
local function allows(wanted, value)
  return is_meant(wanted, value) or type(wanted) == "table" and not wanted.name
    and any(wanted, function(one) return is_meant(one, value) end)
end

--- The values of a parameter in the cases of the whole study, in order.
local function values_of(study, name)
  local list = {}
  local cases = lists.map((study.whole or study).cases or {}, function(entry) return entry.case end)
  for _, holder in ipairs(lists.joined(cases, study.rows)) do
    local value = holder[name]
    if value ~= nil and not any(list, function(known) return values.same(known, value) end) then
      list[#list + 1] = value
    end
  end
  return list
end

--- Raises an error about a value of a parameter that no case has.
local function check_value(where, study, name, wanted)
  local known = values_of(study, name)
  local texts = lists.map(known, function(value) return values.text(value) end)
  local function exists(one) return any(known, function(value) return is_meant(one, value) end) end
  if #known == 0 or wanted == false or exists(wanted) then return end
  for _, one in ipairs(type(wanted) == "table" and #wanted > 0 and wanted or { wanted }) do
    if not exists(one) then
      local hint = meant(one, texts):match "did .*"
      check.reject(where, name, ("a value that a case has, %s"):format(table.concat(texts, ", ")), one, hint)
    end
  end
end

--- A filter as it was written, for messages.
function filter.text(wanted)
  if type(wanted) == "function" then return "the function" end
  local parts = {}
  for name, value in pairs(wanted) do parts[#parts + 1] = ("%s = %s"):format(name, values.text(value)) end
  table.sort(parts)
  return table.concat(parts, ", ")
end

local function read(where, study, wanted)
  if type(wanted) == "function" then return wanted end
  for name in pairs(wanted) do values.check_known(where, name, study) end
  check.keys(lists.map(values.columns(study), function(name) return { name } end), wanted, where, "")
  for _, name in ipairs(study.parameters) do
    if wanted[name] ~= nil then check_value(where, study, name, wanted[name]) end
  end
  return function(row)
    for name, value in pairs(wanted) do
      -- false matches a missing value: failed = false
      if not allows(value, row[name]) and not (value == false and row[name] == nil) then return false end
    end
    return true
  end
end

--- The rows of a study that match a filter: a table of values by column, or a function of a row.
function filter.rows(where, study, wanted)
  return lists.filter(study.rows, read(where, study, wanted))
end

return filter
