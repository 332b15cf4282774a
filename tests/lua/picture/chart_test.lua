-- sg.chart: files, options, invalid arguments.

require "check"

local folder = check.folder()

local function chart(more)
  local options = { file = folder .. "/chart.png", x = { 1, 2, 3 }, { y = { 1, 4, 9 }, label = "x squared" } }
  for key, value in pairs(more or {}) do options[key] = value end
  return options
end

check.case("each file name ending selects a format; files are reproducible", function()
  local beginnings = { png = "\137PNG", svg = "<", pdf = "%PDF" }
  for ending, beginning in pairs(beginnings) do
    local file = folder .. "/a." .. ending
    sg.chart(chart { file = file, xlabel = "x", ylabel = "y", title = "squares", size = { 400, 300 } })
    local first = core.read_file(file)
    check.equal(first:sub(1, #beginning), beginning)
    sg.chart(chart { file = file, xlabel = "x", ylabel = "y", title = "squares", size = { 400, 300 } })
    check.equal(core.read_file(file) == first, true)
  end
end)

check.case("options change the picture", function()
  local seen = {}
  local variants = {
    {}, { log = "y" }, { log = "xy" }, { xrange = { 0, 10 } }, { yrange = { -5, 20 } }, { legend = false },
    { legend = "outside" },
    { title = "t" },
    { [1] = { y = { 1, 4, 9 }, label = "x squared", markers = true } },
    { [1] = { y = { 1, 4, 9 }, label = "x squared", dashed = true } },
    { [1] = { y = { 1, 4, 9 }, label = "x squared", line = false, markers = true } },
    { [1] = { y = { 1, 4 }, x = { 1, 3 }, label = "x squared" } },
    { [1] = { y = { 1, 0 / 0, 9 }, label = "x squared", markers = true } },
    { [2] = { y = { 3, 2, 1 }, label = "falling" } },
    { [2] = { y = { 3, 2, 1 }, label = "falling", color = 1 } },
    { [2] = { y = { 3, 2, 1 }, label = "falling", marker = "open diamond" } },
    { [2] = { y = { 3, 2, 1 }, label = "falling", marker = "none" } },
    { [1] = { y = { 1, 4, 9 }, label = "x squared", width = 8 } },
    { xticks = { { 1, "m1" }, { 2, "m2" }, { 3, "m3" } } },
    { hlines = { 4 } }, { hlines = { { 4, "four" } } }, { vlines = { { 2, "two" } } },
    { inset = { xrange = { 1, 1.2 } } }, { inset = { xrange = { 1, 1.2 }, place = "south-east" } },
    { inset = { xrange = { 1, 1.2 }, yrange = { 0, 5 } } },
  }
  for i, variant in ipairs(variants) do
    variant.size = { 400, 300 }
    sg.chart(chart(variant))
    local bytes = core.read_file(folder .. "/chart.png")
    if seen[bytes] then error(("variants %d and %d look alike"):format(seen[bytes], i)) end
    seen[bytes] = i
  end
end)

check.case("curves with equal label and color share a row of the legend", function()
  local function rows(color)
    local file = folder .. "/legend.svg"
    sg.chart { file = file, x = { 1, 2 }, { y = { 1, 2 }, label = "N2" }, { y = { 2, 3 }, label = "N2", color = color },
               { y = { 4, 5 }, label = "N4" } }
    return select(2, core.read_file(file):gsub(">N2<", ""))
  end
  check.equal(rows(1), 1)
  check.equal(rows(2), 2)
end)

check.case("markers: one per kind of point; curves and kinds in two parts of the legend", function()
  local function svg(marks, more)
    local options = { file = folder .. "/marks.svg", marks = marks, legend_title = "order", marks_title = "mesh",
                      { x = { 1, 2, 3 }, y = { 1, 2, 3 }, label = "N2", marks = { "m1", "m2", "m3" } },
                      { x = { 1, 2 }, y = { 2, 4 }, label = "N4", marks = { "m4", "m1" } } }
    for key, value in pairs(more or {}) do options[key] = value end
    sg.chart(options)
    return core.read_file(options.file)
  end
  local function order(text, ...)
    local last = 0
    for _, name in ipairs { ... } do
      local at = text:find(">" .. name .. "<", 1, true)
      if not at or at < last then error(("'%s' is missing or too early"):format(name)) end
      last = at
    end
  end
  order(svg(), "order", "N2", "N4", "mesh", "m1", "m2", "m3", "m4")
  order(svg { "m4", "m3", "m2", "m1" }, "N4", "mesh", "m4", "m3", "m2", "m1")
  check.equal(svg(nil, { legend = false }):find(">mesh<", 1, true), nil)
  check.fails(function() svg { "m1", "m2", "m3" } end, "[2].marks[1] is 'm4'", "did you mean", "known: m1, m2, m3")
  check.fails(function() svg { "m1", "m1" } end, "marks[2] is 'm1' again")
  check.fails(function() svg(nil, { [3] = { y = { 1 }, x = { 1 }, marks = {} } }) end,
    "[3].marks must have as many names as the curve has points, 1, got 0")
end)

check.case("infinity is a gap like nan", function()
  local function svg(gap)
    sg.chart(chart { file = folder .. "/gap.svg", x = { 1, 2, 3, 4, 5 }, [1] = { y = { 1, 2, gap, 4, 5 } } })
    return core.read_file(folder .. "/gap.svg")
  end
  check.equal(svg(1 / 0) == svg(0 / 0), true)
  check.equal(svg(-1 / 0) == svg(0 / 0), true)
  check.equal(svg(3) == svg(0 / 0), false)
end)

check.case("markers = false removes the markers of several curves", function()
  local function polygons(markers)
    sg.chart { file = folder .. "/markers.svg", x = { 1, 2 }, legend = false, { y = { 1, 2 }, markers = markers },
               { y = { 2, 1 }, markers = markers } }
    return select(2, core.read_file(folder .. "/markers.svg"):gsub("stroke:none;fill%-rule", ""))
  end
  check.equal({ polygons(), polygons(false), polygons(true) }, { 8, 0, 8 })
end)

check.case("a discretization has the same color in all charts; other curves get other colors", function()
  --- The percentages of red of the curves of these names in a chart, the last one first, as they are drawn.
  local function reds(...)
    local file, chart, found = check.file "colors.svg", { x = { 1, 2 } }, {}
    for i, name in ipairs { ... } do chart[i] = { y = { i, i + 1 }, label = name, markers = false } end
    chart.file = file
    sg.chart(chart)
    for red in core.read_file(file):gmatch "stroke%-width:3;[^\"]-stroke:rgb%((%d+)" do found[#found + 1] = red end
    return table.concat({ table.unpack(found, #found - select("#", ...) + 1) }, " ")
  end
  check.equal(reds("exact", "N2-N2.2", "N2-N2.2, published", "N2"), "0 83 83 0")
  check.equal(reds("N4", "L1", "N2-N2.2"), "83 23 33")
  check.equal(reds("N9", "b"), "83 0")
end)

check.case("error draws a band of the curve's color, with gaps where it is nan or infinite", function()
  local function bands(file, error)
    local x = { 1, 2, 3, 4, 5 }
    sg.chart(chart { file = folder .. "/band." .. file, x = x, [1] = { y = x, error = error } })
    local bytes = core.read_file(folder .. "/band." .. file)
    return select(2, bytes:gsub("fill:rgb%(0%%,44%.7[%d.]+%%,69%.8[%d.]+%%%);fill%-opacity:0%.25", "")), bytes
  end
  check.equal(bands("svg"), 0)
  check.equal(bands("svg", { 1, 1, 0, 1, 1 }), 1)
  check.equal(bands("svg", { 1, 1, 0 / 0, 1, 1 }), 2)
  check.equal(bands("svg", { 1, 1 / 0, 1, 1 / 0, 1 }), 3)
  check.equal(bands("svg", { 1 / 0, 1 / 0, 1 / 0, 1 / 0, 0 / 0 }), 0)
  for _, format in ipairs { "png", "pdf" } do
    local _, plain = bands(format)
    local _, banded = bands(format, { 1, 1, 0, 1, 1 })
    check.equal(plain == banded, false)
  end
end)

check.case("missing characters become boxes, with a warning for each text", function()
  local draw = [[local sg = require "signorini" for _, ending in ipairs { "png", "png", "pdf", "svg" } do
    sg.chart { file = "%s/signs." .. ending, title = "%s", x = { 1, 2 }, { y = { 1, 2 } } } end]]
  local function said(title)
    local output, status = check.program { "-e", draw:format(folder, title) }
    check.equal(status, 0)
    return output, select(2, output:gsub("\n", ""))
  end
  local output, lines = said "Druck p_n und \u{F0000}"
  check.equal(lines, 1)
  check.holds(output, "signorini: warning: no installed font contains '\u{F0000}' of the text 'Druck p_n und", "boxes")
  local drawn = core.read_file(folder .. "/signs.png")
  said "Druck p_n und "
  check.equal(core.read_file(folder .. "/signs.png") == drawn, false) -- there is a box
  output, lines = said [[\xff\xfe]]
  check.equal(lines, 1)
  check.holds(output, "is not UTF-8", "save the script as UTF-8")
  output, lines = said "σ_yy ≤ 10^-3"
  check.equal(lines, 0)
end)

check.case("gray is not used for curves", function()
  local file = folder .. "/gray.svg"
  sg.chart { file = file, x = { 1, 2 }, { y = { 1, 2 }, label = "front", color = "gray", width = 12 } }
  check.holds(core.read_file(file), "stroke-width:12;stroke-linecap:butt;stroke-linejoin:round;stroke:rgb(76.8")
  check.fails(function() sg.chart { file = file, x = { 1, 2 }, { y = { 1, 2 }, color = "red" } } end,
    "[1].color must be the number of a curve or 'gray'", "'red'")
end)

check.case("wrong arguments", function()
  local wrong = {
    { { xrange = { 2, 1 } }, "xrange must be increasing" },
    { { size = { 10, 300 } }, "size[1]" },
    { { [1] = { 1, 2, 3 } }, "[1] takes named arguments" },
    { { [1] = { y = { 1, 2 } } }, "[1].y must have as many values as x, 3, got 2" },
    { { [1] = { y = { 1, 2, 3 }, error = { 1, 2 } } }, "[1].error must have as many values as x, 3, got 2" },
    { { [1] = { y = { 1, 2, 3 }, error = {} } }, "[1].error must have as many values as x, 3, got 0" },
    { { [1] = { y = { 1, 2, 3 }, error = { 1, -2, 1 } } }, "[1].error[2] must be a number, 0 or more", "-2" },
    { { [1] = { y = { 1, 2, 3 }, error = { 1, "2", 1 } } }, "[1].error[2] must be a number", "remove the quotes" },
    { { [1] = { y = { 1, 2, 3 }, error = 0.1 } }, "[1].error must be a list", "put it into braces" },
    { { [1] = { y = { 1, 2, 3 }, line = false } }, "without markers shows nothing" },
    { { file = folder .. "/chart.gif" }, "sg.chart", "chart.gif" },
    { { file = folder .. "/none/chart.png" }, "sg.chart", "none" },
    { { log = "y", [1] = { y = { 0, 1, 2 } } }, "sg.chart", "log" },
    { { [1] = { y = { 1, 2, 3 }, color = 0 } }, "[1].color must be the number of a curve", "give a value from 1" },
    { { [1] = { y = { 1, 2, 3 }, line = false, markers = true, marker = "none" } }, "without markers shows nothing" },
    { { xticks = { { 2, "b" }, { 1, "a" } } }, "xticks must increase" },
    { { xticks = { { 1, 2 } } }, "xticks[1][2] must be a string" },
    { { hlines = { { "4" } } }, "hlines[1][1] must be a number" },
    { { hlines = { { 4, "four", 5 } } }, "hlines[1] must be a pair" },
    { { inset = { xrange = { 7, 8 } } }, "sg.chart", "inset: the chart has no curve between x = 7 and 8" },
    { { inset = { xrange = { 2, 1 } } }, "inset.xrange must be increasing" },
    { { inset = { xrange = { 1, 2 }, place = "middle" } }, "inset.place must be 'north-east', 'north-west'" },
  }
  for _, case in ipairs(wrong) do check.fails(function() sg.chart(chart(case[1])) end, table.unpack(case, 2)) end
  check.fails(function() sg.chart { file = "a.png" } end, "at least one curve is needed, got none")
  check.fails(function() sg.chart { file = "a.png", { y = { 1 } } } end, "[1].x is missing")
end)
