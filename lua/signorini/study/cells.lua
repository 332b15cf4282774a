-- The cells of a study's table, for texts, CSV files, reports and notebooks.

local lists = require "signorini.call.lists"
local values = require "signorini.study.values"

local map = lists.map

--- Columns worth printing: outcome and reason only if there is one.
local function telling_columns(study)
  return lists.filter(values.columns(study), function(name)
    local is_account = name == "outcome" or name == "reason"
    return name ~= "failed" and (not is_account or lists.any(study.rows, function(row) return row[name] ~= nil end))
  end)
end

--- Order of values: numbers before texts, missing ones last.
local function before(a, b)
  if a == nil or b == nil then return a ~= nil end
  if type(a) == "number" and type(b) == "number" then return a < b end
  if type(a) == "number" or type(b) == "number" then return type(a) == "number" end
  return values.text(a) < values.text(b)
end

local function sorted_rows(where, study, sort)
  local rows = lists.joined(study.rows)
  if sort == nil then return rows end
  local names, place = type(sort) == "table" and sort or { sort }, {}
  for _, name in ipairs(names) do values.column(where, "sort", name, study) end
  for i, row in ipairs(rows) do place[row] = i end
  table.sort(rows, function(a, b)
    for _, name in ipairs(names) do
      if not values.same(a[name], b[name]) then return before(a[name], b[name]) end
    end
    return place[a] < place[b]
  end)
  return rows
end

--- The columns, units and rows of a table, with texts for values that a cell cannot hold.
return function(where, study, options)
  local columns = options.columns or telling_columns(study)
  local units = map(columns, function(name, j)
    values.column(where, ("columns[%d]"):format(j), name, study)
    return study.units[name] or ""
  end)
  local rows = map(sorted_rows(where, study, options.sort), function(row)
    return map(columns, function(name)
      local value = row[name]
      if name == "reason" and value then return value:match "^[^\n]*" end
      return (type(value) == "table" or type(value) == "boolean") and values.text(value) or value
    end)
  end)
  return columns, units, rows
end
