-- Quantities of a study's rows: a column or a function, with its name, unit and axis label.

local core = require "signorini.core"
local map = require("signorini.call.lists").map
local on_behalf_of = require "signorini.call.on_behalf_of"
local outcomes = require "signorini.study.outcomes"
local values = require "signorini.study.values"

local quantity = {}

--- The error of a column in percent of its value in the row of a reference: { where, key, study, pick, …, reference
--- (the row), uncertain (error bar of the reference in percent, or nil) }. Results of a name "P.error" are the error
--- bars of "P".
local function of_reference(where, key, study, pick)
  values.column(where, key .. ".of", pick.of, study)
  local column, row = pick.of, on_behalf_of(("%s: %s.reference"):format(where, key), "study:row", study.row, study,
    pick.reference)
  local exact, bar = values.number(where, key .. ".of", column, row), row[column .. ".error"]
  if not exact or exact == 0 then
    core.fail(("%s: %s.reference: its %s is %s, so that there is no relative error"):format(where, key, column,
      exact and "0" or "missing"))
  end
  local function error_of(other)
    local value = other ~= row and values.number(where, key, column, other) or nil
    return value and 100 * math.abs(value / exact - 1)
  end
  local name = "error of " .. column
  return { where = where, key = key, study = study, pick = error_of, name = name, unit = "%", label = name .. " (%)",
           reference = row, column = column, exact = exact,
           uncertain = type(bar) == "number" and bar == bar and 100 * math.abs(bar / exact) or nil }
end

--- A sentence on how uncertain the reference of errors is; nil without a reference.
function quantity.doubt(q)
  if not q.reference then return nil end
  local case = ("Reference: %s, %s = %.6g"):format(quantity.case(q.study, q.reference), q.column, q.exact)
  if not q.uncertain then
    return ('%s; how uncertain it is itself is unknown. Hint: return ["%s.error"] = run:error(…)[…] from the cases')
      :format(case, q.column)
  end
  return ("%s ± %.2g %%, within which errors are not known"):format(case, q.uncertain)
end

--- { where, key, study, pick, name, unit, label } of the argument `key`: a column's name, a function of a row, or the
--- error of a column, { of, reference }.
function quantity.read(where, key, study, pick)
  if type(pick) == "table" then return of_reference(where, key, study, pick) end
  values.column(where, key, pick, study)
  local column = type(pick) == "string" and pick or nil
  local unit = column and (study.units[column] or column == "wall" and "s") or ""
  return { where = where, key = key, study = study, pick = pick, name = column or key, unit = unit,
           label = column and (unit ~= "" and ("%s (%s)"):format(column, unit) or column) or "" }
end

--- "order = N2, mesh = m1"
function quantity.case(study, row)
  return table.concat(map(study.parameters, function(name)
    return ("%s = %s"):format(name, values.text(row[name]))
  end), ", ")
end

--- Its number in a row, or nil; a string or a number that is not finite is an error that names the case.
function quantity.number(q, row)
  return values.number(q.where, ("%s (of the case %s)"):format(q.key, quantity.case(q.study, row)), q.pick, row)
end

--- Its value in a row, as a text with all digits, or nil.
function quantity.text(q, row)
  local value = row[q.pick]
  if type(q.pick) == "function" then value = q.pick(row) end
  return value ~= nil and values.text(value, true) or nil
end

--- Its name as a title; empty for a function.
function quantity.title(q) return type(q.pick) == "string" and q.name or "" end

--- A number with its name and unit: "wall = 1.25 s".
function quantity.stated(q, number)
  return ("%s = %.4g%s"):format(q.name, number, q.unit ~= "" and " " .. q.unit or "")
end

--- The cases as points { row, place in the study, a number for the key of each quantity }, and those that failed or
--- lack a quantity as { row, why }. keep(row): which cases count; judge(point): why a point is rejected, or nil.
function quantity.points(study, quantities, keep, judge)
  local points, left_out = {}, {}
  for i, row in ipairs(study.rows) do
    if not keep or keep(row) then
      local point, why = { row = row, place = i }, row.failed and outcomes.line(row) or nil
      for _, q in ipairs(why and {} or quantities) do
        point[q.key] = quantity.number(q, row)
        why = why or not point[q.key] and (row == q.reference and "it is the reference" or "no " .. q.name) or nil
      end
      why = why or judge and judge(point)
      if why then left_out[#left_out + 1] = { row = row, why = why } else points[#points + 1] = point end
    end
  end
  return points, left_out
end

return quantity
