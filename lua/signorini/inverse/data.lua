-- Measured data of a fit, and the results of runs at their abscissae.

local check = require "signorini.call.check"
local core = require "signorini.core"
local csv = require "signorini.output.csv"
local interpolation = require "signorini.inverse.interpolation"
local lists = require "signorini.call.lists"
local on_behalf_of = require "signorini.call.on_behalf_of"
local t = require "signorini.call.types"

local data = {}

-- ── Reading ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A column of numbers of a file.
local function column_of(file, name, what)
  return lists.map(file:column(name), function(value, row)
    if type(value) ~= "number" then
      check.reject(what, ("row %d of the column '%s'"):format(row, name), "a number", value)
    end
    return value
  end)
end

--- The columns of x and y of a file: those that the user names, those with the names of the results, or the only two.
local function columns_of(file, set, what)
  local names = file.columns
  if set.columns then
    for i, name in ipairs(set.columns) do check.value(t.choice(names), name, what, ("columns[%d]"):format(i)) end
    return table.unpack(set.columns)
  end
  if not lists.any(names, function(name) return not tonumber(name) end) then
    core.fail(("%s: file '%s' begins with numbers. Hint: its first line must have the names of the columns"):format(
      what, set.file))
  end
  if lists.holds(names, set.x) and lists.holds(names, set.y) then return set.x, set.y end
  if #names == 2 then return names[1], names[2] end
  core.fail(("%s: file '%s' has the columns %s. Hint: %s"):format(what, set.file, table.concat(names, ", "),
    #names == 1 and names[1]:find "[;\t]" and "columns are separated by commas"
      or "columns = { <that of x>, <that of y> }"))
end

--- x, y and the file of a set.
local function read_points(set, what)
  if (set.points ~= nil) == (set.file ~= nil) then
    core.fail(("%s: %s. Hint: points = { {x, y}, … }, or file = \"….csv\""):format(what,
      set.points and "both points and file are given" or "neither points nor file is given"))
  end
  if set.points and set.columns then
    core.fail(what .. ": columns are those of a file, but points are given")
  end
  if set.points then
    return lists.map(set.points, function(point) return point[1] end),
      lists.map(set.points, function(point) return point[2] end)
  end
  local file = on_behalf_of(what .. ".file", "sg.csv.read", csv.read, set.file)
  local x, y = columns_of(file, set, what)
  return column_of(file, x, what), column_of(file, y, what), file
end

--- The standard deviations of the points of a set: one number, one per point, or a column of the file.
local function read_sigma(set, count, file, what)
  local sigma = set.sigma
  if type(sigma) == "string" then
    if not file then core.fail(("%s.sigma: '%s' names a column, but there is no file"):format(what, sigma)) end
    sigma = column_of(file, check.value(t.choice(file.columns), sigma, what, "sigma"), what)
  elseif type(sigma) ~= "table" then
    sigma = { sigma or 1 }
    for i = 2, count do sigma[i] = sigma[1] end
  end
  if #sigma ~= count then
    core.fail(("%s.sigma: %d values are given for %d points"):format(what, #sigma, count))
  end
  for i, value in ipairs(sigma) do check.value(t.positive, value, what, ("sigma[%d]"):format(i)) end
  return sigma
end

--- The sets { x, y, stage (names), at, values, sigma (lists) } of an argument `data`.
function data.read(where, given)
  return lists.map(given, function(set, i)
    local what = ("%s: data[%d]"):format(where, i)
    if not set.sigma and #given > 1 then
      core.fail(what .. ".sigma is missing: several sets are weighed by the standard deviations of their points")
    end
    local at, values, file = read_points(set, what)
    if #at == 0 then core.fail(what .. " has no points") end
    return { x = set.x, y = set.y, stage = set.stage, what = what, at = at, values = values,
             has_sigma = set.sigma ~= nil, sigma = read_sigma(set, #at, file, what) }
  end)
end

-- ── Results of runs ──────────────────────────────────────────────────────────────────────────────────────────────────

--- The first and the last row of a stage, or of the whole run; the first is the end of the stage before, or the start.
local function rows_of(run, set)
  if not set.stage then return 0, run.rows end
  local first = 0
  for _, stage in ipairs(run.stages) do
    if stage.name == set.stage then return first, first + stage.steps end
    first = first + stage.steps
  end
  local names = lists.map(run.outline, function(stage) return stage.name end)
  check.value(t.choice(names), set.stage, set.what, "stage")
end

--- A column as a function of the row; values: columns by name; start: those with the row 0, if they are others.
local function reader(values, start, name)
  if name == "step" then return function(row) return row end end
  return function(row)
    local list = row == 0 and start[name] or values[name]
    return list and list[row]
  end
end

--- The points of the curve of a set: lists of x and y over its rows, without a first one that is not known.
local function curve_of(set, run, values, start)
  local first, last = rows_of(run, set)
  local x, y = reader(values, start, set.x), reader(values, start, set.y)
  local curve = { x = {}, y = {}, first = first }
  for row = first, last do
    if row > first or (x(row) and y(row)) then
      curve.x[#curve.x + 1], curve.y[#curve.y + 1] = x(row), y(row)
    else
      curve.first = row + 1
    end
  end
  return curve
end

--- Fails unless x rises or falls along a curve of at least two points.
local function check_order(set, curve)
  local x = curve.x
  if #x < 2 then core.fail(("%s: a run of at least two steps is needed to compare with"):format(set.what)) end
  for i = 2, #x do
    if (x[i] - x[i - 1]) * (x[2] - x[1]) <= 0 then
      core.fail(("%s: %s = %.6g at step %d turns back or stays: it must rise or fall throughout. Hint: stage = "
        .. "\"<name>\" compares with one stage, x = \"step\" with the numbers of steps"):format(set.what, set.x, x[i],
        curve.first + i - 1))
    end
  end
end

--- The points of a set that a curve does not reach.
local function beyond(set, curve)
  local low, high = math.min(curve.x[1], curve.x[#curve.x]), math.max(curve.x[1], curve.x[#curve.x])
  local slack, list = 1e-9 * (high - low), {}
  for i, at in ipairs(set.at) do
    if at < low - slack or at > high + slack then list[#list + 1] = i end
  end
  return list
end

--- True if the abscissa of a set changes with a parameter, as where a force is prescribed and a motion is measured.
local function is_free(set, found)
  for _, pair in pairs(found.pairs) do
    local plus, minus = pair.plus.record.values[set.x], pair.minus.record.values[set.x]
    for row, value in ipairs(plus or {}) do
      if value ~= minus[row] then return true end
    end
  end
  return false
end

--- Checks sets against the run at the start: their columns, their stages, and that it reaches the points, unless others
--- may do so.
function data.check(sets, found)
  for _, set in ipairs(sets) do
    check.value(t.choice(found.run.names), set.x, set.what, "x")
    check.value(t.choice(found.results), set.y, set.what, "y")
    local curve = curve_of(set, found.run, found.run.values, found.start)
    check_order(set, curve)
    local i = beyond(set, curve)[1]
    if i and not is_free(set, found) then
      core.fail(("%s: point %d lies at %s = %.6g, but the run goes from %.6g to %.6g. Hint: drive it as far, or leave "
        .. "the point out"):format(set.what, i, set.x, set.at[i], curve.x[1], curve.x[#curve.x]))
    end
  end
end

--- The values of a run, { run, start }, of the y of a set at a list of abscissae.
function data.values(set, found, at)
  local curve = curve_of(set, found.run, found.run.values, found.start)
  return interpolation.cubic(curve.x, curve.y, at)
end

--- What a run says at the points of a set: `values`, their derivatives `slopes` by parameter, and `straight`, by how
--- much linear interpolation between the steps differs, and how many points are `outside` of the run.
function data.predict(set, found)
  local function at_points(values, start)
    local curve = curve_of(set, found.run, values, start)
    return interpolation.cubic(curve.x, curve.y, set.at), curve
  end
  local prediction = { slopes = {} }
  local curve
  prediction.values, curve = at_points(found.run.values, found.start)
  prediction.outside = #beyond(set, curve)
  local straight = interpolation.linear(curve.x, curve.y, set.at)
  prediction.straight = lists.map(straight, function(value, i) return math.abs(value - prediction.values[i]) end)
  for name, pair in pairs(found.pairs) do
    local plus, minus = pair.plus.record.values, pair.minus.record.values
    local above, below = at_points(plus, plus), at_points(minus, minus)
    prediction.slopes[name] = lists.map(above, function(value, i) return (value - below[i]) / (2 * pair.step) end)
  end
  return prediction
end

--- The error bars of a run at the points of a set, 0 where they are not known; and whether some are not.
function data.bars(set, run)
  local values = { [set.x] = run.values[set.x], [set.y] = run:error(set.y) }
  local curve = curve_of(set, run, values, { [set.y] = {}, [set.x] = {} })
  local is_unknown = lists.any(curve.y, function(value) return value ~= value end)
  for i, value in ipairs(curve.y) do curve.y[i] = value == value and value or 0 end
  return lists.map(interpolation.linear(curve.x, curve.y, set.at), math.abs), is_unknown
end

return data
