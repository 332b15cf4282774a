-- The chart of errors against times.

local core = require "signorini.core"
local quantity = require "signorini.study.quantity"

--- The front as steps: whatever lies above or right of them is beaten. They go on to the ends of the data.
local function steps(front, points)
  local x, y, top, right = {}, {}, 0, 0
  for _, point in ipairs(points) do top, right = math.max(top, point.error), math.max(right, point.time) end
  local height = top
  for _, point in ipairs(front) do
    table.move({ point.time, point.time }, 1, 2, #x + 1, x)
    table.move({ height, point.error }, 1, 2, #y + 1, y)
    height = point.error
  end
  x[#x + 1], y[#y + 1] = right, height
  return { x = x, y = y, label = "Pareto front", color = "gray", width = 12 }
end

--- Draws a file; `marks` are the names of all kinds of points, in order, or empty.
return function(result, points, front, marks, options, file)
  local chart = {
    file = file, log = "xy", size = options.size, title = options.title or result.name,
    xlabel = options.xlabel or result.time.label, ylabel = options.ylabel or result.error.label,
    legend_title = quantity.title(result.series), marks_title = #marks > 0 and result.marker or nil,
    marks = #marks > 0 and marks or nil,
  }
  for i, curve in ipairs(result.curves) do
    chart[i] = { x = {}, y = {}, label = curve.name, markers = true, marks = #marks > 0 and {} or nil }
    for j, point in ipairs(curve.points) do
      chart[i].x[j], chart[i].y[j] = point.time, point.error
      if #marks > 0 then chart[i].marks[j] = point.mark end
    end
  end
  chart[#chart + 1] = steps(front, points)
  return core.sg.chart(chart)
end
