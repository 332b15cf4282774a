-- The charts of a study's report: those of the user, or one for each result.

local core = require "signorini.core"
local figure = require "signorini.output.report.figure"
local lists = require "signorini.call.lists"
local on_behalf_of = require "signorini.call.on_behalf_of"
local pictures = require "signorini.study.pictures"
local values = require "signorini.study.values"

local charts = {}

local where = "study:report"
local outcomes = { "done", "failed", "time", "error", "crashed" } -- in the order of their colors
local most_charts, most_curves = 12, 12
local wide = 30    -- a ratio of values from which on an axis can be logarithmic
local many = 60    -- points of a chart with a marker at each one

-- ── Choice ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The values of a column in rows that have results, and whether all are numbers.
local function values_of(study, name)
  local rows = lists.filter(study.rows, function(row) return not row.failed and row[name] ~= nil end)
  local all = lists.map(rows, function(row) return row[name] end)
  return all, #all > 0 and not lists.any(all, function(value) return type(value) ~= "number" end)
end

local function texts_of(study, name)
  local rows = lists.filter(study.rows, function(row) return row[name] ~= nil end)
  return lists.unique(lists.map(rows, function(row) return values.text(row[name], true) end))
end

local function name_of(column) return type(column) == "string" and column or "function" end

--- True if the axis of a column is logarithmic: positive numbers that spread far, most of them in the lower part.
local function is_wide(study, name)
  local numbers, numeric = values_of(study, name)
  if not numeric then return false end
  local low, high = math.huge, -math.huge
  for _, number in ipairs(numbers) do low, high = math.min(low, number), math.max(high, number) end
  return low > 0 and high >= wide * low and lists.median(numbers) < 0.25 * (low + high)
end

--- The parameters with several values, the one along x first: the first with numbers, or else the first.
local function varying(study)
  local names = lists.filter(study.parameters, function(name) return #texts_of(study, name) > 1 end)
  for i, name in ipairs(names) do
    if select(2, values_of(study, name)) then
      table.insert(names, 1, table.remove(names, i))
      break
    end
  end
  return names
end

--- A function of a row that returns the values of several parameters, "N2, 0.2".
local function together(names)
  return function(row)
    return table.concat(lists.map(names, function(name) return values.text(row[name]) end), ", ")
  end
end

--- How the curves of a chart differ: { series (an option of study:chart), by (its name), line (whether they have
--- lines: too many would hide each other) }.
local function curves_of(study, others)
  if #others <= 1 then return { series = others[1], by = others[1], line = true } end
  local all = lists.unique(lists.map(study.rows, together(others)))
  if #all <= most_curves then
    return { series = together(others), by = table.concat(others, ", "), line = true }
  end
  local one = lists.filter(others, function(name) return #texts_of(study, name) <= most_curves end)[1]
  return { series = one, by = one, line = false }
end

--- The results as charts, options of study:chart: over the parameter along x, one curve per value of the others.
local function chosen(study, names)
  local results = lists.filter(lists.unique(lists.joined(study.results, { "wall" })), function(name)
    return select(2, values_of(study, name)) and not lists.holds(names, name)
  end)
  local x, curves = names[1], curves_of(study, { table.unpack(names, 2) })
  return lists.map(results, function(y)
    local log = (is_wide(study, x) and "x" or "") .. (is_wide(study, y) and "y" or "")
    return { x = x, y = y, series = curves.series, legend_title = curves.by, line = curves.line,
             markers = (not curves.line or #study.rows <= many) or nil, log = log ~= "" and log or nil,
             title = ("%s over %s%s"):format(y, x, curves.by and ", by " .. curves.by or "") }
  end)
end

-- ── Figures ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local function figure_of(study, entry, i)
  local what = ("%s: charts[%d]"):format(where, i)
  if core.kind(entry) == "picture" then return figure.of_picture(what, entry) end
  local picture = on_behalf_of(what, "study:chart", pictures.chart, study, lists.merged(entry, { title = "" }))
  return figure.of_picture(what, picture, entry.title or ("%s over %s"):format(name_of(entry.y), name_of(entry.x)))
end

--- The section of the charts: of those given, or of those chosen.
function charts.section(study, given)
  local names = not given and varying(study) or {}
  local list = given or #names > 0 and chosen(study, names) or {}
  local shown = given and list or { table.unpack(list, 1, most_charts) }
  local note = #shown < #list and ("<p>The first %d of %d results are shown.</p>"):format(#shown, #list) or nil
  return { title = "Charts", html = note, figures = lists.map(shown, function(entry, i)
    return figure_of(study, entry, i)
  end) }
end

-- ── Maps ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The figure of one entry of `maps`: of a picture, of a convergence map, or of arguments of study:heatmap.
local function map_figure(study, entry, i)
  local what = ("%s: maps[%d]"):format(where, i)
  if core.kind(entry) == "picture" then return figure.of_picture(what, entry) end
  if getmetatable(entry) == core.types.map then
    local outcomes = require("signorini.study.convergence_map.pictures").outcomes
    return figure.of_picture(what, outcomes(entry, { text = "iterations", title = "" }), entry.name
      .. ": outcomes, with the number of iterations")
  end
  local picture = on_behalf_of(what, "study:heatmap", pictures.heatmap, study, lists.merged(entry, { title = "" }))
  return figure.of_picture(what, picture,
    entry.title or ("%s over %s and %s"):format(name_of(entry.value), entry.x, entry.y))
end

--- The map of outcomes, if there are failures and two parameters with several values determine the case.
local function outcome_map(study)
  local x, y, more = table.unpack(varying(study))
  if not y or more or not lists.any(study.rows, function(row) return row.failed end) then return nil end
  local chart = { x = texts_of(study, x), y = texts_of(study, y), xlabel = x, ylabel = y,
                  title = "", values = {}, categories = lists.map(outcomes, function(name) return { name = name } end) }
  local column, line = {}, {}
  for i, text in ipairs(chart.x) do column[text] = i end
  for j, text in ipairs(chart.y) do line[text], chart.values[j] = j, {} end
  for _, row in ipairs(study.rows) do
    local cells, i = chart.values[line[values.text(row[y], true)]], column[values.text(row[x], true)]
    if cells[i] then return nil end
    cells[i] = row.failed and (row.outcome or "failed") or "done"
  end
  return figure.of_picture(where .. ": outcomes", core.sg.heatmap(chart), "Outcomes")
end

--- The section of the maps.
function charts.maps(study, given)
  return { title = "Maps", figures = given
    and lists.map(given, function(entry, i) return map_figure(study, entry, i) end) or { outcome_map(study) } }
end

return charts
