-- Which rows of a study are meant: study:where and study:row.

local check = require "signorini.check"
local core = require "signorini.core"
local values = require "signorini.study.values"

local filter = {}

--- Whether a value is meant: a table with a name may be called by it.
local function is_meant(wanted, value)
  return values.same(wanted, value) or (type(value) == "table" and value.name ~= nil and value.name == wanted)
end

--- Whether a filter allows a value in a column: a list of values, or one.
local function allows(wanted, value)
  if type(wanted) == "table" and not wanted.name then
    for _, one in ipairs(wanted) do
      if is_meant(one, value) then return true end
    end
  end
  return is_meant(wanted, value)
end

--- The values of a parameter in the cases of the whole study, in order.
local function values_of(study, name)
  local whole, list = study.whole or study, {}
  local function add(value)
    for _, known in ipairs(list) do
      if values.same(known, value) then return end
    end
    list[#list + 1] = value
  end
  for _, entry in ipairs(whole.cases or {}) do add(entry.case[name]) end
  for _, row in ipairs(study.rows) do add(row[name]) end
  return list
end

--- A value of a parameter that no case has is misspelt.
local function check_value(where, study, name, wanted)
  local known, texts = values_of(study, name), {}
  local function exists(one)
    for _, value in ipairs(known) do
      if is_meant(one, value) then return true end
    end
  end
  if #known == 0 or wanted == false or exists(wanted) then return end
  for i, value in ipairs(known) do texts[i] = values.text(value) end
  for _, one in ipairs(type(wanted) == "table" and #wanted > 0 and wanted or { wanted }) do
    if not exists(one) then
      local meant = type(one) == "string" and core.nearest(one, texts)
      check.reject(where, name, ("a value that a case has, %s"):format(table.concat(texts, ", ")), one,
        meant and ("did you mean '%s'?"):format(meant))
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

--- A filter as a function of a row.
local function read(where, study, wanted)
  if type(wanted) == "function" then return wanted end
  local known = {}
  for i, name in ipairs(values.columns(study)) do known[i] = { name } end
  for name in pairs(wanted) do values.check_known(where, name, study) end
  check.keys(known, wanted, where, "")
  for _, name in ipairs(study.parameters) do
    if wanted[name] ~= nil then check_value(where, study, name, wanted[name]) end
  end
  return function(row)
    for name, value in pairs(wanted) do
      -- false stands for what a row does not have: failed = false
      if not allows(value, row[name]) and not (value == false and row[name] == nil) then return false end
    end
    return true
  end
end

--- The rows of a study that a filter keeps: a table of values by column, or a function of a row.
function filter.rows(where, study, wanted)
  local keeps, rows = read(where, study, wanted), {}
  for _, row in ipairs(study.rows) do
    if keeps(row) then rows[#rows + 1] = row end
  end
  return rows
end

return filter
