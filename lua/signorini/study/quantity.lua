-- Quantities of a study's rows: a column or a function, with its name, unit and axis label.

local map = require("signorini.call.lists").map
local outcomes = require "signorini.study.outcomes"
local values = require "signorini.study.values"

local quantity = {}

--- { where, key, study, pick, name, unit, label } of the argument `key`: a column's name or a function of a row.
function quantity.read(where, key, study, pick)
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
        why = why or not point[q.key] and "no " .. q.name or nil
      end
      why = why or judge and judge(point)
      if why then left_out[#left_out + 1] = { row = row, why = why } else points[#points + 1] = point end
    end
  end
  return points, left_out
end

return quantity
