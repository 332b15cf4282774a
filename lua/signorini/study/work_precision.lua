-- sg.work_precision: work–precision diagram of a study, one curve per discretization, and equal-accuracy cost ratios.
-- It interpolates between cases and never extrapolates.

local core = require "signorini.core"
local cut = require("signorini.call.text").cut
local format_table = require("signorini.output.table").text
local lists = require "signorini.call.lists"
local outcomes = require "signorini.study.outcomes"
local quantity = require "signorini.study.quantity"
local values = require "signorini.study.values"

local where = "sg.work_precision"
local widest = 80 -- characters of a printed reason
local most_marks = 16 -- as many markers as charts have

local Result = {}
Result.__index = Result
Result.__name = "work-precision comparison"
core.types.comparison = Result

-- ── Points of error and time, Pareto front, and times at equal error ─────────────────────────────────────────────────

local function before(a, b)
  if a.time ~= b.time then return a.time < b.time end
  return a.error < b.error
end

--- The points by time; at equal times, the smaller error first.
local function sorted(points)
  local list = lists.joined(points)
  table.sort(list, before)
  return list
end

--- The Pareto front: points that no other one beats in time or error without being worse in the other; by time.
local function front_of(points)
  local front = {}
  for _, point in ipairs(sorted(points)) do
    local last = front[#front]
    if not last or point.error < last.error then front[#front + 1] = point end
  end
  return front
end

--- The errors that a curve reaches at known times: from its smallest one to that of its cheapest point, which might be
--- cheaper at any larger error.
local function reach(curve)
  return lists.least(curve, function(point) return point.error end).error, curve[1].error
end

--- The least time on the curve, linear between points in both logarithms, at which its error is at most this one; nil
--- outside its range.
local function time_at(curve, size)
  local last
  for i, point in ipairs(curve) do
    if point.error == size then return point.time end
    if point.error < size then
      if i == 1 then return nil end
      return last.time * (point.time / last.time) ^ (math.log(last.error / size) / math.log(last.error / point.error))
    end
    last = point
  end
end

--- Cost ratio of a to b at equal error: { from, to, at, ratio }. Without `at`: at the smallest, the (geometrically)
--- middle and the largest error that both reach; where one of them does not, the ratio is nil. Without common errors
--- there are no from, to and ratios, but why.
local function compare(a, b, at)
  local least_a, largest_a = reach(a)
  local least_b, largest_b = reach(b)
  local from, to = math.max(least_a, least_b), math.min(largest_a, largest_b)
  if from > to then
    return { at = at or {}, ratio = {},
             why = ("one reaches %.3g to %.3g, the other %.3g to %.3g"):format(least_a, largest_a, least_b, largest_b) }
  end
  local result = { from = from, to = to, at = at or { from, math.sqrt(from) * math.sqrt(to), to }, ratio = {} }
  for i, size in ipairs(result.at) do
    -- Rounding error must not move the middle of a narrow range out of it.
    local within = at and size or math.max(from, math.min(to, size))
    local time_a, time_b = time_at(a, within), time_at(b, within)
    result.ratio[i] = time_a and time_b and time_a / time_b
  end
  return result
end

-- ── The chart ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The front as steps: points above or to the right of them are dominated. They extend to the ends of the data.
local function steps(front, points)
  local x, y, top, right = {}, {}, 0, 0
  for _, point in ipairs(points) do top, right = math.max(top, point.error), math.max(right, point.time) end
  local height = top
  for _, point in ipairs(front) do
    x, y = lists.joined(x, { point.time, point.time }), lists.joined(y, { height, point.error })
    height = point.error
  end
  return { x = lists.joined(x, { right }), y = lists.joined(y, { height }), label = "Pareto front", color = "gray",
           width = 6 }
end

--- Draws a file; `marks` are the names of all kinds of points, in order, or empty.
local function draw(result, points, front, marks, options, file)
  local chart = {
    file = file, log = "xy", size = options.size, title = options.title or result.name,
    xlabel = options.xlabel or result.time.label, ylabel = options.ylabel or result.error.label,
    legend_title = quantity.title(result.series), marks_title = #marks > 0 and result.marker or nil,
    marks = #marks > 0 and marks or nil,
  }
  for i, curve in ipairs(result.curves) do
    local function all(key) return lists.map(curve.points, function(point) return point[key] end) end
    chart[i] = { x = all "time", y = all "error", label = curve.name, markers = true,
                 marks = #marks > 0 and all "mark" or nil }
  end
  chart[#chart + 1] = steps(front, points)
  if result.error.uncertain and result.error.uncertain > 0 then
    local times = lists.map(sorted(points), function(point) return point.time end)
    local size = result.error.uncertain
    chart[#chart + 1] = { x = { times[1], times[#times] }, y = { size, size }, label = "uncertainty of the reference",
                          color = "gray", dashed = true }
  end
  return core.sg.chart(chart)
end

-- ── Reading the arguments ────────────────────────────────────────────────────────────────────────────────────────────

--- A function from rows to the texts that markers show, and its title; nil if all are the same.
local function read_marker(study, pick, series)
  if pick == false then return nil end
  if pick ~= nil then
    local q = quantity.read(where, "marker", study, pick)
    return function(row) return quantity.text(q, row) or "–" end, quantity.title(q)
  end
  local others = lists.filter(study.parameters, function(name) return name ~= series.pick end)
  if #others == 0 then return nil end
  return function(row)
    return table.concat(lists.map(others, function(name) return values.text(row[name], true) end), ", ")
  end, table.concat(others, ", ")
end

local function read_options(study, options)
  local series = options.series or lists.holds(study.parameters, "order") and "order" or study.parameters[1]
  local read = { time = quantity.read(where, "time", study, options.time),
                 error = quantity.read(where, "error", study, options.error),
                 series = quantity.read(where, "series", study, series),
                 keep = options.where, at = options.at, files = options.files or { options.file } }
  read.mark, read.marker = read_marker(study, options.marker, read.series)
  return read
end

-- ── Cases as points ──────────────────────────────────────────────────────────────────────────────────────────────────

--- The points, those left out as { row, why }, and the names of markers in the order of the cases.
local function read_points(study, read)
  local points, left_out = quantity.points(study, { read.time, read.error }, read.keep, function(point)
    point.series, point.mark = quantity.text(read.series, point.row), read.mark and read.mark(point.row)
    if not point.series then return "no " .. read.series.name end
    if point.time <= 0 then
      return ("%s is %g, which a logarithmic axis cannot show"):format(read.time.name, point.time)
    end
    if point.error == 0 then return read.error.name .. " is 0, which a logarithmic axis cannot show" end
    point.error = math.abs(point.error)
  end)
  return points, left_out, lists.unique(lists.map(read.mark and points or {}, function(point) return point.mark end))
end

local function make_curves(points)
  local groups = lists.grouped(points, function(point) return point.series end)
  return lists.map(groups, function(group) return { name = group.key, points = sorted(group) } end)
end

local function make_ratios(list, at)
  return lists.flat(lists.map(list, function(a, i)
    return lists.map({ table.unpack(list, i + 1) }, function(b)
      return lists.merged(compare(a.points, b.points, at), { a = a.name, b = b.name })
    end)
  end))
end

-- ── Reading (by the user) ────────────────────────────────────────────────────────────────────────────────────────────

function Result:table()
  local columns, rows, formats = { "A", "B", "from", "to" }, {}, { [3] = "%.3g", [4] = "%.3g" }
  local heads = { "at from", "middle", "at to" }
  for i, size in ipairs(self.at or heads) do
    columns[4 + i], formats[4 + i] = self.at and ("at %.3g"):format(size) or size, "%.3g"
  end
  for r, ratio in ipairs(self.ratios) do
    rows[r] = { ratio.a, ratio.b, ratio.from, ratio.to, table.unpack(ratio.ratio, 1, #columns - 4) }
  end
  local units = self.error.unit ~= "" and { "", "", self.error.unit, self.error.unit } or nil
  return format_table { columns = columns, units = units, rows = rows, formats = formats }
end

function Result:front()
  local study, last = self.study, #self.study.parameters
  local rows = lists.map(self.pareto, function(row)
    return lists.joined(lists.map(study.parameters, function(name) return values.text(row[name]) end),
      { quantity.number(self.time, row), math.abs(quantity.number(self.error, row)) })
  end)
  local units = lists.map(study.parameters, function(name) return study.units[name] or "" end)
  return format_table { columns = lists.joined(study.parameters, { self.time.name, self.error.name }),
    units = lists.joined(units, { self.time.unit, self.error.unit }), rows = rows,
    formats = { [last + 1] = "%.4g", [last + 2] = "%.4g" } }
end

--- Cost ratios, front, and the cases left out.
function Result:__tostring()
  local time, size = self.time.name, self.error.name
  local lines = { quantity.doubt(self.error) }
  if #self.ratios > 0 then
    lines[#lines + 1] = ("%s: ratio of %s, A to B, at equal %s:"):format(self.name, time, size)
    lines[#lines + 1] = self:table()
  end
  for _, ratio in ipairs(self.ratios) do
    if ratio.why then
      lines[#lines + 1] = ("%s, %s: no %s that both reach: %s"):format(ratio.a, ratio.b, size, ratio.why)
    end
  end
  lines[#lines + 1] = ("Pareto front of %s and %s:"):format(time, size)
  lines[#lines + 1] = self:front()
  if #self.left_out > 0 then lines[#lines + 1] = "Left out:" end
  for _, one in ipairs(self.left_out) do
    lines[#lines + 1] = ("  %s: %s"):format(quantity.case(self.study, one.row), cut(one.why, widest))
  end
  return table.concat(lines, "\n")
end

require("signorini.call.methods").guard("comparison", "front table")

return function(study, options)
  local read = read_options(study, options)
  local points, left_out, marks = read_points(study, read)
  if #points == 0 then
    local why = outcomes.why_none(study)
      or left_out[1] and ("%s: %s"):format(quantity.case(study, left_out[1].row), left_out[1].why)
    core.fail(("%s: no case has both %s and %s%s"):format(where, read.time.name, read.error.name,
      why and ": " .. why or ""))
  end
  if #marks > most_marks then
    if options.marker then
      core.fail(("%s: marker has %d values and charts have %d markers. Hint: choose a column with fewer, "
        .. "or filter the cases"):format(where, #marks, most_marks))
    end
    marks = {}
  end
  local list, front = make_curves(points), front_of(points)
  local result = setmetatable({ name = study.name or "study", study = study, time = read.time, error = read.error,
    series = read.series, marker = read.marker, at = read.at, curves = list, ratios = make_ratios(list, read.at),
    pareto = lists.map(front, function(point) return point.row end), left_out = left_out }, Result)
  for _, file in ipairs(read.files) do draw(result, points, front, marks, options, file) end
  return result
end
