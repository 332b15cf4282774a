-- The pictures of a study: its rows as curves, and over two of its parameters as a heat map.

local check = require "signorini.check"
local core = require "signorini.core"
local holds = require("signorini.lists").holds
local outcomes = require "signorini.study.outcomes"
local quantity = require "signorini.study.quantity"
local types = require "signorini.types"
local values = require "signorini.study.values"

local pictures = {}

--- The arguments that sg.chart or sg.heatmap take over: all but the `own` ones. A label that is missing is the
--- quantity's own, a title the study's name.
local function passed_on(study, options, own, labels)
  local chart = { title = study.name }
  for key, q in pairs(labels) do chart[key] = q.label ~= "" and q.label or nil end
  for key, value in pairs(options) do
    if not holds(own, key) then chart[key] = value end
  end
  return chart
end

--- Raises an error about a picture that would be empty.
local function nothing_to_draw(where, study, what, file)
  local why = outcomes.why_none(study)
  core.fail(("%s: no case has %s; %s cannot be drawn%s"):format(where, what, file, why and ": " .. why or ""))
end

--- Two rows where one was expected: says what tells them apart, and so what is missing.
local function ambiguous(where, study, a, b, place, also)
  local differing = {}
  for _, name in ipairs(study.parameters) do
    if not values.same(a[name], b[name]) then
      differing[#differing + 1] = ("%s (%s, %s)"):format(name, values.text(a[name]), values.text(b[name]))
    end
  end
  if #differing == 0 then core.fail(("%s: the case %s is there twice"):format(where, place)) end
  core.fail(("%s: more than one case at %s: they differ in %s: keep one value with study:where%s")
    :format(where, place, table.concat(differing, ", "), also or ""))
end

-- ── Charts ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local most_ticks = 12 -- that are set to whole numbers
local curve_options = { "markers", "dashed", "line", "width" }
local own_options = { "x", "y", "series", table.unpack(curve_options) }

--- Where the rows stand on the x axis: their numbers, or, where a column holds anything else, their place in the order
--- in which the values first appear, with the names of these places.
local function read_places(where, x, rows)
  local plain = true
  for _, row in ipairs(rows) do
    local value = row[x.pick]
    plain = plain and (type(x.pick) == "function" or value == nil or type(value) == "number")
  end
  if plain then return function(row) return quantity.number(x, row) end end
  local names, places = {}, {}
  local function place(row)
    local name = quantity.text(x, row)
    if name and not places[name] then
      names[#names + 1] = { #names + 1, name }
      places[name] = #names
    end
    return name and places[name]
  end
  for _, row in ipairs(rows) do place(row) end
  return place, names
end

--- One curve per series, each with the points { x, y, row } by x.
local function read_curves(where, study, rows, x_of, y, series, alone)
  local curves, by_name = {}, {}
  for _, row in ipairs(rows) do
    local name = series and quantity.text(series, row) or not series and "" or nil
    local at, height = x_of(row), quantity.number(y, row)
    if name and at and height then
      local curve = by_name[name]
      if not curve then
        curve = { name = name }
        curves[#curves + 1], by_name[name] = curve, curve
      end
      curve[#curve + 1] = { x = at, y = height, row = row, place = #curve }
    end
  end
  for _, curve in ipairs(curves) do
    table.sort(curve, function(a, b) return a.x < b.x or a.x == b.x and a.place < b.place end)
    for i = 2, alone and #curve or 1 do
      local a, b = curve[i - 1], curve[i]
      if a.x == b.x then
        local place = ("%s = %s"):format(alone, values.text(a.row[alone]))
        local of = curve.name ~= "" and (" of the curve %s"):format(curve.name) or ""
        ambiguous(where, study, a.row, b.row, place .. of, ", or give each a curve of its own by series")
      end
    end
  end
  return curves
end

--- Ticks at the values along x where these are few whole numbers with room between them, so that none stands at 1.5;
--- else the axis chooses.
local function whole_ticks(curves, log)
  local seen, list = {}, {}
  for _, curve in ipairs(curves) do
    for _, point in ipairs(curve) do
      local whole = math.tointeger(point.x)
      if not whole then return nil end
      if not seen[whole] then seen[whole], list[#list + 1] = true, whole end
    end
  end
  table.sort(list)
  if #list < 2 or #list > most_ticks then return nil end
  local function place(value) return log and math.log(value) or value end
  local least = (place(list[#list]) - place(list[1])) / most_ticks
  local ticks = {}
  for i, value in ipairs(list) do
    if i > 1 and place(value) - place(list[i - 1]) < least then return nil end
    ticks[i] = { value, tostring(value) }
  end
  return ticks
end

local function finished(study)
  local rows = {}
  for _, row in ipairs(study.rows) do
    if not row.failed then rows[#rows + 1] = row end
  end
  return rows
end

function pictures.chart(study, options)
  local where = "study:chart"
  local x, y = quantity.read(where, "x", study, options.x), quantity.read(where, "y", study, options.y)
  local series = options.series and quantity.read(where, "series", study, options.series)
  local rows, is_parameter = finished(study), holds(study.parameters, x.pick)
  local x_of, names = read_places(where, x, rows)
  local curves = read_curves(where, study, rows, x_of, y, series, is_parameter and options.line and x.pick or nil)
  if #curves == 0 then nothing_to_draw(where, study, ("both %s and %s"):format(x.name, y.name), options.file) end

  local chart = passed_on(study, options, own_options, { xlabel = x, ylabel = y })
  chart.xticks = chart.xticks or names
  if is_parameter and not (chart.xticks or chart.xrange or chart.vlines) then
    chart.xticks = whole_ticks(curves, (chart.log or ""):find "x")
  end
  chart.legend_title = chart.legend_title or series and quantity.title(series)
  for i, curve in ipairs(curves) do
    chart[i] = { x = {}, y = {}, label = curve.name }
    for _, key in ipairs(curve_options) do chart[i][key] = options[key] end
    for j, point in ipairs(curve) do chart[i].x[j], chart[i].y[j] = point.x, point.y end
  end
  return core.sg.chart(chart)
end

-- ── Heat maps ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A parameter's values in their order, as texts.
local function read_axis(where, key, study, name)
  local axis, seen = { name = check.value(types.choice(study.parameters), name, where, key), texts = {} }, {}
  for _, row in ipairs(study.rows) do
    local text = values.text(row[axis.name], true)
    if not seen[text] then seen[text], axis.texts[#axis.texts + 1] = true, text end
  end
  return axis
end

--- The row of each cell: rows[y][x] by the axes' texts.
local function read_cells(where, study, x, y)
  local cells = {}
  for _, text in ipairs(y.texts) do cells[text] = {} end
  for _, row in ipairs(study.rows) do
    local line, at = cells[values.text(row[y.name], true)], values.text(row[x.name], true)
    if line[at] then
      ambiguous(where, study, line[at], row,
        ("%s = %s, %s = %s"):format(x.name, at, y.name, values.text(row[y.name])))
    end
    line[at] = row
  end
  return cells
end

--- What stands in a cell: the value in three digits, what became of a case that failed, or nothing.
local function cell_text(row, number)
  if row.failed then return row.outcome or "failed" end
  return number and tonumber(("%.3g"):format(number)) or ""
end

function pictures.heatmap(study, options)
  local where = "study:heatmap"
  local x, y = read_axis(where, "x", study, options.x), read_axis(where, "y", study, options.y)
  if x.name == y.name then core.fail(("%s: x and y are both %s: choose two parameters"):format(where, x.name)) end
  local value, texts = quantity.read(where, "value", study, options.value), options.texts
  local cells = read_cells(where, study, x, y)

  local chart = passed_on(study, options, { "x", "y", "value", "texts" },
    { label = value, xlabel = quantity.read(where, "x", study, x.name),
      ylabel = quantity.read(where, "y", study, y.name) })
  chart.x, chart.y, chart.values, chart.texts = x.texts, y.texts, {}, texts and {} or nil
  local any = false
  for j, line in ipairs(y.texts) do
    chart.values[j] = {}
    if texts then chart.texts[j] = {} end
    for i, at in ipairs(x.texts) do
      local row = cells[line][at]
      local number = row and not row.failed and quantity.number(value, row) or nil
      any = any or number ~= nil
      chart.values[j][i] = number
      if texts then chart.texts[j][i] = row and cell_text(row, number) end
    end
  end
  if not any then nothing_to_draw(where, study, value.name, options.file) end
  return core.sg.heatmap(chart)
end

return pictures
