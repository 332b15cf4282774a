-- The pictures of a study: its rows as curves, or as a heat map over two of its parameters.

local check = require "signorini.call.check"
local core = require "signorini.core"
local lists = require "signorini.call.lists"
local outcomes = require "signorini.study.outcomes"
local quantity = require "signorini.study.quantity"
local types = require "signorini.call.types"
local values = require "signorini.study.values"

local pictures = {}

--- The arguments that are passed to sg.chart or sg.heatmap: all except the `own` ones. The default of a label is the
--- quantity's, that of the title is the study's name.
local function passed_on(study, options, own, labels)
  local chart = lists.merged({ title = study.name }, options)
  for _, key in ipairs(own) do chart[key] = nil end
  for key, q in pairs(labels) do chart[key] = options[key] or q.label ~= "" and q.label or nil end
  return chart
end

--- Raises an error about a picture that would be empty.
local function nothing_to_draw(where, study, what, file)
  local why = outcomes.why_none(study)
  core.fail(("%s: no case has %s; %s cannot be drawn%s"):format(where, what, file, why and ": " .. why or ""))
end

--- Raises an error about two rows where one was expected, with the columns in which they differ.
local function ambiguous(where, study, a, b, place, also)
  local differing = lists.filter(study.parameters, function(name) return not values.same(a[name], b[name]) end)
  if #differing == 0 then core.fail(("%s: the case %s occurs twice"):format(where, place)) end
  local texts = lists.map(differing, function(name)
    return ("%s (%s, %s)"):format(name, values.text(a[name]), values.text(b[name]))
  end)
  core.fail(("%s: more than one case at %s: they differ in %s. Hint: keep one value with study:where%s")
    :format(where, place, table.concat(texts, ", "), also or ""))
end

-- ── Charts ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local most_ticks = 12 -- at whole numbers
local curve_options = { "markers", "dashed", "line", "width" }
local own_options = { "x", "y", "series", table.unpack(curve_options) }

--- The distinct values of a column in their order, as texts.
local function axis_texts(rows, column)
  return lists.unique(lists.map(rows, function(row) return values.text(row[column], true) end))
end

--- The positions of the rows on the x axis: their numbers or, if a column has other values, the place in the order in
--- which the values first occur, with the names of these places.
local function read_places(x, rows)
  local is_odd = type(x.pick) ~= "function" and lists.any(rows, function(row)
    return row[x.pick] ~= nil and type(row[x.pick]) ~= "number"
  end)
  if not is_odd then return function(row) return quantity.number(x, row) end end
  local having = lists.filter(rows, function(row) return row[x.pick] ~= nil end)
  local names, places = axis_texts(having, x.pick), {}
  for i, name in ipairs(names) do places[name] = i end
  return function(row) return places[quantity.text(x, row)] end,
    lists.map(names, function(name, i) return { i, name } end)
end

--- One curve per series, each with the points { x, y, row }, sorted by x.
local function read_curves(where, study, rows, x_of, y, series, alone)
  local points = {}
  for place, row in ipairs(rows) do
    local name = not series and "" or quantity.text(series, row)
    local at, height = x_of(row), quantity.number(y, row)
    if name and at and height then
      points[#points + 1] = { x = at, y = height, row = row, place = place, name = name }
    end
  end
  local curves = lists.grouped(points, function(point) return point.name end)
  for _, curve in ipairs(curves) do
    table.sort(curve, function(a, b) return a.x < b.x or a.x == b.x and a.place < b.place end)
    for i = 2, alone and #curve or 1 do
      local a, b = curve[i - 1], curve[i]
      if a.x == b.x then
        local place = ("%s = %s"):format(alone, values.text(a.row[alone]))
        local of = curve.key ~= "" and (" of the curve %s"):format(curve.key) or ""
        ambiguous(where, study, a.row, b.row, place .. of, ", or give each a curve of its own by series")
      end
    end
  end
  return curves
end

--- Ticks at the values along x if these are few whole numbers and well separated, so that there is none at 1.5;
--- otherwise the axis chooses.
local function whole_ticks(curves, log)
  local list = lists.unique(lists.map(lists.flat(curves), function(point)
    return math.tointeger(point.x) or point.x
  end))
  if lists.any(list, function(x) return math.type(x) == "float" end) then return nil end
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

function pictures.chart(study, options)
  local where = "study:chart"
  local x, y = quantity.read(where, "x", study, options.x), quantity.read(where, "y", study, options.y)
  local series = options.series and quantity.read(where, "series", study, options.series)
  local rows = lists.filter(study.rows, function(row) return not row.failed end)
  local is_parameter = lists.holds(study.parameters, x.pick)
  local x_of, names = read_places(x, rows)
  local curves = read_curves(where, study, rows, x_of, y, series, is_parameter and options.line and x.pick or nil)
  if #curves == 0 then
    nothing_to_draw(where, study, ("both %s and %s"):format(x.name, y.name), options.file or "the chart")
  end

  local chart = passed_on(study, options, own_options, { xlabel = x, ylabel = y })
  chart.xticks = chart.xticks or names
  if is_parameter and not (chart.xticks or chart.xrange or chart.vlines) then
    chart.xticks = whole_ticks(curves, (chart.log or ""):find "x")
  end
  chart.legend_title = chart.legend_title or series and quantity.title(series)
  for i, curve in ipairs(curves) do
    chart[i] = { x = lists.map(curve, function(point) return point.x end),
                 y = lists.map(curve, function(point) return point.y end), label = curve.key }
    for _, key in ipairs(curve_options) do chart[i][key] = options[key] end
  end
  return core.sg.chart(chart)
end

-- ── Heat maps ────────────────────────────────────────────────────────────────────────────────────────────────────────

local function read_axis(where, key, study, name)
  check.value(types.choice(study.parameters), name, where, key)
  return { name = name, texts = axis_texts(study.rows, name) }
end

--- The row of each cell: rows[y][x] by the texts of the axes.
local function read_cells(where, study, x, y)
  local cells = {}
  for _, text in ipairs(y.texts) do cells[text] = {} end
  for _, row in ipairs(study.rows) do
    local line, at = cells[values.text(row[y.name], true)], values.text(row[x.name], true)
    if line[at] then
      ambiguous(where, study, line[at], row, ("%s = %s, %s = %s"):format(x.name, at, y.name, values.text(row[y.name])))
    end
    line[at] = row
  end
  return cells
end

--- The text of a cell: the value with three digits, the outcome of a failed case, or nothing.
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
  if not any then nothing_to_draw(where, study, value.name, options.file or "the map") end
  return core.sg.heatmap(chart)
end

return pictures
