-- Columns of a study and their values: shared by all readers of studies.
--
-- A study has name, parameters (names in order), results (names in order), units (by name) and rows; a row holds the
-- values of parameters and results by name, wall (s), and for a failed case failed = true and reason. Parameters and
-- results are plain data; tables among them are shown by their field `name`.

local check = require "signorini.call.check"
local core = require "signorini.core"
local lists = require "signorini.call.lists"
local outcomes = require "signorini.study.outcomes"
local types = require "signorini.call.types"

local values = {}

--- The columns of every case besides its parameters and results.
values.accounts = { "wall", "failed", "outcome", "reason" }

--- True if two values of plain data are equal; tables are compared entry by entry.
function values.same(a, b)
  if type(a) ~= "table" or type(b) ~= "table" then return a == b end
  for key, value in pairs(a) do
    if not values.same(value, b[key]) then return false end
  end
  for key in pairs(b) do
    if a[key] == nil then return false end
  end
  return true
end

--- A value in short form: {6, 2} is "6×2", { name = "m1", … } is "m1". exactly: numbers with all digits.
function values.text(value, exactly)
  if type(value) == "table" then
    if value.name then return values.text(value.name, exactly) end
    local texts = lists.map(value, function(entry) return values.text(entry, exactly) end)
    if #texts > 0 then return table.concat(texts, "×") end
    for key, entry in pairs(value) do texts[#texts + 1] = ("%s=%s"):format(key, values.text(entry, exactly)) end
    table.sort(texts)
    return table.concat(texts, " ")
  end
  if type(value) ~= "number" then return tostring(value) end
  return (exactly or math.type(value) == "integer") and core.number_text(value) or ("%.6g"):format(value)
end

--- The names of all results of records or cells, sorted; without lists, which a table cannot show.
function values.result_names(holders)
  local names = {}
  for _, holder in pairs(holders) do
    for name, value in pairs(holder.results) do names[name] = type(value) ~= "table" or names[name] end
  end
  return lists.sorted_names(names)
end

--- All columns of a study by name: parameters, results, then the columns of every case.
function values.columns(study)
  return lists.unique(lists.joined(study.parameters, study.results, values.accounts))
end

--- Raises an error about a result that no case has because all failed: its name may be correct, so the reason of the
--- failures is given.
function values.check_known(where, name, study)
  local columns = values.columns(study)
  if type(name) ~= "string" or lists.holds(columns, name) or core.nearest(name, columns) then return end
  local why = outcomes.why_none(study)
  if why then core.fail(("%s: no case has '%s': %s"):format(where, name, why)) end
end

--- Checks that a study has a column; a function of a row is also accepted.
function values.column(where, key, name, study)
  if type(name) == "function" then return end
  values.check_known(where, name, study)
  check.value(types.choice(values.columns(study)), name, where, key)
end

--- The number that a column or a function returns for a row; nil if there is none. Strings and numbers that are not
--- finite are errors.
function values.number(where, key, pick, row)
  local value = row[pick]
  if type(pick) == "function" then value = pick(row) end
  if value == nil then return nil end
  if type(value) ~= "number" or value ~= value or math.abs(value) == math.huge then
    core.fail(("%s: %s must return finite numbers, got %s"):format(where, key, core.describe(value)))
  end
  return value
end

return values
