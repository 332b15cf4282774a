-- Rows that the pages of charts and heat maps share with those of studies and convergence maps.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local t = require "signorini.call.types"

local rows = {}

rows.file = { "file", t.text, "file name that ends with .png, .svg or .pdf", otherwise = "not written" }

local markers = lists.joined(core.markers, { "none" })

local color = t.worded(t.either(t.count, t.choice { "gray" }), "the number of a curve or 'gray'")

local function pair(least)
  return t.worded(t.tuple({ t.number, t.text }, least), "a pair {position, text}", "pairs {position, text}")
end

local line = t.worded(t.either(t.number, pair(1)), "a number or a pair {position, text}",
  "numbers and pairs {position, text}")

local chart_size = t.list(t.integer(120, 5000), 2)

--- The curves of a chart.
rows.curve = {
  { "y", t.numbers(nil, true), "values; nan and inf are gaps. A single point between gaps gets a marker" },
  { "x", t.numbers(nil, true), "abscissae, one per value", otherwise = "the chart's x" },
  { "error", t.list { kind = "number", low = 0, gaps = true }, [[half heights of a band y ± error below the curves, one
per value; nan and inf leave a gap in it. The automatic range of the y axis includes errors up to the span of the
curves]], optional = true },
  { "label", t.text, "name in the legend; curves with the same label and style share a row", otherwise = "none" },
  { "line", t.flag, "whether to draw the line", default = true },
  { "width", t.positive, "line width in pixels, in a chart of 1600 x 1000", default = 3 },
  { "dashed", t.flag, "whether the line is dashed", default = false },
  { "arrows", t.flag, "arrow heads in the order of the points, such as the direction of a hysteresis loop",
    default = false },
  { "markers", t.flag, "a marker at each point; false: none", otherwise = "a few per curve, if several" },
  { "marker", t.choice(markers), "shape of the markers", otherwise = "that of the curve's number" },
  { "marks", t.list(t.text), [[the kind of each point, such as its mesh: one marker per kind in all curves; the legend
lists them after the curves]], optional = true },
  { "color", color, [[color and dashes of the curve with this number, or gray; 40 curves can be distinguished, a warning
reports more]], otherwise = [[that of the discretization with which the label begins: N2, N2-N2.2, N2-N2.1, N3, N4,
N2-N4, L1, L2 are 1 to 8, further labels with it add 8; that of the curve's number if no label does]] },
}

--- Charts.
rows.chart = {
  { "x", t.numbers(nil, true), "abscissae of the curves without x", optional = true },
  { "xlabel", t.text, 'label of the x axis with its unit: "force (N)"', otherwise = "none" },
  { "ylabel", t.text, "label of the y axis", otherwise = "none" },
  { "title", t.text, "title above the chart", otherwise = "none" },
  { "log", t.choice { "x", "y", "xy" }, "logarithmic axes", otherwise = "none" },
  { "xrange", t.interval, "limits of the x axis", otherwise = "those of the data" },
  { "yrange", t.interval, "limits of the y axis", otherwise = "those of the data within xrange" },
  { "xticks", t.list(pair(2)), "tick labels instead of numbers, in increasing order", optional = true },
  { "hlines", t.list(line), "dotted horizontal reference lines", optional = true },
  { "vlines", t.list(line), "dotted vertical reference lines", optional = true },
  { "legend", t.either(t.flag, t.choice { "inside", "outside" }), [[names of the curves. true: in the first corner
without curves (north-east, north-west, south-east, south-west), otherwise, and with an inset, to the right of the
chart, or below it if the names are long or many; "inside": in a corner; "outside": outside the axes; false: no
legend]], default = true },
  { "legend_title", t.text, "title of the legend", optional = true },
  { "marks", t.list(t.text), "order of the kinds of points", otherwise = "order of first occurrence" },
  { "marks_title", t.text, "title of the list of kinds", optional = true },
  { "inset", t.named {
    { "xrange", t.interval, "part of the x axis" },
    { "yrange", t.interval, "part of the y axis", otherwise = "that of the curves" },
    { "place", t.choice { "north-east", "north-west", "south-east", "south-west" }, "corner of the chart",
      otherwise = "the emptiest one" },
  }, [[Magnifies a part of the chart in a box; if no corner is free, the y axis is extended, unless yrange is given]],
    optional = true },
  { "size", chart_size, "width and height", default = { 1600, 1000 }, unit = "pixels" },
  rows.file,
}

local cells = t.list(t.any)
local of_numbers = { "categories", why = "it is for maps of numbers" }

--- Heat maps.
rows.heatmap = {
  { "title", t.text, "title above the map", otherwise = "none" },
  { "xlabel", t.text, "label of the x axis with its unit", otherwise = "none" },
  { "ylabel", t.text, "label of the y axis with its unit", otherwise = "none" },
  "Maps of numbers:",
  { "label", t.text, "title of the color bar, with the values' unit", otherwise = "none", excludes = of_numbers },
  { "range", t.interval, "lowest and highest value of the colors", otherwise = "that of the values",
    excludes = of_numbers },
  { "log", t.flag, "logarithmic color scale", default = false, excludes = of_numbers },
  { "colormap", t.choice(core.colormaps), "as in sg.picture", default = "viridis", excludes = of_numbers },
  "Size and file:",
  { "size", chart_size, "width and height",
    otherwise = "{1600, 1000}, of two or three panels {1600, 850}, of more {1600, 1400}", unit = "pixels" },
  rows.file,
}

--- The contents of a map's cells.
rows.values = { "values", cells, [=[values[j][i] belongs to y[j] and x[i]: a number, or the name of a category; nil, nan
and inf are blank]=] }
rows.texts = { "texts", cells, "rows of short strings or numbers printed in the cells, omitted where they do not fit",
               optional = true }

--- The rows of these keys, in this order. `otherwise`: defaults in words, by key.
function rows.pick(from, keys, otherwise)
  local picked = {}
  for key in keys:gmatch "%S+" do
    local row = lists.filter(from, function(one) return one[1] == key end)[1]
    picked[#picked + 1] = lists.merged(row, { otherwise = otherwise[key] })
  end
  return picked
end

rows.chart.hints = { y = "each curve is a table: sg.chart{ x = {1, 2}, { y = {3, 4} } }" }

return rows
