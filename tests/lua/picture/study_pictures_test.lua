-- study:chart and study:heatmap: the arguments that they pass to sg.chart and sg.heatmap, invalid arguments.

require "check"

--- Two orders × two meshes × steps; N4 on the coarse mesh has failed.
local function study()
  local rows = {}
  for _, order in ipairs { "N4", "N2" } do
    for i, mesh in ipairs { { 12, 4 }, { 6, 2 } } do
      rows[#rows + 1] = { order = order, mesh = mesh, steps = 10, wall = 3 - i, dPx = 0.1 * i }
    end
  end
  rows[2] = { order = "N4", mesh = { 6, 2 }, steps = 10, wall = 1, failed = true, reason = "diverged" }
  return setmetatable({ name = "ironing", parameters = { "order", "mesh", "steps" }, results = { "dPx" },
           units = { wall = "s", dPx = "%" }, rows = rows }, core.types.study)
end

--- What a function hands to sg.chart or sg.heatmap.
local function handed_over(name, body)
  local seen
  rawset(core.sg, name, function(options) seen = options end)
  local ok, message = pcall(body)
  rawset(core.sg, name, nil)
  if not ok then error(message, 0) end
  return seen
end

local function chart(options, one)
  options.file = options.file or "a.png"
  return handed_over("chart", function() (one or study()):chart(options) end)
end

local function heatmap(options, one)
  options.file = options.file or "a.png"
  return handed_over("heatmap", function() (one or study()):heatmap(options) end)
end

check.case("a chart: one curve per series, by x; labels with units; failed cases have no point", function()
  local got = chart { x = "wall", y = "dPx", series = "order", log = "xy", size = { 800, 600 } }
  check.equal({ got.file, got.log, got.size, got.title }, { "a.png", "xy", { 800, 600 }, "ironing" })
  check.equal({ got.xlabel, got.ylabel, got.legend_title, #got }, { "wall (s)", "dPx (%)", "order", 2 })
  check.equal({ got[1].label, got[1].x, got[1].y }, { "N4", { 2 }, { 0.1 } })
  check.equal({ got[2].label, got[2].x, got[2].y, got[2].markers }, { "N2", { 1, 2 }, { 0.2, 0.1 }, true })
  got = chart { x = "wall", y = function(row) return 2 * row.dPx end, ylabel = "twice", markers = false, width = 5,
                title = "own" }
  check.equal({ #got, got[1].label, got[1].x, got[1].y }, { 1, "", { 1, 2, 2 }, { 0.4, 0.2, 0.2 } })
  check.equal({ got.ylabel, got.title, got[1].markers, got[1].width, got.legend_title }, { "twice", "own", false, 5 })
end)

check.case("texts and tables along x: their names in the order in which they come first", function()
  local got = chart { x = "mesh", y = "dPx", series = "order" }
  check.equal(got.xticks, { { 1, "12×4" }, { 2, "6×2" } })
  check.equal({ got.xlabel, got[2].label, got[2].x, got[2].y }, { "mesh", "N2", { 1, 2 }, { 0.1, 0.2 } })
  check.equal(chart{ x = "steps", y = "dPx", line = false }.xticks, nil)
end)

check.case("a parameter with few whole values along x has its ticks there, and there only", function()
  local function ticks(values, options)
    local rows = {}
    for i, value in ipairs(values) do rows[i] = { n = value, f = i, wall = i } end
    options = options or {}
    options.x, options.y = options.x or "n", "f"
    local one = { name = "s", parameters = { "n" }, results = { "f" }, units = {}, rows = rows }
    return chart(options, setmetatable(one, core.types.study)).xticks
  end
  check.equal(ticks { 3, 1, 2.0 }, { { 1, "1" }, { 2, "2" }, { 3, "3" } })
  check.equal({ ticks { 1, 1.5, 2 }, ticks { 1, 2, 100 }, ticks { 2 } }, {})
  check.equal(ticks({ 1, 2, 4, 16 }, { log = "x" }), { { 1, "1" }, { 2, "2" }, { 4, "4" }, { 16, "16" } })
  check.equal({ ticks({ 1, 2, 3 }, { x = "wall" }), ticks({ 1, 2, 3 }, { xrange = { 0, 5 } }) }, {})
  check.equal(ticks({ 1, 2 }, { xticks = { { 1, "one" } } }), { { 1, "one" } })
end)

check.case("a parameter along x with several cases at a place is ambiguous", function()
  check.fails(function() chart { x = "order", y = "dPx" } end, "study:chart: more than one case at order = N2: ",
    "they differ in mesh (12×4, 6×2)", "study:where", "series")
  check.fails(function() chart { x = "steps", y = "dPx", series = "order" } end, "steps = 10 of the curve N2")
  check.equal(chart{ x = "order", y = "dPx", line = false }[1].x, { 1, 2, 2 }) -- points alone may coincide
end)

check.case("a heat map: axes in the parameters' order, values with texts, failed cells named", function()
  local got = heatmap { x = "order", y = "mesh", value = "dPx", log = true }
  check.equal({ got.x, got.y }, { { "N4", "N2" }, { "12×4", "6×2" } })
  check.equal({ got.values[1], got.values[2][1], got.values[2][2] }, { { 0.1, 0.1 }, nil, 0.2 })
  check.equal({ got.texts[1], got.texts[2] }, { { 0.1, 0.1 }, { "failed", 0.2 } })
  check.equal({ got.label, got.xlabel, got.ylabel, got.title, got.log },
    { "dPx (%)", "order", "mesh", "ironing", true })
  got = heatmap { x = "mesh", y = "order", value = function(row) return row.wall / 3 end, texts = false,
                  label = "third" }
  check.equal({ got.texts, got.label }, { nil, "third" })
  check.near(got.values[2], { 2 / 3, 1 / 3 })
end)

check.case("more than one case in a cell names the missing filter", function()
  local one = study()
  one.rows[5] = { order = "N2", mesh = { 6, 2 }, steps = 20, wall = 1, dPx = 0.1 }
  check.fails(function() heatmap({ x = "order", y = "mesh", value = "dPx" }, one) end, "study:heatmap",
    "more than one case at order = N2, mesh = 6×2", "steps (10, 20)", "study:where")
end)

check.case("pictures are drawn", function()
  local folder = check.folder()
  study():chart({ x = "mesh", y = "dPx", series = "order", file = folder .. "/chart.svg" })
  study():heatmap({ x = "order", y = "mesh", value = "dPx", file = folder .. "/map.svg" })
  for file, texts in pairs { chart = { ">6×2<", ">dPx (%)<", ">N2<" }, map = { ">6×2<", ">failed<", ">dPx (%)<" } } do
    check.holds(core.read_file(("%s/%s.svg"):format(folder, file)), table.unpack(texts))
  end
end)

check.case("wrong arguments", function()
  local function fails(call, options, ...)
    check.fails(function() study()[call](study(), options) end, "study_pictures_test.lua:", ...)
  end
  fails("chart", { file = "a.png", x = "wal", y = "dPx" }, "study:chart: x must be", "did you mean 'wall'?")
  fails("chart", { file = "a.png", x = "wall" }, "y (column, or function of a row) is missing")
  fails("chart", { file = "a.png", x = "wall", y = "order" }, "y (of the case order = N4", "got the string 'N4'")
  fails("chart", { file = "a.png", x = "wall", y = "dPx", serie = "order" }, "did you mean 'series'?")
  fails("chart", { file = "a.png", x = "wall", y = function() end }, "no case has both wall and y")
  fails("heatmap", { file = "a.png", x = "order", y = "dPx", value = "wall" }, "y must be 'order', 'mesh' or 'steps'")
  fails("heatmap", { file = "a.png", x = "order", y = "order", value = "wall" }, "x and y are both order")
  fails("heatmap", { file = "a.png", x = "order", y = "mesh" }, "value (column, or function of a row) is missing")
  fails("heatmap", { file = "a.png", x = "order", y = "mesh", value = "dPx", texts = "no" },
    "texts must be true or false")
  fails("heatmap", { file = "a.png", x = "order", y = "mesh", value = function() end }, "no case has value")
end)
