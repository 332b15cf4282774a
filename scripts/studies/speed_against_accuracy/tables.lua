-- Measurements as tables: { columns, units, rows, formats }, as sg.table and sg.csv.write take them.

local ratios = require "studies.speed_against_accuracy.ratios"

local tables = {}

local error_format, time_format, ratio_format = "%.2e", "%.3g", "%.2f"

local function name_of(row) return ("%s %s"):format(row.order, row.mesh) end

--- Why a case failed, in one line, without the position in a script of an error; nil if it did not.
function tables.reason(row)
  return row.failed and (row.reason or "failed"):match "^[^\n]*":gsub("^%S+%.lua:%d+: ", "") or nil
end

--- Adds a column { name, unit, format }.
local function add_column(to, name, unit, format)
  local i = #to.columns + 1
  to.columns[i], to.units[i], to.formats[i] = name, unit or "", format
end

local function new() return { columns = {}, units = {}, formats = {}, rows = {} } end

--- All cases: costs and errors.
function tables.cases(measured, time)
  local to, failed = new(), false
  for _, row in ipairs(measured.cases.rows) do failed = failed or row.failed end
  add_column(to, "order")
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

--- The ratio of times of every two orders, the faster one first, at the smallest, the (geometrically) middle and the
--- largest common error.
function tables.ratios(comparison, error)
  local to = new()
  add_column(to, "A")
  add_column(to, "B")
  for _, name in ipairs { "smallest error", "largest error" } do add_column(to, name, error.unit, error_format) end
  for _, name in ipairs { "at smallest", "middle", "at largest" } do add_column(to, name, "", ratio_format) end
  for i, entry in ipairs(comparison.ratios) do
    local order, other = entry.a, entry.b
    if (entry.ratio[2] or 0) > 1 then order, other = other, order end
    local ratio = (ratios.of(comparison, order, other) or {}).ratio or {}
    to.rows[i] = { order, other, entry.from, entry.to, ratio[1], ratio[2], ratio[3] }
  end
  return to
end

--- The fastest case with at most the error of N2, for each mesh.
function tables.least(measured, error, time)
  local to = new()
  add_column(to, "instead of")
  add_column(to, error.name, error.unit, error_format)
  add_column(to, "time", "s", time_format)
  add_column(to, "fastest case")
  add_column(to, error.name, error.unit, error_format)
  add_column(to, "time", "s", time_format)
  add_column(to, "time ratio", "", ratio_format)
  for i, pair in ipairs(ratios.least(measured.cases, error.name, time)) do
    local plain, best = pair.plain, pair.best
    to.rows[i] = { name_of(plain), plain[error.name], plain[time], name_of(best), best[error.name], best[time],
                   best[time] / plain[time] }
  end
  return to
end

--- The savings of time, here and as published.
function tables.published(measured, time)
  local to, list = new(), ratios.published(measured.cases, measured.problem.savings, time)
  add_column(to, "case")
  add_column(to, "against")
  for _, error in ipairs(measured.problem.errors) do
    add_column(to, error.name, error.unit, error_format)
    add_column(to, "against", error.unit, error_format)
  end
  add_column(to, "time", "s", time_format)
  add_column(to, "against", "s", time_format)
  add_column(to, "saved", "%", "%.1f")
  add_column(to, "published", "%", "%.1f")
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

--- The Pareto front of each error: cases that no other one beats in both time and error.
function tables.fronts(comparisons, errors)
  local to = new()
  add_column(to, "error")
  add_column(to, "cases")
  for _, error in ipairs(errors) do
    local comparison, names = comparisons[error.name], {}
    for i, row in ipairs(comparison and comparison.pareto or {}) do names[i] = name_of(row) end
    if #names > 0 then to.rows[#to.rows + 1] = { error.title, table.concat(names, ", ") } end
  end
  return to
end

--- The ranges of the middle ratios over all problems.
function tables.ranges(results)
  local to = new()
  for _, name in ipairs { "ratio", "smallest", "problem", "largest", "problem" } do add_column(to, name) end
  to.formats[2], to.formats[4] = ratio_format, ratio_format
  local function place(one) return ("%s: %s"):format(one.problem, one.error) end
  for _, pair in ipairs(ratios.pairs) do
    local list = ratios.over_all(results, pair[1], pair[2])
    local low, high = list[1], list[#list]
    if low then
      to.rows[#to.rows + 1] = { ("%s / %s"):format(pair[1], pair[2]), low.ratio, place(low), high.ratio,
                                place(high) }
    end
  end
  return to
end

--- All problems: the ratios of the compared pairs at the smallest, middle and largest common error.
function tables.summary(results)
  local to = new()
  add_column(to, "problem")
  add_column(to, "error")
  for _, pair in ipairs(ratios.pairs) do add_column(to, ("%s / %s"):format(pair[1], pair[2])) end
  for _, result in ipairs(results) do
    for _, error in ipairs(result.measured.problem.errors) do
      local cells = { result.measured.problem.title, error.title }
      for k, pair in ipairs(ratios.pairs) do
        local comparison = result.comparisons[error.name]
        local found = comparison and ratios.of(comparison, pair[1], pair[2])
        if found and found.ratio then
          cells[2 + k] = ("%.2f, %.2f, %.2f"):format(table.unpack(found.ratio))
        end
      end
      to.rows[#to.rows + 1] = cells
    end
  end
  return to
end

return tables
