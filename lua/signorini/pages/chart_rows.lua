-- Rows that the pages of charts and heat maps share with those of studies and stability maps.

local core = require "signorini.core"
local lists = require "signorini.lists"
local t = require "signorini.types"

local rows = {}

rows.file = { "file", t.text, "a name that ends with .png, .svg or .pdf", otherwise = "none is written" }

local markers = lists.joined(core.markers, { "none" })

local color = t.worded(t.either(t.count, t.choice { "gray" }), "the number of a curve or 'gray'")

local function pair(least)
  return t.worded(t.tuple({ t.number, t.text }, least), "a pair {position, text}", "pairs {position, text}")
end

local line = t.worded(t.either(t.number, pair(1)), "a number or a pair {position, text}",
  "numbers and pairs {position, text}")

local chart_size = t.list(t.integer(120, 5000), 2)

--- Of the curves of a chart.
rows.curve = {
  { "y", t.numbers(nil, true), "values; nan and inf leave a gap. A point between gaps has a marker" },
  { "x", t.numbers(nil, true), "as many abscissae", otherwise = "the chart's x" },
  { "label", t.text, "name in the legend, where curves of one label and look share a row", otherwise = "none" },
  { "line", t.flag, "draws the line", default = true },
  { "width", t.positive, "of the line, in pixels of a chart of 1600 x 1000", default = 3 },
  { "dashed", t.flag, "a dashed line", default = false },
  { "arrows", t.flag, "heads on the line in the order of its points: which way a hysteresis runs", default = false },
  { "markers", t.flag, "a marker at each point; false: none", otherwise = "a few on each of several curves" },
  { "marker", t.choice(markers), "shape of the markers", otherwise = "that of the curve's number" },
  { "marks", t.list(t.text), [[the kind of each point, such as its mesh: one marker per kind in all curves; the legend
lists them after the curves]], optional = true },
  { "color", color, [[looks like the curve of this number, or of none; 40 curves are told apart by color and dashes, and
a warning tells of more]], otherwise = "its own look" },
}

--- Of charts.
rows.chart = {
  { "x", t.numbers(nil, true), "abscissae of the curves that have none of their own", optional = true },
  { "xlabel", t.text, 'line at the x axis, with its unit: "force in N"', otherwise = "none" },
  { "ylabel", t.text, "the same at the y axis", otherwise = "none" },
  { "title", t.text, "line above the chart", otherwise = "none" },
  { "log", t.choice { "x", "y", "xy" }, "logarithmic axes", otherwise = "none" },
  { "xrange", t.interval, "ends of the x axis", otherwise = "those of the data" },
  { "yrange", t.interval, "ends of the y axis", otherwise = "those of the data within xrange" },
  { "xticks", t.list(pair(2)), "names in the place of numbers, in rising order", optional = true },
  { "hlines", t.list(line), "dotted horizontal reference lines", optional = true },
  { "vlines", t.list(line), "dotted vertical reference lines", optional = true },
  { "legend", t.either(t.flag, t.choice { "inside", "outside" }), [[the curves' names. true: in the first corner that
is free of curves (north-east, north-west, south-east, south-west), else, and with an inset, right of the chart, or
below it where they are long or many; "inside": in a corner; "outside": in none]], default = true },
  { "legend_title", t.text, "line above the curves' names", optional = true },
  { "marks", t.list(t.text), "order of the kinds of points", otherwise = "that of their first points" },
  { "marks_title", t.text, "line above the kinds of points", optional = true },
  { "inset", t.named {
    { "xrange", t.interval, "part of the x axis" },
    { "yrange", t.interval, "part of the y axis", otherwise = "that of the curves" },
    { "place", t.choice { "north-east", "north-west", "south-east", "south-west" }, "corner of the chart",
      otherwise = "the emptiest one" },
  }, [[Magnifies a part of the chart in a box; where no corner is free the y axis goes on, unless yrange is given]],
    optional = true },
  { "size", chart_size, "width and height", default = { 1600, 1000 }, unit = "pixels" },
  rows.file,
}

local cells = t.list(t.any)
local of_numbers = { "categories", why = "it is for maps of numbers" }

--- Of heat maps.
rows.heatmap = {
  { "title", t.text, "line above the map", otherwise = "none" },
  { "xlabel", t.text, "line at the x axis, with its unit", otherwise = "none" },
  { "ylabel", t.text, "the same at the y axis", otherwise = "none" },
  "Of numbers:",
  { "label", t.text, "title of the color bar, with the values' unit", otherwise = "none", excludes = of_numbers },
  { "range", t.interval, "lowest and highest value of the colors", otherwise = "that of the values",
    excludes = of_numbers },
  { "log", t.flag, "colors follow the logarithm", default = false, excludes = of_numbers },
  { "colormap", t.choice(core.colormaps), "as in sg.picture", default = "viridis", excludes = of_numbers },
  "On paper:",
  { "size", chart_size, "width and height",
    otherwise = "{1600, 1000}, of two or three panels {1600, 850}, of more {1600, 1400}", unit = "pixels" },
  rows.file,
}

--- What stands in the cells of a map.
rows.values = { "values", cells, [=[values[j][i] belongs to y[j] and x[i]: a number, or the name of a category; nil, nan
and inf are blank]=] }
rows.texts = { "texts", cells, "rows of short strings or numbers in the cells, left out where they do not fit",
               optional = true }

--- The rows of these keys, in this order. `otherwise`: what stands in words for arguments that are left out, by key.
function rows.pick(from, keys, otherwise)
  local picked = {}
  for key in keys:gmatch "%S+" do
    local row = lists.filter(from, function(one) return one[1] == key end)[1]
    picked[#picked + 1] = lists.merged(row, { otherwise = otherwise[key] })
  end
  return picked
end

return rows
