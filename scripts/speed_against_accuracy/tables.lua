-- What was measured, as tables: { columns, units, rows, formats }, as sg.table and sg.csv.write take them.

local shares = require "speed_against_accuracy.shares"

local tables = {}

local error_format, time_format, share_format = "%.2e", "%.3g", "%.2f"

local function name_of(row) return ("%s %s"):format(row.order, row.mesh) end

--- Why a case failed, in a line, without the place in a script at which an error was raised; nil when it did not.
function tables.reason(row)
  return row.failed and (row.reason or "failed"):match "^[^\n]*":gsub("^%S+%.lua:%d+: ", "") or nil
end

--- Adds a column { name, unit, format }.
local function add_column(to, name, unit, format)
  local i = #to.columns + 1
  to.columns[i], to.units[i], to.formats[i] = name, unit or "", format
end

local function new() return { columns = {}, units = {}, formats = {}, rows = {} } end

--- All cases: what they cost and how wrong they are.
function tables.cases(measured, time)
  local to, failed = new(), false
  for _, row in ipairs(measured.cases.rows) do failed = failed or row.failed end
  add_column(to, "label")
  add_column(to, "mesh")
  add_column(to, "DOFs", "", "%d")
  add_column(to, "iterations", "", "%.0f")
  for _, error in ipairs(measured.problem.errors) do add_column(to, error.name, error.unit, error_format) end
  add_column(to, "time", "s", time_format)
  if failed then add_column(to, "failed") end
  for i, row in ipairs(measured.cases.rows) do
    local cells = { row.order, row.mesh, row.dofs and math.floor(row.dofs), row.iterations }
    for k, error in ipairs(measured.problem.errors) do cells[4 + k] = row[error.name] end
    local last = 4 + #measured.problem.errors
    cells[last + 1], cells[last + 2] = row[time], tables.reason(row)
    to.rows[i] = cells
  end
  return to
end

--- Of every two labels, the faster one first, what it takes of the other one's time at the least, the (geometrically)
--- middle and the largest error that both reach.
function tables.ratios(comparison, error)
  local to = new()
  add_column(to, "label")
  add_column(to, "against")
  for _, name in ipairs { "least error", "largest error" } do add_column(to, name, error.unit, error_format) end
  for _, name in ipairs { "at the least", "in the middle", "at the largest" } do
    add_column(to, name, "of its time", share_format)
  end
  for i, ratio in ipairs(comparison.ratios) do
    local label, other = ratio.a, ratio.b
    if (ratio.ratio[2] or 0) > 1 then label, other = other, label end
    local share = (shares.of(comparison, label, other) or {}).share or {}
    to.rows[i] = { label, other, ratio.from, ratio.to, share[1], share[2], share[3] }
  end
  return to
end

--- What is enough for the error of N2 on each mesh.
function tables.least(measured, error, time)
  local to = new()
  add_column(to, "instead of")
  add_column(to, error.name, error.unit, error_format)
  add_column(to, "time", "s", time_format)
  add_column(to, "enough is")
  add_column(to, error.name, error.unit, error_format)
  add_column(to, "time", "s", time_format)
  add_column(to, "share", "of the time", share_format)
  for i, pair in ipairs(shares.least(measured.cases, error.name, time)) do
    local plain, best = pair.plain, pair.best
    to.rows[i] = { name_of(plain), plain[error.name], plain[time], name_of(best), best[error.name], best[time],
                   best[time] / plain[time] }
  end
  return to
end

--- The savings that are printed, beside ours.
function tables.published(measured, time)
  local to, list = new(), shares.published(measured.cases, measured.problem.savings, time)
  add_column(to, "case")
  add_column(to, "against")
  for _, error in ipairs(measured.problem.errors) do
    add_column(to, error.name, error.unit, error_format)
    add_column(to, "against", error.unit, error_format)
  end
  add_column(to, "time", "s", time_format)
  add_column(to, "against", "s", time_format)
  add_column(to, "saved", "%", "%.1f")
  add_column(to, "printed", "%", "%.1f")
  for i, pair in ipairs(list) do
    local cells = { name_of(pair.row), name_of(pair.other) }
    local last = 2
    for _, error in ipairs(measured.problem.errors) do
      cells[last + 1], cells[last + 2] = pair.row[error.name], pair.other[error.name]
      last = last + 2
    end
    cells[last + 1], cells[last + 2] = pair.row[time], pair.other[time]
    cells[last + 3], cells[last + 4] = pair.saved, pair.printed
    to.rows[i] = cells
  end
  return to
end

--- All problems at a glance: the shares of shares.pairs from the least to the largest common error.
function tables.summary(results)
  local to = new()
  add_column(to, "problem")
  add_column(to, "at equal")
  for _, pair in ipairs(shares.pairs) do add_column(to, ("%s of %s"):format(pair[1], pair[2])) end
  for _, result in ipairs(results) do
    for _, error in ipairs(result.measured.problem.errors) do
      local cells = { result.measured.problem.title, error.title }
      for k, pair in ipairs(shares.pairs) do
        local comparison = result.comparisons[error.name]
        local found = comparison and shares.of(comparison, pair[1], pair[2])
        if found and found.share then
          cells[2 + k] = ("%.2f, %.2f, %.2f"):format(table.unpack(found.share))
        end
      end
      to.rows[#to.rows + 1] = cells
    end
  end
  return to
end

return tables
