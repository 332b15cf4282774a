-- Pages: charts and heat maps.

local lists = require "signorini.call.lists"
local t = require "signorini.call.types"
local rows = require "signorini.pages.chart_rows"

local curve = t.worded(t.named(rows.curve), "a curve { y = {…} }", "curves { y = {…} }")
curve.cures = { ["contact profile"] = "write { x = profile.x, y = profile.pressure }, or with another of its lists" }

local name = t.either(t.text, t.number)
local names = t.worded(t.list(name, nil, 1), "a list of at least one name or number")

local color = t.worded(t.either(t.integer(1, 21), t.text),
  'a color such as "#d55e00", or the number of one from 1 to 21')

local category = t.worded(t.either(t.text, t.named {
  { "name", t.text, "name as used in values" },
  { "good", t.flag, "whether the outcome is wanted: light green or blue",
    otherwise = "true for the first category if none sets it" },
  { "color", color, '"#rrggbb", or the number of a style', otherwise = "the next style" },
}), "a category { name = … }", "categories { name = … }")

local map = t.worded(t.named {
  { "title", t.text, "title above the map", optional = true }, rows.values, rows.texts,
}, "a map { title = …, values = … }")

local function without_panels(row)
  return lists.merged(row, { optional = true, excludes = { "panels", why = "each of which has its own" } })
end

local heatmap = lists.joined({
  { "x", names, "names of the columns, in order" },
  { "y", names, "names of the rows, the first one at the bottom" },
  without_panels(rows.values),
  without_panels(rows.texts),
  { "panels", t.list(map, nil, 1), "several maps side by side, instead of values and texts", optional = true },
  { "columns", t.integer(1, 100), "maps in a row", otherwise = "at most three; two for four maps" },
  { "categories", t.list(category, nil, 1), [[values are these names. The legend shows those that occur: good ones in
light green and blue, others in warm and dark colors in the order of the list, hatched from the eighth on; they can also
be distinguished without color]], optional = true },
}, rows.heatmap)

return {
  title = "Pictures and charts", word = "pictures",
  { "sg.chart", [[Returns a chart of curves as a picture, and writes it to `file` if given. Values, ranges and positions
are in the units of the data. In all texts u_y and x_{max} are set as subscripts, mm^2 and 10^-3 as superscripts; \_ and
\^ print the characters themselves.]], entries = { "curves", curve, "curves, as unnamed entries" },
    named = rows.chart,
    returns = t.object "picture",
    example = [[sg.chart{ file = "square.png", x = {1, 2, 3}, { y = {1, 4, 9}, label = "x squared" } }]] },
  { "sg.heatmap", [[Returns a heat map (colored cells of equal size) as a picture, and writes it to `file` if given:
numbers with a color bar, or categories with a legend. Subscripts and superscripts are as in sg.chart.]],
    named = heatmap,
    returns = t.object "picture", example = {
      [[sg.heatmap{ file = "map.png", x = {"N2", "N4"}, y = {10, 20}, values = { {0.3, 0.1}, {0.2, 0.05} } }]],
      [[sg.heatmap{ file = "map.png", x = {"N2", "N4"}, y = {10, 20}, texts = { {"", 12}, {35, 11} },
  categories = { { name = "converged" }, { name = "diverged" } },
  values = { {"diverged", "converged"}, {"converged", "converged"} } }]],
    } },
}
